// SPDX-License-Identifier: Apache-2.0
#include "study/regress/prove.h"

#include "results/metadata.h"
#include "results/regress/update.h"

#include <algorithm>
#include <map>

namespace umbrameter {
namespace {

constexpr uint64_t kRecordSeed = 1001, kCheckSeed = 1;  // so that they share no sample

using MakePicture = std::function<Image(Stage&)>;

/// A stage as a renderer: the picture of the request's seed.
class StagedPicture : public Renderer {
 public:
  StagedPicture(Stage& stage, MakePicture make) : stage_(stage), make_(std::move(make)) {}
  Frame render(const Scene&, const RenderRequest& request, Progress&) override {
    stage_.repeat(request.seed);
    Frame frame;
    frame.image = make_(stage_);
    return frame;
  }

 private:
  Stage& stage_;
  MakePicture make_;
};

/// Its truth, of as many parts as it takes.
class StagedTruth : public Renderer {
 public:
  StagedTruth(Stage& stage, MakePicture make, int parts) : picture_(stage, std::move(make)), parts_(parts) {}
  Frame render(const Scene& scene, const RenderRequest& request, Progress& progress) override {
    constexpr uint64_t kApart = 10;  // a stage takes two seeds in a row
    Frame frame = picture_.render(scene, request, progress);
    RenderRequest next = request;
    for (int part = 1; part < parts_; ++part) {
      next.seed += kApart;
      add_samples(frame.image, picture_.render(scene, next, progress).image);
    }
    return frame;
  }

 private:
  StagedPicture picture_;
  int parts_;
};

RegressPlan plan_of(const SelftestRound& round, int samples_per_pixel, const RegressGates& gates) {
  RegressPlan plan;
  plan.suite = "proof";
  plan.picture.width_px = round.width_px;
  plan.picture.height_px = round.height_px;
  plan.picture.samples_per_pixel = samples_per_pixel;
  plan.most_samples_per_pixel = 2 * samples_per_pixel;
  plan.gates = gates;
  TechniqueRun run;
  run.label = "run";
  run.lights = {LightType::rect, LightType::disk, LightType::sphere, LightType::sun};
  plan.runs = {run};
  return plan;
}

/// One scene with what was recorded of it.
struct Proof {
  const SceneJob& job;
  Stage& stage;
  RegressPlan plan;
  std::map<std::string, Baseline> baselines;  // by choice

  RegressRenderers renderers(Renderer& realtime, const MakePicture& truth) const {
    return {realtime, [this, truth](int samples) -> std::unique_ptr<Renderer> {
              return std::make_unique<StagedTruth>(stage, truth, samples / plan.picture.samples_per_pixel);
            }};
  }
};

Image true_picture(Stage& stage) {
  return stage.truth();
}

/// Of a technique, or of the exact picture: measured, written and read again.
const Baseline& recorded(const std::optional<TechniqueChoice>& choice, Proof& proof) {
  const std::string key = choice ? choice->technique + " " + to_text(choice->parameters) : "";
  const auto [found, is_new] = proof.baselines.try_emplace(key);
  if (!is_new) return found->second;
  StagedPicture realtime(proof.stage,
                         [&](Stage& stage) { return choice ? stage.picture(*choice) : stage.exact(); });
  RegressPlan plan = proof.plan;
  plan.picture.seed = kRecordSeed;
  SilentProgress silent;
  const RegressResults measured =
      measure_suite({&proof.job, 1}, plan, proof.renderers(realtime, true_picture), silent);
  found->second = parse_baseline(to_toml_text(baseline_of(measured, {"", "proof", "", {}})), "baseline.toml");
  return found->second;
}

Image faulty_picture(Trial trial) {
  if (trial.failure) throw Error(trial.failure->kind, trial.failure->message);
  return std::move(trial.picture);
}

ProvedFault proved(const FaultCase& fault, Proof& proof) {
  proof.stage.repeat(kCheckSeed);
  const Trial trial = fault.make(proof.stage);
  const Baseline& baseline = recorded(trial.baseline, proof);
  RegressPlan plan = proof.plan;
  plan.picture.seed = kCheckSeed;
  plan.metric = trial.metric;
  StagedPicture realtime(proof.stage, [&](Stage& stage) { return faulty_picture(fault.make(stage)); });
  const MakePicture truth = [&](Stage& stage) {
    Trial made = fault.make(stage);
    return made.truth ? std::move(*made.truth) : stage.truth();
  };
  SilentProgress silent;
  const RegressResults checked =
      check_suite({&proof.job, 1}, plan, baseline, proof.renderers(realtime, truth), silent);
  const auto is_run = [](const RegressCase& one) { return one.label == "run"; };
  return {fault.name, fault.scene, fault.right, *std::ranges::find_if(checked.cases, is_run)};
}

}  // namespace

std::vector<ProvedFault> prove_faults(std::span<const FaultCase> faults, std::span<const SceneJob> jobs,
                                      const SelftestSettings& settings, PictureRenderers renderers,
                                      int samples_per_pixel, const RegressGates& gates, Progress& progress) {
  std::vector<ProvedFault> all;
  SilentProgress silent;
  progress.begin("faults", jobs.size());
  for (const SceneJob& job : jobs) {
    const SelftestRound& round = settings.rounds.front();
    Stage stage(job, settings, round, renderers, silent);
    Proof proof{job, stage, plan_of(round, samples_per_pixel, gates), {}};
    for (const FaultCase& fault : faults) {
      if (fault.scene == job.name) all.push_back(proved(fault, proof));
    }
    progress.advance(1);
  }
  progress.end();
  return all;
}

}  // namespace umbrameter
