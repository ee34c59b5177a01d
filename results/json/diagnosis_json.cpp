// SPDX-License-Identifier: Apache-2.0
#include "results/json/diagnosis_json.h"

#include "results/json/json_optional.h"

#include <string>

namespace umbrameter {
namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

OrderedJson spread_json(const std::optional<Spread>& spread) {
  if (!spread) return nullptr;
  return {{"median", spread->median}, {"p5", spread->p5},           {"p95", spread->p95},
          {"rmse", spread->rmse},     {"rmse_se", spread->rmse_se}, {"count", spread->count}};
}

std::optional<Spread> read_spread(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return Spread{json.at("median"), json.at("p5"),      json.at("p95"),
                json.at("rmse"),   json.at("rmse_se"), json.at("count")};
}

OrderedJson penumbra_json(const PenumbraNumbers& penumbra) {
  OrderedJson outcomes = OrderedJson::object();
  for (size_t k = 0; k < kProfileOutcomes; ++k) {
    outcomes[std::string(name_of(static_cast<ProfileOutcome>(k)))] = penumbra.outcomes[k];
  }
  return {{"width_octaves", spread_json(penumbra.width_octaves)},
          {"width_10_90_octaves", spread_json(penumbra.width_10_90_octaves)},
          {"offset_world", spread_json(penumbra.offset_world)},
          {"offset_widths", spread_json(penumbra.offset_widths)},
          {"offset_texels", spread_json(penumbra.offset_texels)},
          {"accepted", penumbra.accepted()},
          {"partial", penumbra.partial},
          {"rejected", penumbra.rejected()},
          {"profiles", outcomes}};
}

PenumbraNumbers read_penumbra(const Json& json) {
  PenumbraNumbers penumbra;
  penumbra.partial = json.at("partial");
  penumbra.width_octaves = read_spread(json.at("width_octaves"));
  penumbra.width_10_90_octaves = read_spread(json.at("width_10_90_octaves"));
  penumbra.offset_world = read_spread(json.at("offset_world"));
  penumbra.offset_widths = read_spread(json.at("offset_widths"));
  penumbra.offset_texels = read_spread(json.at("offset_texels"));
  for (size_t k = 0; k < kProfileOutcomes; ++k) {
    penumbra.outcomes[k] = json.at("profiles").at(std::string(name_of(static_cast<ProfileOutcome>(k))));
  }
  return penumbra;
}

OrderedJson hardening_json(const ContactHardening& hardening) {
  return {{"identifiable", hardening.slope.has_value()},
          {"slope", optional_json(hardening.slope)},
          {"slope_margin", optional_json(hardening.slope_margin)},
          {"intercept_octaves", optional_json(hardening.intercept_octaves)},
          {"profiles", hardening.profiles},
          {"octaves", hardening.octaves}};
}

ContactHardening read_hardening(const Json& json) {
  return {json.at("profiles"), json.at("octaves"), read_optional<double>(json.at("slope")),
          read_optional<double>(json.at("intercept_octaves")),
          read_optional<double>(json.at("slope_margin"))};
}

OrderedJson faults_json(const FaultNumbers& faults) {
  OrderedJson classes = OrderedJson::object();
  for (size_t k = 0; k < kFaultClasses; ++k) {
    const FaultShare& share = faults.by_class[k];
    classes[std::string(name_of(static_cast<FaultClass>(k)))] = {
        {"pixels", share.pixels}, {"components", share.components}, {"mean_abs_error", share.mean_abs_error}};
  }
  const auto worst = worst_fault(faults);
  return {{"worst", worst ? OrderedJson(name_of(*worst)) : OrderedJson(nullptr)},
          {"scored_pixels", faults.scored_pixels},
          {"mean_abs_error", optional_json(faults.mean_abs_error)},
          {"peter_panning_gap_world", optional_json(faults.peter_panning_gap_world)},
          {"classes", classes}};
}

FaultNumbers read_faults(const Json& json) {
  FaultNumbers faults;
  faults.scored_pixels = json.at("scored_pixels");
  faults.mean_abs_error = read_optional<double>(json.at("mean_abs_error"));
  faults.peter_panning_gap_world = read_optional<double>(json.at("peter_panning_gap_world"));
  for (size_t k = 0; k < kFaultClasses; ++k) {
    const Json& share = json.at("classes").at(std::string(name_of(static_cast<FaultClass>(k))));
    faults.by_class[k] = {share.at("pixels"), share.at("components"), share.at("mean_abs_error")};
  }
  return faults;
}

OrderedJson moire_json(const Moire& moire) {
  return {{"tiles", moire.tiles},
          {"cycles_per_px", optional_json(moire.cycles_per_px)},
          {"cycles_per_texel", optional_json(moire.cycles_per_texel)}};
}

Moire read_moire(const Json& json) {
  return {json.at("tiles"), read_optional<double>(json.at("cycles_per_px")),
          read_optional<double>(json.at("cycles_per_texel"))};
}

OrderedJson bin_json(std::optional<double> from_px, const FootprintBin& bin) {
  return {
      {"from_px", optional_json(from_px)}, {"pixels", bin.pixels}, {"mean_abs_error", bin.mean_abs_error}};
}

FootprintBin read_bin(const Json& json) {
  return {json.at("pixels"), json.at("mean_abs_error")};
}

OrderedJson causes_json(const ErrorCauses& causes) {
  OrderedJson bins = OrderedJson::array();
  for (size_t k = 0; k < kFootprintBinsPx.size(); ++k) {
    bins.push_back(bin_json(kFootprintBinsPx[k], causes.by_footprint[k]));
  }
  bins.push_back(bin_json(std::nullopt, causes.unknown));
  return {{"by_footprint", bins},
          {"median_footprint_px", optional_json(causes.median_footprint_px)},
          {"stair_texels", optional_json(causes.stair_texels)},
          {"stair_profiles", causes.stair_profiles},
          {"banding", optional_json(causes.banding)},
          {"levels", optional_json(causes.levels)},
          {"banding_profiles", causes.banding_profiles},
          {"noise", optional_json(causes.noise)},
          {"reference_noise", optional_json(causes.reference_noise)}};
}

ErrorCauses read_causes(const Json& json, const FaultNumbers& faults) {
  ErrorCauses causes;
  causes.scored_pixels = faults.scored_pixels;
  causes.mean_abs_error = faults.mean_abs_error;
  const Json& bins = json.at("by_footprint");
  for (size_t k = 0; k < kFootprintBinsPx.size(); ++k) causes.by_footprint[k] = read_bin(bins.at(k));
  causes.unknown = read_bin(bins.at(kFootprintBinsPx.size()));
  causes.median_footprint_px = read_optional<double>(json.at("median_footprint_px"));
  causes.stair_texels = read_optional<double>(json.at("stair_texels"));
  causes.stair_profiles = json.at("stair_profiles");
  causes.banding = read_optional<double>(json.at("banding"));
  causes.levels = read_optional<double>(json.at("levels"));
  causes.banding_profiles = json.at("banding_profiles");
  causes.noise = read_optional<double>(json.at("noise"));
  causes.reference_noise = read_optional<double>(json.at("reference_noise"));
  return causes;
}

}  // namespace

void add_diagnosis(const std::optional<Diagnosis>& diagnosis, nlohmann::ordered_json& object) {
  object["penumbra"] = diagnosis ? penumbra_json(diagnosis->penumbra) : OrderedJson(nullptr);
  object["contact_hardening"] =
      diagnosis ? hardening_json(diagnosis->contact_hardening) : OrderedJson(nullptr);
  object["faults"] = diagnosis ? faults_json(diagnosis->faults) : OrderedJson(nullptr);
  object["moire"] = diagnosis ? moire_json(diagnosis->moire) : OrderedJson(nullptr);
  object["causes"] = diagnosis ? causes_json(diagnosis->causes) : OrderedJson(nullptr);
}

std::optional<Diagnosis> read_diagnosis(const nlohmann::json& object) {
  if (object.at("penumbra").is_null()) return std::nullopt;
  const FaultNumbers faults = read_faults(object.at("faults"));
  return Diagnosis{read_penumbra(object.at("penumbra")), read_hardening(object.at("contact_hardening")),
                   faults, read_moire(object.at("moire")), read_causes(object.at("causes"), faults)};
}

}  // namespace umbrameter
