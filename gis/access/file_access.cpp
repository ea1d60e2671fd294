// SPDX-License-Identifier: Apache-2.0
#include "gis/access/file_access.h"

#include <cpl_conv.h>
#include <cpl_http.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <cpl_vsi_virtual.h>
#include <gdal_priv.h>
#include <ogr_srs_api.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/text.h"
#include "gis/access/gdal_session.h"

namespace frana::gis {

namespace fs = std::filesystem;

// The address makes the name unique.
MemoryFolder::MemoryFolder() : folder_("/vsimem/frana_" + std::to_string(reinterpret_cast<std::uintptr_t>(this))) {
    VSIMkdir(folder_.c_str(), 0700);
}

MemoryFolder::~MemoryFolder() {
    VSIRmdirRecursive(folder_.c_str());
}

std::string MemoryFolder::place_of(const std::string& path) const {
    return folder_ + "/" + fs::path(path).filename().string();
}

void MemoryFolder::write_to_disk(const std::string& path, Sync sync) const {
    const CPLStringList names(VSIReadDir(folder_.c_str()), TRUE);
    for (int i = 0; i < names.size(); ++i) {
        const std::string name = names[i];
        vsi_l_offset size = 0;
        const GByte* bytes = VSIGetMemFileBuffer((folder_ + "/" + name).c_str(), &size, FALSE);
        write_file((fs::path(path).parent_path() / name).string(),
                   {reinterpret_cast<const char*>(bytes), bytes == nullptr ? 0 : static_cast<std::size_t>(size)}, sync);
    }
}

namespace {

bool writes(const char* access) {
    return std::string(access).find_first_of("wa+") != std::string::npos;
}

/// Wraps GDAL's own handler: refuses special files, and to write while a thread only reads. GDAL keeps it until the
/// program ends, and gives it back to whoever asks for the handler of local files.
class LocalFiles : public VSIFilesystemHandler {
  public:
    explicit LocalFiles(VSIFilesystemHandler& files) : files_(files) {}

    VSIVirtualHandle* Open(const char* path, const char* access, bool set_error, CSLConstList options) override {
        if (writes(access) && refuse_writing()) return nullptr;
        if (refuse_special_file(path)) return nullptr;
        return files_.Open(path, access, set_error, options);
    }
    int Stat(const char* path, VSIStatBufL* status, int flags) override { return files_.Stat(path, status, flags); }
    int Unlink(const char* path) override { return refuse_writing() ? -1 : files_.Unlink(path); }
    int Mkdir(const char* path, long mode) override { return refuse_writing() ? -1 : files_.Mkdir(path, mode); }
    int Rmdir(const char* path) override { return refuse_writing() ? -1 : files_.Rmdir(path); }
    int RmdirRecursive(const char* path) override { return refuse_writing() ? -1 : files_.RmdirRecursive(path); }
    int Rename(const char* from, const char* to) override { return refuse_writing() ? -1 : files_.Rename(from, to); }
    char** ReadDir(const char* path) override { return files_.ReadDir(path); }
    char** ReadDirEx(const char* path, int most) override { return files_.ReadDirEx(path, most); }
    char** SiblingFiles(const char* path) override { return files_.SiblingFiles(path); }
    int IsCaseSensitive(const char* path) override { return files_.IsCaseSensitive(path); }
    GIntBig GetDiskFreeSpace(const char* path) override { return files_.GetDiskFreeSpace(path); }
    int SupportsSparseFiles(const char* path) override { return files_.SupportsSparseFiles(path); }
    VSIDIR* OpenDir(const char* path, int depth, const char* const* options) override {
        return files_.OpenDir(path, depth, options);
    }
    bool IsLocal(const char* path) override { return files_.IsLocal(path); }

    /// Begins (1) or ends (-1) that this thread only reads; nests.
    void read_only(int change) {
        const std::lock_guard lock(guard_);
        if ((readers_[std::this_thread::get_id()] += change) == 0) readers_.erase(std::this_thread::get_id());
    }
    void note(AccessProblem problem) {
        const std::lock_guard lock(guard_);
        if (!first_problem_) first_problem_ = std::move(problem);
    }
    std::optional<AccessProblem> pop() {
        const std::lock_guard lock(guard_);
        return std::exchange(first_problem_, std::nullopt);
    }

