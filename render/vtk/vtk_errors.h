// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

namespace frana::render {

/// Collects VTK's messages during its lifetime: VTK reports an error as text and continues, so that a wrong picture
/// would appear to be right. Nothing is written to the terminal. A scope object: may be nested, must not outlive its
/// block; the innermost collects.
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
    vtkSmartPointer<Collector> collector_;
    vtkSmartPointer<vtkOutputWindow> previous_;
    int previous_verbosity_;
};

}  // namespace frana::render
