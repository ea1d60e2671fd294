// SPDX-License-Identifier: Apache-2.0
#include "app/text/display_width.h"

#include <clocale>
#include <cwchar>
#include <sstream>

#include "core/utf8.h"

namespace frana::app {
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
    std::istringstream paragraphs(text);
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

}  // namespace frana::app
