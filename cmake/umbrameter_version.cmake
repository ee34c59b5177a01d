# Puts version and commit into build/generated/umbrameter_version.h at configure time.
execute_process(COMMAND git -C "${CMAKE_SOURCE_DIR}" rev-parse --short=12 HEAD
                OUTPUT_VARIABLE UMBRAMETER_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT UMBRAMETER_COMMIT)
  set(UMBRAMETER_COMMIT "unknown")
endif()
configure_file("${CMAKE_SOURCE_DIR}/cmake/umbrameter_version.h.in"
               "${CMAKE_BINARY_DIR}/generated/umbrameter_version.h" @ONLY)
