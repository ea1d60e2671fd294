// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <any>
#include <map>
#include <typeindex>

namespace frana {

/// The values of the laws' keys, by law: only who reads a law's values includes its header, so that a changed law is
/// compiled where it is used and nowhere else.
class LawValues {
  public:
    template <class Law>
    [[nodiscard]] typename Law::Values& of() {
        std::any& values = values_[typeid(Law)];
        if (!values.has_value()) values = typename Law::Values{};
        return *std::any_cast<typename Law::Values>(&values);
    }
    /// Returns those of a fresh scene where nothing was set.
    template <class Law>
    [[nodiscard]] const typename Law::Values& of() const {
        static const typename Law::Values fresh;
        const auto found = values_.find(typeid(Law));
        return found == values_.end() ? fresh : *std::any_cast<typename Law::Values>(&found->second);
    }

  private:
    std::map<std::type_index, std::any> values_;
};

}  // namespace frana
