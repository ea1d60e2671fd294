// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/rank_pool.h"

#include "app/ensemble/rank_messages.h"
#include "app/text/text_hash.h"

namespace frana::app {
RankPool::RankPool(ranks::Job& job) : job_(job) {}

RankPool::~RankPool() {
    for (int rank = 1; rank < job_.size(); ++rank) job_.send(rank, kind_of(RankMessage::stop));
    // A rank may be sending a record, and waits until it is received.
    for (int left = job_.size() - 1; left > 0;) {
        const auto message = job_.receive();
        if (!message) {
            ranks::wait_a_moment();
        } else if (message->kind == kind_of(RankMessage::bye)) {
            --left;
        }
    }
}

void RankPool::start(const std::string& identity) {
    for (int rank = 1; rank < job_.size(); ++rank) job_.send(rank, kind_of(RankMessage::start), text_hash(identity));
}

void RankPool::handle(ranks::Message& message, const std::function<void(std::size_t, const std::string&)>& keep) {
    switch (static_cast<RankMessage>(message.kind)) {
        case RankMessage::ready:
            free_.insert(free_.end(), take_number(message.bytes), message.from);
            return;
        case RankMessage::record: {
            const std::size_t member = take_number(message.bytes);
            free_.push_back(message.from);
            out_.erase(member);
            keep(member, message.bytes);
            return;
        }
        case RankMessage::problem:
            throw error_from(message.bytes);
        case RankMessage::interrupted:
            interrupted_ = static_cast<int>(take_number(message.bytes));
            return;
        case RankMessage::start:
        case RankMessage::member:
        case RankMessage::stop:
        case RankMessage::bye:
            return;  // of rank 0, or after its `stop`
    }
}

void RankPool::exchange(const std::function<std::optional<MemberTask>()>& take,
                        const std::function<void(std::size_t member, const std::string& record)>& keep) {
    while (auto message = job_.receive()) handle(*message, keep);
    while (!free_.empty()) {
        const auto task = take();
        if (!task) return;
        out_[task->member] = free_.front();
        job_.send(free_.front(), kind_of(RankMessage::member), bytes_of(*task));
        free_.pop_front();
    }
}

}  // namespace frana::app
