// SPDX-License-Identifier: Apache-2.0
#include "study/selftest/kept_trials.h"

#include "core/hash.h"
#include "lab/keys.h"
#include "store/code_hashes.h"

namespace umbrameter {

std::string trial_key(const Stage& stage, const std::string& kind, const std::string& name) {
  const SelftestSettings& settings = stage.settings();
  const std::string surfaces = parity_key(
      reference_key(stage.scene(), quality_of(settings, stage.round()), settings.makers), settings.makers);
  Hasher hasher;
  hasher.text("selftest").text(kSelftestCodeHash).text(settings.techniques_hash);
  return hasher.text(surfaces).text(stage.name()).text(kind).text(name).hex();
}

}  // namespace umbrameter
