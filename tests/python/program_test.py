# SPDX-License-Identifier: Apache-2.0
"""The module says and computes what the program `frana run` does from files: warnings, exposure, solids by place."""
import csv
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy as np
except ImportError:
    print("numpy (Debian: python3-numpy) is not installed")
    sys.exit(77)

import frana

CELL, ROWS, COLUMNS = 4.0, 30, 60
SQUARE = [[20, 40], [60, 40], [60, 80], [20, 80], [20, 40]]
HOUSES = [{"type": "Point", "coordinates": [90, 60, 412.5]},
          {"type": "LineString", "coordinates": [[100, 0], [100, 120]]},
          {"type": "Polygon", "coordinates": [[[80, 50], [96, 50], [96, 70], [80, 70], [80, 50]],
                                              [[84, 54], [92, 54], [92, 66], [84, 66], [84, 54]]]},
          {"type": "Polygon", "coordinates": [[[200, 10], [210, 10], [210, 20], [200, 20], [200, 10]]]},
          {"type": "MultiPoint", "coordinates": [[70, 60], [900, 60]]},
          {"type": "Point", "coordinates": [900, 60]}]
STRUCTURED = {"material.model": "structured", "structured.phases": "solids-and-fluid", "structured.cohesion": "2000",
              "structured.internal-friction-angle": "30", "structured.bed-friction-angle": "15",
              "numerics.particles-per-cell": "9"}


def slope():
    x = CELL * np.arange(COLUMNS, dtype=np.float64)
    return np.ascontiguousarray(np.broadcast_to(100 + np.maximum(0, 0.5 * (120 - x)), (ROWS, COLUMNS)))


def write_raster(path, values):
    with open(path, "w", encoding="ascii") as file:
        file.write(f"ncols {COLUMNS}\nnrows {ROWS}\nxllcorner 0\nyllcorner 0\ncellsize {CELL}\nNODATA_value -9999\n")
        for row in values:
            file.write(" ".join("-9999" if math.isnan(v) else repr(float(v)) for v in row) + "\n")


def write_features(path, geometries):
    features = [{"type": "Feature", "properties": {}, "geometry": geometry} for geometry in geometries]
    with open(path, "w", encoding="ascii") as file:
        json.dump({"type": "FeatureCollection", "features": features}, file)


