# SPDX-License-Identifier: Apache-2.0
# Installs the package far from the build, whose share it must not find, imports it from there and uses a preset.
execute_process(COMMAND mktemp -d OUTPUT_VARIABLE WORK OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
unset(ENV{FRANA_SHARE})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --component python --prefix ${WORK} RESULT_VARIABLE code
  OUTPUT_QUIET)
if(code)
  message(FATAL_ERROR "installing the package failed")
endif()
set(ENV{PYTHONPATH} ${WORK}/lib/python3/dist-packages)
set(ENV{PYTHONDONTWRITEBYTECODE} 1)
execute_process(COMMAND ${PYTHON} -c "import frana; print(frana.__file__, frana.__version__)" RESULT_VARIABLE code
  OUTPUT_VARIABLE out ERROR_VARIABLE out)
string(FIND "${out}" "${WORK}" place)
if(code OR NOT place EQUAL 0)
  message(FATAL_ERROR "the installed package is not imported: ${out}")
endif()
foreach(text __init__.py _frana.pyi py.typed)
  if(NOT EXISTS ${WORK}/lib/python3/dist-packages/frana/${text})
    message(FATAL_ERROR "${text} is not installed")
  endif()
endforeach()
execute_process(COMMAND ${PYTHON} -c "
import frana
import numpy
scene = frana.Scene(numpy.full((20, 30), 100.0) - 2 * numpy.arange(30), cell_size=4)
scene['material.preset'] = 'debris-flow'
scene.add_release(2.0, outline=[(20, -20), (60, -20), (60, -60), (20, -60)])
scene.check()
" RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE out)
file(REMOVE_RECURSE ${WORK})
if(code)
  message(FATAL_ERROR "the installed package does not work by itself: ${out}")
endif()
