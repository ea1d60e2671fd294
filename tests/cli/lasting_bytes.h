// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::test {

/// What of a result's or study's file is the same whenever, on whatever and however often interrupted it is
/// made: its bytes without what tells the time of day, how long it took, on how many threads and in how much
/// memory; of a log and a report only whether there is one.
std::string lasting_bytes(const std::string& file);

/// The same, without what a summary says went wrong on the way.
std::string lasting_bytes_but_warnings(const std::string& file);

}  // namespace frana::test
