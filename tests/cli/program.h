// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::test {

/// Under a sanitizer most of a program's memory is the sanitizer's.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool k_sanitized = true;
#else
inline constexpr bool k_sanitized = false;
#endif

/// What one call of the program did.
struct Outcome {
    int exit_code = -1;
    std::string out;
    std::string err;
    double peak_memory_bytes = 0;  ///< largest resident set
};

/// Runs frana with these arguments in a folder and waits for it. With `signal_after_ms`, sends SIGINT then.
Outcome run_program(const std::string& folder, const std::vector<std::string>& arguments, int signal_after_ms = 0);

std::string read_text(const std::string& path);

/// The value in a JSON text by its path ("runout.drop_m"), or by its name where only one value nearest the root has it;
/// "null" where it is null. Fails the test where the text is no JSON, or has no such value, or more than one.
std::string json_text(const std::string& json, const std::string& key);
/// The same as a number; fails the test where it is none.
double json_number(const std::string& json, const std::string& key);
/// Whether there is such a value, object or list.
bool json_has(const std::string& json, const std::string& key);

}  // namespace frana::test
