// SPDX-License-Identifier: Apache-2.0
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "facade/frana.h"

namespace frana::python {
namespace {

namespace py = pybind11;

/// Works without Python's lock.
template <class Work>
auto unlocked(const Work& work) {
    const py::gil_scoped_release gil;
    return work();
}

/// A run whose steps hold no lock of Python and which Ctrl-C ends.
class PythonRun {
  public:
    PythonRun(const Scene& scene, int threads) : interrupted_(std::make_shared<bool>(false)) {
        Options options;
        options.threads = threads;
        options.stop_requested = [interrupted = interrupted_, next = std::chrono::steady_clock::now()]() mutable {
            if (*interrupted) return true;
            const auto now = std::chrono::steady_clock::now();
            if (now < next) return false;
            next = now + std::chrono::milliseconds(50);
            const py::gil_scoped_acquire gil;
            *interrupted = PyErr_CheckSignals() != 0;
            return *interrupted;
        };
        const py::gil_scoped_release gil;
        run_ = std::make_unique<Run>(scene, std::move(options));
    }
    std::optional<Frame> next() {
        const Turn turn(*this);
        std::optional<Frame> frame = unlocked([&] { return run_->next(); });
        raise_interrupt();
        return frame;
    }
    Result result() {
        const Turn turn(*this);
        std::optional<Result> result = unlocked([&] { return std::optional<Result>(run_->result()); });
        raise_interrupt();
        return *result;
    }
    /// While another thread computes, the time of the frame before.
    [[nodiscard]] double time() const { return is_computing_ ? time_ : run_->time(); }

  private:
    /// One thread of Python at a time computes a run. Begins and ends with Python's lock held.
    class Turn {
      public:
        explicit Turn(PythonRun& run) : run_(run) {
            if (run.is_computing_) throw py::value_error("another thread computes this run: give each thread its own");
            run.time_ = run.run_->time();
            run.is_computing_ = true;
        }
        ~Turn() { run_.is_computing_ = false; }
        Turn(const Turn&) = delete;
        Turn& operator=(const Turn&) = delete;

      private:
        PythonRun& run_;
    };

    // The signal's exception, which is set.
    static void raise_interrupt() {
        if (PyErr_Occurred() != nullptr) throw py::error_already_set();
    }

    std::shared_ptr<bool> interrupted_;
    std::unique_ptr<Run> run_;
    bool is_computing_ = false;
    double time_ = 0;
};

}  // namespace
}  // namespace frana::python

// The Python module: the facade with numpy arrays. Arrays are not copied: a scene reads the user's arrays where they
// are, an array of a result is the result's memory and keeps it.

namespace py = pybind11;
using namespace pybind11::literals;

namespace frana::python {

/// Takes an object only if it was constructed: for one made by __new__ alone pybind11 passes raw memory.
template <class T>
struct ConstructedCaster : py::detail::type_caster_base<T> {
    bool load(py::handle source, bool convert) {
        if (py::isinstance<T>(source)) {
            auto* const object = reinterpret_cast<py::detail::instance*>(source.ptr());
            if (!object->get_value_and_holder().holder_constructed()) return false;
        }
        return py::detail::type_caster_base<T>::load(source, convert);
    }
};

}  // namespace frana::python

namespace pybind11::detail {

template <class T>
requires std::is_same_v<T, frana::Scene> || std::is_same_v<T, frana::Result> || std::is_same_v<T, frana::Frame> ||
    std::is_same_v<T, frana::RasterInfo> || std::is_same_v<T, frana::Problem> ||
    std::is_same_v<T, frana::python::PythonRun>
struct type_caster<T> : frana::python::ConstructedCaster<T> {
};

}  // namespace pybind11::detail

