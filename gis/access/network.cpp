// SPDX-License-Identifier: Apache-2.0
#include "gis/access/network.h"

#include <cpl_conv.h>
#include <cpl_http.h>
#include <cpl_vsi_virtual.h>
#include <gdal_priv.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cerrno>
#include <vector>

#include "gis/access/access_problem.h"

namespace frana::gis {
namespace {

bool allowed = false;

constexpr const char* k_file_systems[] = {"/vsicurl",
                                          "/vsicurl_streaming",
                                          "/vsis3",
                                          "/vsis3_streaming",
                                          "/vsigs",
                                          "/vsigs_streaming",
                                          "/vsiaz",
                                          "/vsiaz_streaming",
                                          "/vsiadls",
                                          "/vsioss",
                                          "/vsioss_streaming",
                                          "/vsiswift",
                                          "/vsiswift_streaming",
                                          "/vsihdfs",
                                          "/vsiwebhdfs"};

constexpr const char* k_network_drivers[] = {
    "AmigoCloud", "Carto",        "Cloudant",      "CouchDB",  "CSW",      "DAAS",          "DODS",
    "EEDA",       "EEDAI",        "Elasticsearch", "GMLAS",    "HANA",     "HTTP",          "MongoDB",
    "MongoDBv3",  "MSSQLSpatial", "MySQL",         "NGW",      "OAPIF",    "OCI",           "ODBC",
    "OGCAPI",     "OGR_OGDI",     "PGeo",          "PLMOSAIC", "PLSCENES", "PostGISRaster", "PostgreSQL",
    "Rasdaman",   "STACIT",       "STACTA",        "WCS",      "WFS",      "WMS",           "WMTS"};

constexpr const char* k_network_remedy = "Copy it to this machine, or start frana with --allow-network";

void note_refused_place(const std::string& place) {
    note_access_problem({"the file refers to data on the network", place, k_network_remedy});
}

/// Contains no files: replaces a network file system.
class NoFiles : public VSIFilesystemHandler {
  public:
    VSIVirtualHandle* Open(const char* path, const char*, bool, CSLConstList) override {
        note_refused_place(path);
        errno = ENOENT;
        return nullptr;
    }
    int Stat(const char* path, VSIStatBufL*, int) override {
        note_refused_place(path);
        errno = ENOENT;
        return -1;
    }
};

/// Replaces the requests of every driver that uses HTTP itself, and of CRSs that are URLs.
CPLHTTPResult* fetch_nothing(const char* url, CSLConstList, GDALProgressFunc, void*, CPLHTTPFetchWriteFunc, void*,
                             void*) {
    note_refused_place(url);
    auto* const result = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
    result->nStatus = 1;
    result->pszErrBuf = CPLStrdup("frana was not started with --allow-network");
    return result;
}

bool names_network(const std::string& path) {
    const auto matches = [&](const std::string& part) { return path.find(part) != std::string::npos; };
    if (matches("://") || std::any_of(std::begin(k_file_systems), std::end(k_file_systems),
                                      [&](const char* name) { return matches(std::string(name) + "/"); }))
        return true;
    const std::string driver = path.substr(0, path.find(':'));
    return driver.size() < path.size() &&
           (EQUAL(driver.c_str(), "PG") || std::any_of(std::begin(k_network_drivers), std::end(k_network_drivers),
                                                       [&](const char* name) { return EQUAL(driver.c_str(), name); }));
}

}  // namespace

void allow_network() {
    allowed = true;
}

bool network_allowed() {
    return allowed;
}

std::optional<std::string> network_remedy(const std::string& path) {
    if (allowed || !names_network(path)) return std::nullopt;
    return k_network_remedy;
}

void disable_network() {
    // GDAL keeps handlers until the program ends, but drops those that others replace.
    static auto* const replaced = new std::vector<VSIFilesystemHandler*>;
    for (const char* name : k_file_systems) {
        for (const char* ending : {"/", "?"}) {  // "/vsicurl?" is followed by options
            const std::string prefix = std::string(name) + ending;
            replaced->push_back(VSIFileManager::GetHandler(prefix.c_str()));
            VSIFileManager::InstallHandler(prefix, new NoFiles);
        }
    }
    for (const char* name : k_network_drivers) {
        GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName(name);
        if (driver == nullptr) continue;
        GetGDALDriverManager()->DeregisterDriver(driver);
        GDALDestroyDriver(driver);
    }
    CPLHTTPSetFetchCallback(fetch_nothing, nullptr);
    // A GML file may name a schema at any address.
    CPLSetConfigOption("GML_DOWNLOAD_SCHEMA", "NO");
}

}  // namespace frana::gis
