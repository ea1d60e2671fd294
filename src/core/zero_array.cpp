// SPDX-License-Identifier: Apache-2.0
#include "core/zero_array.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>

namespace frana {
namespace {

// Arrays of at least this size are of large maps, of which a flow touches little: a huge page would be mostly zeros.
constexpr std::size_t k_sparse_bytes = std::size_t{1} << 30;

std::size_t page_size() noexcept {
    return static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

}  // namespace

void* map_zero_pages(std::size_t bytes) noexcept {
    void* const pages =
        ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (pages == MAP_FAILED) return nullptr;
    if (bytes >= k_sparse_bytes) ::madvise(pages, bytes, MADV_NOHUGEPAGE);
    return pages;
}

void unmap_zero_pages(void* pages, std::size_t bytes) noexcept {
    ::munmap(pages, bytes);
}

TouchedPages::TouchedPages(const void* pages, std::size_t bytes) : page_(page_size()) {
    if (pages == nullptr || bytes == 0) return;
    const int file = ::open("/proc/self/pagemap", O_RDONLY | O_CLOEXEC);
    if (file < 0) return;
    constexpr std::uint64_t k_present = std::uint64_t{1} << 63, k_swapped = std::uint64_t{1} << 62;
    constexpr std::size_t k_at_once = 65536;
    std::vector<std::uint64_t> entries(k_at_once);
    const std::size_t count = (bytes + page_ - 1) / page_, first = reinterpret_cast<std::uintptr_t>(pages) / page_;
    touched_.assign(count, 0);
    for (std::size_t done = 0; done < count;) {
        const std::size_t wanted = std::min(k_at_once, count - done) * sizeof(std::uint64_t);
        const ssize_t read =
            ::pread(file, entries.data(), wanted, static_cast<off_t>((first + done) * sizeof(std::uint64_t)));
        if (read < static_cast<ssize_t>(sizeof(std::uint64_t))) {
            touched_.clear();
            break;
        }
        const std::size_t got = static_cast<std::size_t>(read) / sizeof(std::uint64_t);
        for (std::size_t k = 0; k < got; ++k) touched_[done + k] = (entries[k] & (k_present | k_swapped)) != 0;
        done += got;
    }
    ::close(file);
}

bool TouchedPages::any(std::size_t offset, std::size_t length) const noexcept {
    if (touched_.empty()) return true;
    const std::size_t first = offset / page_, end = std::min((offset + length + page_ - 1) / page_, touched_.size());
    for (std::size_t page = first; page < end; ++page)
        if (touched_[page] != 0) return true;
    return false;
}

}  // namespace frana
