// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/pictures/charts.h"
#include "app/text/text_table.h"
#include "core/words/warning.h"
#include "core/words/words.h"

namespace frana::app {

// What a report consists of, in its language: blocks of plain text, of which html_page.h makes a page.

/// A piece of a paragraph.
struct Span {
    std::string text;
    std::string link{};  ///< file that it leads to
};

struct Heading {
    std::string text;
    std::string id{};  ///< of a section; empty: a heading inside one
};

struct Paragraph {
    std::vector<Span> text;
    std::string lead{};  ///< in bold letters before it
    std::string kind{};  ///< "small", "warning", "good"
};

struct List {
    std::vector<std::string> items;
};

/// A picture: a PNG file, which is embedded when the page is written, or an SVG file; or a drawing as SVG text.
struct Figure {
    std::string file;
    std::string caption, alt;  ///< alt: what it shows, for those who cannot see it
    std::string svg{};
};

struct Block;

/// Blocks that belong together: beside each other ("columns"), in one of the columns ("box"), or folded under a title
/// ("folded").
struct Group {
    std::string kind, title;
    std::vector<Block> content;
};

/// The end of the answer, which with a picture fills the first page of paper.
struct AnswerEnd {};

struct Block {
    std::variant<Heading, Paragraph, List, Table, Figure, Group, AnswerEnd> value;
};

class Document {
  public:
    Document() = default;
    Document(Table table) { add(std::move(table)); }

    /// Begins a section, named by `id`.
    Document& heading(const std::string& id, const std::string& text) { return add(Heading{text, id}); }
    Document& subheading(const std::string& text) { return add(Heading{text}); }
    Document& paragraph(const std::string& text) { return add(Paragraph{{{text}}}); }
    /// With some words in bold letters before it: "Limitations."
    Document& paragraph(const std::string& lead, const std::string& text);
    Document& small(const std::string& text) { return add(Paragraph{{{text}}, "", "small"}); }
    Document& columns(Document content) { return group("columns", "", std::move(content)); }
    Document& box(const std::string& heading, Document content) {
        Document all;
        if (!heading.empty()) all.subheading(heading);
        return group("box", "", std::move(all.add(std::move(content))));
    }
    Document& folded(const std::string& title, Document content) { return group("folded", title, std::move(content)); }
    /// A section with warnings.
    Document& warnings(const Warnings& all, const Words& words);
    /// The first warnings of an answer, as many whole sentences as leave room for it, and how many there are; or the
    /// sentence that there are none.
    Document& first_warnings(const Warnings& all, const Words& words);
    /// Maps, PNG files, under the titles of their rasters; what was drawn for the page of a result's folder instead.
    Document& maps(const std::vector<std::string>& paths, const std::string& folder, const Words& words);
    /// A section with those charts that a result's folder has; nothing if it has none.
    Document& charts(const std::vector<ChartTitle>& all, const std::string& folder, const Words& words);
    Document& end_answer() { return add(AnswerEnd{}); }

    template <class Value>
    Document& add(Value value) {
        blocks_.push_back(Block{std::move(value)});
        return *this;
    }
    Document& add(Document other) {
        for (Block& block : other.blocks_) blocks_.push_back(std::move(block));
        return *this;
    }

    [[nodiscard]] const std::vector<Block>& blocks() const noexcept { return blocks_; }

  private:
    Document& group(const std::string& kind, const std::string& title, Document content) {
        return add(Group{kind, title, std::move(content.blocks_)});
    }

    std::vector<Block> blocks_;
};

/// Returns the drawing of a picture that was made for the page of a result in a folder, else the picture itself.
std::string drawn_for_page(const std::string& folder, const std::string& path);

/// Returns the paths of the PNG files in a folder, sorted.
std::vector<std::string> pictures_in(const std::string& folder);

}  // namespace frana::app
