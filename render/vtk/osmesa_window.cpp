// SPDX-License-Identifier: Apache-2.0
#include "render/vtk/osmesa_window.h"

#include <GL/osmesa.h>
#include <dlfcn.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

#include "core/module.h"
#include "vtkCallbackCommand.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkUnsignedCharArray.h"

// Debian's VTK asks GLEW for OpenGL's functions, and Debian's GLEW asks GLX. These five functions replace libGLX: the
// module exports them, so the dynamic linker finds them before libGLX's, and only OSMesa provides OpenGL.
extern "C" {
using GlFunction = void (*)();

[[gnu::visibility("default"), gnu::used]] void* glXGetCurrentDisplay() {
    static char not_null = 0;  // only compared with null, never dereferenced
    return &not_null;
}

[[gnu::visibility("default"), gnu::used]] GlFunction glXGetProcAddressARB(const unsigned char* name) {
    const char* text = reinterpret_cast<const char*>(name);
    if (std::strcmp(text, "glXGetCurrentDisplay") == 0) {
        return reinterpret_cast<GlFunction>(&glXGetCurrentDisplay);
    }
    if (std::strncmp(text, "glX", 3) == 0) return nullptr;
    return reinterpret_cast<GlFunction>(OSMesaGetProcAddress(text));
}

[[gnu::visibility("default"), gnu::used]] GlFunction glXGetProcAddress(const unsigned char* name) {
    return glXGetProcAddressARB(name);
}

[[gnu::visibility("default"), gnu::used]] int glXQueryVersion(void*, int* major, int* minor) {
    *major = 1;
    *minor = 2;  // old enough that GLEW needs no further GLX function
    return 1;
}

[[gnu::visibility("default"), gnu::used]] const char* glXGetClientString(void*, int) {
    return "";
}
}

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

namespace {

[[noreturn]] void fail(const std::string& what, const std::string& value, const std::string& remedy) {
    throw ModuleFailure({what, "off-screen drawing", value, "", remedy});
}

/// A wrong OpenGL would end in a segmentation fault deep inside a driver; report it here instead.
void check_that_opengl_is_osmesa() {
    const std::string remedy = "link libOSMesa before any other OpenGL library, and do not preload another libGL";
    Dl_info info{};
    void* clear = dlsym(RTLD_DEFAULT, "glClear");
    if (clear == nullptr || dladdr(clear, &info) == 0 || info.dli_fname == nullptr ||
        std::strstr(info.dli_fname, "OSMesa") == nullptr) {
        fail("OpenGL is not OSMesa's", info.dli_fname != nullptr ? info.dli_fname : "no glClear", remedy);
    }
    if (dlsym(RTLD_DEFAULT, "glXGetProcAddressARB") != reinterpret_cast<void*>(&glXGetProcAddressARB)) {
        fail("OpenGL's functions are looked up in GLX, not in OSMesa", "glXGetProcAddressARB", remedy);
    }
}

}  // namespace

class OsmesaWindow::Context {
  public:
    Context(int width, int height) {
        // An unknown driver name in this variable makes OSMesa crash; llvmpipe is the intended one.
        setenv("GALLIUM_DRIVER", "llvmpipe", 1);
        check_that_opengl_is_osmesa();
        const std::array<int, 15> wishes{OSMESA_FORMAT,
                                         OSMESA_RGBA,
                                         OSMESA_DEPTH_BITS,
                                         24,
                                         OSMESA_STENCIL_BITS,
                                         8,
                                         OSMESA_PROFILE,
                                         OSMESA_CORE_PROFILE,
                                         OSMESA_CONTEXT_MAJOR_VERSION,
                                         3,
                                         OSMESA_CONTEXT_MINOR_VERSION,
                                         2,
                                         0,
                                         0,
                                         0};
        osmesa_.reset(OSMesaCreateContextAttribs(wishes.data(), nullptr));
        if (!osmesa_) fail("OSMesa provides no OpenGL 3.2 context", "", "install Debian's libosmesa6");
        make_current();

        on_make_current_->SetClientData(this);
        on_make_current_->SetCallback(
            [](vtkObject*, unsigned long, void* self, void*) { static_cast<Context*>(self)->make_current(); });
        on_is_current_->SetClientData(this);
        on_is_current_->SetCallback([](vtkObject*, unsigned long, void* self, void* answer) {
            *static_cast<bool*>(answer) = OSMesaGetCurrentContext() == static_cast<Context*>(self)->osmesa_.get();
        });
        window_->AddObserver(vtkCommand::WindowMakeCurrentEvent, on_make_current_);
        window_->AddObserver(vtkCommand::WindowIsCurrentEvent, on_is_current_);
        window_->SetOffScreenRendering(1);
        window_->SetSupportsOpenGL(1);
        window_->SetIsDirect(0);
        window_->SetReadyForRendering(true);
        window_->SetMultiSamples(0);
        window_->SetAlphaBitPlanes(1);
        window_->SetSize(width, height);
    }

