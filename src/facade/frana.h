// SPDX-License-Identifier: Apache-2.0
// frana as a library: a scene in, a result out. Values, no files: no GDAL, no coordinate systems. share/doc/library.md
// explains it with an example.
//
//     frana::Scene scene(grid, {elevations});
//     scene.set("material.friction-coefficient", "0.2");
//     scene.add_release({.outline = {{ring, {}}}, .thickness = 3});
//     const frana::Result result = frana::run(scene);
//     const frana::Raster depth = result.raster("max_depth");
//
// Lengths in metres, time in seconds; the keys of scene files have the units of scene files (share/doc/parameters.md).
// Objects are not to be used from several threads at once; different objects may be.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#define FRANA_API __attribute__((visibility("default")))

namespace frana {

/// The interface; for users of this header alone its names are those of `frana`.
namespace facade {

/// "0.1.0"
FRANA_API std::string version();

/// One problem, in the words of the program: what, where, the value, the limit it violates, the remedy. Empty parts do
/// not apply.
struct Problem {
    std::string what, where, value, limit, remedy;
};

/// All problems of a scene, found before anything is computed. what() has one line for each.
class FRANA_API Error : public std::runtime_error {
  public:
    Error(const std::string& text, std::vector<Problem> problems);
    ~Error() override;
    [[nodiscard]] const std::vector<Problem>& problems() const noexcept { return problems_; }

  private:
    std::vector<Problem> problems_;
};

/// A north-up grid of square cells. Row 0 is the northernmost.
struct Grid {
    double west = 0;       ///< easting of the western edge [m]
    double north = 0;      ///< northing of the northern edge [m]
    double cell_size = 1;  ///< side of a cell [m]
    std::int64_t rows = 0, columns = 0;

    bool operator==(const Grid&) const = default;
};

/// Easting and northing [m].
struct Point {
    double x = 0, y = 0;
};
/// A closed ring; the last point is not repeated.
using Ring = std::vector<Point>;
struct Polygon {
    Ring outer;
    std::vector<Ring> holes{};
};

/// One value per cell of a grid, row by row from the north; NaN: no value. They are not copied but read where they are,
/// where the flow comes: they must not change as long as the scene and its runs exist.
struct Values {
    std::span<const double> cells{};
    std::shared_ptr<const void> keeper{};  ///< keeps the memory; empty: the caller does

    [[nodiscard]] bool empty() const noexcept { return cells.empty(); }
};

/// An area that fails: an outline with a thickness, by a number or by cells. Cells without outline: wherever they are
/// positive.
struct Release {
    std::vector<Polygon> outline{};
    double thickness = 0;            ///< [m]; vertical, or as release.thickness-direction says
    Values thicknesses{};            ///< [m], on the scene's grid; where there are any they replace the number
    std::optional<double> volume{};  ///< [m3]: thicknesses are scaled to it; none: that of outline and thicknesses
    std::string name{};
};

/// Discharge of an inflow at one time; linear between times, zero before the first and after the last.
struct HydrographPoint {
    double time = 0;                   ///< [s]; an equal time is a step
    double discharge = 0;              ///< [m3/s]
    std::optional<double> velocity{};  ///< across the line, in map view [m/s]; none: the critical speed
};

/// Material that flows in through a line.
struct Inflow {
    std::vector<Point> line{};
    std::vector<HydrographPoint> hydrograph{};
    std::optional<double> direction{};  ///< [degrees] clockwise from north; none: normal to the line, downhill
};

/// A place where depth and speed are recorded. Without a name it has its number.
struct Gauge {
    Point place;
    std::string name{};
};

/// A line through which the discharge is recorded, positive to the right of its direction.
struct CrossSection {
    std::vector<Point> line{};
    std::string name{};
};

/// What is computed: ground, released mass, and the keys of scene files that need no file.
class FRANA_API Scene {
  public:
    /// @param elevations [m], one per cell of the grid; NaN: no data. Throws Error.
    Scene(const Grid& grid, Values elevations);
    Scene(const Scene& other);
    Scene(Scene&& other) noexcept;
    Scene& operator=(const Scene& other);
    Scene& operator=(Scene&& other) noexcept;
    ~Scene();

    [[nodiscard]] const Grid& grid() const noexcept;
    /// Sets a key of scene files, "section.key", a second time in place of the first. Throws Error if there is no such
    /// key, if the value is not allowed, or if the key concerns files.
    void set(const std::string& key, const std::string& value);
    void set(const std::string& key, double value);
    /// Sets a key of [zones], "zones.friction-angle", or a property of the structured model's solids,
    /// "structured.cohesion", or "structured.initial-fluid-depth", by place; NaN: the value of the material applies, no
    /// fluid.
    void set_values(const std::string& key, Values values);
    /// Walls that no flow overtops stand on the cells with 1; 0 elsewhere.
    void set_walls(Values walls);
    void add_release(Release release);
    void add_inflow(Inflow inflow);
    /// Both are recorded at every step, or as output.sample-interval says. Their names must differ.
    void add_gauge(Gauge gauge);
    void add_section(CrossSection section);
    /// Throws Error with every problem of the scene; returns what is worth a second look.
    [[nodiscard]] std::vector<std::string> check() const;

    struct Data;
    [[nodiscard]] const Data& data() const noexcept { return *data_; }

