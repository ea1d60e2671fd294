// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "render/canvas/dashes.h"
#include "render/canvas/vtk_errors.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

namespace frana::render {
namespace {

/// Sampling points of the page inside a pixel: each row and each column of an 8 x 8 grid once. Averaging these pictures
/// smooths edges with the memory of a single one.
constexpr std::array<std::array<double, 2>, 8> k_samples{{{-0.4375, -0.1875},
                                                          {-0.3125, 0.3125},
                                                          {-0.1875, -0.4375},
                                                          {-0.0625, 0.0625},
                                                          {0.0625, 0.4375},
                                                          {0.1875, -0.3125},
                                                          {0.3125, 0.1875},
                                                          {0.4375, -0.0625}}};

std::uint32_t packed(Rgb colour, double opacity) {
    const auto alpha = static_cast<std::uint32_t>(std::lround(255 * std::clamp(opacity, 0.0, 1.0)));
    return static_cast<std::uint32_t>(colour.r) | static_cast<std::uint32_t>(colour.g) << 8U |
           static_cast<std::uint32_t>(colour.b) << 16U | alpha << 24U;
}

}  // namespace

Canvas::Canvas(int width, int height) : width_(width), height_(height) {}

void Canvas::triangle(Point a, Point b, Point c, Colour colour) {
    for (const Point p : {a, b, c}) {
        corners_.push_back(static_cast<float>(p.x));
        corners_.push_back(static_cast<float>(height_ - p.y));
        colours_.push_back(colour);
    }
}

void Canvas::stroke(std::span<const Point> points, const LineStyle& style) {
    const Colour colour = packed(style.colour, style.opacity);
    const double half = style.width_px / 2;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Point a = points[i], b = points[i + 1];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (length <= 0) continue;
        const Point side{-(b.y - a.y) / length * half, (b.x - a.x) / length * half};
        const Point a1{a.x + side.x, a.y + side.y}, a2{a.x - side.x, a.y - side.y};
        const Point b1{b.x + side.x, b.y + side.y}, b2{b.x - side.x, b.y - side.y};
        triangle(a1, a2, b1, colour);
        triangle(b1, a2, b2, colour);
    }
    // Round joints; gaps are invisible below two pixels, and in a translucent line joints would darken it.
    if (style.width_px < 1.9 || style.opacity < 1) return;
    constexpr int k_sides = 12;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Point centre = points[i];
        const auto rim = [&](int k) {
            const double angle = 2 * std::numbers::pi * k / k_sides;
            return Point{centre.x + half * std::cos(angle), centre.y + half * std::sin(angle)};
        };
        for (int k = 0; k < k_sides; ++k) triangle(centre, rim(k), rim(k + 1), colour);
    }
}

void Canvas::line(std::span<const Point> points, const LineStyle& style, bool closed) {
    if (points.size() < 2) return;
    Polyline whole(points.begin(), points.end());
    if (closed) {
        whole.push_back(points[0]);
        if (style.dashes.empty()) whole.push_back(points[1]);  // the join of both ends gets a round joint as well
    }
    if (style.dashes.empty()) {
        stroke(whole, style);
    } else {
        for (const Polyline& part : dashed(whole, style.dashes)) stroke(part, style);
    }
}

void Canvas::fill(std::span<const Point> corners, Rgb colour, double opacity) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        triangle(corners[0], corners[i], corners[i + 1], packed(colour, opacity));
    }
}

void Canvas::fill(const PageBox& box, Rgb colour, double opacity) {
    const std::array<Point, 4> corners{
        {{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}}};
    fill(corners, colour, opacity);
}

void Canvas::frame(const PageBox& box, const LineStyle& style) {
    const double half = style.width_px / 2;
    fill(PageBox{box.left - half, box.top - half, box.right + half, box.top + half}, style.colour, style.opacity);
    fill(PageBox{box.left - half, box.bottom - half, box.right + half, box.bottom + half}, style.colour, style.opacity);
    fill(PageBox{box.left - half, box.top + half, box.left + half, box.bottom - half}, style.colour, style.opacity);
    fill(PageBox{box.right - half, box.top + half, box.right + half, box.bottom - half}, style.colour, style.opacity);
}

