// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "support/program.h"

namespace frana::test {
namespace {

std::string output_of(const std::string& command) {
    std::FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) return {};
    std::string text;
    std::array<char, 4096> part{};
    while (const std::size_t read = std::fread(part.data(), 1, part.size(), pipe)) text.append(part.data(), read);
    ::pclose(pipe);
    return text;
}

// The flags reached the shipped program; readelf comes with the compiler.
TEST(Hardening, IsInTheReleaseBuild) {
#ifndef FRANA_RELEASE
    GTEST_SKIP() << "not a release build";
#endif
    const std::string elf =
        output_of("readelf -W --file-header --program-headers --dynamic --dyn-syms '" FRANA_PROGRAM "'");
    expect_words(elf, {"DYN (Position-Independent Executable file)", "GNU_RELRO", "BIND_NOW", "__stack_chk_fail",
                       "__snprintf_chk"});
}

}  // namespace
}  // namespace frana::test