  private:
    std::unique_ptr<Data> data_;
};

/// The name of a raster, its title and unit; share/doc/results.md explains each.
struct RasterInfo {
    std::string name, title, unit;
};

/// A raster of a result or frame on the scene's grid, row by row from the north; NaN where nothing ever flowed. Its
/// memory is that of the result: `keeper` keeps it as long as it exists.
struct Raster {
    RasterInfo info;
    Grid grid;
    std::span<const double> cells;
    std::shared_ptr<const void> keeper;

    [[nodiscard]] double at(std::int64_t row, std::int64_t column) const {
        return cells[static_cast<std::size_t>(row * grid.columns + column)];
    }
};

/// A value over time, one for each row: of Result::series, for each step.
struct Series {
    std::string name, unit;
    std::vector<double> values;
};

/// What was recorded at a gauge or a cross-section.
struct Record {
    std::string name;
    std::vector<Series> columns;
};

/// Something that a flow may hit: areas, lines and points, which count together.
struct Exposed {
    std::vector<Polygon> areas{};
    std::vector<std::vector<Point>> lines{};
    std::vector<Point> points{};
};

/// The worst that happens to it on all the cells that it touches, as in exposure.csv. NaN: it is not on the map; the
/// time also where nothing arrives.
struct Exposure {
    bool reached = false;
    double depth = 0, velocity = 0, pressure = 0;  ///< [m], [m/s], [kPa]
    double arrival = 0;                            ///< [s]
    std::string place;                             ///< "on the map", "outside the map", "no elevation", ...
};

/// What a run gives.
class FRANA_API Result {
  public:
    /// The rasters there are: max_depth, max_velocity, arrival_time, ...
    [[nodiscard]] std::vector<RasterInfo> rasters() const;
    /// Throws Error for another name.
    [[nodiscard]] Raster raster(const std::string& name) const;
    /// Columns of timeseries.csv.
    [[nodiscard]] std::vector<Series> series() const;
    /// In the order of Scene::add_gauge: columns of gauges.csv.
    [[nodiscard]] std::vector<Record> gauges() const;
    /// In the order of Scene::add_section: columns of sections.csv.
    [[nodiscard]] std::vector<Record> sections() const;
    /// JSON: what summary.json says of the run itself, by the same keys.
    [[nodiscard]] std::string summary() const;
    /// A number of the summary: "max_depth_m", "runout.horizontal_m". NaN where it is null. Throws Error for another
    /// key.
    [[nodiscard]] double number(const std::string& key) const;
    /// "end-time", "still", "settled", ...
    [[nodiscard]] std::string stop_reason() const;
    /// What must be known before relying on it: the sentences that summary.json has.
    [[nodiscard]] std::vector<std::string> warnings() const;
    /// Choices made.
    [[nodiscard]] std::vector<std::string> notes() const;
    /// What the flow does to each feature.
    [[nodiscard]] std::vector<Exposure> exposure(const std::vector<Exposed>& features) const;

    struct Data;
    explicit Result(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

  private:
    std::shared_ptr<const Data> data_;
};

/// A run that failed: non-finite values, an impossible speed, cells without terrain. Nothing of the result up to there
/// is fit for use but to find the reason.
class FRANA_API RunFailed : public Error {
  public:
    RunFailed(const std::string& text, std::vector<Problem> problems, Result result);
    ~RunFailed() override;
    [[nodiscard]] const Result& result() const noexcept { return result_; }

  private:
    Result result_;
};

struct Options {
    int threads = 1;                            ///< the result does not depend on it by one bit; 0: all there are
    std::function<bool()> stop_requested{};     ///< asked at every step; true: the run ends there
    std::function<void(double)> on_progress{};  ///< called at every step with the simulated time [s]
};

/// The flow at one instant.
class FRANA_API Frame {
  public:
    [[nodiscard]] int index() const noexcept;
    [[nodiscard]] double time() const noexcept;  ///< [s]
    /// The rasters there are: depth, velocity, ...
    [[nodiscard]] std::vector<RasterInfo> rasters() const;
    /// Throws Error for another name.
    [[nodiscard]] Raster raster(const std::string& name) const;

    struct Data;
    explicit Frame(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

  private:
    std::shared_ptr<const Data> data_;
};

/// A run, frame by frame: at the start, at every frame, at the end.
///
///     frana::Run run(scene);
///     while (const auto frame = run.next()) use(*frame);
///     const frana::Result result = run.result();
class FRANA_API Run {
  public:
    /// Throws Error with every problem of the scene.
    explicit Run(const Scene& scene, Options options = {});
    Run(Run&& other) noexcept;
    Run& operator=(Run&& other) noexcept;
    ~Run();

    /// Computes up to the next frame; none: the run has ended.
    std::optional<Frame> next();
    /// Simulated time so far [s].
    [[nodiscard]] double time() const noexcept;
    /// Computes what is left, and returns the result. Throws RunFailed.
    [[nodiscard]] Result result();

    struct Data;

  private:
    std::unique_ptr<Data> data_;
};

/// Runs a scene to its end. Throws Error with every problem of the scene, RunFailed.
[[nodiscard]] FRANA_API Result run(const Scene& scene, Options options = {});

}  // namespace facade

#ifndef FRANA_INSIDE  // the engine has names of its own
using namespace facade;
#endif

}  // namespace frana
