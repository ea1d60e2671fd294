// SPDX-License-Identifier: Apache-2.0
// Loaded before a program: pango_layout_set_text, through which every picture gets its letters, throws at the calls
// FROM to TO of FRANA_TEST_FAULT=FROM-TO, as a failure in the midst of any drawing would.
#include <dlfcn.h>
#include <pango/pango.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

extern "C" void pango_layout_set_text(PangoLayout* layout, const char* text, int length) {
    static std::atomic<long> calls{0};
    static const auto range = [] {
        std::pair<long, long> fault{0, -1};
        if (const char* given = std::getenv("FRANA_TEST_FAULT"))
            std::sscanf(given, "%ld-%ld", &fault.first, &fault.second);
        return fault;
    }();
    const long call = ++calls;
    if (call >= range.first && call <= range.second) throw std::runtime_error("planted fault");
    using Function = void (*)(PangoLayout*, const char*, int);
    static const auto original = reinterpret_cast<Function>(::dlsym(RTLD_NEXT, "pango_layout_set_text"));
    original(layout, text, length);
}
