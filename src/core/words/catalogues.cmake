# SPDX-License-Identifier: Apache-2.0
# The catalogues of texts, share/po/*.po: msgfmt checks and compiles them, and the assembler puts them into the program.
# embedded_catalogues() of src/core/words/words.h is written here.
find_package(Gettext REQUIRED)
set(po_folder ${CMAKE_BINARY_DIR}/generated/po)
file(MAKE_DIRECTORY ${po_folder})
file(GLOB po_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/share/po/*.po)
foreach(po ${po_files})
  cmake_path(GET po STEM code)
  set(mo ${po_folder}/${code}.mo)
  add_custom_command(OUTPUT ${mo} COMMAND ${GETTEXT_MSGFMT_EXECUTABLE} --check --no-hash --output-file=${mo} ${po}
    DEPENDS ${po} VERBATIM)
  list(APPEND mo_files ${mo})
  string(APPEND po_bytes "frana_po_${code}: .incbin \"${mo}\"\nfrana_po_${code}_end:\n")
  string(APPEND po_names "extern const char frana_po_${code}[], frana_po_${code}_end[];\n")
  string(APPEND po_rows "    {\"${code}\", {frana_po_${code}, frana_po_${code}_end}},\n")
endforeach()
file(CONFIGURE OUTPUT ${po_folder}/embedded_catalogues.cpp @ONLY CONTENT [[
// Written by src/core/words/catalogues.cmake.
#include "core/words/words.h"

asm(R"(.pushsection .rodata
@po_bytes@.popsection)");
extern "C" {
@po_names@}

namespace frana {

std::span<const EmbeddedCatalogue> embedded_catalogues() {
    static const EmbeddedCatalogue k_all[]{
@po_rows@    };
    return k_all;
}

}  // namespace frana
]])
# Not compiled with others: the catalogues are read when it is.
set_source_files_properties(${po_folder}/embedded_catalogues.cpp PROPERTIES
  OBJECT_DEPENDS "${mo_files}" SKIP_UNITY_BUILD_INCLUSION ON)
target_sources(core PRIVATE ${po_folder}/embedded_catalogues.cpp)
