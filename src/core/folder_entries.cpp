// SPDX-License-Identifier: Apache-2.0
#include "core/folder_entries.h"

#include <algorithm>

#include "core/error.h"
#include "core/system_remedy.h"

namespace frana {

namespace fs = std::filesystem;

std::vector<fs::directory_entry> folder_entries(const fs::path& folder) {
    constexpr int k_most_tries = 20;  // repeats after interruptions by signals
    std::vector<fs::directory_entry> entries;
    std::error_code error;
    for (int tries = 0; tries < k_most_tries; ++tries) {
        entries.clear();
        fs::directory_iterator entry(folder, error);
        for (; !error && entry != fs::end(entry); entry.increment(error)) entries.push_back(*entry);
        if (error != std::errc::interrupted) break;
    }
    const bool nowhere = error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory ||
                         error == std::errc::too_many_symbolic_link_levels || error == std::errc::filename_too_long;
    if (nowhere) return {};
    if (error)
        throw Error(ErrorKind::environment, Problem{"cannot be read: " + error.message(), folder.string(), "", "",
                                                    system_remedy(error.value())});
    std::sort(entries.begin(), entries.end());
    return entries;
}

}  // namespace frana
