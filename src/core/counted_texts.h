// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/words/sentence.h"

namespace frana {

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

}  // namespace frana