class AsTheProgram(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name
        write_raster(self.file("dtm.asc"), slope())
        write_features(self.file("release.geojson"), [{"type": "Polygon", "coordinates": [SQUARE]}])
        write_features(self.file("houses.geojson"), HOUSES)

    def file(self, name):
        return os.path.join(self.folder, name)

    def program(self, keys):
        """The folder of a result of frana run."""
        own = {"terrain.dtm": "dtm.asc", "terrain.crs": "local", "release.perimeter": "release.geojson",
               "release.thickness": "2", "output.maps": "off", "output.animation": "off", "output.report": "off",
               "output.exposure": "houses.geojson", **keys}
        with open(self.file("scene.ini"), "w", encoding="ascii") as scene:
            for section in sorted({key.split(".")[0] for key in own}):
                scene.write(f"[{section}]\n")
                scene.writelines(f"{key.split('.')[1]} = {value}\n" for key, value in own.items()
                                 if key.startswith(section + "."))
        out = self.file("out")
        subprocess.run([os.environ["FRANA_PROGRAM"], "run", self.file("scene.ini"), "--out", out, "--overwrite",
                        "--quiet"], check=True, stdin=subprocess.DEVNULL)
        with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
            return out, json.load(file)

    @staticmethod
    def scene(keys):
        scene = frana.Scene(slope(), north=CELL * ROWS, cell_size=CELL)
        for key, value in keys.items():
            scene[key] = value
        scene.add_release(2.0, outline=SQUARE)
        return scene

    def expect_same_warnings(self, result, summary):
        """But for those of the program's layer of exposed features, which the library has no key for."""
        told = [warning for warning in summary["warnings"] if "exposed features" not in warning]
        self.assertEqual(result.warnings, told)
        self.assertEqual(result.summary["warnings"], told)

    def test_both_warn_in_the_same_words(self):
        usual = {"material.friction-coefficient": "0.3", "time.end": "8"}
        for keys, expected in (({}, "still moves"),
                               ({"material.friction-coefficient": "0.9"}, "under its friction"),
                               ({"output.trace-threshold": "40"}, "thinner than output.trace-threshold"),
                               ({"numerics.minimum-depth": "1.9"}, "thinner than numerics.minimum-depth"),
                               ({"numerics.particles-per-cell": "1"}, "particles only"),
                               ({"material.friction-coefficient": "0.02", "time.end": "40"}, "left the computed ground")):
            with self.subTest(expected):
                keys = {**usual, **keys}
                _, summary = self.program(keys)
                result = frana.run(self.scene(keys))
                self.expect_same_warnings(result, summary)
                self.assertTrue(any(expected in warning for warning in result.warnings), result.warnings)

    def test_both_give_exposed_features_the_same_values(self):
        keys = {"material.friction-coefficient": "0.3", "time.end": "8"}
        out, _ = self.program(keys)
        with open(os.path.join(out, "exposure.csv"), encoding="utf-8", newline="") as file:
            table = list(csv.DictReader(file))
        result = frana.run(self.scene(keys))
        rows = result.exposure(HOUSES)
        self.assertEqual(len(rows), len(HOUSES))
        for own, row in zip(rows, table):
            self.assertEqual(own["place"], row["place"])
            self.assertEqual(own["reached"], row["reached"] == "1")
            for name in ("max_depth_m", "max_velocity_ms", "max_pressure_kpa", "arrival_s"):
                # The table has the shortest text that reads back as the same double.
                given = float(row[name]) if row[name] else math.nan
                self.assertTrue(own[name] == given or (math.isnan(own[name]) and math.isnan(given)), (name, own, row))
        self.assertEqual([row["reached"] for row in rows], [True, True, True, False, True, False])
        self.assertEqual(rows[4]["place"], "partly outside the map")

        class Shape:  # as shapely has it
            __geo_interface__ = HOUSES[0]
        self.assertEqual(result.exposure([Shape(), {"type": "Feature", "geometry": HOUSES[1]}]), rows[:2])
        for wrong, word in ((3, "is not a geometry"), ({"type": "Circle", "coordinates": [1, 2]}, "is not a geometry"),
                            ({"type": "Point", "coordinates": [math.nan, 2]}, "is not finite")):
            with self.assertRaisesRegex(frana.Error, word):
                result.exposure([wrong])

    def test_both_compute_solids_by_place(self):
        values = np.where(np.arange(COLUMNS) < 10, 500.0, 8000.0) * np.ones((ROWS, 1))
        bed = np.where(np.arange(ROWS) < 15, 10.0, 25.0)[:, None] * np.ones(COLUMNS)
        fluid = np.full((ROWS, COLUMNS), np.nan)
        fluid[:, 20:25] = 0.5
        given = {"structured.cohesion": values, "structured.internal-friction-angle": bed + 5,
                 "structured.initial-fluid-depth": fluid}
        keys = {"time.end": "3", **{key: value for key, value in STRUCTURED.items() if key not in given}}
        del keys["structured.bed-friction-angle"]  # then that inside the material, by place as well
        files = {}
        for key, array in given.items():
            files[key] = "raster:" + key + ".asc"
            write_raster(self.file(key + ".asc"), array)
        _, summary = self.program({**keys, **files})
        scene = self.scene(keys)
        for key, array in given.items():
            scene.set_values(key, array)
        result = frana.run(scene)
        uniform = frana.run(self.scene({**STRUCTURED, "time.end": "3"}))
        for name in ("max_depth_m", "max_velocity_ms", "covered_area_m2", "steps"):
            self.assertEqual(result.summary[name], summary[name], name)
        self.expect_same_warnings(result, summary)
        self.assertTrue(any("damage-length is not given" in warning for warning in result.warnings), result.warnings)
        self.assertNotEqual(result.summary["max_velocity_ms"], uniform.summary["max_velocity_ms"])
        holes = values.copy()
        holes[15, 8] = np.nan
        scene.set_values("structured.cohesion", holes)
        with self.assertRaisesRegex(frana.Error, "structured.cohesion.*has no value on part of the release|"
                                                 "has no value on part of the release.*structured.cohesion"):
            scene.check()
        scene["structured.cohesion"] = 3000  # now that applies there
        scene.check()
        scene.set_values("structured.cohesion", -values)
        with self.assertRaisesRegex(frana.Error, "is out of range"):
            scene.check()
        scene = self.scene({"material.friction-coefficient": 0.3})
        scene.set_values("structured.cohesion", values)
        with self.assertRaisesRegex(frana.Error, "material.model = structured"):
            scene.check()

    def test_both_put_fluid_of_one_depth_on_the_ground(self):
        keys = {**STRUCTURED, "time.end": "2", "structured.initial-fluid-depth": "0.25"}
        _, summary = self.program(keys)
        result = frana.run(self.scene(keys))
        for name in ("max_depth_m", "max_velocity_ms", "covered_area_m2"):
            self.assertEqual(result.summary[name], summary[name], name)
        self.assertGreater(result.summary["covered_area_m2"], 0.9 * ROWS * COLUMNS * CELL**2)


if __name__ == "__main__":
    unittest.main(verbosity=2)
