# SPDX-License-Identifier: Apache-2.0
# Installs the package, and imports it from there.
file(REMOVE_RECURSE ${WORK})
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
