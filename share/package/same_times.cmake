# SPDX-License-Identifier: Apache-2.0
# Run when the files of the packages are in place: gives all of them the same time.
execute_process(COMMAND find ${CPACK_TEMPORARY_INSTALL_DIRECTORY} -exec touch -h -d @${CPACK_FRANA_EPOCH} {} +
  COMMAND_ERROR_IS_FATAL ANY)
