// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace frana::gis {

/// Returns the versions of GDAL with GEOS, and PROJ, at run time: one "NAME VERSION" per line.
std::string library_versions();

/// Allows inputs to be read over the network. Must be called before anything is opened: the first GdalSession disables
/// it for the rest of the program. A scene cannot call it: the user who starts the program decides.
void allow_network();

/// While an instance exists, GDAL is initialised and its messages on this thread are collected here instead of being
/// written to stderr. Sessions nest: each function of gis opens its own, and the innermost collects.
class GdalSession {
  public:
    GdalSession();
    ~GdalSession();
    GdalSession(const GdalSession&) = delete;
    GdalSession& operator=(const GdalSession&) = delete;

    /// Warnings and errors so far, oldest first.
    [[nodiscard]] const std::vector<std::string>& messages() const noexcept { return messages_; }
    /// The latest error, or the latest warning if there was no error, or nothing.
    [[nodiscard]] std::string last_message() const;
    /// Whether GDAL reported a failure (warnings do not count).
    [[nodiscard]] bool failed() const noexcept { return !last_error_.empty(); }
    void clear();
    /// Throws that this ("the raster") cannot be written to a path, with GDAL's message.
    [[noreturn]] void refuse_written(const std::string& what, const std::string& path) const;

    /// For the error handler only.
    void record(bool is_error, const char* message);

  private:
    std::vector<std::string> messages_;
    std::string last_error_;
};

/// Sets one of GDAL's options for this thread during its lifetime, then restores it.
class ThreadOption {
  public:
    ThreadOption(std::string key, const char* value);
    ~ThreadOption();
    ThreadOption(const ThreadOption&) = delete;
    ThreadOption& operator=(const ThreadOption&) = delete;

  private:
    std::string key_;
    std::optional<std::string> before_;
};

/// Prevents GDAL from writing .aux.xml beside a file during its lifetime.
class NoSideFiles : ThreadOption {
  public:
    NoSideFiles() : ThreadOption("GDAL_PAM_ENABLED", "NO") {}
};

}  // namespace frana::gis
