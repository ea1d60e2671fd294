// SPDX-License-Identifier: Apache-2.0
// map.html as a browser shows it. Debian: chromium; skipped where it is absent.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "core/json.h"
#include "core/raster.h"
#include "gis/raster/raster_in.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

class MapPage : public TinyScene {
  protected:
    void SetUp() override {
        if (std::system("command -v chromium >/dev/null 2>&1") != 0)
            GTEST_SKIP() << "chromium (Debian: chromium) is not installed";
    }
    void run(const std::string& output, const std::string& more = "") {
        write_dtm();
        write_scene("[output]\nmaps = off\nanimation = off\ncharts = off\n" + output + "\n" + more);
        ran();
    }
    Json seen(const std::string& script, int width = 1200) {
        const Json all = seen(std::vector<std::string>{script}, width);
        return all.is_array() ? all.at(0) : Json{};
    }
    /// Opens a copy of the page in which each script ends with `seen = ...`; returns these, and what the console shows.
    Json seen(const std::vector<std::string>& scripts, int width = 1200) {
        const std::string page = text_of(path("result/map.html")), end = "</body>";
        std::string run_all;
        for (const std::string& script : scripts) run_all += "{ let seen;\n" + script + "\nall.push(seen); }\n";
        std::string copy = page;
        copy.insert(copy.rfind(end),
                    "<script>(async () => { const all = []; const wait = ms => new Promise(done => "
                    "setTimeout(done, ms)); await wait(300);\n" +
                        run_all +
                        "\ndocument.body.replaceChildren(element('pre', {id: 'seen'}, "
                        "encodeURIComponent(JSON.stringify(all)))); })();</script>");
        std::ofstream(path("copy.html"), std::ios::binary) << copy;
        const std::string command =
            "timeout 120 chromium --headless --no-sandbox --disable-gpu --no-first-run "
            "--disable-background-networking --disable-component-update --disable-sync "
            "--user-data-dir='" +
            path("browser") + "' --window-size=" + std::to_string(width) +
            ",900 --enable-logging=stderr --virtual-time-budget=20000 --dump-dom 'file://" + path("copy.html") +
            "' >'" + path("dom.html") + "' 2>'" + path("console.txt") + "'";
        EXPECT_EQ(std::system(command.c_str()), 0);
        EXPECT_EQ(text_of(path("console.txt")).find("CONSOLE"), std::string::npos) << text_of(path("console.txt"));
        const std::string dom = text_of(path("dom.html")), tag = "<pre id=\"seen\">";
        const std::size_t from = dom.find(tag);
        if (from == std::string::npos) {
            ADD_FAILURE() << "the script did not end";
            return {};
        }
        return Json::parse(unescaped(dom.substr(from + tag.size(), dom.find('<', from + 1) - from - tag.size())));
    }

  private:
    static std::string unescaped(const std::string& text) {
        std::string plain;
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] == '%') {
                plain += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
                i += 2;
            } else {
                plain += text[i];
            }
        }
        return plain;
    }
};

/// A click where a finger or a mouse would be, on a place in metres from the south-west corner.
const std::string k_click =
    "const click = async (x, y) => { const box = map.getContainer().getBoundingClientRect(); const at = "
    "map.latLngToContainerPoint([y, x]); const target = document.elementFromPoint(box.left + at.x, box.top + at.y); "
    "target.dispatchEvent(new MouseEvent('click', {bubbles: true, clientX: box.left + at.x, clientY: box.top + "
    "at.y})); "
    "await wait(300); };\nconst rows = () => [...document.querySelectorAll('#values tr')].map(row => "
    "[...row.children].map(cell => cell.textContent));\n";

/// Of one run, all that its page shows in a window.
class WholePage : public MapPage {
  protected:
    void expect_values(const Json& page) const;
    static void expect_classes(const Json& page);
    /// @param deepest  the cell's depth [m]
    static void expect_place(const Json& page, double deepest);
    static void expect_paper(const Json& told);
};

