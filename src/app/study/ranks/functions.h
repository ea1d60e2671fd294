// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::app::study {

struct Message {
    int from = 0;  ///< rank of the sender
    int kind = 0;  ///< as agreed on by sender and receiver
    std::string bytes;
};

/// All that frana takes from MPI, as functions of the module `mpi`. To be called by one thread. An error of MPI, and
/// the death of a rank, end all processes of the job: MPI has no other way.
struct MpiFunctions {
    void (*begin)();
    int (*rank)();
    int (*size)();
    /// Ranks on the same machine, this one included.
    int (*ranks_here)();
    std::string (*host)();
    /// Returns when the bytes may be reused; the receiver must be receiving if they are many.
    void (*send)(int to, int kind, const std::string& bytes);
    /// Returns false if no message has arrived.
    bool (*receive)(Message& message);
    /// Waits for all ranks.
    void (*end)();
};

}  // namespace frana::app::study
