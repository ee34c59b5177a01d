# SPDX-License-Identifier: Apache-2.0
# cmake -DSOURCE_DIR=... -DOUTPUT=... -P code_hashes.cmake: writes store/code_hashes.h's constants. Comments and
# formatting count, too: an edit that changes nothing costs a rendering, a change that goes unnoticed costs a wrong number.
function(hash_rooms variable)
  set(text "")
  foreach(room IN LISTS ARGN)
    file(GLOB_RECURSE files RELATIVE "${SOURCE_DIR}" "${SOURCE_DIR}/${room}/*.cpp" "${SOURCE_DIR}/${room}/*.h"
         "${SOURCE_DIR}/${room}/CMakeLists.txt")
    list(SORT files)
    foreach(file IN LISTS files)
      file(SHA256 "${SOURCE_DIR}/${file}" hash)
      string(APPEND text "${file} ${hash}\n")
    endforeach()
  endforeach()
  string(SHA256 hash "${text}")
  set(${variable} "${hash}" PARENT_SCOPE)
endfunction()

hash_rooms(reference core scenes reference)
hash_rooms(realtime core scenes realtime engines)
hash_rooms(scoring core metrics study)
set(text "#include \"store/code_hashes.h\"

namespace umbrameter {

const char* const kReferenceCodeHash = \"${reference}\";
const char* const kRealtimeCodeHash = \"${realtime}\";
const char* const kScoringCodeHash = \"${scoring}\";

}  // namespace umbrameter
")
# Written only when it changes, so that nothing is compiled for nothing.
file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT "${text}" @ONLY)
