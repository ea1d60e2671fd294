// SPDX-License-Identifier: Apache-2.0
#include "app/text/text_table.h"

#include <algorithm>
#include <charconv>
#include <clocale>
#include <cstdio>
#include <cwchar>
#include <numeric>
#include <sstream>

#include "app/process/terminal.h"
#include "core/text.h"

namespace frana::app {

std::string csv_cell(const std::string& text) {
    std::string cell = valid_utf8(text);
    if (!cell.empty() && std::string("=+-@\t\r\n'").find(cell.front()) != std::string::npos) cell.insert(0, "'");
    if (cell.find_first_of(",;\"\t\r\n") == std::string::npos) return cell;
    std::string out = "\"";
    for (const char c : cell) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + "\"";
}

std::string csv_line(const std::vector<std::string>& texts) {
    const auto is_number = [](const std::string& text) {
        double value = 0;
        const char* const end = text.data() + text.size();
        const auto [last, error] = std::from_chars(text.data(), end, value);
        return error == std::errc() && last == end;
    };
    std::string line;
    for (const std::string& text : texts)
        line += (&text == &texts.front() ? "" : ",") + (is_number(text) ? text : csv_cell(text));
    return line + "\n";
}

std::string text_of_cell(const std::string& cell) {
    return cell.starts_with('\'') ? cell.substr(1) : cell;
}

namespace {

/// wcwidth knows only the letters of the thread's locale; C.UTF-8 is built into the C library.
class Utf8Locale {
  public:
    Utf8Locale() : own_(::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)), before_(::uselocale(own_)) {}
    ~Utf8Locale() {
        ::uselocale(before_);
        if (own_ != nullptr) ::freelocale(own_);
    }
    Utf8Locale(const Utf8Locale&) = delete;
    Utf8Locale& operator=(const Utf8Locale&) = delete;

  private:
    locale_t own_, before_;
};

/// The character at `at`: its bytes and the columns it takes.
struct Step {
    std::size_t bytes = 1, columns = 1;
};

Step step_at(std::string_view text, std::size_t at) {
    const std::size_t length = utf8_length(text, at);
    if (length < 2) return {};  // plain, or not UTF-8
    constexpr unsigned char k_lead[] = {0, 0, 0x1f, 0x0f, 0x07};
    wchar_t code = static_cast<unsigned char>(text[at]) & k_lead[length];
    for (std::size_t i = 1; i < length; ++i)
        code = static_cast<wchar_t>((code << 6) | (static_cast<unsigned char>(text[at + i]) & 0x3f));
    const int columns = ::wcwidth(code);
    return {length, columns < 0 ? 1 : static_cast<std::size_t>(columns)};
}

}  // namespace

std::size_t display_width(std::string_view text) {
    const Utf8Locale locale;
    std::size_t columns = 0;
    for (std::size_t at = 0; at < text.size();) {
        const Step step = step_at(text, at);
        at += step.bytes;
        columns += step.columns;
    }
    return columns;
}

std::size_t bytes_within(std::string_view text, std::size_t columns) {
    const Utf8Locale locale;
    std::size_t at = 0, used = 0;
    while (at < text.size()) {
        const Step step = step_at(text, at);
        if (at > 0 && used + step.columns > columns) break;
        at += step.bytes;
        used += step.columns;
    }
    return at;
}

std::vector<std::string> wrapped(const std::string& text, std::size_t columns) {
    std::vector<std::string> lines;
    std::istringstream paragraphs(shown_text(text));  // a name in a file must not steer the terminal
    for (std::string paragraph; std::getline(paragraphs, paragraph);) {
        std::istringstream words(paragraph);
        std::string line;
        std::size_t used = 0;
        for (std::string word; words >> word;) {
            std::size_t width = display_width(word);
            if (!line.empty() && used + 1 + width > columns) {
                lines.push_back(line);
                line.clear();
                used = 0;
            }
            while (width > columns) {
                const std::size_t bytes = bytes_within(word, columns);
                if (bytes >= word.size()) break;  // one letter that is wider than the column
                lines.push_back(word.substr(0, bytes));
                word.erase(0, bytes);
                width = display_width(word);
            }
            line += (line.empty() ? "" : " ") + word;
            used += (used > 0 ? 1 : 0) + width;
        }
        lines.push_back(line);
    }
    return lines;
}

std::string padded(const std::string& text, std::size_t columns, bool right) {
    const std::size_t width = display_width(text);
    if (width >= columns) return text;
    const std::string spaces(columns - width, ' ');
    return right ? spaces + text : text + spaces;
}

namespace {

constexpr std::size_t k_gap = 2, k_narrowest = 6;
constexpr std::size_t k_whole = 10;  // words and numbers up to this length are not torn, as "EPSG:32632"

std::size_t widest_line(const std::vector<std::string>& lines) {
    std::size_t widest = 0;
    for (const std::string& line : lines) widest = std::max(widest, display_width(line));
    return widest;
}

/// The longest of the words that a column must not tear.
std::size_t longest_whole_word(const std::string& cell) {
    std::istringstream words(cell);
    std::size_t longest = k_narrowest;
    for (std::string word; words >> word;) longest = std::max(longest, std::min(display_width(word), k_whole));
    return longest;
}

void end_line(std::string& line, std::string& text) {
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
}

}  // namespace

