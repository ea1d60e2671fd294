// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/qgis_project.h"

#include <cpl_conv.h>
#include <cpl_minixml.h>
#include <cpl_vsi.h>
#include <gtest/gtest.h>

#include <memory>

#include "gis/access/table_in.h"
#include "gis/crs/crs.h"
#include "support/files.h"

namespace frana::gis {
namespace {

using Xml = std::unique_ptr<CPLXMLNode, decltype(&CPLDestroyXMLNode)>;

const std::string outline_title = "A < B & \"C\"";

QgisProject project() {
    ProjectLayer frame{"Depth, 2.5 s", "frames/depth_0001.tif", "", Shape::area, "", true, std::pair{2.5, 5.0}};
    ProjectLayer outline{
        outline_title, "extent.gpkg", "release", Shape::area, style_of("release", Shape::area, {}).qml, true, {}};
    return {"Run <1>",
            crs_from_user("EPSG:32632", ""),
            {1, 2, 3, 4},
            {{"Outlines", {outline}}, {"Frames", {frame}, false, false}},
            2.5};
}

/// The .qgs in a .qgz.
std::string content(const std::string& path) {
    VSILFILE* const file = VSIFOpenL(("/vsizip/{" + path + "}/result.qgs").c_str(), "rb");
    if (file == nullptr) return {};
    std::string text(1 << 20, '\0');
    text.resize(VSIFReadL(text.data(), 1, text.size(), file));
    VSIFCloseL(file);
    return text;
}

TEST(QgisProject, IsAnArchiveOfSoundXmlWithRelativeFilesAndTimes) {
    const test::Folder folder;
    const std::string path = folder.file("result.qgz");
    write_qgis_project(path, project());
    EXPECT_EQ(folder.names(), std::vector<std::string>{"result.qgz"});
    const std::string text = content(path);
    const Xml root(CPLParseXMLString(text.c_str()), CPLDestroyXMLNode);
    ASSERT_TRUE(root) << text;
    EXPECT_EQ(text.find(folder.file("")), std::string::npos) << "a path of this machine";
    for (const std::string part :
         {"<datasource>./extent.gpkg|layername=release</datasource>",
          "<datasource>./frames/depth_0001.tif</datasource>", "<start>2000-01-01T00:00:02.500Z</start>",
          "<end>2000-01-01T00:00:05.000Z</end>", "<title>Run &lt;1&gt;</title>", "<authid>EPSG:32632</authid>",
          "<ProjectionsEnabled type=\"int\">1<", "timeStep=\"2500\"", "<Absolute type=\"bool\">false</Absolute>"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST(QgisProject, ASheetShowsItsLayersAndBreaksLongLabelsInItsLegend) {
    const test::Folder folder;
    QgisProject sheets = project();
    ProjectLayer& classes = sheets.groups[1].layers.front();
    classes.style = "<qgis><item value=\"1\" label=\"Medium: depth &lt; 1 m or speed below 1 m/s\"/></qgis>";
    ProjectLayout sheet;
    sheet.title = "Run <1>: Depth";
    sheet.sheet = "A4";
    sheet.portrait = true;
    sheet.window = {0, 0, 950, 800};
    sheet.layers = {outline_title, classes.title};
    sheet.legend = {"", "Depth"};
    sheet.sources = "DTM & flow";
    sheet.classes = {{}, legend_labels(classes.style)};
    sheets.layouts = {sheet};
    ProjectLayout wide = sheet;
    wide.portrait = false;
    write_qgis_project(folder.file("result.qgz"), sheets);
    const std::string text = content(folder.file("result.qgz"));
    ASSERT_TRUE(Xml(CPLParseXMLString(text.c_str()), CPLDestroyXMLNode)) << text;
    for (const std::string part :
         {"<Layout name=\"Run &lt;1&gt;: Depth\"", "size=\"210,297,mm\"", "provider=\"ogr\">frana_layer_1</Layer>",
          "provider=\"gdal\">frana_layer_2</Layer></LayerSet>", "legend/title-label\" value=\"Depth\"",
          "legend/node-order\" value=\"1\"", "DTM &amp; flow", "value=\"Medium: depth &lt; 1 m or speed|below 1 m/s\""})
        EXPECT_NE(text.find(part), std::string::npos) << part;
    EXPECT_EQ(text.find("legend/title-label\" value=\"A &lt;"), std::string::npos)
        << "a layer that is not in the legend";
    EXPECT_GT(frame_of({sheet}).y, frame_of({sheet}).x * 0.9);
    EXPECT_GT(frame_of({wide}).x, frame_of({wide}).y);
    // The map leaves a long subtitle the lines that it needs: 600 letters at 9 points are six lines on 190 mm.
    ProjectLayout warned = sheet;
    warned.subtitle = std::string(600, 'x');
    EXPECT_LE(frame_of({sheet, warned}).y, frame_of({sheet}).y - 15);
    EXPECT_EQ(frame_of({sheet, warned}).x, frame_of({sheet}).x);
}

TEST(QgisProject, TheSameProjectHasTheSameBytesWhateverTheNumberOfThreads) {
    const test::Folder folder;
    QgisProject large = project();
    for (int i = 0; i < 300; ++i) large.groups[1].layers.push_back(large.groups[1].layers.front());
    write_qgis_project(folder.file("a.qgz"), large);
    CPLSetConfigOption("GDAL_NUM_THREADS", "5");
    write_qgis_project(folder.file("b.qgz"), large);
    CPLSetConfigOption("GDAL_NUM_THREADS", nullptr);
    EXPECT_EQ(test::text_in(folder.file("a.qgz")), test::text_in(folder.file("b.qgz")));
}

TEST(QgisProject, AMissingFolderIsAnErrorOfTheEnvironment) {
    const test::Folder folder;
    EXPECT_EQ(test::error_of([&] { write_qgis_project(folder.file("no/result.qgz"), project()); }).kind(),
              ErrorKind::environment);
}

TEST(TimeOrigin, DatesContinueBeyondTheMonth) {
    EXPECT_EQ(date_text(0), "2000-01-01T00:00:00.000Z");
    EXPECT_EQ(date_text(86400 * 60.5), "2000-03-01T12:00:00.000Z");  // 2000 had a 29th of February
}

}  // namespace
}  // namespace frana::gis
