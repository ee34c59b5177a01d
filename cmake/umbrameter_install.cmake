# SPDX-License-Identifier: Apache-2.0
# `cmake --install`: the program and its data (component `program`), headers and static libraries for other projects
# (component `development`). Programs find their data at ../share/umbrameter (core/data_folder.h), so the tree may be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
find_program(GZIP_PROGRAM gzip REQUIRED)

set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # what is installed must be built, not tests and benches

set(data_folder "${CMAKE_INSTALL_DATADIR}/umbrameter")
set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/umbrameter")
set(libraries core scenes metrics reference realtime engines store results lab study report)
list(TRANSFORM libraries PREPEND umbrameter_ OUTPUT_VARIABLE library_targets)

# What programs of this build tree read: the sources themselves.
file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/share")
file(CREATE_LINK "${CMAKE_SOURCE_DIR}" "${CMAKE_BINARY_DIR}/share/umbrameter" SYMBOLIC)

install(TARGETS umbrameter COMPONENT program)
install(TARGETS umbrameter-exact COMPONENT exact)  # a component of its own: GPL by what it links
install(DIRECTORY scenes/library DESTINATION "${data_folder}/scenes" COMPONENT program)
install(DIRECTORY realtime/techniques realtime/shaders DESTINATION "${data_folder}/realtime" COMPONENT program)
install(DIRECTORY engines DESTINATION "${data_folder}" COMPONENT program FILES_MATCHING PATTERN "*.toml" PATTERN "*.mjs"
        PATTERN "*.py" PATTERN "*.html" PATTERN "*.json" PATTERN "installed" EXCLUDE PATTERN "host" EXCLUDE)
install(DIRECTORY scripts/blender DESTINATION "${data_folder}/scripts" COMPONENT program FILES_MATCHING PATTERN "*.py"
        PATTERN __pycache__ EXCLUDE)
install(DIRECTORY studies suites DESTINATION "${data_folder}" COMPONENT program)
install(FILES README.md DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT program)
install(DIRECTORY docs/ DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT program)

# Made from what --help says, by the program itself.
set(manual "${CMAKE_BINARY_DIR}/generated/manual")
file(MAKE_DIRECTORY "${manual}")
set(manual_commands COMMAND umbrameter help --man > "${manual}/umbrameter.1"
                    COMMAND "${GZIP_PROGRAM}" -9 -n -k -f "${manual}/umbrameter.1")
foreach(shell bash zsh fish)
  list(APPEND manual_commands COMMAND umbrameter help --completions ${shell} > "${manual}/${shell}")
endforeach()
add_custom_command(OUTPUT "${manual}/umbrameter.1.gz" "${manual}/bash" "${manual}/zsh" "${manual}/fish" ${manual_commands}
                   DEPENDS umbrameter VERBATIM COMMENT "Writing the manual page and completions")
add_custom_target(umbrameter_manual ALL DEPENDS "${manual}/umbrameter.1.gz")
configure_file(packaging/debian/umbrameter-exact.1 "${manual}/umbrameter-exact.1" COPYONLY)
execute_process(COMMAND "${GZIP_PROGRAM}" -9 -n -k -f "${manual}/umbrameter-exact.1" COMMAND_ERROR_IS_FATAL ANY)
install(FILES "${manual}/umbrameter-exact.1.gz" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT exact)
install(FILES "${manual}/umbrameter.1.gz" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT program)
install(FILES "${manual}/bash" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" RENAME umbrameter
        COMPONENT program)
install(FILES "${manual}/zsh" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions" RENAME _umbrameter
        COMPONENT program)
install(FILES "${manual}/fish" DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d" RENAME umbrameter.fish
        COMPONENT program)

install(TARGETS ${library_targets} EXPORT umbrameter-targets COMPONENT development)
foreach(room IN LISTS libraries)
  install(DIRECTORY ${room} DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/umbrameter" COMPONENT development
          FILES_MATCHING PATTERN "*.h" PATTERN "reference/exact" EXCLUDE PATTERN "assets" EXCLUDE
          PATTERN "techniques" EXCLUDE PATTERN "shaders" EXCLUDE PATTERN "library" EXCLUDE)
endforeach()
install(EXPORT umbrameter-targets NAMESPACE umbrameter:: DESTINATION "${package_folder}" COMPONENT development)
configure_package_config_file(cmake/umbrameter-config.cmake.in "${CMAKE_BINARY_DIR}/generated/umbrameter-config.cmake"
                              INSTALL_DESTINATION "${package_folder}" PATH_VARS CMAKE_INSTALL_DATADIR)
write_basic_package_version_file("${CMAKE_BINARY_DIR}/generated/umbrameter-config-version.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_BINARY_DIR}/generated/umbrameter-config.cmake"
              "${CMAKE_BINARY_DIR}/generated/umbrameter-config-version.cmake"
        DESTINATION "${package_folder}" COMPONENT development)
set(pkgconfig_folder "lib/${CMAKE_LIBRARY_ARCHITECTURE}/pkgconfig")  # Debian's, which a cross compiler finds
cmake_path(NORMAL_PATH pkgconfig_folder)
file(RELATIVE_PATH prefix_from_pc "/${pkgconfig_folder}" "/")
configure_file(cmake/umbrameter.pc.in "${CMAKE_BINARY_DIR}/generated/umbrameter.pc" @ONLY)
install(FILES "${CMAKE_BINARY_DIR}/generated/umbrameter.pc" DESTINATION "${pkgconfig_folder}"
        COMPONENT development)

if(TARGET umbrameter_python)
  install(TARGETS umbrameter_python DESTINATION "lib/python3/dist-packages/umbrameter" COMPONENT python)
  install(DIRECTORY python/umbrameter/ DESTINATION "lib/python3/dist-packages/umbrameter" COMPONENT python
          PATTERN "__pycache__" EXCLUDE)
endif()

include(umbrameter_package)
