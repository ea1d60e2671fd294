// SPDX-License-Identifier: Apache-2.0
#include "app/study/pool/member_runs.h"

#include <string>
#include <utility>

#include "app/process/signals.h"
#include "app/store/interrupted_run.h"
#include "app/text/number_text.h"
#include "core/files.h"

namespace frana::app::study {

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

MemberRunner::MemberRunner(const StudyInput& input, std::string folder, int threads, bool quiet, RankPool* ranks,
                           std::size_t study)
    : input_(input),
      folder_(std::move(folder)),
      threads_(static_cast<std::size_t>(threads)),
      ranks_(ranks),
      study_(study),
      progress_(records_in(folder_).size(), input.table.size(), quiet),
      members_(std::vector<const StudyInput*>(study + 1, &input), threads) {}

int MemberRunner::stopped_by() const {
    return stop_signal() != 0 || ranks_ == nullptr ? stop_signal() : ranks_->interrupted();
}

std::optional<MemberTask> MemberRunner::take() {
    while (next_ < end_) {
        const std::size_t member = next_++;
        if (!own_record(input_, folder_, member)) return MemberTask{member, input_.table.overrides(member), study_};
    }
    return std::nullopt;
}

void MemberRunner::keep(std::size_t member, const std::string& record) {
    write_file(record_file(folder_, member), record, Sync::yes);
    ++computed_;
    progress_.add_member();
}

void MemberRunner::run_until_all_are_back() {
    // One more than threads, so that none waits while a record is written.
    const std::size_t most_out = threads_ + 1;
    while (stopped_by() == 0) {
        if (const std::exception_ptr problem = members_.take_problem()) std::rethrow_exception(problem);
        while (const auto record = members_.take_record()) {
            --out_;
            keep(record->member, record->bytes);
        }
        for (; out_ < most_out; ++out_) {
            auto task = take();
            if (!task) break;
            members_.add(std::move(*task));
        }
        if (ranks_ != nullptr)
            ranks_->exchange([this] { return take(); },
                             [this](std::size_t member, const std::string& record) { keep(member, record); });
        if (out_ == 0 && (ranks_ == nullptr || !ranks_->has_members_out())) return;
        constexpr int k_message_wait = 1, k_signal_wait = 100;  // [ms]
        members_.wait(ranks_ != nullptr ? k_message_wait : k_signal_wait);
    }
}

bool MemberRunner::run_until(std::size_t end) {
    end_ = end;
    run_until_all_are_back();
    progress_.finish();
    return stopped_by() == 0;
}

}  // namespace frana::app::study
