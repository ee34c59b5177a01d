// SPDX-License-Identifier: Apache-2.0
#include "cli/stress_worker.h"

#include "cli/child_process.h"
#include "cli/exact_program.h"
#include "cli/exact_truth.h"
#include "cli/home.h"
#include "cli/reuse.h"
#include "core/clock.h"
#include "core/error.h"
#include "core/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <memory>
#include <thread>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

std::string with_edits(std::string text, const std::vector<ManifestEdit>& edits) {
  for (const ManifestEdit& edit : edits) {
    for (size_t at = text.find(edit.from); at != std::string::npos; at = text.find(edit.from, at))
      text.replace(at, edit.from.size(), edit.to), at += edit.to.size();
  }
  return text;
}

/// The home's techniques with edited manifests, in `folder`, beside the same shaders.
Home edited_home(const Home& home, const std::vector<ManifestEdit>& edits, const fs::path& folder) {
  const fs::path techniques = folder / "techniques";
  fs::remove_all(folder);
  create_folder(folder);
  fs::copy(home.techniques, techniques, fs::copy_options::recursive);
  fs::create_directory_symlink(home.shaders, folder / "shaders");
  for (const auto& entry : fs::recursive_directory_iterator(techniques)) {
    if (entry.path().extension() != ".toml") continue;
    write_file_atomically(entry.path(), with_edits(read_file(entry.path()), edits));
  }
  return {home.library, techniques, home.shaders, home.engines};
}

std::string key_of(const std::vector<ManifestEdit>& edits) {
  std::string key;
  for (const ManifestEdit& edit : edits) key += edit.from + "\n" + edit.to + "\n";
  return key;
}

/// A renderer for the manifests as they are, and one for the edits asked for last.
class EditedRenderers {
 public:
  EditedRenderers(const GlobalOptions& global, const fs::path& folder)
      : global_(global), folder_(folder), plain_{find_home(), {}, {}}, edited_{} {}

  const Home& home(const std::vector<ManifestEdit>& edits) { return made(edits).home; }

  Renderer& renderer(const std::vector<ManifestEdit>& edits) {
    Made& one = made(edits);
    if (!one.renderer) one.renderer = open_realtime_renderer(global_, one.home);
    return *one.renderer;
  }

 private:
  struct Made {
    Home home;
    std::string key;
    std::unique_ptr<Renderer> renderer;
  };

  Made& made(const std::vector<ManifestEdit>& edits) {
    if (edits.empty()) return plain_;
    const std::string key = key_of(edits);
    if (edited_.key == key) return edited_;
    edited_.renderer.reset();
    edited_ = {edited_home(plain_.home, edits, folder_ / "edited"), key, {}};
    return edited_;
  }

  const GlobalOptions& global_;
  fs::path folder_;
  Made plain_, edited_;
};

std::string last_line_of(const fs::path& log) {
  std::ifstream in(log);
  std::string last;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

fs::path journal_of(const fs::path& folder) {
  return folder / "journal.jsonl";
}

/// Waits for the worker's end, or for its silence: true when it was silent too long. `grown` is called when the journal has
/// grown.
bool is_hanging(ChildProcess& worker, const fs::path& journal, int timeout_s,
                const std::function<void()>& grown) {
  const auto size = [&] {
    std::error_code ignored;
    const auto bytes = fs::file_size(journal, ignored);
    return ignored ? uintmax_t{0} : bytes;
  };
  uintmax_t last_size = size();
  Clock::time_point last_growth = Clock::now();
  while (!worker.has_ended()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (const uintmax_t now = size(); now != last_size) {
      last_size = now;
      last_growth = Clock::now();
      grown();
    }
    if (seconds_since(last_growth) < timeout_s) continue;
    worker.kill();
    return true;
  }
  return false;
}

StressCell cell_of_end(const StressAxis& axis, const StressTask& task, bool hangs, int exit_code,
                       const std::string& last_words, int timeout_s) {
  StressCell cell;
  cell.axis = axis.name;
  cell.row = task.row;
  cell.value = task.value;
  cell.outcome = hangs ? StressOutcome::hang : StressOutcome::crash;
  cell.how = hangs ? fmt::format("nothing came of it in {} s", timeout_s)
                   : fmt::format("the process ended with {}{}{}", exit_code, last_words.empty() ? "" : ": ",
                                 last_words);
  return cell;
}

}  // namespace

