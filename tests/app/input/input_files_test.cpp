// SPDX-License-Identifier: Apache-2.0
// Every key that can name a file: with another content --resume treats it as another scene. Loops over the table of
// keys; a new key needs a sample here.
#include <map>

#include "app/input/prepare.h"
#include "app/input/share_directory.h"
#include "app/store/scene_identity.h"
#include "params/keys/laws.h"
#include "params/keys/scene_parameters.h"
#include "resuming.h"
#include "support/checked_scene.h"
#include "support/files.h"

namespace frana::test {
namespace {

class InputFiles : public TinyScene {
  protected:
    InputFiles() {
        write_scene(k_numbers_only);
        write("structured.ini",
              "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n[material]\nmodel = "
              "structured\n[structured]\nphases = solids-and-fluid\ncohesion = 2e3\ninternal-friction-angle = 28\n"
              "[numerics]\nparticles-per-cell = 9\n" +
                  k_numbers_only);
    }
    [[nodiscard]] app::Prepared prepared(const std::string& scene, const Sets& sets) const {
        app::RunLog log(true);
        return app::prepare(read_scene(path(scene), sets, app::share_directory()), log);
    }
    /// `step`: alternately up and down.
    void write_raster(const std::string& name, double value, bool bytes = false, double step = 0) const {
        gis::test::TestRaster raster;
        raster.columns = k_columns;
        raster.rows = k_rows;
        raster.west = k_west;
        raster.north = k_south + k_rows * k_cell;
        raster.cell_x = raster.cell_y = k_cell;
        raster.crs = "EPSG:32632";
        raster.bytes = bytes;
        for (int row = 0; row < k_rows; ++row)
            for (int column = 0; column < k_columns; ++column)
                raster.values.push_back(value + ((row + column) % 2 == 0 ? step : -step));
        gis::test::make_raster(path(name), raster);
    }
    void write_shape(const std::string& wkt) const {
        std::filesystem::remove(path("file.gpkg"));
        gis::test::make_vector(path("file.gpkg"), "GPKG", "EPSG:32632", {wkt});
    }
    static std::string place(double x, double y) {
        return std::to_string(k_west + x) + " " + std::to_string(k_south + y);
    }

