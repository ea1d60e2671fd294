// SPDX-License-Identifier: Apache-2.0
#include "core/utf8.h"

#include <algorithm>

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

}  // namespace frana
