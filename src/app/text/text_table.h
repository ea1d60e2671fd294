// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::app {

/// A table for a terminal: cells wrap at spaces, a newline in a cell starts another line of it.
class TextTable {
  public:
    struct Column {
        std::string title;
        std::size_t widest;  ///< characters; a longer word is not broken
    };
    explicit TextTable(std::vector<Column> columns) : columns_(std::move(columns)) {}

    /// One cell per column.
    void add(const std::vector<std::string>& cells);
    [[nodiscard]] std::string text() const;

  private:
    using Lines = std::vector<std::string>;
    std::vector<Column> columns_;
    std::vector<std::vector<Lines>> rows_;
};

}  // namespace frana::app
