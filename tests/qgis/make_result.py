# SPDX-License-Identifier: Apache-2.0
"""A short run of the sample with every styled file, for the pictures, and RESULT_it and the like, whose sheets have the
longest texts of a language: make_result.py FRANA SAMPLE RESULT."""
import find_qgis  # noqa: F401
import shutil
import subprocess
import sys

program, sample, result = sys.argv[1:]
COMMON = ["--quiet", "--overwrite", "--set", "terrain.cell-size=10", "--set", "output.maps=off",
          "--set", "output.animation=off", "--set", "output.report=off", "--set", "hazard.scheme=swiss-flood",
          "--set", "material.friction-table=ngi-avalanche", "--set", "material.return-period=300"]
LONG = ["title=Rockslide above the upper villages and the hydropower station at the mouth of the valley, 2026 survey",
        "map-author=Office for Natural Hazards of the Autonomous Province, Department of Geology",
        "map-attribution=Province, Department of Geology and Mapping, orders 4 to 12 of 2025, under a licence that asks "
        "for this whole sentence wherever the data are shown, printed or passed on to a third party"]
SOURCE = ("Airborne laser scanning of the Autonomous Province, flown in autumn 2024, first and last returns filtered, "
          "interpolated by the surveyor; public licence, order number 2025/1234")


def run(out, *settings):
    shutil.rmtree(out, ignore_errors=True)  # with pictures of an earlier session, which an overwrite would refuse
    pairs = [part for setting in settings for part in ("--set", setting)]
    return subprocess.call([program, "run", sample + "/scene.ini", "--out", out, *COMMON, *pairs])


failed = run(result, "time.end=6", "time.frame-interval=1.5")
for number, language in enumerate(("en", "it", "de", "fr", "es")):
    size = ("A4", "A3", "A4", "A3", "A4")[number]
    failed = failed or run(result + "_" + language, "time.end=0.5", "output.language=" + language, "terrain.source=" + SOURCE,
                           "output.map-size=" + size, *("output." + setting for setting in LONG))
sys.exit(failed)
