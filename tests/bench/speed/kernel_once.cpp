// SPDX-License-Identifier: Apache-2.0
// Runs one kernel a given number of times, for tools that count instructions: kernel_once NAME TIMES; without
// arguments it lists the names.
#include <cstdio>
#include <cstdlib>

#include "kernels.h"

int main(int count, char** words) {
    const auto cases = frana::bench::kernel_cases();
    for (const auto& one : cases) {
        if (count < 3) {
            std::puts(one.name.c_str());
        } else if (one.name == words[1]) {
            for (int i = std::atoi(words[2]); i > 0; --i) one.run();
            return 0;
        }
    }
    return count < 3 ? 0 : 2;
}
