// SPDX-License-Identifier: Apache-2.0
#include "core/error.h"

#include <algorithm>
#include <cerrno>
#include <utility>

#include "core/text.h"

namespace frana {

std::string system_remedy(int reason) {
    switch (reason) {
        case ENOMEM:
            return "Memory ran out: end other programs, allow more (ulimit -v), or choose larger cells "
                   "(terrain.cell-size) or smaller pictures (output.map-size)";
        case EAGAIN:
            return "The system refused a thread: allow more (ulimit -u, ulimit -v) or use fewer --threads";
        case EMFILE:
        case ENFILE:
            return "Too many files are open: allow more (ulimit -n)";
        case ENOSPC:
        case EDQUOT:
        case EFBIG:
            return "Free some disk space, then repeat the command";
        case EACCES:
        case EPERM:
        case EROFS:
            return "Check the rights of the file and its folder";
        case EINTR:
            return "Repeat the command";
        case EIO:
            return "The disk or the network could not be read or written: check it, then repeat the command";
        default:
            return "Check the place's rights and free space";
    }
}

namespace {

constexpr std::size_t k_printed = 3;

std::string grouped_digits(std::int64_t count) {
    std::string text = std::to_string(count);
    for (std::size_t place = text.size(); place > 3; place -= 3) text.insert(place - 3, " ");
    return text;
}

}  // namespace

void CountedTexts::add(const std::string& kind, const Sentence& text) {
    auto found = std::find_if(kinds_.begin(), kinds_.end(), [&](const Kind& k) { return k.name == kind; });
    if (found == kinds_.end()) found = kinds_.insert(kinds_.end(), Kind{kind, {}, 0});
    if (found->first.size() < k_printed) {
        found->first.push_back(text);
    } else {
        ++found->more;
    }
}

std::vector<Sentence> CountedTexts::texts() const {
    std::vector<Sentence> all;
    for (const Kind& kind : kinds_) {
        all.insert(all.end(), kind.first.begin(), kind.first.end());
        if (kind.more > 0)
            all.back() = worded("{1}; and {2} more of this kind", {all.back(), numeral(grouped_digits(kind.more))});
    }
    return all;
}

namespace {

constexpr std::size_t k_longest_value = 1000;  // characters

std::string join(const std::vector<Problem>& problems) {
    std::string text;
    for (const Problem& problem : problems) {
        if (!text.empty()) text += '\n';
        text += describe(problem);
    }
    return text;
}

}  // namespace

Place Place::given(const std::string& before, const std::string& of_key) {
    Place place(before.c_str());
    place.text += of_key;
    place.key = of_key;
    if (place.option.empty()) place.file = before.substr(0, before.rfind(": "));
    return place;
}

std::string describe(const Problem& problem) {
    std::string text = problem.where.empty() ? problem.what : problem.where.text + ": " + problem.what;
    if (!problem.value.empty() || !problem.limit.empty()) {
        text += " (";
        if (!problem.value.empty()) text += "value " + elided(problem.value, k_longest_value);
        if (!problem.value.empty() && !problem.limit.empty()) text += "; ";
        if (!problem.limit.empty()) text += "allowed " + problem.limit;
        text += ')';
    }
    if (!problem.remedy.empty()) text += ". " + problem.remedy;
    // File names may contain terminal control sequences.
    return one_line(text);
}

Error::Error(ErrorKind kind, std::vector<Problem> problems)
    : std::runtime_error(join(problems)), kind_(kind), problems_(std::move(problems)) {}

Error::Error(ErrorKind kind, Problem problem) : Error(kind, std::vector<Problem>{std::move(problem)}) {}

void Problems::add(Problem problem) {
    const auto is_known = [&](const Problem& one) {
        return one.where == problem.where && describe(one) == describe(problem);
    };
    if (std::none_of(list_.begin(), list_.end(), is_known)) list_.push_back(std::move(problem));
}

void Problems::add(const Error& error) {
    if (error.kind() != ErrorKind::input) throw error;
    list_.insert(list_.end(), error.problems().begin(), error.problems().end());
}

void Problems::throw_if_any() const {
    if (!list_.empty()) throw Error(ErrorKind::input, list_);
}

}  // namespace frana
