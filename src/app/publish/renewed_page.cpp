// SPDX-License-Identifier: Apache-2.0
#include "app/publish/renewed_page.h"

#include <filesystem>

#include "app/publish/html_page.h"
#include "app/store/manifest.h"
#include "app/store/own_files.h"
#include "app/store/result_files.h"
#include "app/text/text_file.h"

namespace frana::app {

bool renew_page(const std::string& folder, const std::function<std::vector<PagePart>(const Words&)>& parts) {
    const std::string path = (std::filesystem::path(folder) / k_report_file).string();
    if (!std::filesystem::exists(path)) return true;
    std::string page = read_text_file(path);
    for (const PagePart& part : parts(words_of_page(page))) {
        if (auto renewed = with_part(page, part.name, part.html))
            page = std::move(*renewed);
        else if (!part.optional)
            return false;
    }
    const bool in_making = std::filesystem::exists(std::filesystem::path(folder) / k_building_file);
    if (!in_making) begin_own(folder, {path});
    write_text_file(path, page);
    if (!in_making) record_files({path});
    return true;
}

}  // namespace frana::app
