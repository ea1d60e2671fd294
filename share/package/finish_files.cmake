# SPDX-License-Identifier: Apache-2.0
# Run when the files of the packages are in place: packs the manual pages and gives all files the same time.
execute_process(COMMAND find ${CPACK_TEMPORARY_INSTALL_DIRECTORY} -path */share/man/* -type f -exec gzip -9nf {} +
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND find ${CPACK_TEMPORARY_INSTALL_DIRECTORY} -exec touch -h -d @${CPACK_FRANA_EPOCH} {} +
  COMMAND_ERROR_IS_FATAL ANY)