OverlayImage Canvas::covered() const {
    float left = 1e9F, right = -1e9F, low = 1e9F, high = -1e9F;
    for (std::size_t i = 0; i < corners_.size(); i += 2) {
        left = std::min(left, corners_[i]);
        right = std::max(right, corners_[i]);
        low = std::min(low, corners_[i + 1]);
        high = std::max(high, corners_[i + 1]);
    }
    // Samples are up to half a pixel from a pixel's centre.
    const auto within = [](double edge, int length) {
        return static_cast<int>(std::clamp(edge, 0.0, static_cast<double>(length)));
    };
    OverlayImage part;
    part.left = within(std::floor(left), width_);
    part.top = height_ - within(std::ceil(high), height_);
    part.width = within(std::ceil(right), width_) - part.left;
    part.height = height_ - within(std::floor(low), height_) - part.top;
    if (part.width < 1 || part.height < 1) return {};
    return part;
}

OverlayImage Canvas::draw() const {
    const OverlayImage part = covered();
    if (part.width == 0) return {};
    VtkErrors errors;
    OsmesaWindow window(part.width, part.height);
    const auto n_corners = static_cast<vtkIdType>(colours_.size());
    vtkNew<vtkFloatArray> positions;
    positions->SetNumberOfComponents(3);
    positions->SetNumberOfTuples(n_corners);
    vtkNew<vtkUnsignedCharArray> shades;
    shades->SetNumberOfComponents(4);
    shades->SetNumberOfTuples(n_corners);
    vtkNew<vtkCellArray> triangles;
    for (vtkIdType i = 0; i < n_corners; ++i) {
        const auto k = static_cast<std::size_t>(i);
        // Later triangles are nearer to the viewer, so that the depth test lets them cover earlier ones.
        const vtkIdType triangle = i / 3;
        const double height = 0.9 * static_cast<double>(triangle) / static_cast<double>(n_corners);
        positions->SetTuple3(i, corners_[2 * k], corners_[2 * k + 1], height);
        for (int band = 0; band < 4; ++band) {
            shades->SetTypedComponent(i, band,
                                      static_cast<unsigned char>(colours_[k] >> (8U * static_cast<unsigned>(band))));
        }
        if (i % 3 == 0) triangles->InsertNextCell({i, i + 1, i + 2});
    }
    vtkNew<vtkPoints> points;
    points->SetData(positions);
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->SetPolys(triangles);
    mesh->GetPointData()->SetScalars(shades);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    mapper->SetColorModeToDirectScalars();
    mapper->SetScalarModeToUsePointData();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->ForceOpaqueOn();  // drawn in order and blended; the translucent pass would blend regardless of order
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(0, 0, 0);
    renderer->SetBackgroundAlpha(0);
    renderer->AddActor(actor);
    window.vtk().AddRenderer(renderer);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(part.height / 2.0);
    camera->SetClippingRange(0.5, 1.05);

    std::vector<std::uint16_t> sum(4 * static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height));
    const Point middle{part.left + part.width / 2.0, height_ - part.top - part.height / 2.0};
    OverlayImage picture;
    for (const auto& sample : k_samples) {
        const double x = middle.x + sample[0], y = middle.y + sample[1];
        camera->SetFocalPoint(x, y, 0);
        camera->SetPosition(x, y, 1);
        window.render();
        picture = window.read_rgba();
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = static_cast<std::uint16_t>(sum[i] + picture.rgba[i]);
    }
    const unsigned n_samples = k_samples.size();
    for (std::size_t i = 0; i < sum.size(); ++i) {
        picture.rgba[i] = static_cast<std::uint8_t>((sum[i] + n_samples / 2) / n_samples);
    }
    picture.left = part.left;
    picture.top = part.top;
    window.vtk().RemoveRenderer(renderer);
    errors.throw_if_any("a picture's lines could not be drawn");
    return picture;
}

void compose(Image& page, const OverlayImage& overlay, int right, int down) {
    const int left = overlay.left + right, top = overlay.top + down;
    if (left < 0 || top < 0 || left + overlay.width > page.width || top + overlay.height > page.height) {
        throw Error(ErrorKind::input, Problem{"a layer lies outside its page", "", "", "", ""});
    }
    const std::uint8_t* ink = overlay.rgba.data();
    for (int row = 0; row < overlay.height; ++row) {
        std::uint8_t* to = page.pixel(left, top + row);
        for (int column = 0; column < overlay.width; ++column, ink += 4, to += 3) {
            const unsigned through = 255U - ink[3];
            if (through == 255U) continue;
            for (int band = 0; band < 3; ++band) {
                const unsigned mixed = ink[band] + (to[band] * through + 127U) / 255U;
                to[band] = static_cast<std::uint8_t>(std::min(mixed, 255U));
            }
        }
    }
}

}  // namespace frana::render
