# SPDX-License-Identifier: Apache-2.0
# cpack reads this before it begins: it takes the times inside the packages from the environment.
set(ENV{SOURCE_DATE_EPOCH} ${CPACK_FRANA_EPOCH})
