// SPDX-License-Identifier: Apache-2.0
#include "app/store/json_file.h"

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/files.h"

namespace frana::app {
namespace {

// A file that does not exist or is not accessible counts as absent; a read error of the disk is a problem.
bool is_not_there(int reason) {
    return reason == ENOENT || reason == ENOTDIR || reason == EISDIR || reason == EACCES || reason == EPERM ||
           reason == ELOOP || reason == ENAMETOOLONG || reason == EINVAL;
}

}  // namespace

std::optional<Json> read_json_file(const std::string& path) {
    std::string text;
    const int reason = read_blocks(path, [&](std::string_view bytes) { text += bytes; });
    if (is_not_there(reason)) return std::nullopt;
    if (reason != 0)
        throw Error(ErrorKind::environment, Problem{std::string("cannot be read: ") + std::strerror(reason), path, "",
                                                    "", system_remedy(reason)});
    Json json = Json::parse(text, nullptr, false);
    return json.is_discarded() ? std::nullopt : std::optional(std::move(json));
}

template <class T>
std::optional<T> value_in(const Json& json, const std::string& pointer) {
    const Json::json_pointer place(pointer);
    if (!json.contains(place)) return std::nullopt;
    const Json& value = json[place];
    const bool is_of_type = std::is_same_v<T, bool>           ? value.is_boolean()
                            : std::is_same_v<T, std::int64_t> ? value.is_number_integer()
                            : std::is_same_v<T, double>       ? value.is_number()
                                                              : value.is_string();
    return is_of_type ? std::optional(value.get<T>()) : std::nullopt;
}

template std::optional<bool> value_in(const Json&, const std::string&);
template std::optional<double> value_in(const Json&, const std::string&);
template std::optional<std::int64_t> value_in(const Json&, const std::string&);
template std::optional<std::string> value_in(const Json&, const std::string&);

}  // namespace frana::app
