// SPDX-License-Identifier: Apache-2.0
#pragma once
// What makes a manifest whole: every name means something, everything declared is used, what is read was
// written before.

#include "realtime/manifest/read_manifest.h"

namespace umbrameter {

/// Resources, views and passes: formats that fit their use, reads of what earlier passes wrote, nothing
/// unused, `visibility` written. Error{input} at the first fault.
void check_passes(const Technique& technique);

/// Whether a pass may leave some of what it writes as it was: triangles do between them, tests where they fail, and compute
/// shaders unless they say that they do not.
bool leaves_texels_out(const PassDeclaration& pass);

/// Nothing of an earlier frame but what passes with `once` wrote: each other read, and each drawing over what is there,
/// follows a write of the same frame. Error{input} at the first that does not.
void check_frames(const Technique& technique);

/// One meaning for each name that shaders see. check_passes() calls it.
void check_identifiers(const Technique& technique);

/// Views: origins and fits that go with the technique's lights and with each other. check_passes() calls it.
void check_views(const Technique& technique);

/// Parameters: each is read (define and uniform ones by `shader_tokens`, host ones by an expression or a
/// fit), presets name them, constraints hold for the defaults and every preset. Error{input} at the first
/// fault.
void check_parameters(const Manifest& manifest, const std::set<std::string, std::less<>>& shader_tokens);

/// The parameter values that break no constraint, or Error{input} naming the one that fails and what it sees.
void check_constraint(const Technique& technique, const Expression& constraint, const ParameterValues& values,
                      std::string_view of_what);

}  // namespace umbrameter
