// SPDX-License-Identifier: Apache-2.0
// What a law says of itself, in its own header: its row (Law), its keys (LawKey) and, in `Values`, their
// values. src/physics/laws.h lists the laws; everything else loops over that list.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/text.h"
#include "core/words/words.h"

namespace frana {

/// The key that selects a law.
enum class LawKind { bed_friction, in_plane_stress, erosion, deposition, detrainment };

/// The row of a law. From it follow: the words of the keys, missing and unread keys, the zones used, laws that exclude
/// each other, and the list of terms.
struct Law {
    std::string sentence;                       ///< in the list of terms
    std::string yield_sentence{};               ///< the same for its yield stress, if that is a term of its own
    std::vector<std::string> reads{}, needs{};  ///< keys of other laws or of all, to which the table adds its own
    std::vector<std::string> resists_alike{};   ///< resistances of which a scene may have only one law
    /// The bed resists with at least the friction coefficient times the normal stress, so that an energy line bounds
    /// the run-out.
    bool resists_with_friction = false;
    /// Friction coefficient up to which the law is defined: RAMMS's term (1 - mu) N_0 would be negative above 1.
    double greatest_friction = std::numeric_limits<double>::infinity();
    std::string angle_from_bed{};  ///< key of an angle below that of the bed's friction the law is not defined
    std::string word{};            ///< of the key that selects it; "on" for deposition and detrainment
    LawKind kind = LawKind::bed_friction;

    [[nodiscard]] bool needs_key(const std::string& name) const { return contains(needs, name); }
    [[nodiscard]] bool reads_key(const std::string& name) const { return contains(reads, name) || needs_key(name); }
    /// Bed laws read every key of [zones] that they read elsewhere; in-plane stress does not vary by place.
    [[nodiscard]] bool reads_zone(const std::string& name) const {
        const auto same = [&](const std::string& key) { return quantity_of(key) == quantity_of(name); };
        return kind != LawKind::in_plane_stress &&
               (std::any_of(reads.begin(), reads.end(), same) || std::any_of(needs.begin(), needs.end(), same));
    }
    /// "material.bed-friction = chezy"
    [[nodiscard]] std::string selected_by() const {
        static constexpr const char* k_keys[] = {"material.bed-friction", "material.in-plane-stress",
                                                 "entrainment.erosion", "entrainment.deposition",
                                                 "entrainment.detrainment"};
        return std::string(k_keys[static_cast<int>(kind)]) + " = " + word;
    }

  private:
    static bool contains(const std::vector<std::string>& list, const std::string& name) {
        return std::find(list.begin(), list.end(), name) != list.end();
    }
    /// Returns "cohesion" for "material.cohesion" and "zones.cohesion".
    static std::string quantity_of(const std::string& key) { return key.substr(key.find('.') + 1); }
};

/// A number that a law brings with it, in the unit of scene files. Not given and without an effect when absent: the law
/// needs it.
template <class Values, class Number>
struct LawKey {
    Number Values::*member;  ///< double with its default, or optional
    const char* name;
    const char* called;  ///< in the report; empty: as in scene files
    const char* unit;
    NumberRange range;
    const char* meaning;
    std::string absent{};  ///< the effect if an optional one is not given
    bool may_be_off = false;

    [[nodiscard]] bool needed() const { return !std::is_same_v<Number, double> && absent.empty(); }
};

template <class Values, class Number>
LawKey<Values, Number> law_key(Number Values::*member, const char* name, const char* called, const char* unit,
                               NumberRange range, const char* meaning, std::string absent = {},
                               bool may_be_off = false) {
    return {member, name, called, unit, range, meaning, std::move(absent), may_be_off};
}

/// Friction angles: degrees in scene files, tangents in laws.
inline double tangent_of(double degrees) {
    return std::tan(degrees * std::numbers::pi / 180);
}

template <class Law>
struct OwnValues {};
template <class Law>
requires requires {
    typename Law::Values;
}
struct OwnValues<Law> : Law::Values {};

/// Laws of a kind, as types: the one list of them.
template <LawKind Kind, class... Laws>
struct LawList {
    static constexpr LawKind kind = Kind;
    struct Values : OwnValues<Laws>... {};  ///< of their keys
    /// One of them or `None`; a sweep visits it once, outside its loop.
    template <class None>
    using Chosen = std::variant<None, Laws...>;
    /// One value for each of them and for `None`.
    template <template <class> class For, class None>
    using ForEach = std::tuple<For<None>, For<Laws>...>;

    /// Calls visit.operator()<Law>() for each.
    template <class Visit>
    static void for_each(Visit&& visit) {
        (visit.template operator()<Laws>(), ...);
    }
};

/// Returns the values of all laws of a list, of which a law is built.
/// @param values of LawValues
template <class List, class Values>
typename List::Values all_values(const Values& values) {
    typename List::Values all;
    List::for_each([&]<class Law>() {
        if constexpr (requires { typename Law::Values; })
            static_cast<typename Law::Values&>(all) = values.template of<Law>();
    });
    return all;
}

/// Calls a function for each key that a law brings with it.
template <class Law, class Function>
void for_each_key(Function&& function) {
    if constexpr (requires { Law::keys(); })
        std::apply([&](const auto&... keys) { (function(keys), ...); }, Law::keys());
}

}  // namespace frana
