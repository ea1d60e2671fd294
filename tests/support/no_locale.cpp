// SPDX-License-Identifier: Apache-2.0
// Part of every test program: the machine's locale changes nothing.
#include <cstdlib>

namespace {

[[maybe_unused]] const int k_is_set = ::setenv("LC_ALL", "C.UTF-8", 1);

}  // namespace
