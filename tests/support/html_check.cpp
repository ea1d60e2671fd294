// SPDX-License-Identifier: Apache-2.0
#include "support/html_check.h"

#include <map>
#include <set>

namespace frana::test {
namespace {

/// Value of an attribute of a tag; empty if it has none.
std::string attribute(const std::string& tag, const std::string& name) {
    const std::string before = " " + name + "=\"";
    const std::size_t at = tag.find(before);
    if (at == std::string::npos) return "";
    const std::size_t begin = at + before.size();
    return tag.substr(begin, tag.find('"', begin) - begin);
}

std::string without(std::string text, const std::string& open, const std::string& close) {
    for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
        const std::size_t end = text.find(close, at);
        text.erase(at, end == std::string::npos ? std::string::npos : end + close.size() - at);
    }
    return text;
}

/// What a start tag is alone.
class TagCheck {
  public:
    explicit TagCheck(std::vector<std::string>& problems) : problems_(problems) {}

    void operator()(const std::string& name, const std::string& tag) {
        if (name == "html" && attribute(tag, "lang").size() != 2) problems_.push_back("no language");
        if (name == "img" && attribute(tag, "alt").size() < 10) problems_.push_back("a picture has no text");
        if (name == "svg" && attribute(tag, "aria-label").size() < 10) problems_.push_back("a chart has no text");
        const std::string source = attribute(tag, "src"), link = attribute(tag, "href");
        if ((!source.empty() && !source.starts_with("data:")) || link.find("//") != std::string::npos)
            problems_.push_back("fetched: " + tag.substr(0, 80));
        if (name == "script" || name == "link" || name == "iframe") problems_.push_back("a tag " + name);
        if (const std::string id = attribute(tag, "id"); !id.empty() && !ids_.insert(id).second)
            problems_.push_back("twice: id " + id);
        if (name.size() == 2 && name[0] == 'h' && name[1] >= '1' && name[1] <= '6') heading(name[1] - '0');
    }
    void finish() const {
        if (firsts_ != 1) problems_.push_back("headings of the first level: " + std::to_string(firsts_));
    }

  private:
    void heading(int level) {
        if (level > level_ + 1) problems_.push_back("a heading h" + std::to_string(level) + " skips a level");
        level_ = level;
        firsts_ += level == 1 ? 1 : 0;
    }

    std::vector<std::string>& problems_;
    std::set<std::string> ids_;
    int level_ = 0, firsts_ = 0;
};

}  // namespace

std::vector<std::string> html_problems(const std::string& page) {
    std::vector<std::string> problems, open;
    if (!page.starts_with("<!DOCTYPE html>\n<html ")) problems.emplace_back("does not begin as HTML");
    const std::string text = without(without(page, "<!--", "-->"), "<style>", "</style>");
    static const std::set<std::string> k_alone{"meta", "img",      "br",      "hr",  "line",
                                               "rect", "polyline", "polygon", "path"};
    TagCheck check(problems);
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
        const std::size_t end = text.find('>', at);
        if (end == std::string::npos) {
            problems.emplace_back("a tag has no end");
            break;
        }
        const std::string tag = text.substr(at + 1, end - at - 1);
        at = end;
        if (tag.starts_with("!DOCTYPE")) continue;
        const bool closes = tag.starts_with("/");
        const std::string rest = closes ? tag.substr(1) : tag, name = rest.substr(0, rest.find_first_of(" /\n"));
        if (!closes) check(name, tag);
        if (tag.ends_with("/") || k_alone.contains(name)) continue;
        if (!closes) {
            open.push_back(name);
        } else if (open.empty() || open.back() != name) {
            problems.push_back("</" + name + "> closes " + (open.empty() ? "nothing" : open.back()));
            if (!open.empty()) open.pop_back();
        } else {
            open.pop_back();
        }
    }
    for (const std::string& name : open) problems.push_back("not closed: " + name);
    check.finish();
    return problems;
}

std::vector<std::vector<std::string>> printed_rows(const std::string& page) {
    const std::string text = without(page, "<details>", "</details>");
    std::vector<std::vector<std::string>> rows;
    for (std::size_t at = text.find("<tr"); at != std::string::npos; at = text.find("<tr", at + 1)) {
        const std::string row = text.substr(at, text.find("</tr>", at) - at);
        std::vector<std::string>& cells = rows.emplace_back();
        for (std::size_t cell = row.find("<td"); cell != std::string::npos; cell = row.find("<td", cell + 1)) {
            const std::size_t begin = row.find('>', cell) + 1;
            cells.push_back(letters_of(row.substr(begin, row.find("</td>", begin) - begin)));
        }
    }
    return rows;
}

std::string letters_of(const std::string& html) {
    static const std::map<std::string, std::string> k_signs{
        {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}};
    std::string text = without(html, "<", ">");
    for (const auto& [code, sign] : k_signs)
        if (code != "&amp;")
            for (std::size_t at = text.find(code); at != std::string::npos; at = text.find(code, at))
                text.replace(at, code.size(), sign);
    for (std::size_t at = text.find("&amp;"); at != std::string::npos; at = text.find("&amp;", at + 1))
        text.replace(at, 5, "&");
    return without_space(text);
}

std::string without_space(const std::string& text) {
    std::string letters;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const std::string_view rest(text.data() + at, text.size() - at);
        if (rest.starts_with("\u00A0")) {
            at += 1;
        } else if (rest.starts_with("\u202F")) {
            at += 2;
        } else if (std::string_view(" \n\t\f\r").find(text[at]) == std::string_view::npos) {
            letters += text[at];
        }
    }
    return letters;
}

std::size_t count_of(const std::string& text, const std::string& word) {
    std::size_t n = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++n;
    return n;
}

}  // namespace frana::test
