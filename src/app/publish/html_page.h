// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/files.h"
#include "core/words/sentence.h"
#include "core/words/words.h"

namespace frana::app {

/// A table of a page. Cells are text, escaped here; the head is repeated on each printed page.
class HtmlTable {
  public:
    explicit HtmlTable(const std::vector<std::string>& heads = {});

    /// @param kind a class of the style; empty: none
    HtmlTable& row(const std::vector<std::string>& cells, const std::string& kind = {});
    /// A name, a number aligned to the right, its unit, and perhaps more.
    HtmlTable& number(const std::string& name, const std::string& value, const std::string& unit,
                      const std::vector<std::string>& more = {});
    /// The same with more cells as HTML.
    HtmlTable& number_with(const std::string& name, const std::string& value, const std::string& unit,
                           const std::string& cells);
    /// Rows as HTML.
    HtmlTable& raw(const std::string& html);

    [[nodiscard]] std::string html(const std::string& kind = {}) const;

  private:
    std::string head_, rows_;
};

/// Returns a paragraph in small letters; the text is escaped here.
std::string small_print(const std::string& text);

/// New content of a part of a page: page_part.
struct PagePart {
    std::string name, html;
    bool optional = false;  ///< a page may be without it
};

/// Replaces parts of report.html of a result, which gets its name when it is complete, and its mark in the manifest. A
/// page that was changed since is kept under another name. Returns false if there is a report of an older frana,
/// without these parts, which stays as it is. Throws Error(environment).
/// @param parts in the language of the page
bool renew_page(const std::string& folder, const std::function<std::vector<PagePart>(const Words&)>& parts);

/// How a page begins: with its title alone; or with a section that contains the title and the answer, which with a
/// picture fills the first page of paper.
enum class Opening { title, answer, answer_with_picture };

/// A self-contained page, for the screen and for paper (A4), written piece by piece, so that memory contains one
/// picture at a time. It gets its name when it is finished.
class HtmlPage {
  public:
    /// @param origin a small line below the title: what computed it, from what
    HtmlPage(const std::string& path, const std::string& title, const std::string& origin, const Words& words = {},
             Opening opening = Opening::title);

    /// The pictures to come, which share the bytes that a page may have.
    void expect_pictures(std::size_t count);

    /// Ends the section that an answer opened.
    void end_answer() { add("</section>\n"); }

    /// Adds HTML as it is.
    void add(const std::string& html) { file_ << html; }
    /// Adds a heading; later ones of the same level begin new sections. The text is escaped.
    void add_heading(const std::string& id, const std::string& text);
    /// Adds a section with the warnings of a run, or the sentence that there were none.
    void add_warnings(const std::vector<Sentence>& warnings);
    /// Adds a PNG file, embedded.
    /// @param caption below it  @param alt what it shows, for those who cannot see it
    void add_picture(const std::string& path, const std::string& caption, const std::string& alt);
    /// Adds PNG files under the titles of their rasters or charts, or their names. @param kind "Map", in the page's
    /// language
    void add_pictures(const std::vector<std::string>& paths, const std::string& kind);
    /// Throws Error(environment).
    void finish();

  private:
    std::string folder_;
    FileAside aside_;
    std::ofstream file_;
    Words words_;
    std::size_t picture_bytes_;
};

/// Greatest size of one picture's file; of many the part of each is smaller.
inline constexpr std::size_t k_picture_bytes = 250'000;

/// Returns a PNG file as a figure of a page, as a JPEG of at most these bytes if it is larger.
std::string figure_html(const std::string& path, const std::string& caption, const std::string& alt,
                        std::size_t most_bytes = k_picture_bytes);

/// Returns the first warnings of a page's answer, shortened, and how many there are; or the sentence that there are
/// none.
std::string first_warnings(const std::vector<Sentence>& warnings, const Words& words);

/// A drawing inside the page, as wide as it where it has a caption; without one, small.
std::string svg_figure(const std::string& svg, const std::string& caption, const std::string& alt);

/// Returns the drawing of a picture that was made for the page of a result in a folder, else the picture itself.
std::string drawn_for_page(const std::string& folder, const std::string& path);
/// Deletes the pictures that were drawn for the page alone, from a folder that is still being written.
void remove_page_pictures(const std::string& folder);

/// Returns the paths of the PNG files in a folder, sorted.
std::vector<std::string> pictures_in(const std::string& folder);

/// Returns a part of a page that another command can replace: HTML between two comments with its name.
std::string page_part(const std::string& name, const std::string& html);
/// Returns the page with that part replaced; none if it has no such part.
std::optional<std::string> with_part(const std::string& page, const std::string& name, const std::string& html);
/// Returns the language that a page of frana is written in.
Words words_of_page(const std::string& page);

}  // namespace frana::app