  private:
    bool refuse_writing() {
        const std::lock_guard lock(guard_);
        const bool refused = readers_.count(std::this_thread::get_id()) > 0;
        if (refused) errno = EROFS;
        return refused;
    }

    VSIFilesystemHandler& files_;
    std::mutex guard_;  ///< libraries also read on their own threads
    std::map<std::thread::id, int> readers_;
    std::optional<AccessProblem> first_problem_;
};

/// Replaces the handler of standard input, which would read the user's typing.
class NoStream : public VSIFilesystemHandler {
  public:
    VSIVirtualHandle* Open(const char* path, const char*, bool, CSLConstList) override {
        note_access_problem({"a stream is not a regular file", path, "Copy its content into a file"});
        errno = EINVAL;
        return nullptr;
    }
    int Stat(const char*, VSIStatBufL*, int) override {
        errno = ENOENT;
        return -1;
    }
};

LocalFiles& local_files() {
    return dynamic_cast<LocalFiles&>(*VSIFileManager::GetHandler(""));
}

}  // namespace

void guard_local_files() {
    // GDAL keeps handlers until the program ends, but drops those that others replace.
    static VSIFilesystemHandler* const streams[] = {VSIFileManager::GetHandler("/vsistdin/"),
                                                    VSIFileManager::GetHandler("/vsistdin?")};
    (void)streams;
    VSIFileManager::InstallHandler("", new LocalFiles(*VSIFileManager::GetHandler("")));
    for (const char* prefix : {"/vsistdin/", "/vsistdin?"}) VSIFileManager::InstallHandler(prefix, new NoStream);
}

void note_access_problem(AccessProblem problem) {
    local_files().note(std::move(problem));
}

std::optional<AccessProblem> pop_access_problem() {
    return local_files().pop();
}

bool refuse_special_file(const char* path) {
    struct stat status {};
    if (::stat(path, &status) != 0 || S_ISREG(status.st_mode) || S_ISDIR(status.st_mode)) return false;
    note_access_problem({"a FIFO, a device or a socket is not a regular file", path, "Copy its content into a file"});
    errno = EINVAL;
    return true;
}

ReadingOnly::ReadingOnly() {
    local_files().read_only(1);
}

ReadingOnly::~ReadingOnly() {
    local_files().read_only(-1);
}

namespace {

std::atomic<unsigned> limit_seconds = 0;  // 0: no limit
std::atomic<int> limits = 0;
char late_message[1024];  // what the handler may print: no memory is requested there

void end_program(int) {
    (void)!::write(STDERR_FILENO, late_message, std::strlen(late_message));
    ::_exit(2);
}

}  // namespace

void limit_reading(unsigned seconds) {
    limit_seconds = seconds;
    std::signal(SIGALRM, end_program);
}

TimeLimit::TimeLimit(const Place& where) {
    static std::mutex guard;
    const std::lock_guard lock(guard);
    const unsigned seconds = limit_seconds;
    if (seconds == 0) return;
    if (limits++ == 0)
        std::snprintf(late_message, sizeof late_message,
                      "frana: %s: reading takes too long: %u s without an answer from the library. Check the file (an "
                      "endless view?), copy it to this machine, or allow more with FRANA_READ_SECONDS\n",
                      where.text.c_str(), seconds);
    ::alarm(seconds);
}

TimeLimit::~TimeLimit() {
    if (limit_seconds > 0 && --limits == 0) ::alarm(0);
}

void TimeLimit::again() noexcept {
    if (limit_seconds > 0) ::alarm(limit_seconds);
}

namespace {

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

bool network_allowed() {
    const GdalSession session;
    return dynamic_cast<const NoFiles*>(VSIFileManager::GetHandler("/vsicurl/")) == nullptr;
}

std::optional<std::string> network_remedy(const std::string& path) {
    if (!names_network(path) || network_allowed()) return std::nullopt;
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
