# SPDX-License-Identifier: Apache-2.0
"""A short run of the sample with every styled file, for the pictures: make_result.py FRANA SAMPLE RESULT."""
import find_qgis  # noqa: F401
import shutil
import subprocess
import sys

program, sample, result = sys.argv[1:]
shutil.rmtree(result, ignore_errors=True)  # with pictures of an earlier session, which an overwrite would refuse
sys.exit(subprocess.call([
    program, "run", sample + "/scene.ini", "--out", result, "--quiet",
    "--set", "time.end=6", "--set", "terrain.cell-size=10", "--set", "output.maps=off", "--set", "output.animation=off",
    "--set", "time.frame-interval=1.5", "--set", "output.report=off", "--set", "hazard.scheme=swiss-flood",
    "--set", "material.friction-table=ramms-avalanche", "--set", "material.return-period=300"]))
