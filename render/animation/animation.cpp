// SPDX-License-Identifier: Apache-2.0
#include "render/animation/animation.h"

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
    const bool fixed = !base.classes.empty() || base.maximum || !base.categories.empty() ||
                       (base.layer != nullptr && !value_range(*base.layer).empty());
    if (!fixed) {
        throw Error(ErrorKind::input,
                    Problem{"an animation's colour scale is not fixed", "", "", "",
                            "give class bounds, a maximum, or the maximum over time as the base's raster"});
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

class MapAnimator::Page {
  public:
    explicit Page(const MapSpec& base) : page_(with_fixed_scale(base), true, ground_) {}

    Image frame(const Raster& layer, const std::string& subtitle) {
        check_values(layer, page_.scale());
        return page_.draw(&layer, nullptr, subtitle).paint();
    }
    Image frame(const Dots& dots, const std::string& subtitle) {
        check_values(dots, page_.scale());
        return page_.draw(nullptr, &dots, subtitle).paint();
    }

  private:
    std::shared_ptr<const MapGround> ground_;
    MapPage page_;
};

MapAnimator::MapAnimator(const MapSpec& base) : page_(std::make_unique<Page>(base)) {}
MapAnimator::~MapAnimator() = default;
MapAnimator::MapAnimator(MapAnimator&&) noexcept = default;
MapAnimator& MapAnimator::operator=(MapAnimator&&) noexcept = default;

Image MapAnimator::frame(const Raster& layer, const std::string& subtitle) {
    return page_->frame(layer, subtitle);
}

Image MapAnimator::frame(const Dots& dots, const std::string& subtitle) {
    return page_->frame(dots, subtitle);
}

class ViewAnimator::Session {
  public:
    explicit Session(const ViewSpec& base) : session_(with_fixed_scale(base), true, place_) {}

    Image frame(const Raster& layer, const std::string& subtitle) {
        check_values(layer, session_.scale());
        return session_.draw(&layer, nullptr, subtitle).paint();
    }
    Image frame(const Dots& dots, const std::string& subtitle) {
        check_values(dots, session_.scale());
        return session_.draw(nullptr, &dots, subtitle).paint();
    }

  private:
    std::shared_ptr<ViewPlace> place_;
    ViewSession session_;
};

ViewAnimator::ViewAnimator(const ViewSpec& base) : session_(std::make_unique<Session>(base)) {}
ViewAnimator::~ViewAnimator() = default;
ViewAnimator::ViewAnimator(ViewAnimator&&) noexcept = default;
ViewAnimator& ViewAnimator::operator=(ViewAnimator&&) noexcept = default;

Image ViewAnimator::frame(const Raster& layer, const std::string& subtitle) {
    return session_->frame(layer, subtitle);
}

Image ViewAnimator::frame(const Dots& dots, const std::string& subtitle) {
    return session_->frame(dots, subtitle);
}

}  // namespace frana::render
