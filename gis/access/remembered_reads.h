// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <type_traits>

#include "core/grid_spec.h"

namespace frana::gis {

/// What reading functions returned, by function and all its arguments: who reads the same again, as the members of a
/// study do, gets the same again, even if the file has changed. May be used by several threads; files are read by one
/// at a time. Memory is freed with the object.
class RememberedReads {
  public:
    RememberedReads() = default;
    RememberedReads(const RememberedReads&) = delete;
    RememberedReads& operator=(const RememberedReads&) = delete;

    /// Returns what was remembered for a key, or else what `read` returns, which may throw: then nothing is kept.
    template <class Result>
    Result get(const std::string& key, const std::function<Result()>& read) {
        std::shared_ptr<const Result> known;
        {
            const std::lock_guard lock(mutex_);
            std::shared_ptr<const void>& kept = kept_[key];
            if (!kept) kept = std::make_shared<const Result>(read());
            known = std::static_pointer_cast<const Result>(kept);
        }
        return *known;
    }

  private:
    std::recursive_mutex mutex_;  ///< one reading function may call another
    std::map<std::string, std::shared_ptr<const void>> kept_;
};

/// As long as it exists, the reading functions that this thread calls use a memory of earlier reads.
class UseRemembered {
  public:
    explicit UseRemembered(RememberedReads& reads);
    ~UseRemembered();
    UseRemembered(const UseRemembered&) = delete;
    UseRemembered& operator=(const UseRemembered&) = delete;

  private:
    RememberedReads* before_;
};

/// That of this thread; null: none.
RememberedReads* remembered_reads() noexcept;

/// The name of a function and its arguments, bit by bit.
class ReadKey {
  public:
    explicit ReadKey(const std::string& function) { add(function); }

    void add(const std::string& text) {
        add(text.size());
        key_ += text;
    }
    template <class Number, std::enable_if_t<std::is_arithmetic_v<Number> || std::is_enum_v<Number>, int> = 0>
    void add(Number number) {
        char bytes[sizeof number];
        std::memcpy(bytes, &number, sizeof number);
        key_.append(bytes, sizeof bytes);
    }
    void add(Point point) { add_all(point.x, point.y); }
    void add(const GridSpec& grid) {
        add_all(grid.west, grid.north, grid.cell_size, grid.columns, grid.rows, grid.crs_wkt, grid.origin_column,
                grid.origin_row);
    }
    template <class T>
    void add(const std::optional<T>& value) {
        add(value.has_value());
        if (value) add(*value);
    }
    template <class... T>
    void add_all(const T&... values) {
        (add(values), ...);
    }
    [[nodiscard]] const std::string& text() const noexcept { return key_; }

  private:
    std::string key_;
};

/// Returns read(), or what this thread's memory knows of it. The arguments must be all that `read` depends on besides
/// files.
template <class Read, class... Arguments>
auto remembered(const char* function, const Read& read, const Arguments&... arguments) {
    RememberedReads* const reads = remembered_reads();
    if (reads == nullptr) return read();
    ReadKey key(function);
    key.add_all(arguments...);
    return reads->get<decltype(read())>(key.text(), read);
}

}  // namespace frana::gis
