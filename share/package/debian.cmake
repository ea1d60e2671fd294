# SPDX-License-Identifier: Apache-2.0
# Debian packages of the components: the target `packages` writes build/packages/*.deb, the same bytes from the same
# sources in whatever folder. ./build.sh package does all that it needs.
# Time of all files in the packages: the day of the version. SOURCE_DATE_EPOCH overrides it.
set(epoch 1795478400)
if(NOT "$ENV{SOURCE_DATE_EPOCH}" STREQUAL "")
  set(epoch $ENV{SOURCE_DATE_EPOCH})
endif()

set(ENV{SOURCE_DATE_EPOCH} ${epoch})
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(changelog.in changelog @ONLY)
execute_process(COMMAND gzip -9nc changelog OUTPUT_FILE changelog.gz WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}
  COMMAND_ERROR_IS_FATAL ANY)

# debian_package(COMPONENT SUMMARY TEXT [SECTION NAME] [DEPENDS NAMES] [RECOMMENDS NAMES] [SUGGESTS NAMES] [NAME NAME]
# [CODE]): NAME, else frana-COMPONENT. CODE: for one kind of processor, with dependencies by dpkg-shlibdeps.
macro(debian_package component summary text)
  cmake_parse_arguments(arg "CODE" "NAME;SECTION;DEPENDS;RECOMMENDS;SUGGESTS" "" ${ARGN})
  string(TOUPPER ${component} key)
  set(name frana-${component})
  if(arg_NAME)
    set(name ${arg_NAME})
  endif()
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${summary}\n${text}")
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION science)
  if(arg_SECTION)
    set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${arg_SECTION})
  endif()
  foreach(relation DEPENDS RECOMMENDS SUGGESTS)
    set(CPACK_DEBIAN_${key}_PACKAGE_${relation} "${arg_${relation}}")
  endforeach()
  if(arg_CODE)
    set(CPACK_DEBIAN_${key}_PACKAGE_SHLIBDEPS ON)
  else()
    set(CPACK_DEBIAN_${key}_PACKAGE_ARCHITECTURE all)
  endif()
  install(FILES copyright ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name}
    COMPONENT ${component} EXCLUDE_FROM_ALL)
endmacro()

set(same "frana (= ${PROJECT_VERSION})")
debian_package(program "run-out of landslides: from GIS files to hazard maps"
  "How far, how deep and how fast a failed slope runs: terrain, outline, thickness
and material in, GeoTIFFs, maps and animations out. Depth-averaged material
point method for landslides, debris flows, rock avalanches and dense snow
avalanches." NAME frana CODE
  DEPENDS "fonts-dejavu-core, libjs-leaflet" RECOMMENDS "frana-pictures, frana-studies"
  SUGGESTS "frana-samples, frana-doc, frana-mpi, qgis")
debian_package(pictures "run-out of landslides: maps, views and animations"
  "The parts of frana that draw maps and views and write animations. Without them
frana writes rasters, outlines and tables." CODE DEPENDS ${same})
debian_package(studies "run-out of landslides: many runs with uncertain values"
  "The part of frana that draws the values of ensembles and calibrations." CODE DEPENDS ${same})
debian_package(mpi "run-out of landslides: studies on many machines"
  "The part of frana that shares the runs of a study between the processes that
mpirun or srun started." CODE DEPENDS "${same}, openmpi-bin" RECOMMENDS frana-studies)
debian_package(samples "run-out of landslides: sample scenes"
  "Scenes to try frana with, on synthetic terrain: a hillside, a flume, blocks
that fracture." RECOMMENDS frana)
debian_package(doc "run-out of landslides: documents"
  "The models and their limits, input, results, maps, ensembles, calibration,
validation." SECTION doc SUGGESTS frana)
debian_package(qgis "run-out of landslides: plugin for QGIS"
  "frana's commands as algorithms of the Processing toolbox. 'frana qgis-plugin
--install' puts them into a user's profile." DEPENDS frana RECOMMENDS qgis)

if(TARGET frana_library)
  set(library libfrana${PROJECT_VERSION_MAJOR})
  debian_package(library "run-out of landslides: library"
    "The engine of frana for other programs: a scene in, a result out." NAME ${library} SECTION libs CODE
    SUGGESTS frana)
  # Written here: CPack would look for such a line in every package, and warn of the modules, which have no soname.
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/shlibs "libfrana ${PROJECT_VERSION_MAJOR} ${library} (= ${PROJECT_VERSION})\n")
  set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_SOURCE_DIR}/triggers
    ${CMAKE_CURRENT_BINARY_DIR}/shlibs)
  debian_package(dev "run-out of landslides: header of the library"
    "The header of the engine of frana, and what CMake needs to find it." NAME libfrana-dev SECTION libdevel
    DEPENDS "${library} (= ${PROJECT_VERSION})")
  set(CPACK_DEBIAN_DEV_PACKAGE_ARCHITECTURE)
endif()
if(TARGET frana_python)
  find_package(Python REQUIRED COMPONENTS Interpreter)
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  debian_package(python "run-out of landslides: Python module"
    "The engine of frana for Python: scenes and results as arrays of NumPy." NAME python3-frana SECTION python CODE
    DEPENDS "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next}), python3-numpy"
    SUGGESTS frana)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_PACKAGE_NAME frana)
set(CPACK_PACKAGE_CONTACT "${FRANA_AUTHORS} <${FRANA_CONTACT}>")
if(FRANA_HOMEPAGE)
  set(CPACK_DEBIAN_PACKAGE_HOMEPAGE ${FRANA_HOMEPAGE})
endif()
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
  WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_SOURCE_DIR}/before_packing.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_SOURCE_DIR}/finish_files.cmake)
set(CPACK_FRANA_EPOCH ${epoch})
set(CMAKE_SKIP_PACKAGE_ALL_DEPENDENCY ON)
include(CPack)
add_custom_target(packages COMMAND ${CMAKE_CPACK_COMMAND} --config ${CMAKE_BINARY_DIR}/CPackConfig.cmake
  WORKING_DIRECTORY ${CMAKE_BINARY_DIR} VERBATIM)
add_dependencies(packages ${code} generated_docs)
