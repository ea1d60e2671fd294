// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "core/error.h"

/// The entry point for libFuzzer, and for replay.cpp with every file of a corpus. Must return for any bytes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace frana::fuzz {

/// Runs work that may refuse its input: an Error must contain a problem; any other exception ends the program.
template <class Work>
void refused_or_done(const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        if (error.problems().empty() || error.problems().front().what.empty()) __builtin_trap();
    }
}

/// A file in memory under a name that GDAL opens, during its lifetime.
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

/// The file's kind is its first byte; returns the rest.
struct Input {
    char kind = 0;
    const std::uint8_t* data = nullptr;
    std::size_t size = 0;
};
Input split(const std::uint8_t* data, std::size_t size);

}  // namespace frana::fuzz
