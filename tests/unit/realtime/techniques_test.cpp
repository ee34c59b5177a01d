// SPDX-License-Identifier: Apache-2.0
// Groups of parameters, what a technique is found by, and how its parameters get their values.

#include "realtime/manifest/technique_cache.h"
#include "tests/support/source_dir.h"
#include "tests/unit/realtime/whole_manifest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Manifest, ParameterGroupsComeFromTheSharedFolder) {
  TechniqueFolder folder;
  folder.write_shared("bias.toml",
                      "[[parameter]]\nname = \"softness\"\ntype = \"real\"\ndefault = 0.25\nmin = 0\nmax = "
                      "1\nstage = \"uniform\"\ndoc = \"x\"\n");
  const std::string without =
      replaced(whole_manifest(),
               "[[parameter]]\nname = \"softness\"\ntype = \"real\"\ndefault = 0.5\nmin = 0.0\nmax = "
               "1.0\nstage = \"uniform\"\ndoc = \"Softness.\"\n",
               "");
  const Technique technique =
      load(folder, replaced(without, "constraints", "include = [\"bias\"]\nconstraints"));
  EXPECT_EQ(std::get<double>(default_values(technique.parameters).at("softness")), 0.25);
  EXPECT_THAT(error_of(folder, replaced(without, "constraints", "include = [\"bais\"]\nconstraints")),
              AllOf(HasSubstr("there is no shared manifest 'bais'"), HasSubstr("'bias'")));
}

TEST(Manifest, ParameterGroupsMayBeginWithOthersButNotWithThemselves) {
  TechniqueFolder folder;
  folder.write_shared("outer.toml",
                      "include = [\"inner\"]\n[[parameter]]\nname = \"softness\"\ntype = "
                      "\"real\"\ndefault = 0.25\nmin = 0\nmax = 1\nstage = \"uniform\"\ndoc = \"x\"\n");
  const std::string manifest =
      replaced(whole_manifest(),
               "[[parameter]]\nname = \"softness\"\ntype = \"real\"\ndefault = 0.5\nmin = 0.0\nmax = "
               "1.0\nstage = \"uniform\"\ndoc = \"Softness.\"\n",
               "");
  const std::string grouped = replaced(manifest, "constraints", "include = [\"outer\"]\nconstraints");
  folder.write_shared("inner.toml",
                      "[[parameter]]\nname = \"unused\"\ntype = \"boolean\"\ndefault = true\nstage = "
                      "\"host\"\ndoc = \"x\"\n");
  EXPECT_THAT(error_of(folder, grouped), HasSubstr("host parameter 'unused' is never read"));
  folder.write_shared("inner.toml", "include = [\"outer\"]\n");
  EXPECT_THAT(error_of(folder, grouped),
              AllOf(HasSubstr("inner.toml:1"), HasSubstr("'outer' comes in a second time")));
}

TEST(Manifest, HashCoversManifestShadersAndGroupsButNotThePlace) {
  TechniqueFolder a;
  TechniqueFolder b;
  const std::string hash = load(a, whole_manifest()).hash;
  EXPECT_EQ(load(b, whole_manifest()).hash, hash);
  EXPECT_NE(load(b, replaced(whole_manifest(), "default = 4", "default = 5")).hash, hash);
  load(b, whole_manifest());
  b.write("resolve.frag", std::string(kFragment) + "// changed\n");
  EXPECT_NE(load_technique(b.path(), b.shared_folder(), TechniqueFolder::shaders_folder()).hash, hash);
}

TEST(Techniques, AreListedWithoutTheSharedFolder) {
  TechniqueFolder folder;
  load(folder, whole_manifest());
  folder.write_shared("bias.toml", "");
  const auto techniques = list_techniques(folder.techniques_folder(), TechniqueFolder::shaders_folder());
  ASSERT_EQ(techniques.size(), 1u);
  EXPECT_EQ(techniques[0].id, "tried");
}

