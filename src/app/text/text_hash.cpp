// SPDX-License-Identifier: Apache-2.0
#include "app/text/text_hash.h"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>

namespace frana::app {

std::string text_hash(const std::string& text) {
    return to_string(boost::uuids::name_generator_sha1(boost::uuids::ns::url())(text));
}

}  // namespace frana::app
