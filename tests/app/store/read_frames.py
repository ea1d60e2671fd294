# SPDX-License-Identifier: Apache-2.0
"""Opens frames.zarr and frames.nc of a result as users do, with xarray, and compares with what is expected.

read_frames.py RESULT EXPECTED.json: coordinates and scene's name; RESULT/depth.f32 and velocity.f32 are the
values of the GeoTIFF frames, one after the other, NaN where there is none. Prints every CRS that it found, one a line.
Exit code 77: xarray is not there.
"""
import json
import pathlib
import sys
import warnings

try:
    import netCDF4  # noqa: F401
    import numpy
    import xarray
    import zarr  # noqa: F401
except ImportError as missing:
    print(f"{missing} (Debian: python3-xarray python3-zarr python3-netcdf4)")
    sys.exit(77)

folder, expected = pathlib.Path(sys.argv[1]), json.loads(pathlib.Path(sys.argv[2]).read_text(encoding="utf-8"))


def compare(frames):
    assert frames.attrs["Conventions"] == "CF-1.8"
    assert frames.attrs["SCENE"] == expected["scene"], frames.attrs["SCENE"]
    assert frames.time.dtype == "datetime64[ns]", "no CF time coordinate"
    seconds = (frames.time.values - numpy.datetime64("2000-01-01")) / numpy.timedelta64(1, "s")
    # datetime64[ns] counts whole nanoseconds
    assert numpy.allclose(seconds, expected["time"], rtol=0, atol=1.5e-9), (seconds, expected["time"])
    for axis in ("x", "y"):
        assert frames[axis].dtype == "float64", axis
        assert list(frames[axis].values) == expected[axis], (axis, frames[axis].values)
    for name in ("depth", "velocity"):
        values = frames[name]
        assert values.dims == ("time", "y", "x"), values.dims
        assert values.attrs["units"] == {"depth": "m", "velocity": "m s-1"}[name]
        shape = [len(expected[axis]) for axis in values.dims]
        written = numpy.fromfile(folder / (name + ".f32"), "<f4").reshape(shape)
        assert numpy.array_equal(values.values, written, equal_nan=True), name
        assert numpy.isnan(written).any() and (written[-1] > 0).any(), "nothing to compare"
        # Required by rioxarray.
        mapping = frames.coords[values.encoding["grid_mapping"]]
        mapping.load()
        for word in ("crs_wkt", "spatial_ref"):
            print(mapping.attrs[word])
    late = numpy.datetime64("2000-01-01") + numpy.timedelta64(int(1e9 * expected["time"][-1] + 1e7), "ns")
    assert frames.depth.sel(time=late, method="nearest").time.values == frames.time.values[-1]


warnings.simplefilter("error")  # reading metadata that are not consolidated gives one
with warnings.catch_warnings():
    warnings.simplefilter("ignore", DeprecationWarning)
    compare(xarray.open_zarr(folder / "frames.zarr", decode_coords="all"))
    compare(xarray.open_dataset(folder / "frames.nc", decode_coords="all"))
    for frames in (xarray.open_zarr(folder / "frames.zarr"), xarray.open_dataset(folder / "frames.nc")):
        frames.load()
    for frames in (xarray.open_zarr(folder / "frames.zarr", decode_times=False),
                   xarray.open_dataset(folder / "frames.nc", decode_times=False)):
        assert list(frames.time.values) == expected["time"], frames.time.values
