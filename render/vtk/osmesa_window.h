// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

class vtkRenderWindow;

namespace frana::render {

/// Collects VTK's messages during its lifetime: VTK reports an error as text and continues, so that a wrong picture
/// would appear to be right. Nothing is written to the terminal. A scope object: may be nested, must not outlive its
/// block; the innermost collects. VTK has one place for messages: other threads wait for the end of the outermost.
class VtkErrors {
  public:
    VtkErrors();
    ~VtkErrors();
    VtkErrors(const VtkErrors&) = delete;
    VtkErrors& operator=(const VtkErrors&) = delete;

    /// Throws ModuleFailure naming `what` with VTK's first message, if there was any; clears the messages.
    void throw_if_any(const std::string& what);

  private:
    class Collector;
    inline static std::recursive_mutex one_at_a_time_;
    std::unique_lock<std::recursive_mutex> alone_{one_at_a_time_};
    vtkSmartPointer<Collector> collector_;
    vtkSmartPointer<vtkOutputWindow> previous_;
    int previous_verbosity_;
};

/// A VTK render window that draws into memory through OSMesa: no display, no X server, no GPU. Used by one thread at a
/// time. Members of VTK's scene must be released before the window.
class OsmesaWindow {
  public:
    /// Throws ModuleFailure if OpenGL would not be OSMesa's or no context can be made.
    OsmesaWindow(int width, int height);
    ~OsmesaWindow();
    OsmesaWindow(const OsmesaWindow&) = delete;
    OsmesaWindow& operator=(const OsmesaWindow&) = delete;

    [[nodiscard]] vtkRenderWindow& vtk() noexcept;
    void resize(int width, int height);

    /// Draws the scene. Throws ModuleFailure with VTK's message if VTK or OpenGL reports an error.
    void render();

    /// Draws the scene once for each of some samples, before each of which `aim` is called with its number. Returns the
    /// mean, row by row from the top, three bytes a pixel.
    [[nodiscard]] std::vector<std::uint8_t> mean_picture(std::size_t samples,
                                                         const std::function<void(std::size_t)>& aim);

  private:
    class Context;
    std::unique_ptr<Context> context_;
};

}  // namespace frana::render
