// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

namespace frana {

/// Pages of zeros from the system, which need memory only where they are written, whatever their number: memory is not
/// reserved, and huge pages are not used where only a small part of each would be.
/// Null if the address space is exhausted.
[[nodiscard]] void* map_zero_pages(std::size_t bytes) noexcept;
void unmap_zero_pages(void* pages, std::size_t bytes) noexcept;

/// Which pages of mapped memory may contain non-zero bytes, according to the system. Memory without information counts
/// as touched.
class TouchedPages {
  public:
    /// @param pages from map_zero_pages, or null: everything counts as touched
    TouchedPages(const void* pages, std::size_t bytes);
    /// Whether any page of a part counts as touched; offsets in bytes from the first page.
    [[nodiscard]] bool any(std::size_t offset, std::size_t length) const noexcept;

  private:
    std::vector<std::uint8_t> touched_;  // by page; empty: unknown
    std::size_t page_;
};

/// A fixed array that starts as zeros and needs memory only where it is written: the system allocates zero pages on
/// first touch. Grid-wide fields use it so that idle terrain costs nothing. Throws std::bad_alloc if the address space
/// is exhausted.
template <class T>
class ZeroArray {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

  public:
    ZeroArray() = default;
    explicit ZeroArray(std::size_t size) : size_(size) {
        // One spare element allows the array to begin on T's own boundary: calloc aligns to 16 bytes only.
        std::size_t room = (size + 1) * k_stride;
        const bool maps = room >= k_mapped_bytes;
        block_ = Block(maps ? map_zero_pages(room) : std::calloc(size + 1, k_stride), Free{maps ? room : 0});
        if (!block_) throw std::bad_alloc();
        void* place = block_.get();
        data_ = static_cast<T*>(std::align(alignof(T), size * k_stride, place, room));
    }
    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] T* data() noexcept { return data_; }
    [[nodiscard]] const T* data() const noexcept { return data_; }
    T& operator[](std::size_t i) noexcept { return data_[i]; }
    const T& operator[](std::size_t i) const noexcept { return data_[i]; }
    /// Which of its pages may contain non-zero bytes.
    [[nodiscard]] TouchedPages touched() const {
        return {block_.get_deleter().mapped > 0 ? data_ : nullptr, size_ * k_stride};
    }

  private:
    struct Free {
        std::size_t mapped = 0;  // bytes; 0: from calloc
        void operator()(void* p) const noexcept { mapped > 0 ? unmap_zero_pages(p, mapped) : std::free(p); }
    };
    using Block = std::unique_ptr<void, Free>;
    static constexpr std::size_t k_stride = sizeof(T), k_mapped_bytes = std::size_t{1} << 18;
    static_assert(alignof(T) <= k_stride);
    Block block_;
    T* data_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace frana
