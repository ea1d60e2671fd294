// SPDX-License-Identifier: Apache-2.0
#include "gis/access/gdal_session.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>
#include <proj.h>
#include <sys/resource.h>

#include <mutex>
#include <utility>

#include "core/error.h"
#include "core/raster.h"
#include "gis/access/file_access.h"

namespace frana::gis {

std::string library_versions() {
    int major = 0, minor = 0, micro = 0;
    std::string text = std::string("GDAL ") + GDALVersionInfo("RELEASE_NAME") + "\n";
    if (OGRGetGEOSVersion(&major, &minor, &micro))
        text += "GEOS " + std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(micro) + "\n";
    return text + "PROJ " + proj_info().version + "\n";
}

namespace {

void CPL_STDCALL keep(CPLErr kind, CPLErrorNum, const char* message) {
    if (kind != CE_Warning && kind != CE_Failure && kind != CE_Fatal) return;
    static_cast<GdalSession*>(CPLGetErrorHandlerUserData())->record(kind != CE_Warning, message);
}

/// Users set these for their own work; an input file from others must not use them.
constexpr std::pair<const char*, const char*> k_settings[] = {
    {"GDAL_VRT_ENABLE_PYTHON", "NO"},          // a VRT's pixel functions are programs
    {"OGR_SQLITE_LOAD_EXTENSIONS", ""},        // SQLite's extensions are programs
    {"GML_SKIP_RESOLVE_ELEMS", "ALL"},         // references in GML are followed anywhere, and a file is written
    {"SHAPE_RESTORE_SHX", "NO"},               // writes beside the shapefile
    {"CPL_VSIL_GZIP_WRITE_PROPERTIES", "NO"},  // writes beside the archive
};

/// Drivers that start a program (GPSBabel) or write a database beside the file (VFK).
constexpr const char* k_left_out_drivers[] = {"GPSBabel", "VFK"};

bool mapping_is_limited() {
    rlimit space{};
    return ::getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY;
}

void disable_other_access() {
    for (const auto& [name, value] : k_settings) CPLSetConfigOption(name, value);
    for (const char* name : k_left_out_drivers) {
        GDALDriverH const driver = GDALGetDriverByName(name);
        if (driver == nullptr) continue;
        GDALDeregisterDriver(driver);
        GDALDestroyDriver(driver);
    }
    // A map must not depend on a server's answers, whatever PROJ_NETWORK is.
    OSRSetPROJEnableNetwork(FALSE);
}

/// GDAL's drivers and file systems are the process's: the first call decides.
void initialise(bool network) {
    static std::once_flag once;
    std::call_once(once, [network] {
        GDALAllRegister();
        disable_other_access();
        guard_local_files();
        if (!network) disable_network();
        // Tiles are compressed and warped in parallel; the values are the same. A value set by the user is kept. GDAL
        // waits for ever for a thread that could not be started for lack of address space.
        if (CPLGetConfigOption("GDAL_NUM_THREADS", nullptr) == nullptr)
            CPLSetConfigOption("GDAL_NUM_THREADS", mapping_is_limited() ? "1" : "ALL_CPUS");
        // Cache for blocks that were read: GDAL's default, a twentieth of the machine's memory, is more than reading
        // needs.
        constexpr GIntBig k_cache_bytes = 128 << 20;
        if (CPLGetConfigOption("GDAL_CACHEMAX", nullptr) == nullptr) GDALSetCacheMax64(k_cache_bytes);
    });
}

}  // namespace

void allow_network() {
    initialise(true);
}

GdalSession::GdalSession() {
    initialise(false);
    CPLPushErrorHandlerEx(keep, this);
}

GdalSession::~GdalSession() {
    CPLPopErrorHandler();
}

void GdalSession::record(bool is_error, const char* message) {
    messages_.emplace_back(message);
    if (is_error) last_error_ = message;
}

std::string GdalSession::last_message() const {
    if (failed()) return last_error_;
    return messages_.empty() ? std::string() : messages_.back();
}

void GdalSession::clear() {
    messages_.clear();
    last_error_.clear();
}

void GdalSession::refuse_written(const std::string& what, const std::string& path) const {
    const std::string message = last_message();
    throw Error(ErrorKind::environment,
                Problem{what + " cannot be written" + (message.empty() ? "" : ": " + message), path, "", "",
                        "Check that the folder exists, may be written and has free space"});
}

ThreadOption::ThreadOption(std::string key, const char* value) : key_(std::move(key)) {
    if (const char* before = CPLGetThreadLocalConfigOption(key_.c_str(), nullptr)) before_ = before;
    CPLSetThreadLocalConfigOption(key_.c_str(), value);
}

ThreadOption::~ThreadOption() {
    CPLSetThreadLocalConfigOption(key_.c_str(), before_ ? before_->c_str() : nullptr);
}

}  // namespace frana::gis