TEST(Techniques, AreFoundByIdAndByPath) {
  TechniqueFolder folder;
  load(folder, whole_manifest());
  const auto found = [&](const std::string& name) {
    return find_technique(name, folder.techniques_folder(), TechniqueFolder::shaders_folder()).id;
  };
  EXPECT_EQ(found("tried"), "tried");
  EXPECT_EQ(found(folder.path().string()), "tried");
  try {
    found("treid");
    FAIL() << "found a technique that is not there";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("no technique 'treid'"), HasSubstr("'tried'")));
  }
}

TEST(Techniques, AreReadAgainOnlyWhenTheirFilesChanged) {
  TechniqueFolder folder;
  load(folder, whole_manifest());
  TechniqueCache cache(folder.techniques_folder(), TechniqueFolder::shaders_folder());
  const auto first = cache.find("tried");
  EXPECT_EQ(cache.find("tried"), first);
  folder.write("technique.toml", replaced(whole_manifest(), "default = 4", "default = 16"));
  EXPECT_EQ(cache.find("tried")->parameters.front().default_value, ParameterValue(int64_t{16}));
  folder.write("unused.glsl", "// new\n");
  EXPECT_NE(cache.find("tried")->hash, first->hash);
}

TEST(Parameters, ResolveDefaultsThenPresetThenOverrides) {
  TechniqueFolder folder;
  const Technique technique = load(folder, whole_manifest());
  const ParameterValues values =
      resolve_parameters(technique, {{"preset", std::string("fine")}, {"taps", int64_t{8}}});
  EXPECT_EQ(std::get<int64_t>(values.at("taps")), 8);         // override
  EXPECT_EQ(std::get<int64_t>(values.at("map_size")), 1024);  // preset
  EXPECT_EQ(std::get<double>(values.at("softness")), 0.5);    // default
}

TEST(Parameters, BadOverridesAreErrors) {
  TechniqueFolder folder;
  const Technique technique = load(folder, whole_manifest());
  const auto error = [&](const ParameterValues& overrides) -> std::string {
    try {
      resolve_parameters(technique, overrides);
    } catch (const Error& caught) {
      return caught.what();
    }
    return "no error";
  };
  EXPECT_THAT(error({{"tabs", int64_t{1}}}), AllOf(HasSubstr("no parameter 'tabs'"), HasSubstr("'taps'")));
  EXPECT_THAT(error({{"taps", int64_t{65}}}), HasSubstr("range"));
  EXPECT_THAT(error({{"taps", 1.5}}), HasSubstr("an integer"));
  EXPECT_THAT(error({{"preset", std::string("fin")}}),
              AllOf(HasSubstr("no preset 'fin'"), HasSubstr("'fine'")));
  EXPECT_THAT(error({{"taps", int64_t{64}}}), HasSubstr("taps <= map_size"));
}

TEST(Parameters, IntegersServeForRealParameters) {
  TechniqueFolder folder;
  const ParameterValues values =
      resolve_parameters(load(folder, whole_manifest()), {{"softness", int64_t{1}}});
  EXPECT_EQ(std::get<double>(values.at("softness")), 1.0);
}

// Every technique of ours must pass its own checks.
TEST(Techniques, OfTheLibraryLoad) {
  const auto realtime = source_dir() / "realtime";
  EXPECT_GE(list_techniques(realtime / "techniques").size(), 4u);
}

// A range of ours in metres would be wrong in centimetres.
TEST(Techniques, OfTheLibraryHaveNoRangeInWorldUnits) {
  for (const Technique& technique : list_techniques(source_dir() / "realtime" / "techniques")) {
    for (const Parameter& parameter : technique.parameters)
      EXPECT_EQ(parameter.unit == "world", parameter.is_relative_to_scene)
          << technique.id << " " << parameter.name;
  }
}

}  // namespace
}  // namespace umbrameter
