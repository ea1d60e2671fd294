// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::test {

/// Returns the part of a result's or study's file that does not depend on when, on what machine and with how many
/// interruptions it is made: its bytes without the time of day, the duration, the number of threads and the memory; of
/// a log and a report only whether there is one.
std::string lasting_bytes(const std::string& file);

/// The same, without a summary's warnings.
std::string lasting_bytes_but_warnings(const std::string& file);

}  // namespace frana::test