namespace frana::python {
namespace {

using Array = py::array_t<double, py::array::c_style>;

std::string shape_text(const py::array& array) {
    std::string text;
    for (py::ssize_t i = 0; i < array.ndim(); ++i) text += (i > 0 ? " x " : "") + std::to_string(array.shape(i));
    return text;
}

/// The values of an array, which they keep. Throws TypeError for an array that would have to be copied.
Values values_of(const py::object& object, const char* what) {
    const auto refuse = [&](const std::string& problem, const std::string& remedy) {
        throw py::type_error(std::string(what) + ": " + problem + ". " + remedy);
    };
    if (!py::isinstance<py::array>(object))
        refuse("is not a numpy array", "Give numpy.asarray(values, dtype=numpy.float64)");
    if (py::isinstance(object, py::module_::import("numpy.ma").attr("MaskedArray")))
        refuse("is a masked array, and the values under its mask would count", "Give values.filled(numpy.nan)");
    const auto array = py::reinterpret_borrow<py::array>(object);
    if (array.ndim() != 2) refuse("has " + std::to_string(array.ndim()) + " dimensions", "Give rows x columns");
    if (!py::isinstance<Array>(object))
        refuse("is not a C-contiguous array of float64, and frana makes no copies",
               "Give numpy.ascontiguousarray(values, dtype=numpy.float64)");
    // A reference that any thread of the engine may be the last to drop.
    const std::shared_ptr<const void> keeper(object.inc_ref().ptr(), [](const void* kept) {
        const py::gil_scoped_acquire gil;
        Py_DECREF(static_cast<PyObject*>(const_cast<void*>(kept)));
    });
    return {{static_cast<const double*>(array.data()), static_cast<std::size_t>(array.size())}, keeper};
}

/// The same for an array on a scene's grid.
Values values_on(const Grid& grid, const py::object& object, const char* what) {
    Values values = values_of(object, what);
    const auto array = py::reinterpret_borrow<py::array>(object);
    if (array.shape(0) != grid.rows || array.shape(1) != grid.columns)
        throw py::value_error(std::string(what) + ": has " + shape_text(array) + " values, and the scene " +
                              std::to_string(grid.rows) + " x " + std::to_string(grid.columns) + " cells");
    return values;
}

/// A read-only array that is the memory of a result.
py::array array_of(const Raster& raster) {
    auto keeper = std::make_unique<std::shared_ptr<const void>>(raster.keeper);
    const py::capsule base(keeper.get(), [](void* kept) { delete static_cast<std::shared_ptr<const void>*>(kept); });
    static_cast<void>(keeper.release());
    py::array_t<double> array({raster.grid.rows, raster.grid.columns}, raster.cells.data(), base);
    array.attr("flags").attr("writeable") = false;
    return array;
}

std::string text_of(const py::object& value) {
    if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "on" : "off";
    if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
        std::string list;
        for (const auto& one : value) list += (list.empty() ? "" : ", ") + std::string(py::str(one));
        return list;
    }
    return py::str(value);
}

Scene make_scene(const py::object& elevations, double west, double north, double cell_size) {
    Values values = values_of(elevations, "elevations");
    const auto array = py::reinterpret_borrow<py::array>(elevations);
    return Scene({west, north, cell_size, array.shape(0), array.shape(1)}, std::move(values));
}

[[noreturn]] void refuse(const Problem& problem) {
    throw Error(problem.where + ": " + problem.what + ". " + problem.remedy, {problem});
}

/// The same as a tuple of numbers; refused if it is none.
template <class Numbers>
Numbers numbers_of(const py::handle& row, const Problem& problem) {
    try {
        return row.cast<Numbers>();
    } catch (const py::cast_error&) {
        Problem refused = problem;
        refused.value = py::str(row);
        refuse(refused);
    }
}

std::vector<Point> points_of(const py::handle& points) {
    std::vector<Point> list;
    for (const auto& point : points) {
        const auto [x, y] = numbers_of<std::pair<double, double>>(
            point, {"is not a point", "points", "", "", "Give points (x, y) in metres"});
        list.push_back({x, y});
    }
    return list;
}

Ring ring_of(const py::handle& points) {
    Ring ring = points_of(points);
    if (ring.size() > 1 && ring.front().x == ring.back().x && ring.front().y == ring.back().y) ring.pop_back();
    return ring;
}

void add_release(Scene& scene, const py::object& thickness, const py::object& outline, const py::object& holes,
                 std::optional<double> volume, const std::string& name) {
    Release release;
    if (!outline.is_none()) {
        Polygon& polygon = release.outline.emplace_back();
        polygon.outer = ring_of(outline);
        for (const auto& hole : holes) polygon.holes.push_back(ring_of(hole));
    }
    if (py::isinstance<py::float_>(thickness) || py::isinstance<py::int_>(thickness))
        release.thickness = thickness.cast<double>();
    else
        release.thicknesses = values_on(scene.grid(), thickness, "thickness");
    release.volume = volume;
    release.name = name;
    scene.add_release(std::move(release));
}

/// Rows of time, discharge and, if there is a third, velocity.
Inflow inflow_of(const py::object& line, const py::object& hydrograph, std::optional<double> direction) {
    Inflow inflow;
    inflow.line = points_of(line);
    inflow.direction = direction;
    for (const auto& row : hydrograph) {
        const Problem problem{"is not a row of two or three numbers", "hydrograph", "", "",
                              "Give (time, discharge) or (time, discharge, velocity)"};
        const auto numbers = numbers_of<std::vector<double>>(row, problem);
        if (numbers.size() != 2 && numbers.size() != 3) refuse(problem);
        HydrographPoint& point = inflow.hydrograph.emplace_back(HydrographPoint{numbers[0], numbers[1]});
        if (numbers.size() == 3) point.velocity = numbers[2];
    }
    return inflow;
}

/// Adds a geometry of GeoJSON; coordinates beyond x and y are heights, which do not matter.
void add_geometry(const py::object& given, Exposed& feature) {
    const py::object geometry = py::hasattr(given, "__geo_interface__") ? given.attr("__geo_interface__") : given;
    const Problem problem{"is not a geometry of GeoJSON", "features", "", "",
                          "Give Point, LineString, Polygon, their Multi forms or a GeometryCollection"};
    if (!py::isinstance<py::dict>(geometry)) refuse(problem);
    const auto member = [&](const char* name) { return py::object(geometry.attr("get")(name)); };
    const std::string type = py::str(member("type"));
    if (type == "Feature") return add_geometry(member("geometry"), feature);
    const py::object parts = member(type == "GeometryCollection" ? "geometries" : "coordinates");
    if (parts.is_none()) refuse(problem);
    if (type == "GeometryCollection") {
        for (const auto& part : parts) add_geometry(py::reinterpret_borrow<py::object>(part), feature);
        return;
    }
    const auto flat = [](const py::handle& points) {
        py::list list;
        for (const auto& point : points) list.append(point[py::slice(0, 2, 1)]);
        return list;
    };
    const auto add_one = [&](const std::string& kind, const py::handle& one) {
        if (kind == "Point") {
            feature.points.push_back(points_of(flat(py::make_tuple(one))).front());
        } else if (kind == "LineString") {
            feature.lines.push_back(points_of(flat(one)));
        } else if (kind == "Polygon") {
            Polygon polygon;
            for (const auto& ring : one)
                (polygon.outer.empty() ? polygon.outer : polygon.holes.emplace_back()) = ring_of(flat(ring));
            feature.areas.push_back(std::move(polygon));
        } else {
            refuse(problem);
        }
    };
    if (!type.starts_with("Multi")) return add_one(type, parts);
    for (const auto& part : parts) add_one(type.substr(5), part);
}

py::list exposure_of(const Result& result, const py::iterable& features) {
    std::vector<Exposed> all;
    for (const auto& one : features) add_geometry(py::reinterpret_borrow<py::object>(one), all.emplace_back());
    py::list rows;
    for (const Exposure& row : result.exposure(all))
        rows.append(py::dict("reached"_a = row.reached, "max_depth_m"_a = row.depth, "max_velocity_ms"_a = row.velocity,
                             "max_pressure_kpa"_a = row.pressure, "arrival_s"_a = row.arrival, "place"_a = row.place));
    return rows;
}

/// Columns of series by their names.
py::dict columns_of(const std::vector<Series>& series) {
    py::dict columns;
    for (const Series& column : series)
        columns[py::str(column.name)] =
            py::array_t<double>(static_cast<py::ssize_t>(column.values.size()), column.values.data());
    return columns;
}

py::dict records_of(const std::vector<Record>& records) {
    py::dict named;
    for (const Record& record : records) named[py::str(record.name)] = columns_of(record.columns);
    return named;
}

py::dict rasters_of(const std::vector<RasterInfo>& list) {
    py::dict rasters;
    for (const RasterInfo& info : list) rasters[py::str(info.name)] = info;
    return rasters;
}

/// Sets a Python exception with its problems.
template <class Failure>
py::object exception_of(const py::object& type, const Failure& failure) {
    py::object exception = type(failure.what());
    exception.attr("problems") = failure.problems();
    return exception;
}

void add_errors(py::module_& module) {
    const auto make = [&](const char* name, const char* text, const py::handle& base) {
        const auto type = py::reinterpret_steal<py::object>(
            PyErr_NewExceptionWithDoc((std::string("frana.") + name).c_str(), text, base.ptr(), nullptr));
        module.attr(name) = type;
        return type;
    };
    // The module lives as long as the process.
    static const py::handle error =
        make("Error", "Problems of a scene, all of them, found before anything is computed: `problems`.",
             PyExc_Exception)
            .release();
    static const py::handle failed =
        make("RunFailed",
             "A run that failed (non-finite values, an impossible speed, cells without terrain): `problems`, and the "
             "`result` up to there, which is fit only to find the reason.",
             error)
            .release();
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const RunFailed& failure) {
            py::object exception = exception_of(py::reinterpret_borrow<py::object>(failed), failure);
            exception.attr("result") = failure.result();
            PyErr_SetObject(failed.ptr(), exception.ptr());
        } catch (const Error& failure) {
            PyErr_SetObject(error.ptr(), exception_of(py::reinterpret_borrow<py::object>(error), failure).ptr());
        }
    });
}

