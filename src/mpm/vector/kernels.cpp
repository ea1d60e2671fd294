// SPDX-License-Identifier: Apache-2.0
#include "mpm/vector/kernels.h"

// In a source of its own: those with the kernels are compiled for processors that may differ from this one.
namespace frana {

#if defined(__x86_64__)

namespace {
bool has(Instructions set) {
    const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (set == Instructions::avx2) return avx2;
#if defined(FRANA_AVX512)
    return avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512dq");
#else
    return false;
#endif
}
}  // namespace

const VectorKernels* vector_kernels(Instructions set) {
    if (!has(set)) return nullptr;
#if defined(FRANA_AVX512)
    if (set == Instructions::avx512) return &compiled_vector_kernels<Instructions::avx512>();
#endif
    return &compiled_vector_kernels<Instructions::avx2>();
}

const VectorNodeKernels* vector_node_kernels(Instructions set) {
    if (!has(set)) return nullptr;
#if defined(FRANA_AVX512)
    if (set == Instructions::avx512) return &compiled_vector_node_kernels<Instructions::avx512>();
#endif
    return &compiled_vector_node_kernels<Instructions::avx2>();
}

#else

const VectorKernels* vector_kernels(Instructions) {
    return nullptr;
}

const VectorNodeKernels* vector_node_kernels(Instructions) {
    return nullptr;
}

#endif

namespace {
template <class Kernels>
const Kernels* newest(const Kernels* (*compiled_for)(Instructions)) {
    const Kernels* const kernels = compiled_for(Instructions::avx512);
    return kernels != nullptr ? kernels : compiled_for(Instructions::avx2);
}
}  // namespace

const VectorKernels* vector_kernels() {
    return newest<VectorKernels>(vector_kernels);
}

const VectorNodeKernels* vector_node_kernels() {
    return newest<VectorNodeKernels>(vector_node_kernels);
}

}  // namespace frana
