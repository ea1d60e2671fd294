// SPDX-License-Identifier: Apache-2.0
#include "app/publish/html_table.h"

#include "core/markup.h"

namespace frana::app {
namespace {

std::string cell(const char* open, const std::string& text, const char* close) {
    return open + escaped_markup(text) + close;
}

std::string value_cells(const std::string& name, const std::string& value, const std::string& unit) {
    return cell("<td>", name, "</td>") + cell("<td class=\"n\">", value, "</td>") +
           cell("<td class=\"u\">", unit, "</td>");
}

}  // namespace

HtmlTable::HtmlTable(const std::vector<std::string>& heads) {
    for (const std::string& head : heads)
        head_ += head.empty() ? "<td></td>" : cell("<th scope=\"col\">", head, "</th>");
    if (!heads.empty()) head_ = "<thead><tr>" + head_ + "</tr></thead>\n";
}

HtmlTable& HtmlTable::row(const std::vector<std::string>& cells, const std::string& kind) {
    rows_ += kind.empty() ? "<tr>" : "<tr class=\"" + kind + "\">";
    for (const std::string& text : cells) rows_ += cell("<td>", text, "</td>");
    rows_ += "</tr>\n";
    return *this;
}

HtmlTable& HtmlTable::number(const std::string& name, const std::string& value, const std::string& unit,
                             const std::vector<std::string>& more) {
    rows_ += "<tr>" + value_cells(name, value, unit);
    for (const std::string& text : more) rows_ += cell("<td class=\"soft\">", text, "</td>");
    rows_ += "</tr>\n";
    return *this;
}

HtmlTable& HtmlTable::number_with(const std::string& name, const std::string& value, const std::string& unit,
                                  const std::string& cells) {
    rows_ += "<tr>" + value_cells(name, value, unit) + cells + "</tr>\n";
    return *this;
}

HtmlTable& HtmlTable::raw(const std::string& html) {
    rows_ += html;
    return *this;
}

std::string HtmlTable::html(const std::string& kind) const {
    return (kind.empty() ? "<table>\n" : "<table class=\"" + kind + "\">\n") + head_ + "<tbody>\n" + rows_ +
           "</tbody>\n</table>\n";
}

std::string small_print(const std::string& text) {
    return "<p class=\"small\">" + escaped_markup(text) + "</p>\n";
}

}  // namespace frana::app
