// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/canvas/image.h"

class vtkRenderWindow;

namespace frana::render {

/// Pixels with opacity, colours premultiplied by it (as OpenGL blends over transparent black), from the top; `left` and
/// `top` are the position of the first one on a page.
struct OverlayImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
    int left = 0, top = 0;
};

/// A VTK render window that draws into memory through OSMesa: no display, no X server, no GPU. Used by one thread at a
/// time. Members of VTK's scene must be released before the window.
class OsmesaWindow {
  public:
    /// Throws Error(environment) if OpenGL would not be OSMesa's or no context can be made.
    OsmesaWindow(int width, int height);
    ~OsmesaWindow();
    OsmesaWindow(const OsmesaWindow&) = delete;
    OsmesaWindow& operator=(const OsmesaWindow&) = delete;

    [[nodiscard]] vtkRenderWindow& vtk() noexcept;
    void resize(int width, int height);

    /// Draws the scene. Throws Error(environment) with VTK's message if VTK or OpenGL reports an error.
    void render();

    /// Returns the last drawing.
    [[nodiscard]] Image read_rgb();
    [[nodiscard]] OverlayImage read_rgba();

  private:
    class Context;
    std::unique_ptr<Context> context_;
};

}  // namespace frana::render
