// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana::bench {

/// Returns the bytes per second that `threads` threads move between memory and processor: the best of several passes of
/// a[i] = b[i] + s c[i] over arrays far larger than the caches, 24 bytes per element (the "triad" of McCalpin's STREAM,
/// 1995, which does not count that a line is read before it is written).
double memory_bandwidth(int threads);

}  // namespace frana::bench
