// SPDX-License-Identifier: Apache-2.0
#include "core/json.h"

#include <array>
#include <charconv>
#include <cmath>

#include "core/utf8.h"

namespace frana {

std::string shortest_text(double value) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

std::string json_quoted(std::string_view text) {
    static constexpr char k_hex[] = "0123456789abcdef";
    std::string quoted = "\"";
    for (const char c : valid_utf8(text)) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            quoted += '\\';
            quoted += c;
        } else if (c == '\n') {
            quoted += "\\n";
        } else if (c == '\t') {
            quoted += "\\t";
        } else if (byte < 0x20) {
            quoted += "\\u00";
            quoted += k_hex[byte >> 4];
            quoted += k_hex[byte & 15];
        } else {
            quoted += c;
        }
    }
    return quoted + '"';
}

void JsonWriter::place(std::string_view key) {
    if (!has_items_.empty()) {
        if (has_items_.back()) out_ += ',';
        has_items_.back() = true;
        out_ += '\n';
        out_.append(2 * has_items_.size(), ' ');
    }
    if (!key.empty()) {
        out_ += json_quoted(key);
        out_ += ": ";
    }
}

void JsonWriter::open(std::string_view key, char bracket) {
    place(key);
    out_ += bracket;
    has_items_.push_back(false);
}

void JsonWriter::close(char bracket) {
    const bool had_items = has_items_.back();
    has_items_.pop_back();
    if (had_items) {
        out_ += '\n';
        out_.append(2 * has_items_.size(), ' ');
    }
    out_ += bracket;
}

JsonWriter& JsonWriter::begin_object(std::string_view key) {
    open(key, '{');
    return *this;
}

JsonWriter& JsonWriter::end_object() {
    close('}');
    return *this;
}

JsonWriter& JsonWriter::begin_array(std::string_view key) {
    open(key, '[');
    return *this;
}

JsonWriter& JsonWriter::end_array() {
    close(']');
    return *this;
}

JsonWriter& JsonWriter::number(std::string_view key, double value) {
    place(key);
    out_ += std::isfinite(value) ? shortest_text(value) : "null";
    return *this;
}

JsonWriter& JsonWriter::integer(std::string_view key, std::int64_t value) {
    place(key);
    out_ += std::to_string(value);
    return *this;
}

JsonWriter& JsonWriter::text(std::string_view key, std::string_view value) {
    place(key);
    out_ += json_quoted(value);
    return *this;
}

JsonWriter& JsonWriter::boolean(std::string_view key, bool value) {
    place(key);
    out_ += value ? "true" : "false";
    return *this;
}

JsonWriter& JsonWriter::null(std::string_view key) {
    place(key);
    out_ += "null";
    return *this;
}

std::string JsonWriter::str() const {
    return out_ + '\n';
}

}  // namespace frana
