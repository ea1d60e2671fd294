// SPDX-License-Identifier: Apache-2.0
#include "app/store/json_file.h"

#include <boost/property_tree/json_parser.hpp>
#include <cerrno>
#include <cstring>
#include <sstream>

#include "core/error.h"
#include "core/read_blocks.h"
#include "core/system_remedy.h"
#include "params/grammar/value_text.h"

namespace frana::app {
namespace {

// What is not there for this program is none; what the disk does not give is a fault.
bool is_not_there(int reason) {
    return reason == ENOENT || reason == ENOTDIR || reason == EISDIR || reason == EACCES || reason == EPERM ||
           reason == ELOOP || reason == ENAMETOOLONG || reason == EINVAL;
}

}  // namespace

std::optional<JsonTree> read_json_file(const std::string& path) {
    std::string text;
    const int reason = read_blocks(path, [&](std::string_view bytes) { text += bytes; });
    if (is_not_there(reason)) return std::nullopt;
    if (reason != 0)
        throw Error(ErrorKind::environment, Problem{std::string("cannot be read: ") + std::strerror(reason), path, "",
                                                    "", system_remedy(reason)});
    JsonTree tree;
    try {
        std::istringstream stream(text);
        boost::property_tree::read_json(stream, tree);
    } catch (const boost::property_tree::json_parser_error&) {
        return std::nullopt;
    }
    return tree;
}

std::optional<double> number_in(const JsonTree& tree, const std::string& path) {
    const auto text = tree.get_optional<std::string>(path);
    return text ? number_from_text(*text) : std::nullopt;
}

}  // namespace frana::app
