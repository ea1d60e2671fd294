// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/colour_scale.h"
#include "render/map2d.h"
#include "render/map_body.h"
#include "render/map_layout.h"
#include "render/osmesa_window.h"

namespace frana::render {

/// A map without its layer: relief, lines and texts drawn once, ready to receive one layer after the other.
class MapPage {
  public:
    /// `for_frames`: other layers than the specification's will come, each with a subtitle of its own.
    MapPage(const MapSpec& spec, bool for_frames);

    /// The map with a layer (none if null) and a subtitle; the latter only where the page was made for
    /// frames.
    [[nodiscard]] Image draw(const Raster* layer, const std::string& subtitle) const;

    [[nodiscard]] const MapLayout& layout() const noexcept { return layout_; }
    [[nodiscard]] const ColourScale& scale() const noexcept { return scale_; }

  private:
    void arrange(const MapSpec& spec, bool for_frames);

    ColourScale scale_;
    MapFrame frame_;
    MapLayout layout_;
    Image ground_;      ///< paper and relief
    LayerImage above_;  ///< lines and texts over the layer
    Image inset_;
    Point subtitle_at_;
};

}  // namespace frana::render
