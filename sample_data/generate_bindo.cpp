// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iostream>

#include "core/error.h"
#include "sample_data/bindo_sample.h"

/// generate_sample DIR: writes the sample's files into a folder, which is made if it is not there.
int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: generate_sample DIR\n";
        return 2;
    }
    try {
        std::filesystem::create_directories(argv[1]);
        frana::sample::write_bindo_sample(argv[1]);
    } catch (const std::exception& error) {
        std::cerr << "generate_sample: " << error.what() << '\n';
        return 4;
    }
    return 0;
}