std::vector<TechniqueRun> stress_techniques(const StressPlan& plan) {
  const Home home = find_home();
  if (plan.techniques.empty()) return all_techniques(home);
  std::vector<TechniqueRun> runs;
  for (const std::string& text : plan.techniques) {
    if (text.find(':') != std::string::npos && !fs::is_directory(text))
      fail_input(fmt::format("'{}' sets parameters, which is what axes do", text), {},
                 "name the technique alone");
    runs.push_back(choose_technique(text, {}, home));
    const auto same = std::ranges::count(runs, runs.back().label, &TechniqueRun::label);
    if (same > 1) fail_input(fmt::format("technique '{}' is named twice", runs.back().label));
  }
  return runs;
}

fs::path axis_folder(const fs::path& folder, const StressAxis& axis) {
  return folder / axis.name;
}

void work_on_axis(const StressAxis& axis, const StressPlan& plan, const GlobalOptions& global,
                  const fs::path& folder, bool keep_pictures, bool reuse) {
  die_with_parent();
  const fs::path place = axis_folder(folder, axis);
  EditedRenderers renderers(global, place);
  VerbCache cache = open_cache(global, global.out, reuse);
  const auto oracle_program = find_exact_program();
  const TruthOracle no_oracle = [](const Scene&, std::span<const ReceiverPoint>) { return std::nullopt; };
  const StressTools tools = {
      .techniques = stress_techniques(plan),
      .realtime = [&](const std::vector<ManifestEdit>& edits) -> Renderer& {
        return renderers.renderer(edits);
      },
      .choose =
          [&](const TechniqueRun& run, const std::vector<std::string>& assignments,
              const std::vector<ManifestEdit>& edits) {
            return choose_technique(run.technique, assignments, renderers.home(edits));
          },
      .reference = cache.reference(plan.picture),
      .oracle = oracle_program ? exact_truth(exact_oracle_of(*oracle_program)) : no_oracle};
  const JournalState done = read_journal(journal_of(place));
  JournalWriter journal(journal_of(place));
  SilentProgress silent;
  run_stress_axis(axis, plan, tools, place, keep_pictures, done, journal, silent);
}

std::vector<StressCell> watch_axis(const StressAxis& axis, const StressPlan& plan, const StressKeys& keys,
                                   Answers& answers, const std::vector<std::string>& arguments,
                                   const fs::path& folder, Progress& progress) {
  const fs::path place = axis_folder(folder, axis);
  create_folder(place);
  const fs::path journal = journal_of(place), log = place / "worker.log";
  fs::remove(journal);  // of an earlier run
  const size_t cells = cells_of(axis, keys.techniques.size());
  progress.begin(axis.name, cells);
  std::vector<StressCell> known = kept_cells(answers, axis, keys);
  progress.advance(known.size());
  if (known.size() == cells) {
    progress.end();
    sort_cells(known, axis, keys);
    return known;
  }
  for (const StressCell& cell : known) JournalWriter(journal).finish(cell);
  JournalTail tail(journal);
  tail.take();
  const auto keep_new = [&] {
    for (const StressCell& cell : tail.take()) keep_cell(answers, axis, keys, cell);
  };
  size_t told = known.size();
  while (true) {
    ChildProcess worker(arguments, log);
    const bool hangs = is_hanging(worker, journal, plan.timeout_s, keep_new);
    keep_new();
    JournalState state = read_journal(journal);
    progress.advance(state.cells.size() - told);
    told = state.cells.size();
    if (!hangs && worker.exit_code() == 0) {
      progress.end();
      sort_cells(state.cells, axis, keys);
      return std::move(state.cells);
    }
    const std::string last_words = last_line_of(log);
    if (!state.open)
      throw Error(ErrorKind::internal, fmt::format("axis '{}': a worker ended with {} between two cells: {}",
                                                   axis.name, worker.exit_code(), last_words));
    JournalWriter(journal).finish(
        cell_of_end(axis, *state.open, hangs, worker.exit_code(), last_words, plan.timeout_s));
  }
}

}  // namespace umbrameter
