// SPDX-License-Identifier: Apache-2.0
#pragma once
// The manual page and the completions of shells, made from what --help is made from.

#include <CLI/CLI.hpp>

#include <string>

namespace umbrameter {

/// roff for man(1): every verb with its options, exit codes, environment and files.
std::string manual_page(const CLI::App& app);

/// A script for "bash", "zsh" or "fish" that completes verbs, options, names of scenes and of techniques; Error{input} for
/// other shells.
std::string completions(const CLI::App& app, const std::string& shell);

}  // namespace umbrameter
