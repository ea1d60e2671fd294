// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "params/keys/shared_values.h"

namespace frana::bench {

/// Gives each key that a law of a list needs and the material lacks a value within its limits, so that every law can be
/// built.
template <class List, class Values>
void give_needed_keys(Values& values) {
    List::for_each([&]<class Law>() {
        for_each_key<Law>([&](const auto& key) {
            if constexpr (requires { values.*key.member = key.range.highest; }) {
                if (key.needed() && !(values.*key.member))
                    values.*key.member = std::sqrt(key.range.highest * std::fmax(key.range.lowest, 1e-3));
            }
        });
    });
}

}  // namespace frana::bench
