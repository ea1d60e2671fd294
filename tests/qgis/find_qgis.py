# SPDX-License-Identifier: Apache-2.0
"""QGIS's Python bindings, or exit code 77, by which ctest knows a skipped test."""
import atexit
import os
import shutil
import sys
import tempfile

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
# A separate profile: the user's is neither read nor written, and parallel tests do not wait for its databases.
if "QGIS_CUSTOM_CONFIG_PATH" not in os.environ:
    os.environ["QGIS_CUSTOM_CONFIG_PATH"] = tempfile.mkdtemp(prefix="frana_qgis_")
    atexit.register(shutil.rmtree, os.environ["QGIS_CUSTOM_CONFIG_PATH"], ignore_errors=True)
try:
    import qgis.core  # noqa: F401
except ImportError:
    print("QGIS's Python bindings (Debian: python3-qgis) are not installed")
    sys.exit(77)
