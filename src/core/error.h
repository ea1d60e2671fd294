// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/words/sentence.h"

namespace frana {

/// Returns a remedy for the user after a system call failed for this reason (errno), as a sentence without its full
/// stop.
std::string system_remedy(int reason);

/// Many similar messages: the first few of each kind are kept, the rest are counted.
class CountedTexts {
  public:
    void add(const std::string& kind, const Sentence& text);

    /// Returns, in order of first occurrence, the first texts of each kind, then "and 497 more like it".
    [[nodiscard]] std::vector<Sentence> texts() const;

  private:
    struct Kind {
        std::string name;
        std::vector<Sentence> first;
        std::int64_t more = 0;
    };
    std::vector<Kind> kinds_;
};

/// The kind of error; determines the program's exit code.
enum class ErrorKind {
    input,        ///< usage, configuration or input data: nothing was computed (exit code 2)
    numerical,    ///< the computation failed, the last state was written (exit code 3)
    environment,  ///< disk full, unwritable output, missing font (exit code 4)
};

/// Where a problem is, for people and, in parts, for programs.
struct Place {
    Place() = default;
    /// A file, or an option: "--threads".
    Place(std::string words) : text(std::move(words)) {  // NOLINT(google-explicit-constructor)
        text.starts_with("--") ? option = text.substr(0, text.find(' ')) : file = text;
    }
    /// An option, or words: "command line".
    Place(const char* words) : Place(std::string(words)) { file.clear(); }  // NOLINT(google-explicit-constructor)
    /// A key in a file.
    Place(const std::string& in_file, const std::string& of_key)
        : text(in_file + ": " + of_key), file(in_file), key(of_key) {}
    /// A key with what is before it: "--set " or "study.ini: ".
    static Place given(const std::string& before, const std::string& of_key);

    operator const std::string&() const { return text; }  // NOLINT(google-explicit-constructor)
    [[nodiscard]] bool empty() const noexcept { return text.empty(); }
    /// Adds words.
    Place& operator+=(const std::string& more) { return text += more, *this; }
    friend Place operator+(Place place, const std::string& more) { return std::move(place += more); }
    bool operator==(const Place& other) const { return text == other.text; }

    std::string text;               ///< "scene.ini: material.friction-coefficient"
    std::string file, key, option;  ///< empty: not known
};

/// One problem, in words for the user: what, where, the value, the limit it violates, the remedy. Empty parts are
/// omitted from the message.
struct Problem {
    std::string what;  ///< "basal friction coefficient is out of range"
    Place where;
    std::string value;   ///< "3.2"
    std::string limit;   ///< "0 to 2"
    std::string remedy;  ///< "typical values are 0.05 to 0.4"
};

/// One line: "where: what (value V; allowed L). Remedy."
std::string describe(const Problem& problem);

/// The only exception frana throws for problems of the user's input and of the environment; thrown during set-up and
/// I/O, caught in main.
class Error : public std::runtime_error {
  public:
    Error(ErrorKind kind, std::vector<Problem> problems);
    Error(ErrorKind kind, Problem problem);

    [[nodiscard]] ErrorKind kind() const noexcept { return kind_; }
    [[nodiscard]] const std::vector<Problem>& problems() const noexcept { return problems_; }

  private:
    ErrorKind kind_;
    std::vector<Problem> problems_;
};

/// Collects all problems of a scene so that they are reported in one pass.
class Problems {
  public:
    /// One that is there already is not added again.
    void add(Problem problem);
    void add(const Problems& others) {
        for (const Problem& problem : others.list_) add(problem);
    }
    /// Adds the problems of an Error of kind input; rethrows any other kind.
    void add(const Error& error);
    [[nodiscard]] bool empty() const noexcept { return list_.empty(); }
    [[nodiscard]] const std::vector<Problem>& list() const noexcept { return list_; }
    /// Throws Error(input) with all collected problems, if there are any.
    void throw_if_any() const;

  private:
    std::vector<Problem> list_;
};

/// Returns what `work` returns, or that type's empty value after an Error, with which `told` is called. Work that
/// returns nothing: returns whether it was done. Throws what `told` throws.
template <class Told, class Work>
requires std::invocable<const Told&, const Error&>
auto attempt(const Told& told, const Work& work) {
    if constexpr (std::is_void_v<decltype(work())>) {
        return attempt(told, [&] { return work(), true; });
    } else {
        try {
            return work();
        } catch (const Error& error) {
            told(error);
            return decltype(work()){};
        }
    }
}

/// The same; the problems of an Error(input) are added to `problems`, any other is thrown.
template <class Work>
auto attempt(Problems& problems, const Work& work) {
    return attempt([&](const Error& error) { problems.add(error); }, work);
}

/// The same where the error is reported later, or does not matter.
template <class Work>
auto attempt(const Work& work) {
    return attempt([](const Error&) {}, work);
}

}  // namespace frana
