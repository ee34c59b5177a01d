# SPDX-License-Identifier: Apache-2.0
# cmake -DSOURCE_DIR=... -DOUTPUT=... -P code_hashes.cmake: writes store/code_hashes.h's constants, of what computes numbers and
# nothing else: not how results are written (but for the rows of the catalogue), not what report and cli do. Comments
# and formatting count, too: an edit that changes nothing costs a rendering, a change that goes unnoticed costs a wrong number.
# hash_code(<variable> <room or file without its ending>...)
# scenes/altered makes scenes that keys know by their own hash: it counts only where it is named.
function(hash_code variable)
  set(text "")
  foreach(name IN LISTS ARGN)
    set(code "${SOURCE_DIR}/${name}")
    file(GLOB_RECURSE files RELATIVE "${SOURCE_DIR}" "${code}/*.cpp" "${code}/*.h" "${code}/CMakeLists.txt")
    file(GLOB own_files RELATIVE "${SOURCE_DIR}" "${code}.cpp" "${code}.h")
    list(APPEND files ${own_files})
    if(name STREQUAL "scenes")
      list(FILTER files EXCLUDE REGEX "^scenes/altered/")
    endif()
    list(LENGTH files count)
    if(count EQUAL 0)
      message(FATAL_ERROR "there is no code called ${name}")
    endif()
    list(SORT files)
    foreach(file IN LISTS files)
      file(SHA256 "${SOURCE_DIR}/${file}" hash)
      string(APPEND text "${file} ${hash}\n")
    endforeach()
  endforeach()
  string(SHA256 hash "${text}")
  set(${variable} "${hash}" PARENT_SCOPE)
endfunction()

hash_code(reference core scenes reference)
hash_code(realtime core scenes realtime engines)
hash_code(scoring core metrics lab results/measured_rows)
hash_code(regress metrics lab results/catalogue results/measured_rows results/regress study/regress)
hash_code(selftest metrics lab results/catalogue results/measured_rows results/selftest scenes/altered/scene_change study/stage study/fault_case study/selftest)
hash_code(traits study/traits)
hash_code(stress metrics lab results/catalogue results/measured_rows results/stress scenes/altered/stress study/stress)
hash_code(tune metrics lab results/catalogue results/measured_rows results/tune study/tune)
set(text "#include \"store/code_hashes.h\"

namespace umbrameter {

const char* const kReferenceCodeHash = \"${reference}\";
const char* const kRealtimeCodeHash = \"${realtime}\";
const char* const kScoringCodeHash = \"${scoring}\";
const char* const kRegressCodeHash = \"${regress}\";
const char* const kSelftestCodeHash = \"${selftest}\";
const char* const kTraitsCodeHash = \"${traits}\";
const char* const kStressCodeHash = \"${stress}\";
const char* const kTuneCodeHash = \"${tune}\";

}  // namespace umbrameter
")
# Written only when it changes, so that nothing is compiled for nothing.
file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT "${text}" @ONLY)
