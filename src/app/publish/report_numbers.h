// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>

#include "app/text/number_text.h"
#include "core/words/words.h"

namespace frana::app {

/// Numbers and units as a report shows them in its language.
class ReportNumbers {
  public:
    explicit ReportNumbers(const Words& words) : words_(words) {}

    [[nodiscard]] std::string operator()(double value, int digits = 4) const {
        return words_.number(number_text(value, digits));
    }
    template <class T>
    [[nodiscard]] std::string grouped(T value) const {
        return words_.number(app::grouped(value));
    }
    /// Of any size: in groups of digits from a thousand on.
    [[nodiscard]] std::string of_any_size(double value) const {
        return std::abs(value) < 1000 ? (*this)(value) : grouped(value);
    }
    /// Of a fraction, without the sign.
    [[nodiscard]] std::string percent(double fraction) const { return (*this)(100 * fraction, 2); }
    /// With so many digits, in groups where they do not reach to the decimals.
    [[nodiscard]] std::string rounded(double value, int digits = 4) const {
        return std::abs(value) < std::pow(10, digits) ? (*this)(value, digits) : grouped(value);
    }
    /// Returns "m³/s" for "m3/s", nothing for "-".
    [[nodiscard]] static std::string unit(const std::string& text) { return text == "-" ? "" : unit_sign(text); }

  private:
    const Words& words_;
};

}  // namespace frana::app
