// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::app {

enum class FileKind { text, table, vector, raster, style, picture, page, film, stack, working };

/// A file that frana writes into a result directory. The one list: what a result's manifest may name, what a
/// folder in the making may hold and what the documents and tests know of.
struct ResultFile {
    /// Of the path inside the result: "*" stands for any text within a name, "/**" at the end for all that is
    /// below.
    std::string pattern;
    FileKind kind;
    std::string written_by;  ///< the first command that does: "run", "render"
};

/// All of them; rasters of the table of layers come with their styles.
const std::vector<ResultFile>& result_files();

/// The row of a path inside a result, also while that file is being written ("max_depth.partial123.tif");
/// null for what frana does not write.
const ResultFile* known_file(const std::string& path);

/// Whether a path inside a result is that of such a file in the making by a process that was killed.
bool is_leftover(const std::string& path);

inline constexpr const char* k_manifest_file = "manifest.json";
/// In the folder in which a result is being built, from its first moment.
inline constexpr const char* k_building_file = "being_built.json";
/// In the folder in which a result is being built: pictures of report.html alone.
inline constexpr const char* k_page_folder = "report_pictures";
/// In an older result that is being replaced, until its user's files are in the new one.
inline constexpr const char* k_replaced_file = "being_replaced.json";

}  // namespace frana::app
