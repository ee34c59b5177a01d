# SPDX-License-Identifier: Apache-2.0
# `cpack -G DEB` in the build folder: one Debian package a component. Dependencies come from the libraries that are linked.
set(CPACK_PACKAGE_NAME umbrameter)
set(CPACK_PACKAGE_VENDOR "Umbrameter")
set(CPACK_PACKAGE_CONTACT "Umbrameter maintainers <maintainers@umbrameter.invalid>")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "measure how wrong a real-time shadow is, why, and its cost")
set(CPACK_PACKAGE_DESCRIPTION
"Renders a scene with a shadow technique in OpenGL and with a ray tracer that
samples the area light until it knows its own error, and compares both pixel
by pixel, with confidence intervals. Pictures of other renderers can be scored.")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "${CPACK_PACKAGE_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${CMAKE_SOURCE_DIR}/LICENSE")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
    WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program exact development)
if(TARGET umbrameter_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME umbrameter)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "libegl1, libgl1, libgl1-mesa-dri")  # opened at run time
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "umbrameter-exact, fonts-dejavu-core")
set(CPACK_DEBIAN_EXACT_PACKAGE_NAME umbrameter-exact)
set(CPACK_DEBIAN_EXACT_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_EXACT_DESCRIPTION "exact oracle of Umbrameter
Answers 'umbrameter reference --exact-check' in exact arithmetic. Links CGAL's
arrangements and is therefore under the GNU General Public License.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-umbrameter)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "umbrameter, python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-pandas, python3-matplotlib")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Python module of Umbrameter
Scenes, truths, shadow techniques and scores with intervals and fault classes
on numpy arrays.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libumbrameter-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "headers and static libraries of Umbrameter
Headers, static libraries, CMake package and pkg-config file to render truths,
run shadow techniques and score pictures from another program.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libglm-dev, libfmt-dev, libtbb-dev, libembree-dev, libopenimageio-dev, nlohmann-json3-dev, libsqlite3-dev, libzstd-dev, libassimp-dev, libpugixml-dev, libxxhash-dev, libnlopt-dev, libnlopt-cxx-dev, libepoxy-dev, libegl-dev, zlib1g-dev")

# What Debian asks of every package: copyright and changelog.
foreach(pair IN ITEMS program:umbrameter exact:umbrameter-exact development:libumbrameter-dev python:python3-umbrameter)
  string(REGEX MATCH "^[^:]+" component "${pair}")
  string(REGEX MATCH "[^:]+$" package "${pair}")
  set(copyright copyright)
  if(component STREQUAL "exact")
    set(copyright copyright-exact)
  endif()
  install(FILES "${CMAKE_SOURCE_DIR}/packaging/debian/${copyright}" RENAME copyright DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}"
          COMPONENT ${component})
  install(FILES "${CMAKE_BINARY_DIR}/generated/changelog.gz" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}"
          COMPONENT ${component})
endforeach()
configure_file(packaging/debian/changelog.in "${CMAKE_BINARY_DIR}/generated/changelog" @ONLY)
execute_process(COMMAND "${GZIP_PROGRAM}" -9 -n -k -f "${CMAKE_BINARY_DIR}/generated/changelog" COMMAND_ERROR_IS_FATAL ANY)
include(CPack)