    ~Context() {
        // VTK's window frees its OpenGL objects, for which the context must be current and alive.
        make_current_quietly();
        window_->Finalize();
        window_->RemoveAllObservers();
    }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    void make_current() {
        if (!make_current_quietly()) fail("OSMesa's context cannot be used", "", "is memory short?");
    }

    vtkGenericOpenGLRenderWindow& window() { return *window_; }

  private:
    bool make_current_quietly() {
        // VTK draws to its own frame buffers; OSMesa's only has to exist.
        return OSMesaMakeCurrent(osmesa_.get(), pixels_.data(), GL_UNSIGNED_BYTE, k_side, k_side) == GL_TRUE;
    }

    struct Destroy {
        void operator()(OSMesaContext context) const { OSMesaDestroyContext(context); }
    };
    static constexpr int k_side = 16;
    std::array<unsigned char, 4 * k_side * k_side> pixels_{};
    std::unique_ptr<osmesa_context, Destroy> osmesa_;
    vtkNew<vtkCallbackCommand> on_make_current_, on_is_current_;
    vtkNew<vtkGenericOpenGLRenderWindow> window_;
};

OsmesaWindow::OsmesaWindow(int width, int height) {
    VtkErrors errors;
    context_ = std::make_unique<Context>(width, height);
    errors.throw_if_any("off-screen drawing could not be set up");
}

OsmesaWindow::~OsmesaWindow() {
    const VtkErrors silence;  // errors are ignored in a destructor
    context_.reset();
}

vtkRenderWindow& OsmesaWindow::vtk() noexcept {
    return context_->window();
}

void OsmesaWindow::resize(int width, int height) {
    context_->window().SetSize(width, height);
}

void OsmesaWindow::render() {
    VtkErrors errors;
    context_->make_current();
    context_->window().Render();
    errors.throw_if_any("the picture could not be drawn");
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
        fail("OpenGL reports an error", std::to_string(error), "this is an error of the drawing system");
    }
}

std::vector<std::uint8_t> OsmesaWindow::mean_picture(std::size_t samples, const std::function<void(std::size_t)>& aim) {
    const int width = context_->window().GetSize()[0], height = context_->window().GetSize()[1];
    const std::size_t line = 3 * static_cast<std::size_t>(width), size = line * static_cast<std::size_t>(height);
    vtkNew<vtkUnsignedCharArray> bytes;  // for all samples: pages of memory cost more than their sums
    std::vector<std::uint16_t> sum(size);
    for (std::size_t sample = 0; sample < samples; ++sample) {
        aim(sample);
        render();
        VtkErrors errors;
        context_->window().GetPixelData(0, 0, width - 1, height - 1, 0, bytes, 0);
        errors.throw_if_any("the picture could not be read back");
        const unsigned char* const picture = bytes->GetPointer(0);
        for (std::size_t i = 0; i < size; ++i) sum[i] = static_cast<std::uint16_t>(sum[i] + picture[i]);
    }
    std::vector<std::uint8_t> mean(size);
    for (std::size_t row = 0; row < static_cast<std::size_t>(height); ++row) {
        const std::uint16_t* const from = sum.data() + line * (static_cast<std::size_t>(height) - 1 - row);
        for (std::size_t i = 0; i < line; ++i)
            mean[line * row + i] = static_cast<std::uint8_t>((from[i] + samples / 2) / samples);
    }
    return mean;
}

}  // namespace frana::render
