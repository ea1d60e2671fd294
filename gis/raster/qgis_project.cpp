// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/qgis_project.h"

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "core/error.h"
#include "core/files.h"
#include "core/text.h"
#include "gis/access/gdal_session.h"
#include "gis/access/table_in.h"

namespace frana::gis {
namespace {

std::string element(const std::string& name, const std::string& text) {
    return "<" + name + ">" + escaped_markup(text) + "</" + name + ">";
}

std::string crs_element(const std::string& wkt) {
    if (wkt.empty()) return "<spatialrefsys/>";
    OGRSpatialReference crs;
    crs.importFromWkt(wkt.c_str());
    char* long_form = nullptr;
    const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
    crs.exportToWkt(&long_form, options);
    std::string text = "<spatialrefsys>" + element("wkt", long_form ? long_form : wkt);
    CPLFree(long_form);
    const char *const authority = crs.GetAuthorityName(nullptr), *const code = crs.GetAuthorityCode(nullptr);
    if (authority && code) text += element("authid", std::string(authority) + ":" + code);
    return text + "</spatialrefsys>";
}

/// The content of a QML document's root.
std::string style_content(const std::string& qml) {
    const auto root = qml.find("<qgis"), begin = root == std::string::npos ? root : qml.find('>', root);
    const auto end = qml.rfind("</qgis>");
    if (begin == std::string::npos || end == std::string::npos || end < begin) return {};
    return qml.substr(begin + 1, end - begin - 1);
}

std::string extent_element(const Bounds& box) {
    return "<extent>" + element("xmin", shortest_text(box.west)) + element("ymin", shortest_text(box.south)) +
           element("xmax", shortest_text(box.east)) + element("ymax", shortest_text(box.north)) + "</extent>";
}

const char* geometry_word(Shape shape) {
    return shape == Shape::area ? "Polygon" : shape == Shape::line ? "Line" : "Point";
}

class Document {
  public:
    explicit Document(const QgisProject& project) : project_(project), crs_(crs_element(project.crs_wkt)) {
        for (const ProjectGroup& group : project.groups) add(group);
        for (std::size_t i = 0; i < project.layouts.size(); ++i) {
            std::vector<LayerReference> shown;
            for (const std::string& title : project.layouts[i].layers) shown.push_back(references_.at(title));
            layouts_ += layout_element(project.layouts, i, shown, crs_);
        }
    }

    [[nodiscard]] std::string text() const {
        std::ostringstream out;
        out << "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n<qgis projectname=\""
            << escaped_markup(project_.title) << "\" version=\"3.22.0\">\n  <homePath path=\"\"/>\n  "
            << element("title", project_.title) << "\n  <projectCrs>" << crs_ << "</projectCrs>\n"
            << "  <layer-tree-group>\n"
            << tree_ << "  </layer-tree-group>\n  <mapcanvas name=\"theMapCanvas\"><units>meters</units>"
            << extent_element(project_.extent) << "<rotation>0</rotation><destinationsrs>" << crs_
            << "</destinationsrs></mapcanvas>\n  <projectlayers>\n"
            << layers_ << "  </projectlayers>\n"
            << "  <properties><Paths><Absolute type=\"bool\">false</Absolute></Paths>" << crs_switch()
            << "</properties>\n"
            << time_settings() << "  <Layouts>\n"
            << layouts_ << "  </Layouts>\n</qgis>\n";
        return out.str();
    }

  private:
    void add(const ProjectGroup& group) {
        const auto state = [](bool on) { return on ? "Qt::Checked" : "Qt::Unchecked"; };
        tree_ += "    <layer-tree-group name=\"" + escaped_markup(group.name) + "\" checked=\"" + state(group.visible) +
                 "\" expanded=\"" + (group.expanded ? "1" : "0") + "\">\n";
        for (const ProjectLayer& layer : group.layers) {
            // QGIS replaces ids of up to ten letters, and then does not find the layers of the tree.
            const std::string id = "frana_layer_" + std::to_string(++count_);
            const std::string source = source_of(layer);
            tree_ += "      <layer-tree-layer id=\"" + id + "\" name=\"" + escaped_markup(layer.title) +
                     "\" source=\"" + escaped_markup(source) + "\" providerKey=\"" +
                     (layer.layer.empty() ? "gdal" : "ogr") + "\" checked=\"" + state(layer.visible) +
                     "\" expanded=\"" + (layer.visible && layer.layer.empty() ? "1" : "0") + "\"/>\n";
            add(layer, id, source);
            references_[layer.title] = {id, layer.title, source, layer.layer.empty() ? "gdal" : "ogr"};
        }
        tree_ += "    </layer-tree-group>\n";
    }

