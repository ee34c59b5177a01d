# SPDX-License-Identifier: Apache-2.0
# cmake -D OUTPUT=file.cpp -D ASSETS=a;b -P embed_assets.cmake: defines report_asset(name) (report/assets.h).
set(text "#include \"report/assets.h\"\n\n#include \"core/error.h\"\n\nnamespace umbrameter {\nnamespace {\n")
set(table "")
set(index 0)
foreach(asset IN LISTS ASSETS)
  get_filename_component(name "${asset}" NAME)
  file(READ "${asset}" hex HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
  string(APPEND text "const unsigned char kAsset${index}[] = {${bytes}0};\n")
  string(APPEND table "  if (name == \"${name}\") return {reinterpret_cast<const char*>(kAsset${index}), sizeof(kAsset${index}) - 1};\n")
  math(EXPR index "${index} + 1")
endforeach()
string(APPEND text "}  // namespace\n\nstd::string_view report_asset(std::string_view name) {\n${table}"
                   "  UMBRAMETER_ASSERT(false, \"no report asset '{}'\", name);\n  return {};\n}\n\n}  // namespace umbrameter\n")
file(WRITE "${OUTPUT}" "${text}")
