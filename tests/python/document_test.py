# SPDX-License-Identifier: Apache-2.0
"""Runs the examples of share/doc/python.md, one after the other in one namespace, as a notebook does."""
import contextlib
import importlib
import io
import os
import pathlib
import re
import sys
import tempfile

try:
    import numpy as np
except ImportError:
    print("numpy (Debian: python3-numpy) is not installed")
    sys.exit(77)

document = pathlib.Path(__file__).resolve().parents[2] / "share/doc/python.md"
blocks = re.findall(r"^```python(?: needs=(\S+))?\n(.*?)^```", document.read_text(), re.MULTILINE | re.DOTALL)
assert len(blocks) >= 7, "the document has lost its examples"

os.chdir(tempfile.mkdtemp())
names, printed = {}, []
for needs, code in blocks:
    if needs:
        try:
            importlib.import_module(needs)
        except ImportError:
            print(f"{needs} (Debian: python3-gdal) is not installed: its example is left out")
            continue
        from osgeo import gdal
        first = names["elevations"].astype(np.float32)
        first[0, 0] = -9999
        dtm = gdal.GetDriverByName("GTiff").Create("dtm.tif", first.shape[1], first.shape[0], 1, gdal.GDT_Float32)
        dtm.SetGeoTransform((600000, 5, 0, 5000300, 0, -5))
        dtm.GetRasterBand(1).SetNoDataValue(-9999)
        dtm.GetRasterBand(1).WriteArray(first)
        dtm = None
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        exec(compile(code, str(document), "exec"), names)
    printed.append(out.getvalue())
    if needs:
        written = gdal.Open("max_depth.tif").ReadAsArray()
        assert 1 < written.max() < 10, written.max()
        assert written[0, 0] == -9999

text = "".join(printed)
print(text)
assert "max_velocity    Maximum velocity [m/s]" in text
volumes = [float(v) for v in re.findall(r" s +(\d+) m3 on", text)]
assert len(volumes) >= 5 and all(abs(v - 4 * 80 * 100) < 0.05 * 4 * 80 * 100 for v in volumes), volumes
assert float(re.search(r"run-out: ([\d.]+) m", text)[1]) > 100
assert float(re.search(r"at the bridge: ([\d.]+) m", text)[1]) > 0.1
passed, entered = map(float, re.search(r"road's line: ([\d.]+) of ([\d.]+) m3", text).groups())
assert abs(entered - 1600) < 1e-6 and 0.5 * entered < passed <= 1.01 * entered, (passed, entered)
assert "material.friction-coefficient: is out of range (value 32;" in text
