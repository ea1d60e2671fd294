// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/error.h"

namespace frana::gis {

/// Times of frames begin at 2000-01-01 00:00 UTC: CF conventions and QGIS need a date, and a scene has none.
/// Returns "2000-01-01T00:01:30.500Z" for 90.5 s.
std::string date_text(double seconds);

/// A table of texts, row by row.
struct Table {
    std::vector<std::string> remarks{};  ///< lines before the header, without their "# "
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
};

/// Refuses a CSV file of which a row has more fields than the header, which OGR would drop: with commas between them
/// and within numbers, the rest of a number would be the value of the next column. `place` names key and file. Throws
/// Error(input).
void refuse_surplus_fields(const std::string& path, const std::string& place);

/// Reads a CSV file with a header, before which lines may begin with #; comma, semicolon or tab between the columns.
/// `where` names the key. Throws Error(input): missing file, not a table, no row, refuse_surplus_fields.
Table read_table(const std::string& path, const Place& where);

}  // namespace frana::gis
