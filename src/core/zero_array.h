// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace frana {

/// A fixed array that starts as zeros and costs memory only where it is written: the system hands out zero
/// pages on first touch. Grid-wide fields use it so that idle terrain costs nothing.
template <class T>
class ZeroArray {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

  public:
    ZeroArray() = default;
    explicit ZeroArray(std::size_t size) : block_(std::calloc(size + 1, k_stride)), size_(size) {
        if (!block_) throw std::bad_alloc();
        // calloc aligns to 16 bytes only; one spare element lets the array begin on T's own boundary.
        void* place = block_.get();
        std::size_t room = (size + 1) * k_stride;
        data_ = static_cast<T*>(std::align(alignof(T), size * k_stride, place, room));
    }
    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] T* data() noexcept { return data_; }
    [[nodiscard]] const T* data() const noexcept { return data_; }
    T& operator[](std::size_t i) noexcept { return data_[i]; }
    const T& operator[](std::size_t i) const noexcept { return data_[i]; }

  private:
    struct Free {
        void operator()(void* p) const noexcept { std::free(p); }
    };
    static constexpr std::size_t k_stride = sizeof(T);
    static_assert(alignof(T) <= k_stride);
    std::unique_ptr<void, Free> block_;
    T* data_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace frana
