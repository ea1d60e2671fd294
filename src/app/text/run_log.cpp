// SPDX-License-Identifier: Apache-2.0
#include "app/text/run_log.h"

#include <cstdio>
#include <iostream>

#include "core/text.h"

namespace frana::app {

void RunLog::note(const std::string& text) {
    char stamp[32];
    std::snprintf(stamp, sizeof stamp, "%9.2f s  ", since_start_.seconds());
    lines_.push_back(stamp + text);
}

const Warnings& RunLog::tell(const Warnings& warnings) {
    for (const std::string& text : texts_of(warnings)) {
        note("WARNING: " + text);
        if (quiet_)
            withheld_.push_back(text);
        else
            std::cerr << "frana: warning: " << shown_text(text) << '\n';
    }
    return warnings;
}

void RunLog::info(const std::string& text) {
    note(text);
    if (!quiet_) std::cerr << "frana: " << shown_text(text) << '\n';
}

void RunLog::print_deferred_warnings() const {
    for (const std::string& text : withheld_) std::cerr << "frana: warning: " << shown_text(text) << '\n';
}

void RunLog::continue_from(const std::vector<std::string>& earlier) {
    lines_.insert(lines_.begin(), earlier.begin(), earlier.end());
}

std::string RunLog::text() const {
    std::string all;
    for (const std::string& line : lines_) {
        all += valid_utf8(line);
        all += '\n';
    }
    return all;
}

}  // namespace frana::app