Table& Table::number(const std::string& name, const std::string& value, const std::string& unit,
                     const std::vector<Cell>& more) {
    std::vector<Cell> cells{name, {value, "n"}, {unit, "u"}};
    cells.insert(cells.end(), more.begin(), more.end());
    return row(std::move(cells));
}

std::string Table::csv() const {
    std::string text = csv_line(heads_);
    for (const auto& [kind, cells] : rows_) {
        std::vector<std::string> texts;
        for (const Cell& cell : cells) texts.push_back(cell.text);
        text += csv_line(texts);
    }
    return text;
}

std::vector<std::size_t> Table::widths(std::size_t width, const std::vector<Layout>& columns) const {
    std::vector<std::size_t> widths, least;
    for (std::size_t i = 0; i < heads_.size(); ++i) {
        widths.push_back(widest_line(wrapped(heads_[i], columns[i].widest)));
        least.push_back(longest_whole_word(heads_[i]));
        for (const auto& [kind, row] : rows_) {
            widths[i] = std::max(widths[i], widest_line(wrapped(row.at(i).text, columns[i].widest)));
            least[i] = std::max(least[i], longest_whole_word(row.at(i).text));
        }
    }
    const std::size_t gaps = k_gap * (heads_.size() - 1);
    for (std::size_t all = std::accumulate(widths.begin(), widths.end(), gaps); all > width; --all) {
        std::size_t widest = heads_.size();
        for (std::size_t i = 0; i < widths.size(); ++i)
            if (widths[i] > least[i] && (widest == heads_.size() || widths[i] > widths[widest])) widest = i;
        if (widest == heads_.size()) return {};
        --widths[widest];
    }
    return widths;
}

std::string Table::as_lists(std::size_t width) const {
    std::string text;
    for (const auto& [kind, row] : rows_) {
        for (std::size_t i = 0; i < heads_.size(); ++i) {
            if (row[i].text.empty()) continue;
            std::string cell = row[i].text;
            std::replace(cell.begin(), cell.end(), '\n', ' ');
            for (const std::string& line : wrapped(heads_[i] + ": " + cell, width)) text += line + '\n';
        }
        text += '\n';
    }
    return text;
}

std::string Table::text(std::size_t width, const std::vector<Layout>& columns, bool ruled) const {
    const std::vector<std::size_t> wide = widths(width, columns);
    if (wide.empty()) return as_lists(width);
    std::string text;
    const auto put = [&](const auto& text_of) {
        std::vector<std::vector<std::string>> lines;
        std::size_t height = 1;
        for (std::size_t i = 0; i < wide.size(); ++i) {
            lines.push_back(wrapped(text_of(i), wide[i]));
            height = std::max(height, lines.back().size());
        }
        for (std::size_t k = 0; k < height; ++k) {
            std::string line;
            for (std::size_t i = 0; i < lines.size(); ++i)
                line +=
                    padded(k < lines[i].size() ? lines[i][k] : "", wide[i], columns[i].right) + std::string(k_gap, ' ');
            end_line(line, text);
        }
    };
    const auto rule = [&] {
        std::string line;
        for (const std::size_t columns_of : wide) line += std::string(columns_of, '-') + std::string(k_gap, ' ');
        end_line(line, text);
    };
    put([&](std::size_t i) { return heads_[i]; });
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        if (ruled || r == 0) rule();
        put([&](std::size_t i) { return rows_[r].second.at(i).text; });
    }
    return text;
}

std::string fact_line(const std::string& name, const std::string& value, std::size_t width) {
    constexpr std::size_t k_indent = 2, k_name = 16, k_least = 20;
    const std::string head = std::string(k_indent, ' ') + padded(name, k_name) + " ";
    const std::size_t left = display_width(head);
    const std::vector<std::string> lines = wrapped(value, std::max(k_least, width > left ? width - left : 0));
    std::string text;
    for (std::size_t i = 0; i < std::max<std::size_t>(1, lines.size()); ++i) {
        std::string line = (i == 0 ? head : std::string(left, ' ')) + (i < lines.size() ? lines[i] : "");
        end_line(line, text);
    }
    return text;
}

void print_fact(const std::string& name, const std::string& value) {
    std::fputs(fact_line(name, value, output_width()).c_str(), stdout);
}

std::string folded(const std::string& text, std::size_t width) {
    std::string all;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
        if (display_width(line) <= width || indent + k_narrowest > width) {
            all += line + '\n';
            continue;
        }
        bool first = true;
        for (const std::string& part : wrapped(line.substr(indent), width - indent - k_gap)) {
            all += std::string(indent + (first ? 0 : k_gap), ' ') + part + '\n';
            first = false;
        }
    }
    return all;
}

bool precedes(const std::string& one, const std::string& other) {
    const auto padded_numbers = [](const std::string& text) {
        std::string key, digits;
        for (const char c : text + '\0') {
            if (c >= '0' && c <= '9') {
                digits += c;
                continue;
            }
            constexpr std::size_t k_digits = 20;
            if (!digits.empty() && digits.size() < k_digits) key.append(k_digits - digits.size(), '0');
            key += std::exchange(digits, {}) + c;
        }
        return key;
    };
    return padded_numbers(one) < padded_numbers(other);
}

}  // namespace frana::app
