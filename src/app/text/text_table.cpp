// SPDX-License-Identifier: Apache-2.0
#include "app/text/text_table.h"

#include <algorithm>
#include <sstream>

namespace frana::app {
namespace {

std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
    std::vector<std::string> lines;
    std::istringstream paragraphs(text);
    for (std::string paragraph; std::getline(paragraphs, paragraph);) {
        std::istringstream words(paragraph);
        std::string line;
        for (std::string word; words >> word;) {
            if (!line.empty() && line.size() + 1 + word.size() > width) {
                lines.push_back(line);
                line.clear();
            }
            line += (line.empty() ? "" : " ") + word;
        }
        lines.push_back(line);
    }
    return lines;
}

}  // namespace

void TextTable::add(const std::vector<std::string>& cells) {
    std::vector<Lines> row;
    for (std::size_t i = 0; i < columns_.size(); ++i) row.push_back(wrapped(cells.at(i), columns_[i].widest));
    rows_.push_back(std::move(row));
}

std::string TextTable::text() const {
    std::vector<std::size_t> widths;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        widths.push_back(columns_[i].title.size());
        for (const auto& row : rows_)
            for (const std::string& line : row[i]) widths[i] = std::max(widths[i], line.size());
    }
    std::string text;
    const auto put = [&](const std::vector<std::string>& cells) {
        std::string line;
        for (std::size_t i = 0; i < cells.size(); ++i)
            line += cells[i] + std::string(widths[i] - cells[i].size() + 2, ' ');
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    };
    std::vector<std::string> titles, rules;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        titles.push_back(columns_[i].title);
        rules.emplace_back(widths[i], '-');
    }
    put(titles);
    for (const auto& row : rows_) {
        put(rules);
        std::size_t height = 1;
        for (const Lines& cell : row) height = std::max(height, cell.size());
        for (std::size_t k = 0; k < height; ++k) {
            std::vector<std::string> cells;
            for (const Lines& cell : row) cells.push_back(k < cell.size() ? cell[k] : "");
            put(cells);
        }
    }
    return text;
}

}  // namespace frana::app
