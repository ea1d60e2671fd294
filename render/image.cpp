// SPDX-License-Identifier: Apache-2.0
#include "render/image.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "core/error.h"
#include "core/file_aside.h"
#include "render/vtk_errors.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkUnsignedCharArray.h"

namespace frana::render {
namespace {

[[noreturn]] void fail(const std::string& path, const char* what) {
    throw Error(ErrorKind::environment, Problem{what, path, std::strerror(errno), "",
                                                "check the folder, its permissions and the free space"});
}

}  // namespace

Image::Image(int columns, int rows, Rgb fill) : width(columns), height(rows) {
    rgb.resize(3 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
        rgb[i] = fill.r;
        rgb[i + 1] = fill.g;
        rgb[i + 2] = fill.b;
    }
}

void write_png(const std::string& path, const Image& image) {
    if (image.width < 1 || image.height < 1) {
        throw Error(ErrorKind::environment, Problem{"an empty picture is not written", path, "", "", ""});
    }
    VtkErrors errors;
    vtkNew<vtkImageData> pixels;
    pixels->SetDimensions(image.width, image.height, 1);
    pixels->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    const std::size_t line = 3 * static_cast<std::size_t>(image.width);
    for (int row = 0; row < image.height; ++row) {  // VTK counts rows from below
        std::memcpy(pixels->GetScalarPointer(0, image.height - 1 - row, 0), image.pixel(0, row), line);
    }
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(pixels);
    writer->SetCompressionLevel(5);
    writer->WriteToMemoryOn();
    writer->Write();
    errors.throw_if_any("the picture could not be coded: " + path);
    vtkUnsignedCharArray* bytes = writer->GetResult();

    FileAside file(path);
    std::FILE* stream = std::fopen(file.partial_path().c_str(), "wb");
    if (stream == nullptr) fail(path, "the picture cannot be written");
    const auto size = static_cast<std::size_t>(bytes->GetNumberOfValues());
    const bool written = std::fwrite(bytes->GetPointer(0), 1, size, stream) == size;
    const bool closed = std::fclose(stream) == 0;
    if (!written || !closed) fail(path, "the picture could not be written whole");
    file.rename_into_place();
}

}  // namespace frana::render
