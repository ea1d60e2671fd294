// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "gis/access/table_in.h"
#include "support/files.h"

namespace frana::test {

/// A table by row and column.
using Rows = std::vector<std::map<std::string, std::string>>;
inline Rows rows_of(const std::string& file) {
    const gis::Table table = gis::read_table(file, "table");
    Rows rows;
    for (const auto& cells : table.rows) {
        auto& row = rows.emplace_back();
        for (std::size_t i = 0; i < cells.size(); ++i) row[table.columns[i]] = cells[i];
    }
    return rows;
}

/// A whole record in a file of a study that is being built.
struct KeptRecord {
    std::string file;
    std::size_t at = 0, size = 0;
};

/// Those in some files, by the description of the format alone: magic, format, bytes of the rest, rest, CRC-32.
inline std::vector<KeptRecord> kept_records(const std::string& folder, const std::vector<std::string>& files) {
    constexpr std::string_view k_magic = "frana mb";
    std::vector<KeptRecord> records;
    for (const std::string& file : files) {
        const std::string bytes = read_text(folder + "/" + file);
        for (std::size_t at = bytes.find(k_magic); at != std::string::npos; at = bytes.find(k_magic, at + 1)) {
            std::uint64_t rest = 0;
            if (bytes.size() - at < 24) break;
            std::memcpy(&rest, bytes.data() + at + 12, sizeof rest);
            if (rest + 24 <= bytes.size() - at) records.push_back({file, at, static_cast<std::size_t>(rest) + 24});
        }
    }
    return records;
}

}  // namespace frana::test
