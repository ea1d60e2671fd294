// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
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

}  // namespace frana
