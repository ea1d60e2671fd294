// SPDX-License-Identifier: Apache-2.0
#include "gis/gdal_session.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>

#include <mutex>

namespace frana::gis {
namespace {

void CPL_STDCALL keep(CPLErr kind, CPLErrorNum, const char* message) {
    if (kind != CE_Warning && kind != CE_Failure && kind != CE_Fatal) return;
    static_cast<GdalSession*>(CPLGetErrorHandlerUserData())->take(kind != CE_Warning, message);
}

}  // namespace

GdalSession::GdalSession() {
    static std::once_flag once;
    std::call_once(once, [] {
        GDALAllRegister();
        // Tiles are unpacked and warped side by side; the values are the same. Who set it otherwise meant it.
        if (CPLGetConfigOption("GDAL_NUM_THREADS", nullptr) == nullptr)
            CPLSetConfigOption("GDAL_NUM_THREADS", "ALL_CPUS");
    });
    CPLPushErrorHandlerEx(keep, this);
}

GdalSession::~GdalSession() {
    CPLPopErrorHandler();
}

void GdalSession::take(bool is_error, const char* message) {
    messages_.emplace_back(message);
    if (is_error) last_error_ = message;
}

std::string GdalSession::last_message() const {
    if (failed()) return last_error_;
    return messages_.empty() ? std::string() : messages_.back();
}

void GdalSession::forget() {
    messages_.clear();
    last_error_.clear();
}

}  // namespace frana::gis
