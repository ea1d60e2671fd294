// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "core/error.h"

/// What a harness gives to libFuzzer, and what replay.cpp calls for every file of a corpus. Must return for any bytes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace frana::fuzz {

/// Runs what may refuse its input: an Error must say what is wrong; anything else that is thrown ends the program.
template <class Work>
void refused_or_done(const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        if (error.problems().empty() || error.problems().front().what.empty()) __builtin_trap();
    }
}

/// A file in memory under a name that GDAL opens, for as long as this lives.
class MemoryFile {
  public:
    MemoryFile(std::string path, const std::uint8_t* data, std::size_t size);
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    [[nodiscard]] const std::string& path() const noexcept { return path_; }

  private:
    std::string path_;
};

/// The file's kind is its first byte; returns what follows it.
struct Input {
    char kind = 0;
    const std::uint8_t* data = nullptr;
    std::size_t size = 0;
};
Input split(const std::uint8_t* data, std::size_t size);

}  // namespace frana::fuzz
