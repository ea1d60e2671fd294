// SPDX-License-Identifier: Apache-2.0
// The network is used only if the user who starts the program allows it, whatever the files contain.
#include <cpl_vsi.h>

#include "support/checked_scene.h"
#include "web_server.h"

namespace frana::test {
namespace {

class Network : public CheckedScene {
  protected:
    /// Of the perimeter, with another "crs" member.
    [[nodiscard]] std::string perimeter_with_crs(const std::string& crs) const {
        std::string text = read_text(path("perimeter.geojson"));
        const std::string own = R"({"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::32632"}})";
        text.replace(text.find(own), own.size(), crs);
        return text;
    }
    [[nodiscard]] static std::string layer_of(const std::string& source, const std::string& more = "") {
        return "<OGRVRTDataSource><OGRVRTLayer name=\"perimeter\"><SrcDataSource>" + source + "</SrcDataSource>" +
               more + "</OGRVRTLayer></OGRVRTDataSource>";
    }
    [[nodiscard]] static std::string raster_of(const std::string& source, const std::string& crs = "EPSG:32632") {
        return "<VRTDataset rasterXSize=\"60\" rasterYSize=\"30\"><SRS>" + crs + "</SRS><GeoTransform>" +
               std::to_string(k_west) + ",5,0," + std::to_string(k_south + 150) +
               ",0,-5</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\"><SimpleSource>"
               "<SourceFilename>" +
               source + "</SourceFilename><SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>";
    }
    [[nodiscard]] std::string gml(const std::string& head, const std::string& crs) const {
        return "<?xml version=\"1.0\"?>" + head +
               "<ogr:FeatureCollection xmlns:ogr=\"http://ogr.maptools.org/\" "
               "xmlns:gml=\"http://www.opengis.net/gml\">"
               "<gml:featureMember><ogr:a><ogr:geometryProperty><gml:Polygon srsName=\"" +
               crs +
               "\"><gml:outerBoundaryIs><gml:LinearRing><gml:coordinates>527020,5094055 527070,5094055 "
               "527070,5094095 527020,5094055</gml:coordinates></gml:LinearRing></gml:outerBoundaryIs>"
               "</gml:Polygon></ogr:geometryProperty></ogr:a></gml:featureMember></ogr:FeatureCollection>";
    }
    /// Writes bytes as a file of another name, in an archive if the name has that ending.
    static void write_at(const std::string& name, const std::string& text) {
        VSILFILE* file = VSIFOpenL(name.c_str(), "wb");
        ASSERT_NE(file, nullptr) << name;
        VSIFWriteL(text.data(), 1, text.size(), file);
        VSIFCloseL(file);
    }
};

TEST_F(Network, NoPathLeadsThereUnlessAllowed) {
    const WebServer server;
    const std::string url = server.url() + "/a";
    const std::vector<std::string> keys{"terrain.dtm=" + url + ".tif",
                                        "terrain.dtm=/vsicurl/" + url + ".tif",
                                        "terrain.dtm=/vsizip//vsicurl/" + url + ".zip/a.tif",
                                        "terrain.dtm=WCS:" + url,
                                        "release.perimeter=" + url + ".geojson",
                                        "release.perimeter=WFS:" + url,
                                        "release.perimeter=GeoJSON:" + url,
                                        "release.perimeter=ESRIJSON:" + url,
                                        "release.perimeter=TopoJSON:" + url,
                                        "release.perimeter=gltp://" + server.place() + "/vrf/x",
                                        "release.perimeter=PG:host=127.0.0.1 port=" + server.port(),
                                        "output.map-background=" + url + ".tif",
                                        "output.map-background=/vsicurl/" + url + ".tif",
                                        "release.thickness=raster:/vsicurl_streaming/" + url + ".tif"};
    for (const std::string& key : keys) {
        const Checked checked = check({key});
        EXPECT_TRUE(checked.is_refused()) << key;
        expect_words(checked.told(), {"read over the network", "--allow-network"});
        EXPECT_EQ(server.calls(), 0) << key;
    }
}

TEST_F(Network, NoVectorFileLeadsThereUnlessAllowed) {
    const WebServer server;
    const std::string url = server.url() + "/a";
    write("link.geojson",
          perimeter_with_crs(R"({"type": "link", "properties": {"href": ")" + url + R"(", "type": "ogcwkt"}})"));
    write("name.geojson", perimeter_with_crs(R"({"type": "name", "properties": {"name": ")" + url + R"("}})"));
    write("url.vrt", layer_of(url + ".geojson"));
    write("geojson.vrt", layer_of("GeoJSON:" + url));
    write("esrijson.vrt", layer_of("ESRIJSON:" + url));
    write("topojson.vrt", layer_of("TopoJSON:" + url));
    write("seq.vrt", layer_of("GeoJSONSeq:" + url));
    write("curl.vrt", layer_of("/vsicurl/" + url + ".geojson"));
    write("options.vrt", layer_of("/vsicurl?url=" + url + ".geojson"));
    write("crs.vrt", layer_of(path("perimeter.geojson"), "<LayerSRS>" + url + "</LayerSRS>"));
    write("ogdi.vrt", layer_of("gltp://" + server.place() + "/vrf/x"));
    write("schema.gml", gml("", url));
    write("type.gml", gml("<!DOCTYPE x SYSTEM \"" + url + ".dtd\">", "EPSG:32632"));
    write_at("/vsizip/" + path("in.zip") + "/in.vrt", layer_of("/vsicurl/" + url + ".geojson"));
    write("archive.vrt", layer_of("/vsizip/{/vsicurl/" + url + ".zip}/a.geojson"));
    for (const std::string file : {"link.geojson", "url.vrt", "geojson.vrt", "esrijson.vrt", "topojson.vrt", "seq.vrt",
                                   "curl.vrt", "options.vrt", "/vsizip/in.zip/in.vrt", "archive.vrt"}) {
        const Checked checked = check({"release.perimeter=" + file});
        EXPECT_EQ(server.calls(), 0) << file;
        EXPECT_TRUE(checked.is_refused()) << file;
        expect_words(checked.told(), {"on the network", file.substr(file.rfind('/') + 1), "--allow-network"});
    }
    // Files of other keys use the same filter; so do lines and points.
    for (const std::string key : {"scar.perimeter=", "scar.front=", "output.profiles=", "terrain.walls="}) {
        const Checked checked = check({key + "url.vrt"});
        EXPECT_NE(checked.told().find("on the network"), std::string::npos) << key << checked.told();
    }
    // References that GDAL does not follow by itself.
    for (const std::string file : {"name.geojson", "crs.vrt", "schema.gml", "type.gml", "ogdi.vrt"})
        (void)check({"release.perimeter=" + file});
    EXPECT_EQ(server.calls(), 0);
}

TEST_F(Network, NoRasterLeadsThereUnlessAllowed) {
    const WebServer server;
    const std::string url = server.url() + "/a";
    write("curl.vrt", raster_of("/vsicurl/" + url + ".tif"));
    write("http.vrt", raster_of(url + ".tif"));
    write("crs.vrt", raster_of(path("dtm.asc"), url));
    write("dap.vrt", raster_of("NETCDF:&quot;" + url + ".nc&quot;:v"));
    write("plain-dap.vrt", raster_of("NETCDF:" + url));
    write("fits.vrt", raster_of("FITS:&quot;" + url + ".fits&quot;:1"));
    write("inner.vrt", raster_of(path("curl.vrt")));
    write("tiles.vrt", raster_of("&lt;GDAL_WMS&gt;&lt;Service name='TMS'&gt;&lt;ServerUrl&gt;" + url +
                                 "&lt;/ServerUrl&gt;&lt;/Service&gt;&lt;/GDAL_WMS&gt;"));
    write("map.xml", "<GDAL_WMS><Service name=\"TMS\"><ServerUrl>" + url +
                         "</ServerUrl></Service><DataWindow><UpperLeftX>0</UpperLeftX></DataWindow></GDAL_WMS>");
    // By the program: the formats that tests write with GDAL are more than it reads, and some have a network of their
    // own.
    for (const std::string file : {"curl.vrt", "http.vrt", "crs.vrt", "dap.vrt", "plain-dap.vrt", "fits.vrt",
                                   "inner.vrt", "tiles.vrt", "map.xml"}) {
        const Outcome outcome = frana({"check", "scene.ini", "--set", "terrain.dtm=" + file});
        EXPECT_EQ(server.calls(), 0) << file;
        EXPECT_EQ(outcome.exit_code, 2) << file << outcome.out;
        EXPECT_NE(outcome.err.find(file), std::string::npos) << file << outcome.err;
    }
    for (const std::string file : {"curl.vrt", "inner.vrt"}) {
        const std::string messages = frana({"check", "scene.ini", "--set", "terrain.dtm=" + file}).err;
        expect_words(messages, {"on the network", "--allow-network"});
    }
}

TEST_F(Network, IsReachedWhereItIsAllowed) {
    WebServer server;
    server.put("/perimeter.geojson", read_text(path("perimeter.geojson")));
    server.put("/crs", "EPSG:32632");
    server.put("/dtm.asc", read_text(path("dtm.asc")));
    server.put("/dtm.prj", read_text(path("dtm.prj")));
    write("url.vrt", layer_of(server.url() + "/perimeter.geojson"));
    const std::vector<std::string> keys{"release.perimeter=" + server.url() + "/perimeter.geojson",
                                        "release.perimeter=GeoJSON:" + server.url() + "/perimeter.geojson",
                                        "release.perimeter=/vsicurl/" + server.url() + "/perimeter.geojson",
                                        "release.perimeter=url.vrt",
                                        "terrain.dtm=/vsicurl/" + server.url() + "/dtm.asc"};
    for (const std::string& key : keys) {
        const int before = server.calls();
        succeeded(frana({"check", "scene.ini", "--allow-network", "--set", key}));
        EXPECT_GT(server.calls(), before) << key;
    }
}

}  // namespace
}  // namespace frana::test