void WholePage::expect_values(const Json& page) const {
    EXPECT_EQ(page["requests"], 0);
    ASSERT_GE(page["layers"].size(), 5U);
    for (const Json& layer : page["layers"]) {
        const std::string name = layer["name"];
        const Raster raster = gis::read_result_raster(path("result/" + name + ".tif"));
        const double step = layer["step"];
        std::size_t compared = 0;
        for (std::int64_t row = 0; row < page["grid"]["rows"]; ++row)
            for (std::int64_t column = 0; column < page["grid"]["columns"]; ++column) {
                const double east = page["grid"]["west"].get<double>() + (static_cast<double>(column) + 0.5) * k_cell;
                const double north =
                    page["grid"]["south"].get<double>() +
                    (static_cast<double>(page["grid"]["rows"].get<std::int64_t>() - row) - 0.5) * k_cell;
                const double value = raster.at(static_cast<std::int64_t>((raster.grid.north - north) / k_cell),
                                               static_cast<std::int64_t>((east - raster.grid.west) / k_cell));
                const Json& shown =
                    layer["values"]
                         [static_cast<std::size_t>(row * page["grid"]["columns"].get<std::int64_t>() + column)];
                if (std::isnan(value)) {
                    ASSERT_TRUE(shown.is_null()) << name;
                } else if (!shown.is_null()) {  // zeros of some maps are blank
                    ASSERT_NEAR(shown.get<double>(), value, 0.5001 * step) << name;
                    ++compared;
                }
            }
        EXPECT_GT(compared, 20U) << name;
    }
    EXPECT_EQ(page["layers"][0]["name"], "max_depth");
    EXPECT_NE(text_of(path("result/map.html")).find("One run with one set of values"), std::string::npos);
    EXPECT_LE(page["layers"][0]["step"].get<double>(), 0.01 * 0.2);
}

// Inside a class its colour alone; at an edge pixels of one cell differ. What the cells hold stays.
void WholePage::expect_classes(const Json& page) {
    EXPECT_EQ(page["finer"], 4);
    EXPECT_GT(page["inside"].get<int>(), 10);
    EXPECT_EQ(page["wrong"], 0);
    EXPECT_GT(page["mixed"].get<int>(), 10);
}

void WholePage::expect_place(const Json& page, double deepest) {
    std::map<std::string, std::string> rows;
    for (const Json& row : page["rows"]) rows[row[0]] = row[1];
    EXPECT_NEAR(std::stod(rows["Maximum depth, vertical"]), deepest, 0.001001);
    EXPECT_TRUE(rows["Maximum depth, vertical"].ends_with(" m"));
    EXPECT_TRUE(rows["Maximum velocity"].ends_with(" m/s"));
    // EPSG:32632 at these coordinates, by PROJ's cs2cs: 46.0 N, 9.35 E; the middle of the slope is near.
    double latitude = 0, longitude = 0;
    ASSERT_EQ(std::sscanf(rows["Latitude, longitude"].c_str(), "%lf, %lf", &latitude, &longitude), 2);
    EXPECT_NEAR(latitude, 46.0, 0.01);
    EXPECT_NEAR(longitude, 9.35, 0.01);
    EXPECT_NE(page["popup"].get<std::string>().find(rows["Maximum depth, vertical"]), std::string::npos);
    EXPECT_GT(page["frames"].get<int>(), 2);
}

// On paper the ground fills the map, and the map the page that is turned as its ground is.
void WholePage::expect_paper(const Json& told) {
    const bool upright = told.at("page").get<std::string>().find("portrait") != std::string::npos;
    EXPECT_NEAR(told.at("across").get<double>(), 1, 0.02);
    EXPECT_NEAR(told.at("along").get<double>(), 1, 0.02);
    const double width = told.at("width"), height = told.at("height");
    EXPECT_EQ(upright, width < height);
    // 12 mm are the margins; legend and values need the rest of the height.
    EXPECT_TRUE(std::abs(width - (upright ? 186 : 273)) < 1 || std::abs(height - (upright ? 190 : 125)) < 1)
        << width << " x " << height;
    EXPECT_EQ(told.at("before"), told.at("after"));
}

