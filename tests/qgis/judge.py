# SPDX-License-Identifier: Apache-2.0
"""Runs SCRIPT RESULT NAME... (draw_style.py, open_project.py) and goes by what it drew: judge.py SCRIPT RESULT NAME...

QGIS may crash or hang while it leaves, when every picture is drawn and compared. So the drawing has a time limit, and
the verdicts that it writes count, one for each name, not how it left."""
import os
import subprocess
import sys
import tempfile
import traceback

LIMIT = 30  # seconds for a name, whose pictures need about two
SKIPPED = 77


def verdict_of(result, name):
    return os.path.join(result, name + ".verdict")


def judge_each(result, names, check):
    """Calls check(result, name) for each name, goes on after one that fails, writes the verdicts and leaves."""
    for name in names:
        try:
            check(result, name)
        except Exception:
            traceback.print_exc()
            continue
        with open(verdict_of(result, name), "w") as verdict:
            verdict.write("good")
    # Layers that outlive QGIS's own clean-up crash it; everything is reported and written by now.
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(0)


def judge(script, result, *names):
    for name in names:
        if os.path.exists(verdict_of(result, name)):
            os.remove(verdict_of(result, name))
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), script)
    # The drawing may end in any way: its profile is removed here.
    with tempfile.TemporaryDirectory(prefix="frana_qgis_", ignore_cleanup_errors=True) as profile:
        environment = dict(os.environ, QGIS_CUSTOM_CONFIG_PATH=profile)
        limit = 60 + LIMIT * len(names)
        try:
            code = subprocess.run([sys.executable, script, result, *names], timeout=limit, env=environment).returncode
        except subprocess.TimeoutExpired:
            code = "none, ended after %d s" % limit
    if code == SKIPPED:
        return SKIPPED
    missing = [name for name in names if not os.path.exists(verdict_of(result, name))]
    if missing or not names:
        print("no verdict on", ", ".join(missing), "; exit code", code)
        return 1
    if code != 0:
        print("the pictures are good; QGIS left with exit code", code)
    return 0


if __name__ == "__main__":
    sys.exit(judge(*sys.argv[1:]))
