// SPDX-License-Identifier: Apache-2.0
#include "mpm/vector/kernels.h"

// In a source of its own: those with the kernels are compiled for processors that may differ from this one.
namespace frana {
namespace {
bool has_instructions() {
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
    return false;
#endif
}
}  // namespace

const VectorKernels* vector_kernels() {
    return has_instructions() ? compiled_vector_kernels() : nullptr;
}

const VectorNodeKernels* vector_node_kernels() {
    return has_instructions() ? compiled_vector_node_kernels() : nullptr;
}

}  // namespace frana
