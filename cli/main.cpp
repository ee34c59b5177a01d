// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.h"
#include "cli/console.h"
#include "cli/interruption.h"

#include <fmt/format.h>

#include <new>

int main(int argc, char** argv) {
  using namespace umbrameter;
  install_interruption_handler();
  try {
    CLI::App app;
    CommandLine line;
    const std::optional<int> exit_code = parse_command_line(argc, argv, app, line);
    return exit_code ? *exit_code : line.verb();
  } catch (const Error& error) {
    print_error(error.what());
    return exit_code(error.kind());
  } catch (const std::bad_alloc&) {
    print_error("not enough memory (try a smaller resolution)");
    return kExitEnvironment;
  } catch (const std::exception& error) {
    print_error(fmt::format("internal: {}", error.what()));
    return kExitInternal;
  }
}