TEST_F(WholePage, HasValuesClassesThePlaceClickedRoadsAndFillsPaper) {
    write_features("roads", {{"LineString", {{-50, 75}, {400, 75}}}, {"LineString", {{-50, 9000}, {400, 9000}}}});
    run("frames = on\nmap-context = roads.geojson");
    const Raster depth = gis::read_result_raster(path("result/max_depth.tif"));
    std::size_t deepest = 0;
    for (std::size_t cell = 0; cell < depth.values.size(); ++cell)
        if (depth.values[cell] > 0 && !(depth.values[cell] <= depth.values[deepest])) deepest = cell;
    const Point place = depth.grid.cell_centre(static_cast<std::int64_t>(deepest) / depth.grid.columns,
                                               static_cast<std::int64_t>(deepest) % depth.grid.columns);
    const std::string x = std::to_string(place.x) + " - grid.west", y = std::to_string(place.y) + " - grid.south";
    const std::string
        values =
            "seen = {grid, requests: performance.getEntriesByType('resource').length, layers: []};\n"
            "for (const one of data.layers) seen.layers.push({name: one.name, step: one.step, values: "
            "[...await cellsOf(one)].map(value => Number.isNaN(value) ? null : value)});",
        classes =
            "const values = await cellsOf(layer), width = shown.width;\n"
            "const bytes = shown.getContext('2d').getImageData(0, 0, width, shown.height).data;\n"
            "const of = (row, column) => row < 0 || column < 0 || row >= grid.rows || column >= grid.columns ? -1 : "
            "classOf(layer, values[row * grid.columns + column]);\n"
            "seen = {finer, inside: 0, wrong: 0, mixed: 0};\n"
            "for (let row = 0; row < grid.rows; ++row) for (let column = 0; column < grid.columns; ++column) {\n"
            "const own = of(row, column), around = [-1, 0, 1].flatMap(r => [-1, 0, 1].map(c => of(row + r, column + "
            "c))), "
            "colours = new Set();\n"
            "for (let k = 0; k < finer * finer; ++k) { const at = 4 * ((row * finer + Math.floor(k / finer)) * width + "
            "column * finer + k % finer); colours.add(bytes.slice(at, at + 4).join()); }\n"
            "if (own >= 0 && around.every(one => one === own)) { ++seen.inside; if (colours.size > 1 || "
            "!colours.has([...layer.classes[own].colour, 255].join())) ++seen.wrong; }\n"
            "else if (colours.size > 1) ++seen.mixed; }",
        click = k_click + "await click(" + x + ", " + y + "); seen = {rows: rows(), popup: " +
                "document.querySelector('.leaflet-popup-content').textContent, frames: data.frames.list.length};",
        roads =
            "seen = data.shapes.filter(one => one.title === 'Surroundings')"
            ".map(one => [one.features.length, map.hasLayer(one.group)]);",
        paper =
            "const before = map.getSize().x; window.dispatchEvent(new Event('beforeprint'));"
            "const view = map.getBounds(), size = map.getSize();"
            "seen = { across: extent[1][1] / (view.getEast() - view.getWest()), along: extent[1][0] / (view.getNorth() "
            "- "
            "view.getSouth()), width: size.x * 25.4 / 96, height: size.y * 25.4 / 96, page: sheet.textContent, before "
            "};"
            "window.dispatchEvent(new Event('afterprint')); seen.after = map.getSize().x;";
    const Json all = seen({values, classes, click, roads, paper});
    ASSERT_EQ(all.size(), 5U);
    expect_values(all[0]);
    expect_classes(all[1]);
    expect_place(all[2], depth.values[deepest]);
    EXPECT_EQ(all[3], Json::array({Json::array({1, true})})) << "of two roads one meets the map";
    expect_paper(all[4]);
}

TEST_F(MapPage, DrawsALineAndPlaysOnAPhone) {
    run("frames = on");
    const Json page =
        seen(k_click +
                 "seen = {columns: grid.columns, wide: document.documentElement.scrollWidth - "
                 "document.documentElement.clientWidth};\n"
                 "const w = grid.columns * grid.cell, h = grid.rows * grid.cell;\n"
                 "await click(0.5 * w, 0.5 * h); seen.popup = "
                 "document.querySelector('.leaflet-popup-content').textContent; map.closePopup();\n"
                 "byId('line').click(); await click(0.25 * w, 0.5 * h); await click(0.75 * w, 0.5 * h); "
                 "byId('line').click(); await wait(300);\n"
                 "seen.charts = document.querySelectorAll('#chart svg').length;\n"
                 "const made = []; HTMLAnchorElement.prototype.click = function () { made.push(this.href, "
                 "this.download); };\n"
                 "byId('save').click(); seen.csv = decodeURIComponent(made[0].split(',').slice(1).join(',')); "
                 "seen.name = made[1];\n"
                 "const pixels = () => shown.toDataURL();\n"
                 "await showLayer(); seen.greatest = pixels();\n"
                 "const slider = byId('frame'); slider.value = 0; slider.dispatchEvent(new Event('input')); await "
                 "wait(300);\n"
                 "seen.first = pixels(); seen.time = byId('time-text').textContent;\n"
                 "byId('play').click(); await wait(900); byId('play').click(); seen.later = Number(slider.value);\n"
                 "choice.selectedIndex = 1; choice.dispatchEvent(new Event('change')); await wait(300); seen.legend "
                 "= byId('legend').textContent;",
             500);
    EXPECT_LE(page["wide"], 0);
    EXPECT_NE(page["popup"].get<std::string>().find("Maximum velocity"), std::string::npos)
        << "all values, at the touch";
    EXPECT_GE(page["charts"].get<int>(), 3);
    const std::string csv = page["csv"];
    EXPECT_TRUE(csv.starts_with("distance_m,x,y,ground_m,max_depth_m,max_velocity_ms")) << csv.substr(0, 100);
    // A head, and samples half a cell apart over half of the columns.
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2 + page["columns"].get<int>());
    EXPECT_EQ(page["name"], "line.csv");
    EXPECT_NE(page["greatest"], page["first"]);
    EXPECT_EQ(page["time"], "0 s");
    EXPECT_GT(page["later"].get<int>(), 0);
    EXPECT_TRUE(page["legend"].get<std::string>().starts_with("Maximum velocity"));
}

