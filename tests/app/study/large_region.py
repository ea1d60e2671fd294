#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A region as large as regions get: slopes of 1 000 m3 on a DTM of 20 000 x 20 000 cells of 1 m.

usage: large_region.py FOLDER [SLOPES [CELLS]]

The DTM is compressed tiles of one valley profile that repeats every 2 000 m, in a VRT of strips. Needs gdal-bin.
"""
import json
import math
import os
import struct
import subprocess
import sys

folder = sys.argv[1]
slopes = int(sys.argv[2]) if len(sys.argv) > 2 else 500
cells = int(sys.argv[3]) if len(sys.argv) > 3 else 20000
WEST, NORTH, VALLEY, STRIP = 500000, 5120000, 2000, 2000
os.makedirs(folder, exist_ok=True)


def height(x):
    """Steep flanks of 31 degrees, flat at the foot, across the valleys."""
    d = abs(x % VALLEY - VALLEY / 2)
    return 1000 + 0.6 * max(0.0, d - 150) + 0.0004 * min(d, 150) ** 2


row = struct.pack(f"<{cells}f", *(height(c + 0.5) for c in range(cells)))
strips = []
for top in range(0, cells, STRIP):
    rows = min(STRIP, cells - top)
    strip = os.path.join(folder, f"strip_{top}.tif")
    if top in (0, cells - cells % STRIP):  # strips of one height are alike
        raw = os.path.join(folder, "strip.bil")
        with open(raw, "wb") as file:
            for _ in range(rows):
                file.write(row)
        with open(os.path.join(folder, "strip.hdr"), "w") as file:
            file.write(f"nrows {rows}\nncols {cells}\nnbands 1\nnbits 32\npixeltype float\nbyteorder I\nlayout bil\n")
        subprocess.run(["gdal_translate", "-q", "-of", "GTiff", "-co", "TILED=YES", "-co", "COMPRESS=DEFLATE", "-co",
                        "PREDICTOR=3", "-a_srs", "EPSG:32632", "-a_ullr", str(WEST), str(NORTH - top),
                        str(WEST + cells), str(NORTH - top - rows), raw, strip], check=True)
        os.remove(raw)
    else:
        subprocess.run(["gdal_translate", "-q", "-co", "TILED=YES", "-co", "COMPRESS=DEFLATE", "-co", "PREDICTOR=3",
                        "-a_ullr", str(WEST), str(NORTH - top), str(WEST + cells), str(NORTH - top - rows), strips[0],
                        strip], check=True)
    strips.append(strip)
subprocess.run(["gdalbuildvrt", "-q", os.path.join(folder, "dtm.vrt"), *strips], check=True)

features = []
across = max(1, cells // VALLEY)
for i in range(slopes):
    column, place = i % across, i // across
    # 20 x 33.4 m, 1.5 m thick: 1 000 m3, on the western flank of a valley
    x = WEST + column * VALLEY + 550
    y = NORTH - 300 - (cells - 600) * (place + 0.5) / math.ceil(slopes / across)
    ring = [[x, y], [x + 20, y], [x + 20, y + 33.4], [x, y + 33.4], [x, y]]
    features.append({"type": "Feature", "properties": {"NAME": f"slope {i}", "SCENARIO": f"T{(30, 100, 300)[i % 3]}",
                                                       "YEARS": (30, 100, 300)[i % 3]},
                     "geometry": {"type": "Polygon", "coordinates": [ring]}})
with open(os.path.join(folder, "slopes.geojson"), "w") as file:
    json.dump({"type": "FeatureCollection",
               "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::32632"}},
               "features": features}, file)
with open(os.path.join(folder, "scene.ini"), "w") as file:
    file.write("[terrain]\ndtm = dtm.vrt\n[release]\nperimeter = slopes.geojson\nthickness = 1.497\n[material]\n"
               "friction-coefficient = 0.35\nturbulence = 400\n[time]\nend = 120\n[hazard]\nscheme = swiss-hillslope-debris-flow\n"
               "process = all\n[output]\nmaps = off\nanimation = off\nreport = off\n")
with open(os.path.join(folder, "region.ini"), "w") as file:
    file.write("[region]\nscene = scene.ini\nname = NAME\nscenario = SCENARIO\nreturn-period = YEARS\n")
