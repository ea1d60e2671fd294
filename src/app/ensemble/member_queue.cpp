// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/member_queue.h"

#include <filesystem>
#include <utility>

#include "app/store/saved_work.h"
#include "study/member_record.h"

namespace frana::app {

MemberQueue::MemberQueue(std::string folder) : folder_(std::move(folder)) {}

void MemberQueue::extend_to(std::size_t end) {
    end_ = end;
}

std::optional<std::size_t> MemberQueue::take() {
    while (next_ < end_) {
        const std::size_t member = next_++;
        const std::string file = record_file(folder_, member);
        if (!std::filesystem::exists(file) || !study::read_record(file)) return member;
    }
    return std::nullopt;
}

}  // namespace frana::app
