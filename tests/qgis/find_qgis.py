# SPDX-License-Identifier: Apache-2.0
"""QGIS's Python bindings, or exit code 77, by which ctest knows a skipped test."""
import os
import sys

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
try:
    import qgis.core  # noqa: F401
except ImportError:
    # Debian's bindings belong to Debian's interpreter, which need not be the first on the path.
    if os.path.exists("/usr/bin/python3") and os.path.realpath(sys.executable) != os.path.realpath("/usr/bin/python3"):
        os.execv("/usr/bin/python3", ["/usr/bin/python3"] + sys.argv)
    print("QGIS's Python bindings (Debian: python3-qgis) are not installed")
    sys.exit(77)
