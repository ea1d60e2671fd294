# SPDX-License-Identifier: Apache-2.0
# Who answers for what is handed out: in the Debian packages and in the plugin's metadata. Whoever packs says so by -D;
# the defaults are those of share/qgis/frana/metadata.txt, an address that no one has (RFC 6761, .invalid) and no page.
set(plugin_metadata ${PROJECT_SOURCE_DIR}/share/qgis/frana/metadata.txt)
foreach(pair author=FRANA_AUTHORS email=FRANA_CONTACT)
  string(REPLACE = ";" pair ${pair})
  list(GET pair 0 key)
  list(GET pair 1 variable)
  file(STRINGS ${plugin_metadata} line REGEX "^${key}=")
  string(REPLACE "${key}=" "" default_${variable} "${line}")
endforeach()
set(FRANA_AUTHORS ${default_FRANA_AUTHORS} CACHE STRING "Who answers for the packages and the plugin")
set(FRANA_CONTACT ${default_FRANA_CONTACT} CACHE STRING "Their address")
set(FRANA_HOMEPAGE "" CACHE STRING "Their page")

# filled_metadata(FILE): writes the plugin's metadata with them and with the version.
function(filled_metadata file)
  file(READ ${plugin_metadata} text)
  foreach(part AUTHORS CONTACT)
    string(REPLACE "=${default_FRANA_${part}}" "=${FRANA_${part}}" text "${text}")
  endforeach()
  if(FRANA_HOMEPAGE)
    string(APPEND text "homepage=${FRANA_HOMEPAGE}\n")
  endif()
  string(REGEX REPLACE "\nversion=[^\n]*" "\nversion=${PROJECT_VERSION}" text "${text}")
  file(GENERATE OUTPUT ${file} CONTENT "${text}")
endfunction()
