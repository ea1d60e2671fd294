// SPDX-License-Identifier: Apache-2.0
#include "core/markup.h"

#include <array>
#include <cstdint>
#include <cstdio>

#include "core/utf8.h"

namespace frana {

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

}  // namespace frana
