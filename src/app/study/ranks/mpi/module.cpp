// SPDX-License-Identifier: Apache-2.0
// The only user of MPI. It is linked to the module `mpi` alone.
#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include "app/study/ranks/functions.h"
#include "core/module.h"

namespace frana::app::study {
namespace {

void begin() {
    int level = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level);
}

int rank() {
    int number = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &number);
    return number;
}

int size() {
    int number = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &number);
    return number;
}

int ranks_here() {
    MPI_Comm here = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
    int number = 1;
    MPI_Comm_size(here, &number);
    MPI_Comm_free(&here);
    return number;
}

std::string host() {
    char name[MPI_MAX_PROCESSOR_NAME] = "";
    int length = 0;
    MPI_Get_processor_name(name, &length);
    return {name, static_cast<std::size_t>(length)};
}

void send(int to, int kind, const std::string& bytes) {
    MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, to, kind, MPI_COMM_WORLD);
}

bool receive(Message& message) {
    int arrived = 0;
    MPI_Message handle = MPI_MESSAGE_NULL;
    MPI_Status status;
    MPI_Improbe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &arrived, &handle, &status);
    if (arrived == 0) return false;
    int count = 0;
    MPI_Get_count(&status, MPI_BYTE, &count);
    message.from = status.MPI_SOURCE;
    message.kind = status.MPI_TAG;
    message.bytes.resize(static_cast<std::size_t>(count));
    MPI_Mrecv(message.bytes.data(), count, MPI_BYTE, &handle, &status);
    return true;
}

void end() {
    MPI_Finalize();
}

}  // namespace
}  // namespace frana::app::study

FRANA_MODULE(frana::app::study::MpiFunctions, {.begin = frana::app::study::begin,
                                               .rank = frana::app::study::rank,
                                               .size = frana::app::study::size,
                                               .ranks_here = frana::app::study::ranks_here,
                                               .host = frana::app::study::host,
                                               .send = frana::app::study::send,
                                               .receive = frana::app::study::receive,
                                               .end = frana::app::study::end})
