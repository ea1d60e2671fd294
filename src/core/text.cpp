// SPDX-License-Identifier: Apache-2.0
#include "core/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>

namespace frana {
namespace {

/// Lead bytes and the range of the second byte, which excludes overlong forms, surrogates and codes beyond Unicode.
struct Form {
    unsigned char first, last;  ///< lead bytes
    std::size_t length;
    unsigned char least, most;  ///< second byte
};
constexpr Form k_forms[] = {{0x00, 0x7F, 1, 0x00, 0xFF}, {0xC2, 0xDF, 2, 0x80, 0xBF}, {0xE0, 0xE0, 3, 0xA0, 0xBF},
                            {0xE1, 0xEC, 3, 0x80, 0xBF}, {0xED, 0xED, 3, 0x80, 0x9F}, {0xEE, 0xEF, 3, 0x80, 0xBF},
                            {0xF0, 0xF0, 4, 0x90, 0xBF}, {0xF1, 0xF3, 4, 0x80, 0xBF}, {0xF4, 0xF4, 4, 0x80, 0x8F}};

unsigned char byte_at(std::string_view text, std::size_t at) noexcept {
    return static_cast<unsigned char>(text[at]);
}

std::string written_out(std::string_view text, bool controls) {
    static constexpr char k_hex[] = "0123456789abcdef";
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        const unsigned char byte = byte_at(text, i);
        const std::size_t length = utf8_length(text, i);
        if (length == 0 || (controls && (byte < 0x20 || byte == 0x7F))) {
            out += "\\x";
            out += k_hex[byte >> 4];
            out += k_hex[byte & 15];
        } else {
            out += text.substr(i, length);
        }
        i += std::max<std::size_t>(1, length);
    }
    return out;
}

}  // namespace

std::size_t utf8_length(std::string_view text, std::size_t at) noexcept {
    for (const Form& form : k_forms) {
        const unsigned char lead = byte_at(text, at);
        if (lead < form.first || lead > form.last) continue;
        if (form.length == 1) return 1;
        if (at + form.length > text.size()) return 0;
        const unsigned char second = byte_at(text, at + 1);
        if (second < form.least || second > form.most) return 0;
        for (std::size_t k = 2; k < form.length; ++k)
            if ((byte_at(text, at + k) & 0xC0) != 0x80) return 0;
        return form.length;
    }
    return 0;
}

std::string valid_utf8(std::string_view text) {
    return written_out(text, false);
}

std::string one_line(std::string_view text) {
    return written_out(text, true);
}

std::string elided(std::string_view text, std::size_t most) {
    std::size_t characters = 0, kept = 0;  // `kept`: bytes of the first most - 1 characters
    for (std::size_t i = 0; i < text.size(); ++characters) {
        if (characters + 1 == most) kept = i;
        if (characters == most) return std::string(text.substr(0, kept)) + "\u2026";
        i += std::max<std::size_t>(1, utf8_length(text, i));
    }
    return std::string(text);
}

std::string shortest_text(double value) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

std::string shown_text(std::string_view text) {
    // Of the bytes of a character as one number: line ends and tabs stay.
    const auto is_hidden = [](std::uint32_t bytes) {
        const auto within = [bytes](std::uint32_t first, std::uint32_t last) {
            return bytes >= first && bytes <= last;
        };
        return (bytes < 0x20 && bytes != '\t' && bytes != '\n' && bytes != '\r') || within(0x7F, 0x7F) ||
               within(0xC280, 0xC29F) ||      // U+0080 to U+009F
               within(0xD89C, 0xD89C) ||      // U+061C
               within(0xE2808E, 0xE2808F) ||  // U+200E, U+200F
               within(0xE280A8, 0xE280AE) ||  // U+2028 to U+202E
               within(0xE281A6, 0xE281A9) ||  // U+2066 to U+2069
               within(0xEFBBBF, 0xEFBBBF) ||  // U+FEFF
               within(0xEFBFBE, 0xEFBFBF);    // U+FFFE, U+FFFF
    };
    const std::string valid = valid_utf8(text);
    std::string out;
    for (std::size_t i = 0, length = 0; i < valid.size(); i += length) {
        length = utf8_length(valid, i);
        std::uint32_t bytes = 0;
        for (std::size_t k = 0; k < length; ++k) bytes = bytes << 8 | static_cast<unsigned char>(valid[i + k]);
        if (is_hidden(bytes))
            out += ' ';
        else
            out.append(valid, i, length);
    }
    return out;
}

std::string escaped_markup(std::string_view text) {
    std::string out;
    for (const char c : shown_text(text)) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\'':
                out += "&#39;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

std::string hex(Rgb colour) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", colour.r, colour.g, colour.b);
    return text.data();
}

std::string base64(std::string_view bytes) {
    static constexpr char k_signs[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? k_signs[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

}  // namespace frana