    /// How a key names a file, and two contents of that file.
    struct Sample {
        std::string scene = "scene.ini";
        Sets sets;
        std::function<void(int)> write;
    };
    [[nodiscard]] std::optional<Sample> sample_of(const Parameter& key) const;
    [[nodiscard]] std::optional<Sample> file_sample_of(const std::string& name) const;
    [[nodiscard]] Sample raster_sample_of(const Parameter& key) const;
};

// Two values allowed by the key, under the law that reads them.
InputFiles::Sample InputFiles::raster_sample_of(const Parameter& key) const {
    const std::string name = key.name();
    std::vector<double> values;
    for (const double value : {0.5, 0.6, 20.0, 21.0, 2000.0, 2100.0})
        if (values.size() < 2 && key.fits(value)) values.push_back(value);
    Sample sample;
    sample.sets = {name + "=raster:file.tif"};
    sample.write = [this, values](int version) { write_raster("file.tif", values.at(version)); };
    if (key.section == "structured") sample.scene = "structured.ini";
    for (const std::string soil : {"conductivity", "suction", "moisture-deficit"})  // which only stand together
        if (name.starts_with("structured.soil-") && !name.ends_with(soil))
            sample.sets.push_back("structured.soil-" + soil + "=0.1");
    const std::vector<const Law*> readers = readers_of(name);
    if (readers.empty()) return sample;
    const Law& law = *readers.front();
    std::string selected = law.selected_by();
    std::erase(selected, ' ');
    sample.sets.push_back(law.kind != LawKind::bed_friction ? selected : "material.bed-friction=voellmy, " + law.word);
    return sample;
}

std::optional<InputFiles::Sample> InputFiles::file_sample_of(const std::string& name) const {
    const auto box = [this](double west) {
        return [this, west](int version) {
            const std::string a = place(west + version, 60), b = place(west + 20, 60), c = place(west + 20, 90),
                              d = place(west + version, 90);
            write_shape("POLYGON((" + a + "," + b + "," + c + "," + d + "," + a + "))");
        };
    };
    const auto line = [this](int version) {
        write_shape("LINESTRING(" + place(40 + version, 60) + "," + place(40, 90) + ")");
    };
    const auto point = [this](int version) { write_shape("POINT(" + place(40 + version, 60) + ")"); };
    const auto raster = [this](int version) { write_raster("file.tif", 2 + version); };
    const auto picture = [this](int version) { write_raster("file.tif", 100 + version, true); };
    const auto logo = [this](int version) {
        std::filesystem::remove(path("file.tif"));
        write_raster("file.tif", 100 + version, true);
        gis::test::copy_as(path("file.tif"), path("file.png"), "PNG");
    };
    const auto hydrograph = [this](int version) {
        write("file.csv", "time,discharge,velocity\n0,5,2\n10," + std::to_string(5 + version) + ",2\n");
    };
    write("forest.ini", own_friction_table(0.2));
    const Sets flows{"inflow.line=line.geojson", "inflow.hydrograph=flood.csv"};
    write("flood.csv", "time,discharge,velocity\n0,5,2\n10,5,2\n");
    write_features("line", {{"LineString", {{90, 60}, {90, 90}}}});
    const std::string shape = name + "=file.gpkg", tif = name + "=file.tif", scene = "scene.ini";
    const std::map<std::string, Sample> samples{
        {"terrain.dtm",
         {scene,
          {name + "=file.asc"},
          [this](int version) {
              write_dtm([version](int, int column) { return 300 - column - 0.1 * version; }, true, "file.asc");
          }}},
        {"terrain.friction-zones", {scene, {shape, "zones.friction-angle=attribute:thick"}, box(100)}},
        {"terrain.obstacles", {scene, {shape, "terrain.obstacle-height=2"}, box(100)}},
        {"terrain.walls", {scene, {shape}, box(100)}},
        {"release.perimeter", {scene, {shape}, box(30)}},
        {"release.thickness", {scene, {name + "=raster:file.tif"}, raster}},
        {"inflow.line", {scene, {flows[1], shape}, line}},
        {"inflow.hydrograph", {scene, {flows[0], name + "=file.csv"}, hydrograph}},
        {"structured.rain",
         {"structured.ini",
          {name + "=table:file.csv"},
          [this](int version) { write("file.csv", "time,rain\n0,20\n10," + std::to_string(20 + version) + "\n"); }}},
        {"structured.zones", {"structured.ini", {shape, "structured.initial-fluid-depth=attribute:thick"}, box(30)}},
        {"hazard.scheme",
         {scene,
          {name + "=file.ini"},
          [this](int version) {
              write("file.ini",
                    "[scheme]\ntitle = Own\nsource = None\n[class-1]\nname = Low\ncolour = ffdd33\n[class-2]\n"
                    "name = High\ncolour = d7191c\ncondition = depth > " +
                        std::to_string(1 + version) + " m\n");
          }}},
        {"material.friction-table",
         {scene,
          {name + "=file.ini", "material.return-period=30"},
          [this](int version) { write("file.ini", own_friction_table(0.2 + 0.1 * version)); }}},
        {"material.forest",
         {scene, {shape, "material.friction-table=forest.ini", "material.return-period=30"}, box(100)}},
        {"output.map-background", {scene, {tif}, picture}},
        {"output.map-context", {scene, {shape}, line}},
        {"output.map-logo", {scene, {name + "=file.png"}, logo}},
        {"output.gauges", {scene, {shape}, point}},
        {"output.cross-sections", {scene, {shape}, line}},
        {"output.profiles", {scene, {shape}, line}},
        {"output.exposure", {scene, {shape}, point}},
        {"exposure.fragility",
         {scene,
          {name + "=file.csv", "output.exposure=perimeter.geojson"},
          [this](int version) {
              write("file.csv", "state,loss_ratio,quantity,unit,median,beta\nheavy,1,depth,m," +
                                    std::to_string(1 + version) + ",0\n");
          }}},
        {"observed.perimeter", {scene, {shape}, box(30)}},
        {"observed.front", {scene, {shape}, line}},
        {"observed.deposit", {scene, {shape}, box(100)}},
    };
    const auto found = samples.find(name);
    if (found == samples.end()) return std::nullopt;
    return found->second;
}

std::optional<InputFiles::Sample> InputFiles::sample_of(const Parameter& key) const {
    if (const auto sample = file_sample_of(key.name())) return sample;
    if (key.fits) return raster_sample_of(key);
    return std::nullopt;
}

TEST_F(InputFiles, AnotherContentOfAnyFileIsAnotherScene) {
    int keys = 0;
    for (const Parameter& key : scene_parameters()) {
        if (!key.reads_files()) continue;
        SCOPED_TRACE(key.name());
        const auto sample = sample_of(key);
        if (!sample) {
            ADD_FAILURE() << "the key names files, but this test has no sample of one";
            continue;
        }
        ++keys;
        try {
            sample->write(0);
            const std::string first = app::scene_identity(prepared(sample->scene, sample->sets));
            EXPECT_TRUE(app::scene_identity(prepared(sample->scene, sample->sets)) == first) << "twice the same";
            sample->write(1);
            EXPECT_FALSE(app::scene_identity(prepared(sample->scene, sample->sets)) == first);
        } catch (const Error& error) {
            ADD_FAILURE() << error.what();
        }
    }
    EXPECT_GT(keys, 25);
}

// The cells of the thickness's own raster determine the volume, even if the working grid is not affected.
TEST_F(InputFiles, AThicknessCountsByItsOwnCells) {
    const Sets sets{"release.thickness=raster:file.tif", "terrain.cell-size=10", "terrain.crs=EPSG:32632"};
    const auto identity = [&](double step) {
        write_raster("file.tif", 2, false, step);
        return app::scene_identity(prepared("scene.ini", sets));
    };
    EXPECT_FALSE(identity(0) == identity(0.25));
}

class ChangedInput : public Resuming {};

// Files only drawn or compared count too: --resume would show the old one as the new.
TEST_F(ChangedInput, IsNotResumedAndNotCalledComplete) {
    write_polygon("scar", {{20, 50}, {200, 50}, {200, 100}, {20, 100}});
    const std::vector<std::string> more{"--set", "observed.perimeter=scar.geojson"};
    const auto with = [&](std::vector<std::string> first) {
        first.insert(first.end(), more.begin(), more.end());
        return first;
    };
    interrupt("begun", more);
    succeeded(frana(run("done", with({"--quiet"}))));
    write_polygon("scar", {{20, 50}, {210, 50}, {210, 100}, {20, 100}});
    for (const std::string result : {"begun", "done"}) {
        refusal_of(frana(run(result, with({"--resume"}))), {"the content of Observed outline differs"});
    }
}

}  // namespace
}  // namespace frana::test
