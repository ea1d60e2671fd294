// SPDX-License-Identifier: Apache-2.0
#include "gis/access/remembered_reads.h"

namespace frana::gis {
namespace {

thread_local RememberedReads* of_this_thread = nullptr;

}  // namespace

UseRemembered::UseRemembered(RememberedReads& reads) : before_(of_this_thread) {
    of_this_thread = &reads;
}

UseRemembered::~UseRemembered() {
    of_this_thread = before_;
}

RememberedReads* remembered_reads() noexcept {
    return of_this_thread;
}

}  // namespace frana::gis
