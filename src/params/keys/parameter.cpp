// SPDX-License-Identifier: Apache-2.0
#include "params/keys/parameter.h"

namespace frana {

std::string present_name(const std::string& name) {
    const std::string scar = "scar.";
    return name.starts_with(scar) ? "observed." + name.substr(scar.size()) : name;
}

}  // namespace frana
