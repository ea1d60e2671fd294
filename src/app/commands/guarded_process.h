// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana::app {

/// Behind the doors of gis, for libraries that do not go through GDAL: environment variables that would let a
/// file do more than hold data are forgotten, and unless the network is allowed the kernel gives this process
/// no socket that leads off the machine (where it can; silently without).
/// A file that takes long to read is told of on a terminal unless `quiet`; one that takes too long ends the
/// program. To be called before any thread begins.
void guard_process(bool network, bool quiet);

}  // namespace frana::app
