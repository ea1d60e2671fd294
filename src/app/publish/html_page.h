// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "core/file_aside.h"

namespace frana::app {

/// A self-contained page, for the screen and for paper, written piece by piece, so that memory contains one picture at
/// a time. It gets its name when it is finished.
class HtmlPage {
  public:
    /// @param origin a small line below the title: what computed it, from what
    HtmlPage(const std::string& path, const std::string& title, const std::string& origin);

    /// Adds HTML as it is.
    void add(const std::string& html) { file_ << html; }
    /// Adds a section with the warnings of a run, or the sentence that there were none.
    void add_warnings(const std::vector<std::string>& warnings);
    /// Adds a PNG file, embedded.
    void add_picture(const std::string& path, const std::string& caption);
    /// Throws Error(environment).
    void finish();

  private:
    FileAside aside_;
    std::ofstream file_;
};

/// Returns a row of a table; texts are escaped.
/// @param cell "td", or "th" for a head
std::string table_row(const std::vector<std::string>& cells, const char* cell = "td");

}  // namespace frana::app
