# SPDX-License-Identifier: Apache-2.0
"""Runs SCRIPT NAME RESULT (draw_style.py) and goes by what it drew: judge.py NAME RESULT [SCRIPT].

QGIS may crash or hang while it leaves, when every picture is drawn and compared. So the drawing has a time limit, and
the verdict that it writes at the end counts, not how it left."""
import os
import subprocess
import sys
import tempfile

LIMIT = 120  # seconds for the two pictures, which need about two
SKIPPED = 77


def judge(name, result, script="draw_style.py"):
    verdict = os.path.join(result, name + ".verdict")
    if os.path.exists(verdict):
        os.remove(verdict)
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), script)
    # The drawing may end in any way: its profile is removed here.
    with tempfile.TemporaryDirectory(prefix="frana_qgis_", ignore_cleanup_errors=True) as profile:
        environment = dict(os.environ, QGIS_CUSTOM_CONFIG_PATH=profile)
        try:
            code = subprocess.run([sys.executable, script, name, result], timeout=LIMIT, env=environment).returncode
        except subprocess.TimeoutExpired:
            code = "none, ended after %d s" % LIMIT
    if code == SKIPPED:
        return SKIPPED
    if not os.path.exists(verdict):
        print("no verdict; exit code", code)
        return 1
    if code != 0:
        print("the pictures are good; QGIS left with exit code", code)
    return 0


if __name__ == "__main__":
    sys.exit(judge(*sys.argv[1:]))
