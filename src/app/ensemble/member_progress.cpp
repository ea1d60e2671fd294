// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/member_progress.h"

#include <string>

#include "app/text/number_text.h"

namespace frana::app {

MemberProgress::MemberProgress(std::size_t done, std::size_t total, bool quiet)
    : done_(done), total_(total), line_(quiet) {}

void MemberProgress::add_member() {
    ++done_;
    ++here_;
    if (!line_.is_due()) return;
    const double left = line_.seconds() / static_cast<double>(here_) * static_cast<double>(total_ - done_);
    line_.show("member " + std::to_string(done_) + " of at most " + std::to_string(total_) + "  " +
               duration_text(left) + " left at most");
}

void MemberProgress::finish() {
    line_.finish();
}

}  // namespace frana::app
