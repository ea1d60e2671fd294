// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

namespace frana::render {

/// Collects what VTK would print, for as long as it lives: VTK reports an error as text and goes on, so a
/// wrong picture would look like success. Nothing reaches the terminal. A scope object: may be nested, must
/// not outlive the block it is made in; messages go to the innermost.
class VtkErrors {
  public:
    VtkErrors();
    ~VtkErrors();
    VtkErrors(const VtkErrors&) = delete;
    VtkErrors& operator=(const VtkErrors&) = delete;

    /// Throws Error(environment) naming `what` with VTK's first message, if there was any; forgets them then.
    void throw_if_any(const std::string& what);

  private:
    class Collector;
    vtkSmartPointer<Collector> collector_;
    vtkSmartPointer<vtkOutputWindow> previous_;
    int previous_verbosity_;
};

}  // namespace frana::render
