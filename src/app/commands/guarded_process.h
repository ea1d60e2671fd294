// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana::app {

/// Protects the process beyond the filters of gis, for libraries that do not use GDAL: environment variables that would
/// allow a file to do more than contain data are cleared, and unless the network is allowed the kernel refuses this
/// process sockets to other machines (where supported; otherwise silently without).
/// A file that needs long to be read is reported on a terminal unless `quiet`; one that exceeds a limit ends the
/// program. Must be called before any thread starts.
void guard_process(bool network, bool quiet);

}  // namespace frana::app
