// SPDX-License-Identifier: Apache-2.0
#include "render/vtk/osmesa_window.h"

#include <gtest/gtest.h>

#include <memory>
#include <thread>

#include "core/colour.h"
#include "core/module.h"
#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

namespace frana::render {
namespace {

void paint(OsmesaWindow& window, double red, double green, double blue) {
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(red, green, blue);
    window.vtk().AddRenderer(renderer);
    window.render();
}

std::vector<std::uint8_t> picture(OsmesaWindow& window) {
    return window.mean_picture(1, [](std::size_t) {});
}

Rgb colour(OsmesaWindow& window, std::size_t width, std::size_t column, std::size_t row) {
    const std::vector<std::uint8_t> pixels = picture(window);
    const std::uint8_t* p = pixels.data() + 3 * (row * width + column);
    return {p[0], p[1], p[2]};
}

TEST(OsmesaWindow, DrawsWithoutADisplayAndReadsBackTheRightWayUp) {
    OsmesaWindow window(64, 48);
    vtkNew<vtkRenderer> lower, upper;
    lower->SetViewport(0, 0, 1, 0.5);
    lower->SetBackground(1, 0, 0);
    upper->SetViewport(0, 0.5, 1, 1);
    upper->SetBackground(0, 0, 1);
    window.vtk().AddRenderer(lower);
    window.vtk().AddRenderer(upper);
    ASSERT_EQ(picture(window).size(), 3U * 64 * 48);
    EXPECT_EQ(colour(window, 64, 32, 10), (Rgb{0, 0, 255}));
    EXPECT_EQ(colour(window, 64, 32, 40), (Rgb{255, 0, 0}));
}

TEST(OsmesaWindow, SeveralAtOnceAndOneAfterTheOther) {
    auto first = std::make_unique<OsmesaWindow>(20, 20);
    OsmesaWindow second(30, 30);
    paint(*first, 1, 0, 0);
    paint(second, 0, 1, 0);
    EXPECT_EQ(colour(*first, 20, 5, 5), (Rgb{255, 0, 0}));
    first.reset();
    second.render();
    EXPECT_EQ(colour(second, 30, 5, 5), (Rgb{0, 255, 0}));
    second.resize(50, 40);
    second.render();
    EXPECT_EQ(picture(second).size(), 3U * 50 * 40);
}

TEST(OsmesaWindow, WorksOnAnotherThread) {
    Rgb seen;
    std::thread([&] {
        OsmesaWindow window(20, 20);
        paint(window, 0, 0, 1);
        seen = colour(window, 20, 10, 10);
    }).join();
    EXPECT_EQ(seen, (Rgb{0, 0, 255}));
}

TEST(OsmesaWindow, AVtkErrorBecomesAnErrorAndNothingIsPrinted) {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    std::string words;
    {
        OsmesaWindow window(20, 20);
        vtkNew<vtkPoints> points;
        points->InsertNextPoint(0, 0, 0);
        points->InsertNextPoint(1, 0, 0);
        points->InsertNextPoint(0, 1, 0);
        vtkNew<vtkCellArray> cells;
        cells->InsertNextCell({0, 1, 2});
        vtkNew<vtkPolyData> mesh;
        mesh->SetPoints(points);
        mesh->SetPolys(cells);
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(mesh);
        // VTK's pipeline runs while it draws; with a missing file it reports an error, draws without it and continues.
        vtkNew<vtkPNGReader> reader;
        reader->SetFileName("there is no such picture.png");
        vtkNew<vtkTexture> texture;
        texture->SetInputConnection(reader->GetOutputPort());
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        actor->SetTexture(texture);
        vtkNew<vtkRenderer> renderer;
        renderer->AddActor(actor);
        window.vtk().AddRenderer(renderer);
        try {
            window.render();
        } catch (const ModuleFailure& failure) {
            words = describe(failure.problem);
        }
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_NE(words.find("no such picture"), std::string::npos) << words;
}

}  // namespace
}  // namespace frana::render
