// SPDX-License-Identifier: Apache-2.0
#include "render/vtk/vtk_errors.h"

#include <utility>

#include "core/module.h"
#include "vtkLogger.h"
#include "vtkObjectFactory.h"

namespace frana::render {

class VtkErrors::Collector : public vtkOutputWindow {
  public:
    static Collector* New();

    void DisplayText(const char* text) override { keep(text); }
    void DisplayErrorText(const char* text) override { keep(text); }
    void DisplayGenericWarningText(const char* text) override { keep(text); }
    // Warnings and debug texts are not errors of the picture.
    void DisplayWarningText(const char*) override {}
    void DisplayDebugText(const char*) override {}

    std::vector<std::string> messages;

  private:
    void keep(const char* text) {
        if (text != nullptr && *text != '\0') messages.emplace_back(text);
    }
};

vtkStandardNewMacro(VtkErrors::Collector)

    VtkErrors::VtkErrors()
    : collector_(vtkSmartPointer<Collector>::New()),
      previous_(vtkOutputWindow::GetInstance()),
      previous_verbosity_(static_cast<int>(vtkLogger::GetCurrentVerbosityCutoff())) {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    vtkOutputWindow::SetInstance(collector_);
}

VtkErrors::~VtkErrors() {
    vtkOutputWindow::SetInstance(previous_);
    vtkLogger::SetStderrVerbosity(static_cast<vtkLogger::Verbosity>(previous_verbosity_));
}

void VtkErrors::throw_if_any(const std::string& what) {
    if (collector_->messages.empty()) return;
    const std::vector<std::string> messages = std::exchange(collector_->messages, {});
    std::string words = messages.front();
    for (char& c : words) {
        if (c == '\n' || c == '\t') c = ' ';
    }
    if (messages.size() > 1) words += " (and " + std::to_string(messages.size() - 1) + " more)";
    throw ModuleFailure({what, "VTK", words, "", "this is an error of the drawing system, not of the data"});
}

}  // namespace frana::render
