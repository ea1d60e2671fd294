// SPDX-License-Identifier: Apache-2.0
#include "core/counted_texts.h"

#include <algorithm>

namespace frana {
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

}  // namespace frana
