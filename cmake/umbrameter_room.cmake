# SPDX-License-Identifier: Apache-2.0
# umbrameter_room(<name> [LINKS ...] [PRIVATE_LINKS ...]): one static library a room; its sources are the folder,
# less subfolders that have a CMakeLists.txt of their own.
# The include root is the repository, so an include path shows the room: #include "metrics/image/parity.h".
# umbrameter_options(<target>): the warnings and sanitizers every target of ours is built with.

function(umbrameter_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                                           -Woverloaded-virtual -Wnull-dereference)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-restrict)  # false alarms in std::string at -O3, GCC bug 105651
  endif()
  if(UMBRAMETER_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(UMBRAMETER_SANITIZE)
    # Bad pointers end in the address sanitizer anyway; to check each for null, alignment and type, too, doubles the
    # time to compile.
    target_compile_options(${target} PUBLIC -fsanitize=address,undefined -fno-sanitize=null,alignment,object-size,vptr
                                            -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
  if(UMBRAMETER_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# Clang reads the headers of most files once a room. Other builds do without: there every file must name what it uses.
function(umbrameter_precompile target)
  if(UMBRAMETER_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    target_precompile_headers(${target} PRIVATE <fmt/format.h> <glm/geometric.hpp> <glm/mat4x4.hpp> <nlohmann/json.hpp>
      <algorithm> <array> <cmath> <filesystem> <functional> <map> <optional> <span> <string> <vector>)
    target_compile_options(${target} PRIVATE "SHELL:-Xclang -fno-pch-timestamp")  # else ccache keeps none
  endif()
endfunction()

# Reading headers is most of a small file's compile time. Names of one file shadow nothing in another, and GCC 12 sees null
# pointers in what it inlines then that are not there.
function(umbrameter_unite target)
  if(UMBRAMETER_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
    target_compile_options(${target} PRIVATE -Wno-shadow -Wno-null-dereference)
  endif()
endfunction()

function(umbrameter_room name)
  cmake_parse_arguments(ROOM "" "" "LINKS;PRIVATE_LINKS" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
  file(GLOB own_targets CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*/CMakeLists.txt")
  foreach(own_target IN LISTS own_targets)
    get_filename_component(folder "${own_target}" DIRECTORY)
    list(FILTER sources EXCLUDE REGEX "^${folder}/")
  endforeach()
  add_library(umbrameter_${name} STATIC ${sources})
  target_include_directories(umbrameter_${name} PUBLIC "$<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}>"
                             "$<INSTALL_INTERFACE:include/umbrameter>")
  set_target_properties(umbrameter_${name} PROPERTIES EXPORT_NAME ${name})
  target_link_libraries(umbrameter_${name} PUBLIC ${ROOM_LINKS} PRIVATE ${ROOM_PRIVATE_LINKS})
  umbrameter_options(umbrameter_${name})
  umbrameter_precompile(umbrameter_${name})
  umbrameter_unite(umbrameter_${name})
endfunction()
