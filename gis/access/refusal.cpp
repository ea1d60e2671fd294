// SPDX-License-Identifier: Apache-2.0
#include "gis/access/refusal.h"

#include <mutex>
#include <utility>

namespace frana::gis {
namespace {

// Libraries also read on their own threads.
std::mutex guard;
std::optional<Refusal> first;

}  // namespace

void note_refusal(Refusal refusal) {
    const std::lock_guard lock(guard);
    if (!first) first = std::move(refusal);
}

std::optional<Refusal> pop_refusal() {
    const std::lock_guard lock(guard);
    return std::exchange(first, std::nullopt);
}

}  // namespace frana::gis
