// SPDX-License-Identifier: Apache-2.0
#include "gis/access/json_members.h"

#include <algorithm>

namespace frana::gis {
namespace {

constexpr std::size_t k_longest = 65536;  // of a stored key or value
constexpr std::size_t k_most_members = 100;

}  // namespace

void JsonMembers::read(const char* bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) step(bytes[i]);
}

void JsonMembers::step(char c) {
    if (reading_ && !in_string_ && levels_.size() == depth_of_text_ && (c == ',' || c == '}')) end_value();
    if (reading_ && text_.size() < k_longest) text_ += c;
    if (in_string_) {
        if (escaped_ || (c != '"' && c != '\\')) {
            escaped_ = false;
            if (string_.size() < k_longest) string_ += c;
        } else if (c == '\\') {
            escaped_ = true;
        } else {
            in_string_ = false;
        }
        return;
    }
    switch (c) {
        case '"':
            in_string_ = true;
            string_.clear();
            break;
        case ':':
            if (levels_.empty() || !levels_.back().expects_key) break;
            levels_.back().key = string_;
            levels_.back().expects_key = false;
            if (!reading_ && !levels_.back().left_out && string_ == name_) {
                reading_ = true;
                depth_of_text_ = levels_.size();
                text_.clear();
            }
            break;
        case ',':
            if (!levels_.empty()) levels_.back().expects_key = levels_.back().is_object;
            break;
        case '{':
        case '[':
            open(c);
            break;
        case '}':
        case ']':
            close();
            break;
        default:
            break;
    }
}

void JsonMembers::open(char c) {
    const bool left_out = !levels_.empty() && (levels_.back().left_out || levels_.back().key == besides_);
    levels_.push_back({c == '{', c == '{', left_out});
}

void JsonMembers::close() {
    if (!levels_.empty()) levels_.pop_back();
}

void JsonMembers::end_value() {
    reading_ = false;
    const auto from = text_.find_first_not_of(" \t\r\n"), to = text_.find_last_not_of(" \t\r\n");
    JsonMember member{from == std::string::npos ? "" : text_.substr(from, to - from + 1), depth_of_text_ == 1};
    const auto same = [&](const JsonMember& one) { return one.text == member.text && one.at_top == member.at_top; };
    if (found_.size() < k_most_members && std::none_of(found_.begin(), found_.end(), same))
        found_.push_back(std::move(member));
}

}  // namespace frana::gis
