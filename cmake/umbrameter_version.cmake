# SPDX-License-Identifier: Apache-2.0
# cmake -DSOURCE_DIR=... -DOUTPUT=... -DVERSION=... -P umbrameter_version.cmake: writes the constants of core/version.h.
# Run by every build, so that a result never carries the commit of an earlier one.
execute_process(COMMAND git -C "${SOURCE_DIR}" describe --always --dirty --abbrev=12 --exclude=*
                OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT COMMIT)
  set(COMMIT "unknown")
endif()
# Written only when it changes.
configure_file("${CMAKE_CURRENT_LIST_DIR}/umbrameter_version.cpp.in" "${OUTPUT}" @ONLY)
