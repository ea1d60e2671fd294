// SPDX-License-Identifier: Apache-2.0
#include "core/json.h"

#include <nlohmann/json.hpp>

#include "core/text.h"

namespace frana {
namespace {

void make_valid(Json& value) {
    if (auto* const text = value.get_ptr<std::string*>()) *text = valid_utf8(*text);
    if (!value.is_structured()) return;
    for (Json& child : value) make_valid(child);
}

}  // namespace

std::string json_text(Json value) {
    make_valid(value);
    return value.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace frana
