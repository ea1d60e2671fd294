// SPDX-License-Identifier: Apache-2.0
// Runs every file of a corpus through a harness, then random changes of them, without a fuzzer and with any compiler:
// replay_NAME FOLDER [COUNT]. FRANA_SEED (default 1) selects others: the same seed and count give the same inputs on
// every machine. An input on which a harness crashed is left in replay_NAME.input.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string_view>
#include <vector>

#include "harness.h"

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;
using Random = std::mt19937_64;

// Returns a number below `count`, which is positive.
std::size_t below(Random& random, std::size_t count) {
    return static_cast<std::size_t>(random() % count);
}

// Values difficult for readers: non-finite, too large or negative numbers, both as text and as bytes.
constexpr std::string_view k_words[] = {"nan",
                                        "inf",
                                        "-1",
                                        "1e308",
                                        "-1e-308",
                                        "0",
                                        "99999999999999999999",
                                        "",
                                        "\n",
                                        ",",
                                        "=",
                                        "[",
                                        "\"",
                                        std::string_view("\0\0\0\0", 4),
                                        "\xff\xff\xff\xff",
                                        std::string_view("\0\0\0\x80", 4),
                                        std::string_view("\0\0\0\0\0\0\xf8\x7f", 8),
                                        "\xc3\x28"};

void change(Bytes& bytes, const std::vector<Bytes>& corpus, Random& random) {
    constexpr std::size_t k_longest = 64;
    const std::size_t place = below(random, bytes.size() + 1);
    const auto at = [&](Bytes& list, std::size_t i) { return list.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::size_t most = std::min(k_longest, bytes.size() - place);
    switch (random() % 6) {
        case 0:
            if (place < bytes.size()) bytes[place] ^= static_cast<std::uint8_t>(1U << (random() % 8));
            break;
        case 1:
            if (place < bytes.size()) bytes[place] = static_cast<std::uint8_t>(random());
            break;
        case 2:
            bytes.erase(at(bytes, place), at(bytes, place + below(random, most + 1)));
            break;
        case 3: {  // a word, over the present bytes or before them
            const std::string_view word = k_words[below(random, std::size(k_words))];
            if (random() % 2 == 0) bytes.erase(at(bytes, place), at(bytes, place + std::min(most, word.size())));
            bytes.insert(at(bytes, place), word.begin(), word.end());
            break;
        }
        case 4: {  // a piece of another input
            Bytes other = corpus[below(random, corpus.size())];
            if (other.empty()) break;
            const std::size_t from = below(random, other.size());
            const std::size_t count = 1 + below(random, std::min(k_longest, other.size() - from));
            bytes.insert(at(bytes, place), at(other, from), at(other, from + count));
            break;
        }
        default:
            if (random() % 8 == 0) bytes.resize(place);
    }
}

// Kept on disk while the harness runs.
void run_saved(const Bytes& bytes, const fs::path& file) {
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

}  // namespace

int main(int count, char** words) {
    if (count != 2 && count != 3) {
        std::fprintf(stderr, "usage: %s FOLDER [COUNT]\n", words[0]);
        return 2;
    }
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(words[1])) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    const fs::path kept = fs::path(words[0]).filename() += ".input";
    std::vector<Bytes> corpus;
    for (const auto& file : files) {
        std::ifstream stream(file, std::ios::binary);
        const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
        run_saved(corpus.emplace_back(bytes.begin(), bytes.end()), kept);
    }
    const long wanted = count == 3 ? std::atol(words[2]) : 0;
    const char* const asked = std::getenv("FRANA_SEED");
    const std::uint64_t seed = asked != nullptr ? std::strtoull(asked, nullptr, 10) : 1;
    std::printf("%zu inputs, %ld changes of them, seed %llu\n", corpus.size(), wanted,
                static_cast<unsigned long long>(seed));
    std::fflush(stdout);
    Random random(seed);
    for (long tried = 0; tried < wanted && !corpus.empty(); ++tried) {
        Bytes bytes = corpus[below(random, corpus.size())];
        for (std::size_t changes = 1 + below(random, 6); changes > 0; --changes) change(bytes, corpus, random);
        run_saved(bytes, kept);
    }
    fs::remove(kept);
    return corpus.empty() ? 1 : 0;
}
