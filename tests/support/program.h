// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <source_location>
#include <string>
#include <vector>

#include "core/json.h"

namespace frana::test {

/// With a sanitizer most of a program's memory is the sanitizer's.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool k_sanitized = true;
#else
inline constexpr bool k_sanitized = false;
#endif

/// The outcome of one call of the program.
struct Outcome {
    int exit_code = -1;
    std::string out;
    std::string err;
    double peak_memory_bytes = 0;  ///< largest resident set
    double cpu_seconds = 0;        ///< processor time of all its threads
};

/// Runs frana with these arguments in a folder and waits for it. With `signal_after_ms`, sends SIGINT then.
Outcome run_program(const std::string& folder, const std::vector<std::string>& arguments, int signal_after_ms = 0);

/// Returns the outcome of a call that ended with exit code 0; otherwise throws with what the program said, which fails
/// and ends the test. A refusal that is expected is compared by its exit code instead.
Outcome succeeded(const Outcome& outcome, const std::source_location& place = std::source_location::current());

/// Expects that a call was refused with exit code 2 and a message with these words; returns its outcome.
Outcome refusal_of(const Outcome& outcome, const std::vector<std::string>& words = {},
                   const std::source_location& place = std::source_location::current());

/// Words of a call with more after them.
std::vector<std::string> with_more(std::vector<std::string> words, const std::vector<std::string>& more);
/// The same with `--set` before each of these.
std::vector<std::string> with_sets(std::vector<std::string> words, const std::vector<std::string>& sets);

std::string read_text(const std::string& path);

/// Fails unless a text has all these words; the other: if it has one of them.
void expect_words(const std::string& text, const std::vector<std::string>& words);
void expect_no_words(const std::string& text, const std::vector<std::string>& words);

/// Fails the test if the text is no JSON.
Json parse_json(const std::string& text);
/// Returns the value in a JSON text by its name if only one value nearest the root has it, or by names that follow each
/// other ("runout.drop_m"). Fails the test if there is no such value, or more than one.
Json json_value(const std::string& json, const std::string& key);
/// The same as a text or a number; fails the test if it is none.
std::string json_text(const std::string& json, const std::string& key);
double json_number(const std::string& json, const std::string& key);
/// Whether there is such a value, object or list.
bool json_has(const std::string& json, const std::string& key);
/// Whether one text of a list contains these words.
bool json_lists(const std::string& json, const std::string& key, const std::string& words);

}  // namespace frana::test