    void add(const ProjectLayer& layer, const std::string& id, const std::string& source) {
        const bool raster = layer.layer.empty();
        const std::string style = style_content(layer.style);
        layers_ += raster ? "    <maplayer type=\"raster\" autoRefreshEnabled=\"0\">\n"
                          : std::string("    <maplayer type=\"vector\" geometry=\"") + geometry_word(layer.shape) +
                                "\" labelsEnabled=\"" + (style.find("<labeling") != std::string::npos ? "1" : "0") +
                                "\">\n";
        layers_ += "      " + element("id", id) + element("datasource", source) + element("layername", layer.title) +
                   "\n      <srs>" + crs_ + "</srs>\n      " +
                   (raster ? "<provider>gdal</provider>" : "<provider encoding=\"UTF-8\">ogr</provider>") + "\n";
        if (!layer.attribution.empty()) layers_ += "      " + element("attribution", layer.attribution) + "\n";
        if (layer.seconds) {
            layers_ += "      <temporal enabled=\"1\" mode=\"0\" fetchMode=\"0\"><fixedRange>" +
                       element("start", date_text(layer.seconds->first)) +
                       element("end", date_text(layer.seconds->second)) + "</fixedRange></temporal>\n";
            last_ = std::max(last_, layer.seconds->second);
        }
        layers_ += style + "\n    </maplayer>\n";
    }

    static std::string source_of(const ProjectLayer& layer) {
        return "./" + layer.file + (layer.layer.empty() ? "" : "|layername=" + layer.layer);
    }

    /// QGIS takes no notice of projectCrs without it.
    [[nodiscard]] std::string crs_switch() const {
        return project_.crs_wkt.empty()
                   ? ""
                   : "<SpatialRefSys><ProjectionsEnabled type=\"int\">1</ProjectionsEnabled></SpatialRefSys>";
    }

    [[nodiscard]] std::string time_settings() const {
        if (!(last_ > 0)) return {};
        constexpr double k_pictures_per_second = 4;
        // Milliseconds, since the interval need not be whole seconds.
        return "  <ProjectTimeSettings cumulativeTemporalRange=\"0\" timeStepUnit=\"ms\" timeStep=\"" +
               shortest_text(std::max(1.0, std::round(project_.step * 1000))) + "\" frameRate=\"" +
               shortest_text(k_pictures_per_second) + "\"><TemporalRange>" + element("start", date_text(0)) +
               element("end", date_text(last_)) + "</TemporalRange></ProjectTimeSettings>\n";
    }

    const QgisProject& project_;
    std::string crs_, tree_, layers_, layouts_;
    std::map<std::string, LayerReference> references_;  ///< by title
    int count_ = 0;
    double last_ = 0;
};

/// Returns a zip archive with one file.
std::string zipped(const std::string& name, const std::string& content, const std::string& path,
                   const GdalSession& session) {
    const CPLConfigOptionSetter one_thread("GDAL_NUM_THREADS", "1", false);  // otherwise the bytes depend on it
    const std::string archive = "/vsimem/frana_project_" + std::to_string(reinterpret_cast<std::uintptr_t>(&content));
    const auto refuse = [&] {
        VSIUnlink(archive.c_str());
        throw Error(ErrorKind::environment,
                    Problem{"the project cannot be packed: " + session.last_message(), path, "", "", ""});
    };
    VSILFILE* const file = VSIFOpenL(("/vsizip/{" + archive + "}/" + name).c_str(), "wb");
    if (!file) refuse();
    const bool written = VSIFWriteL(content.data(), 1, content.size(), file) == content.size();
    if (VSIFCloseL(file) != 0 || !written) refuse();
    vsi_l_offset length = 0;
    const GByte* const bytes = VSIGetMemFileBuffer(archive.c_str(), &length, FALSE);
    if (!bytes) refuse();
    std::string packed(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(length));
    VSIUnlink(archive.c_str());
    return packed;
}

}  // namespace

void write_qgis_project(const std::string& path, const QgisProject& project) {
    const GdalSession session;
    write_file(path, zipped("result.qgs", Document(project).text(), path, session));
}

}  // namespace frana::gis
