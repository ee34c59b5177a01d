// SPDX-License-Identifier: Apache-2.0
#include "cli/interruption.h"

#include "cli/console.h"

#include <chrono>
#include <csignal>
#include <map>
#include <mutex>
#include <thread>

#include <unistd.h>

namespace umbrameter {
namespace {

struct Registry {
  std::mutex mutex;
  std::map<std::filesystem::path, TemporaryPlace> places;
  std::string note = "interrupted; nothing was written";
};

/// Never destroyed: the signal thread may still look at it while the process ends.
Registry& registry() {
  static auto* instance = new Registry;
  return *instance;
}

/// Another thread may be writing into the folder, so once may not be enough.
void remove_for_good(const TemporaryPlace& place) {
  constexpr int kTries = 50;
  std::error_code ignored;
  for (int i = 0; i < kTries; ++i) {
    remove_place(place);
    if (!std::filesystem::exists(place.folder, ignored)) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

[[noreturn]] void wait_for_signal(sigset_t signals) {
  int signal = 0;
  while (sigwait(&signals, &signal) != 0) continue;
  registry().mutex.lock();  // kept: nobody may register anything from here on
  for (const auto& [folder, place] : registry().places) remove_for_good(place);
  print_note(registry().note);
  _exit(128 + signal);
}

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

void install_interruption_handler() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM}) {
    if (!is_ignored(signal)) sigaddset(&signals, signal);
  }
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread(wait_for_signal, signals).detach();
}

void set_interruption_note(const std::string& note) {
  const std::lock_guard lock(registry().mutex);
  registry().note = note;
}

void remove_place(const TemporaryPlace& place) {
  std::error_code ignored;
  std::filesystem::remove_all(place.folder, ignored);
  for (const auto& parent : place.made_parents) std::filesystem::remove(parent, ignored);  // only when empty
}

RemovedOnInterruption::RemovedOnInterruption(const TemporaryPlace& place) : folder_(place.folder) {
  const std::lock_guard lock(registry().mutex);
  registry().places[folder_] = place;
}

RemovedOnInterruption::~RemovedOnInterruption() {
  const std::lock_guard lock(registry().mutex);
  registry().places.erase(folder_);
}

}  // namespace umbrameter
