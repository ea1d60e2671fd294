// SPDX-License-Identifier: Apache-2.0
#include "render/animation/animation.h"

#include <algorithm>
#include <type_traits>

#include "core/error.h"
#include "render/canvas/furniture.h"
#include "render/map/legend.h"
#include "render/map/map_page.h"
#include "render/view/view_session.h"

namespace frana::render {
namespace {

/// Frames share one scale, so its range must be specified.
template <class Spec>
const Spec& with_fixed_scale(const Spec& base) {
    const bool fixed = !base.classes.empty() || !base.categories.empty() ||
                       (base.layer != nullptr && !value_range(*base.layer).empty());
    if (!fixed) {
        throw Error(ErrorKind::input, Problem{"an animation's colour scale is not fixed", "", "", "",
                                              "give class bounds, or the maximum over time as the base's raster"});
    }
    return base;
}

/// A value without a colour would disappear from the picture: an animation that hides the greatest values is worse than
/// none.
void check_value(double value, const ColourScale& scale) {
    if (scale.categorical() || scale.find(value) != nullptr) return;
    throw Error(ErrorKind::input,
                Problem{"a frame's value lies outside the animation's colour scale", "", number(value),
                        number(scale.classes().front().lower) + " to " + number(scale.classes().back().upper),
                        "make the scale from the maximum over time"});
}

void check_values(const Raster& layer, const ColourScale& scale) {
    const ValueRange range = value_range(layer);
    if (range.empty()) return;
    check_value(range.least, scale);
    check_value(range.greatest, scale);
}

void check_values(const Dots& dots, const ColourScale& scale) {
    for (const Dot& dot : dots.dots) check_value(dot.value, scale);
}

}  // namespace

template <class Spec>
struct Animator<Spec>::Session {
    static constexpr bool k_is_map = std::is_same_v<Spec, MapSpec>;

    std::shared_ptr<std::conditional_t<k_is_map, const MapGround, ViewPlace>> ground;
    std::conditional_t<k_is_map, MapPage, ViewSession> page;

    Image last;  ///< of a map, in which only the subtitle and the inside of the frame change

    explicit Session(const Spec& base) : page(with_fixed_scale(base), true, ground) {}

    Image paint(const Page& drawn) {
        if constexpr (k_is_map) {
            if (last.width > 0) {
                const PageBox& map = page.layout().map;
                repaint(drawn, {0, 0, static_cast<double>(drawn.width()), map.top});
                repaint(drawn, map);
                return last;
            }
        }
        return last = drawn.paint();
    }

    void repaint(const Page& drawn, const PageBox& box) {
        const int left = static_cast<int>(box.left), top = static_cast<int>(box.top);
        Page part(static_cast<int>(box.width()), static_cast<int>(box.height()));
        part.put(drawn, -left, -top);
        const Image pixels = part.paint();
        for (int row = 0; row < pixels.height; ++row)
            std::copy_n(pixels.pixel(0, row), 3 * pixels.width, last.pixel(left, top + row));
    }
};

template <class Spec>
Animator<Spec>::Animator(const Spec& base) : session_(std::make_unique<Session>(base)) {}
template <class Spec>
Animator<Spec>::~Animator() = default;
template <class Spec>
Animator<Spec>::Animator(Animator&&) noexcept = default;
template <class Spec>
Animator<Spec>& Animator<Spec>::operator=(Animator&&) noexcept = default;

template <class Spec>
Image Animator<Spec>::frame(const Raster& layer, const std::string& subtitle) {
    check_values(layer, session_->page.scale());
    return session_->paint(session_->page.draw(&layer, nullptr, subtitle));
}

template <class Spec>
Image Animator<Spec>::frame(const Dots& dots, const std::string& subtitle) {
    check_values(dots, session_->page.scale());
    return session_->paint(session_->page.draw(nullptr, &dots, subtitle));
}

template class Animator<MapSpec>;
template class Animator<ViewSpec>;

}  // namespace frana::render
