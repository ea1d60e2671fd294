// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>

#include "core/error.h"
#include "sample_data/samples.h"

/// generate_sample NAME DIR: writes a sample's files to a folder, created if necessary.
int main(int argc, char** argv) {
    const std::map<std::string, std::function<void(const std::string&)>> samples{
        {"bindo", frana::sample::write_bindo_sample},
        {"fan", frana::sample::write_fan_sample},
        {"flume", frana::sample::write_flume_sample},
        {"fracture", frana::sample::write_fracture_sample},
        {"reservoir", frana::sample::write_reservoir_sample}};
    const auto sample = argc == 3 ? samples.find(argv[1]) : samples.end();
    if (sample == samples.end()) {
        std::cerr << "usage: generate_sample bindo|fan|flume|fracture|reservoir DIR\n";
        return 2;
    }
    try {
        std::filesystem::create_directories(argv[2]);
        sample->second(argv[2]);
    } catch (const std::exception& error) {
        std::cerr << "generate_sample: " << error.what() << '\n';
        return 4;
    }
    return 0;
}
