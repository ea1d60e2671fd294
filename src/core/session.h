// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>

#include "core/grid_spec.h"

namespace frana {

/// A function and its arguments, bit by bit.
class ReadKey {
  public:
    void add(const std::string& text) {
        add(text.size());
        key_ += text;
    }
    template <class Value>
    requires std::is_arithmetic_v<Value> || std::is_enum_v<Value> || std::is_pointer_v<Value>
    void add(Value value) {
        char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        key_.append(bytes, sizeof bytes);
    }
    void add(Point point) { add_all(point.x, point.y); }
    void add(const Bounds& box) { add_all(box.west, box.south, box.east, box.north); }
    void add(const GridSpec& grid) {
        add_all(grid.west, grid.north, grid.cell_size, grid.columns, grid.rows, grid.crs_wkt, grid.origin_column,
                grid.origin_row);
    }
    template <class T>
    void add(const std::optional<T>& value) {
        add(value.has_value());
        if (value) add(*value);
    }
    /// A type that lists its members.
    template <class T>
    requires requires(const T& value) { value.members(); }
    void add(const T& value) {
        std::apply([this](const auto&... members) { add_all(members...); }, value.members());
    }
    template <class... T>
    void add_all(const T&... values) {
        (add(values), ...);
    }
    [[nodiscard]] const std::string& text() const noexcept { return key_; }

  private:
    std::string key_;
};

/// What functions that read files returned, by function and all its arguments: who reads the same again, as the members
/// of a study do, gets the same again, even if the file has changed. May be used by several threads; files are read by
/// one at a time. Memory is freed with the object.
class RememberedReads {
  public:
    /// Returns what was remembered, or else what `read` returns, which may throw: then nothing is kept.
    template <class Result, class... Parameters>
    Result get(Result (*read)(Parameters...), const std::remove_cvref_t<Parameters>&... arguments) {
        ReadKey key;
        key.add_all(read, arguments...);
        std::shared_ptr<const Result> known;
        {
            const std::lock_guard lock(mutex_);
            std::shared_ptr<const void>& kept = kept_[key.text()];
            if (!kept) kept = std::make_shared<const Result>(read(arguments...));
            known = std::static_pointer_cast<const Result>(kept);
        }
        return *known;
    }

  private:
    std::mutex mutex_;
    std::map<std::string, std::shared_ptr<const void>> kept_;
};

/// What whoever starts the program decides for all that is read and run: no scene can change it.
struct Session {
    double memory_limit = 0;                   ///< total memory that may be used [bytes]; 0: whatever the machine has
    std::shared_ptr<RememberedReads> reads{};  ///< null: every file is read anew

    /// Returns what a function that reads files returns, or returned before.
    template <class Result, class... Parameters>
    Result read(Result (*function)(Parameters...),
                const std::type_identity_t<std::remove_cvref_t<Parameters>>&... arguments) const {
        return reads ? reads->get(function, arguments...) : function(arguments...);
    }
};

}  // namespace frana
