// SPDX-License-Identifier: Apache-2.0
#include "bench/speed/memory_bandwidth.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include "core/thread_pool.h"

namespace frana::bench {

double memory_bandwidth(int threads) {
    constexpr std::size_t k_elements = 16'000'000;  // three arrays of 128 MB
    constexpr std::size_t k_block = 250'000;
    constexpr int k_passes = 6;
    std::vector<double> a(k_elements, 0), b(k_elements, 1), c(k_elements, 2);
    ThreadPool pool(threads);
    double best = 0;
    for (int pass = 0; pass < k_passes; ++pass) {
        const double s = 1 + pass;
        const auto begin = std::chrono::steady_clock::now();
        pool.for_blocks(k_elements, k_block, [&](std::size_t from, std::size_t to) {
            double *const out = a.data();
            const double *const in = b.data(), *const factor = c.data();
            for (std::size_t i = from; i < to; ++i) out[i] = in[i] + s * factor[i];
        });
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        // The sum is used, so that no pass can be optimised away.
        if (a[k_elements / 2] == 1 + 2 * s) best = std::max(best, 3 * sizeof(double) * k_elements / seconds);
    }
    return best;
}

}  // namespace frana::bench
