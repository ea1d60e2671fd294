// SPDX-License-Identifier: Apache-2.0
// Time of each kernel, in nanoseconds per particle (the counter "ns"), with Google Benchmark.
#include <benchmark/benchmark.h>

#include "kernels.h"

int main(int count, char** words) {
    for (const auto& one : frana::bench::kernel_cases()) {
        benchmark::RegisterBenchmark(one.name.c_str(), [run = one.run](benchmark::State& state) {
            for (auto step : state) run();
            state.counters["ns"] =
                benchmark::Counter(1e-9 * frana::bench::k_kernel_particles * static_cast<double>(state.iterations()),
                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
        });
    }
    benchmark::Initialize(&count, words);
    benchmark::RunSpecifiedBenchmarks();
}