// More than a million cells round the release: blocks of two, of which each has its greatest value, as the page says.
TEST_F(MapPage, ShowsTheGreatestValueOfBlocksOfALargeMap) {
    write_dtm();
    write_polygon("perimeter", {{10, 10}, {290, 10}, {290, 140}, {10, 140}});
    write_scene(k_pages_only + "[terrain]\ncell-size = 0.2\n[numerics]\nscheme = finite-volume\n");
    ran("result", {"time.end=0.02"});
    const Json page = seen(
        "const values = await cellsOf(data.layers.find(one => one.name === 'max_depth')); seen = {grid, notes: "
        "document.querySelector('aside').textContent, values: []};\n"
        "for (let cell = 0; cell < count; cell += 997) seen.values.push([cell, Number.isNaN(values[cell]) ? null : "
        "values[cell]]);");
    const Raster depth = gis::read_result_raster(path("result/max_depth.tif"));
    const double side = page["grid"]["cell"], west = page["grid"]["west"], south = page["grid"]["south"];
    const std::int64_t columns = page["grid"]["columns"], rows = page["grid"]["rows"];
    ASSERT_NEAR(side, 2 * depth.grid.cell_size, 1e-9);
    EXPECT_LE(columns * rows, 1'100'000);
    EXPECT_NE(page["notes"].get<std::string>().find("Cells of 0.4 m"), std::string::npos);
    const double north = south + side * static_cast<double>(rows);
    const auto row0 = std::llround((depth.grid.north - north) / depth.grid.cell_size),
               column0 = std::llround((west - depth.grid.west) / depth.grid.cell_size);
    int compared = 0;
    for (const Json& one : page["values"]) {
        const std::int64_t cell = one[0];
        double greatest = k_no_data;
        for (std::int64_t r = row0 + 2 * (cell / columns); r < row0 + 2 * (cell / columns) + 2; ++r)
            for (std::int64_t c = column0 + 2 * (cell % columns); c < column0 + 2 * (cell % columns) + 2; ++c)
                if (r < depth.grid.rows && c < depth.grid.columns) greatest = std::fmax(greatest, depth.at(r, c));
        ASSERT_EQ(one[1].is_null(), std::isnan(greatest)) << cell;
        if (one[1].is_null()) continue;
        ASSERT_NEAR(one[1].get<double>(), greatest, 0.001001) << cell;
        ++compared;
    }
    EXPECT_GT(compared, 100);
    EXPECT_LT(fs::file_size(path("result/map.html")), 6'000'000U);
}

TEST_F(MapPage, ShowsHostileNamesAsText) {
    const std::string name = "</script><img src=x onerror=alert(1)>\\\"'";
    run("title = " + name + "\nlanguage = de");
    const Json page = seen(
        "seen = {title: document.querySelector('h1').textContent, images: "
        "document.querySelectorAll('img').length, language: document.documentElement.lang, outlines: "
        "byId('outlines').textContent};");
    EXPECT_EQ(page["title"], name);
    EXPECT_EQ(page["images"], 0);
    EXPECT_EQ(page["language"], "de");
    EXPECT_NE(page["outlines"].get<std::string>().find("Anrissgebiet"), std::string::npos);
}

}  // namespace
}  // namespace frana::test