void add_problem(py::module_& module) {
    py::class_<Problem>(module, "Problem", "One problem of a scene.")
        .def_readonly("what", &Problem::what)
        .def_readonly("where", &Problem::where, "the key")
        .def_readonly("value", &Problem::value)
        .def_readonly("limit", &Problem::limit)
        .def_readonly("remedy", &Problem::remedy)
        .def("__repr__", [](const Problem& p) { return "<frana.Problem " + p.where + ": " + p.what + ">"; });
}

void add_scene(py::module_& module) {
    py::class_<Scene>(
        module, "Scene",
        "What is computed: the ground, the mass that fails, and keys of scene files.\n\n"
        "elevations: array of float64 [m], rows x columns, C-contiguous, the northernmost row first; NaN: "
        "no data. It is not copied: do not change it as long as the scene or a run of it exists.\n"
        "west, north: easting and northing of the north-western corner [m]\n"
        "cell_size: side of a cell [m]")
        .def(py::init(&make_scene), "elevations"_a, py::kw_only(), "west"_a = 0.0, "north"_a = 0.0, "cell_size"_a)
        .def(
            "set",
            [](Scene& scene, const std::string& key, const py::object& value) { scene.set(key, text_of(value)); },
            "key"_a, "value"_a,
            "Sets a key of scene files, \"section.key\", to a text, number, bool or list, in the units of scene files "
            "(share/doc/parameters.md). Raises Error if there is no such key or the value is not allowed.")
        .def("__setitem__",
             [](Scene& scene, const std::string& key, const py::object& value) { scene.set(key, text_of(value)); })
        .def(
            "set_values",
            [](Scene& scene, const std::string& key, const py::object& values) {
                scene.set_values(key, values_on(scene.grid(), values, key.c_str()));
            },
            "key"_a, "values"_a,
            "Sets a key of [zones], such as \"zones.friction-angle\" [degrees], or of the structured model's solids, "
            "such as \"structured.cohesion\" [Pa], or \"structured.initial-fluid-depth\" [m], by place: array of "
            "float64, "
            "rows x columns; NaN: the material's own value. Not copied.")
        .def(
            "set_walls",
            [](Scene& scene, const py::object& walls) { scene.set_walls(values_on(scene.grid(), walls, "walls")); },
            "walls"_a, "Walls that no flow overtops: array of float64, rows x columns; 1 wall, 0 none. Not copied.")
        .def("add_release", &add_release, "thickness"_a, "outline"_a = py::none(), "holes"_a = py::list(),
             "volume"_a = py::none(), "name"_a = "",
             "Adds an area that fails.\n\n"
             "thickness: [m], one number, or an array of float64, rows x columns, not copied; nothing fails where it "
             "is 0 or NaN\n"
             "outline: points (x, y) [m] of a ring; with an array of thicknesses it may be left out\n"
             "holes: rings in it\n"
             "volume: [m3], to which the thickness is scaled")
        .def(
            "add_inflow",
            [](Scene& scene, const py::object& line, const py::object& hydrograph, std::optional<double> direction) {
                scene.add_inflow(inflow_of(line, hydrograph, direction));
            },
            "line"_a, "hydrograph"_a, "direction"_a = py::none(),
            "Adds material that flows in through a line.\n\n"
            "line: points (x, y) [m]\n"
            "hydrograph: rows (time [s], discharge [m3/s]) or (time, discharge, velocity [m/s]), linear between them; "
            "without velocity it crosses the line at the critical speed\n"
            "direction: [degrees] clockwise from north; None: normal to the line, downhill")
        .def(
            "add_gauge",
            [](Scene& scene, double x, double y, const std::string& name) {
                scene.add_gauge({{x, y}, name});
            },
            "x"_a, "y"_a, "name"_a = "",
            "Adds a place where depth and speed are recorded at every step, or as output.sample-interval says. Without "
            "a name it has its number.")
        .def(
            "add_section",
            [](Scene& scene, const py::object& line, const std::string& name) {
                scene.add_section({points_of(line), name});
            },
            "line"_a, "name"_a = "",
            "Adds a line of points (x, y) [m] through which the discharge is recorded, positive to the right of its "
            "direction.")
        .def("check", &Scene::check,
             "Raises Error with every problem of the scene; returns what is worth a second look.")
        .def_property_readonly(
            "shape", [](const Scene& scene) { return std::pair(scene.grid().rows, scene.grid().columns); },
            "rows, columns")
        .def_property_readonly(
            "west", [](const Scene& scene) { return scene.grid().west; }, "[m]")
        .def_property_readonly(
            "north", [](const Scene& scene) { return scene.grid().north; }, "[m]")
        .def_property_readonly(
            "cell_size", [](const Scene& scene) { return scene.grid().cell_size; }, "[m]");
}

