// SPDX-License-Identifier: Apache-2.0
// Serialisation of state to bytes and back. Each class with state has one function template `serialise` that lists its
// members; the archive passed to it writes or reads, so everything written is also read.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/zero_array.h"

namespace frana {

template <class Archive, class T>
void transfer(Archive& archive, T& value);

/// Writes state; never changes it.
class StateWriter {
  public:
    static constexpr bool k_reads = false;
    using Sink = std::function<void(const void*, std::size_t)>;

    explicit StateWriter(Sink sink) : sink_(std::move(sink)) {}
    /// Appends to `text`.
    explicit StateWriter(std::string& text)
        : sink_([&text](const void* from, std::size_t count) { text.append(static_cast<const char*>(from), count); }) {}
    template <class... T>
    void operator()(T&... values) {
        (transfer(*this, values), ...);
    }
    void bytes(const void* from, std::size_t count) { sink_(from, count); }

  private:
    Sink sink_;
};

/// Reads state into objects set up for the same scene. Throws Error(input) if the stored state does not match them.
class StateReader {
  public:
    static constexpr bool k_reads = true;
    using Source = std::function<void(void*, std::size_t)>;  ///< throws Error(input) at the end of the data

    /// @param size bytes available from the source: no count read may exceed it
    StateReader(Source source, std::uint64_t size) : source_(std::move(source)), left_(size) {}
    /// @param text which must outlive the reader
    explicit StateReader(std::string_view text)
        : StateReader(
              [next = text.data()](void* to, std::size_t count) mutable {
                  std::copy_n(next, count, static_cast<char*>(to));
                  next += count;
              },
              text.size()) {}
    template <class... T>
    void operator()(T&... values) {
        (transfer(*this, values), ...);
    }
    void bytes(void* to, std::size_t count) {
        require(count <= left_);
        source_(to, count);
        left_ -= count;
    }
    [[nodiscard]] std::uint64_t left() const noexcept { return left_; }
    static void require(bool fits) {
        if (!fits)
            throw Error(ErrorKind::input, Problem{"the saved state does not fit this program and scene", "checkpoint",
                                                  "", "", "Run the scene from its start"});
    }

  private:
    Source source_;
    std::uint64_t left_;
};

/// A number of items of at least `size` bytes each.
template <class Archive>
std::size_t transfer_count(Archive& archive, std::size_t count, std::size_t size) {
    std::uint64_t n = count;
    archive(n);
    if constexpr (Archive::k_reads) StateReader::require(n <= archive.left() / size);
    return static_cast<std::size_t>(n);
}

template <class T>
inline constexpr bool k_plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

template <class Archive, class T>
void serialise(Archive& archive, std::vector<T>& list) {
    const std::size_t count = transfer_count(archive, list.size(), 1);
    if constexpr (Archive::k_reads) list.resize(count);
    if constexpr (k_plain<T>) {
        archive.bytes(list.data(), count * sizeof(T));
    } else {
        for (T& value : list) archive(value);
    }
}

template <class Archive, class T, std::size_t Size>
void serialise(Archive& archive, std::array<T, Size>& list) {
    for (T& value : list) archive(value);
}

template <class Archive>
void serialise(Archive& archive, std::string& text) {
    text.resize(transfer_count(archive, text.size(), 1));
    archive.bytes(text.data(), text.size());
}

/// The object must exist on both sides or on neither: the scene decides.
template <class Archive, class T>
void serialise(Archive& archive, std::unique_ptr<T>& value) {
    bool there = value != nullptr;
    archive(there);
    if constexpr (Archive::k_reads) StateReader::require(there == (value != nullptr));
    if (there) archive(*value);
}

/// Elements are serialised by their own type, else as bytes; blocks of zeros are omitted, so that idle terrain costs
/// almost nothing.
template <class Archive, class T>
void serialise(Archive& archive, ZeroArray<T>& array) {
    constexpr std::size_t k_block = std::max<std::size_t>(1, 4096 / sizeof(T));  // elements
    static constexpr std::array<std::byte, k_block * sizeof(T)> k_zeros{};
    std::uint64_t size = array.size();
    archive(size);
    if constexpr (Archive::k_reads) {
        StateReader::require(array.size() == size);  // the scene decides
        array = ZeroArray<T>(array.size());
    }
    const TouchedPages touched = array.touched();
    const std::uint64_t blocks = (array.size() + k_block - 1) / k_block;
    const auto count = [&](std::uint64_t block) { return std::min<std::size_t>(k_block, size - block * k_block); };
    const auto empty = [&](std::uint64_t block) {
        const std::size_t bytes = count(block) * sizeof(T);
        return !touched.any(block * k_block * sizeof(T), bytes) ||
               std::memcmp(array.data() + block * k_block, k_zeros.data(), bytes) == 0;
    };
    // Runs of non-zero blocks: [first, last), until an empty run.
    std::uint64_t first = 0, last = 0;
    do {
        if constexpr (!Archive::k_reads) {
            for (first = last; first < blocks && empty(first);) ++first;
            for (last = first; last < blocks && !empty(last);) ++last;
        }
        archive(first, last);
        if constexpr (Archive::k_reads) StateReader::require(first <= last && last <= blocks);
        if (first == last) continue;
        T* const from = array.data() + first * k_block;
        const std::size_t elements = (last - first - 1) * k_block + count(last - 1);
        if constexpr (requires(T & value) { value.serialise(archive); }) {
            for (std::size_t i = 0; i < elements; ++i) archive(from[i]);
        } else {
            archive.bytes(from, elements * sizeof(T));
        }
    } while (first < last);
}

/// One value, serialised by its own member function, by a free function beside its type or, for numbers, as bytes.
template <class Archive, class T>
void transfer(Archive& archive, T& value) {
    if constexpr (requires { value.serialise(archive); }) {
        value.serialise(archive);
    } else if constexpr (std::is_same_v<T, bool>) {
        std::uint8_t byte = value ? 1 : 0;
        archive.bytes(&byte, sizeof byte);
        if constexpr (Archive::k_reads) StateReader::require(byte <= 1);
        value = byte == 1;
    } else if constexpr (k_plain<T>) {
        archive.bytes(&value, sizeof value);
    } else {
        serialise(archive, value);
    }
}

}  // namespace frana
