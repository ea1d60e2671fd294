// SPDX-License-Identifier: Apache-2.0
#include "app/text/csv_cell.h"

#include "core/utf8.h"

namespace frana::app {

std::string csv_cell(const std::string& text) {
    std::string cell = valid_utf8(text);
    if (!cell.empty() && std::string("=+-@\t\r\n'").find(cell.front()) != std::string::npos) cell.insert(0, "'");
    if (cell.find_first_of(",;\"\t\r\n") == std::string::npos) return cell;
    std::string out = "\"";
    for (const char c : cell) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + "\"";
}

std::string text_of_cell(const std::string& cell) {
    return cell.starts_with('\'') ? cell.substr(1) : cell;
}

}  // namespace frana::app