void add_results(py::module_& module) {
    py::class_<RasterInfo>(module, "RasterInfo", "The name of a raster with its title and unit.")
        .def_readonly("name", &RasterInfo::name)
        .def_readonly("title", &RasterInfo::title)
        .def_readonly("unit", &RasterInfo::unit)
        .def("__repr__", [](const RasterInfo& info) { return "<" + info.title + " [" + info.unit + "]>"; });
    const char* const k_raster =
        "A raster by its name: read-only array of float64, rows x columns; NaN where nothing ever flowed. It is the "
        "memory of the result, which it keeps.";
    py::class_<Frame>(module, "Frame", "The flow at one instant.")
        .def_property_readonly("index", &Frame::index)
        .def_property_readonly("time", &Frame::time, "simulated time [s]")
        .def_property_readonly(
            "rasters", [](const Frame& frame) { return rasters_of(frame.rasters()); },
            "the rasters there are: depth [m], velocity [m/s], ...")
        .def(
            "__getitem__", [](const Frame& frame, const std::string& name) { return array_of(frame.raster(name)); },
            "name"_a, k_raster);
    py::class_<Result>(module, "Result", "What a run gives.")
        .def_property_readonly(
            "rasters", [](const Result& result) { return rasters_of(result.rasters()); },
            "the rasters there are: max_depth [m], max_velocity [m/s], max_pressure [kPa], arrival_time [s], "
            "final_depth [m], ...")
        .def(
            "__getitem__", [](const Result& result, const std::string& name) { return array_of(result.raster(name)); },
            "name"_a, k_raster)
        .def_property_readonly(
            "summary", [](const Result& result) { return py::module_::import("json").attr("loads")(result.summary()); },
            "what summary.json says of the run itself, by the same keys")
        .def_property_readonly(
            "series", [](const Result& result) { return columns_of(result.series()); },
            "one value for each step: time [s], dt [s], volume [m3], max_depth [m], max_speed [m/s], "
            "front_distance [m], kinetic_energy [J], covered_area [m2], ...")
        .def_property_readonly(
            "gauges", [](const Result& result) { return records_of(result.gauges()); },
            "by the names of gauges, values over time: time [s], depth [m], speed [m/s]")
        .def_property_readonly(
            "sections", [](const Result& result) { return records_of(result.sections()); },
            "by the names of cross-sections, values over time: time [s], discharge [m3/s], volume [m3], "
            "wetted_width [m], max_depth [m], max_speed [m/s]")
        .def_property_readonly("stop_reason", &Result::stop_reason, "\"end-time\", \"still\", \"settled\", ...")
        .def_property_readonly("warnings", &Result::warnings,
                               "what must be known before relying on it: the sentences that summary.json has")
        .def_property_readonly("notes", &Result::notes, "choices made")
        .def("exposure", &exposure_of, "features"_a,
             "What the flow does to features, as in exposure.csv: a dict for each, with reached, max_depth_m, "
             "max_velocity_ms, max_pressure_kpa, arrival_s (NaN where nothing arrives) and place.\n\n"
             "features: geometries of GeoJSON as dicts (type, coordinates) in the scene's coordinates, or objects that "
             "have __geo_interface__, such as those of shapely. Each counts every cell that it touches.");
    py::class_<PythonRun>(module, "Run",
                          "A run, frame by frame: an iterator. While it computes, other threads of Python run, and "
                          "Ctrl-C ends it.")
        .def(py::init<const Scene&, int>(), "scene"_a, "threads"_a = 1)
        .def("__iter__", [](PythonRun& run) -> PythonRun& { return run; })
        .def(
            "__next__",
            [](PythonRun& run) {
                std::optional<Frame> frame = run.next();
                if (!frame) throw py::stop_iteration();
                return *frame;
            },
            "Computes up to the next frame: at the start, at every frame, at the end.")
        .def_property_readonly("time", &PythonRun::time, "simulated time so far [s]")
        .def("result", &PythonRun::result, "Computes what is left, and returns the result.");
}

}  // namespace
}  // namespace frana::python

PYBIND11_MODULE(_frana, module) {
    module.doc() = "The engine of frana; see the package frana.";
    module.attr("__version__") = frana::version();
    frana::python::add_errors(module);
    frana::python::add_problem(module);
    frana::python::add_scene(module);
    frana::python::add_results(module);
}
