# SPDX-License-Identifier: Apache-2.0
"""QGIS's Python bindings, or exit code 77, by which ctest knows a skipped test."""
import os
import sys

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
try:
    import qgis.core  # noqa: F401
except ImportError:
    print("QGIS's Python bindings (Debian: python3-qgis) are not installed")
    sys.exit(77)
