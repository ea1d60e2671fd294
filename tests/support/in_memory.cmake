# SPDX-License-Identifier: Apache-2.0
# ctest reads this before it starts anything: files of tests are in memory, where a sync waits for no disk, if that has
# room for the largest of them.
if(NOT DEFINED ENV{TMPDIR} AND IS_DIRECTORY /dev/shm)
  execute_process(COMMAND df --output=avail --block-size=1M /dev/shm OUTPUT_VARIABLE free ERROR_QUIET)
  string(REGEX MATCH "[0-9]+" free "${free}")
  if(free GREATER 8000)
    set(ENV{TMPDIR} /dev/shm)
  endif()
endif()
