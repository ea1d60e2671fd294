# SPDX-License-Identifier: Apache-2.0
"""In which fraction of rasters a threshold is exceeded, cell by cell, and its standard error."""
from __future__ import annotations

import math
from typing import Callable

import numpy
from osgeo import gdal, osr

from .translation import tr

NODATA = -9999.0
_ROWS = 256  # of a block
_ALIGNED = 1e-3  # of a cell: rasters of one map have the same cells to the last digits


class GridError(Exception):
    """The rasters do not fit; a sentence for the user."""


class Grid:
    """North up, square cells: a window of a common lattice."""

    def __init__(self, path: str) -> None:
        self.path = path
        self.data = gdal.Open(path)
        if self.data is None:
            raise GridError(tr("{0} is not a raster that GDAL reads", path))
        self.west, self.cell, turn_x, self.north, turn_y, step = self.data.GetGeoTransform()
        if turn_x or turn_y or not math.isclose(step, -self.cell, rel_tol=1e-9):
            raise GridError(tr("{0} is turned or has cells that are not square. Use rasters of frana's results", path))
        self.columns, self.rows = self.data.RasterXSize, self.data.RasterYSize

    def offset(self, west: float, north: float) -> tuple[int, int]:
        """Columns and rows from a corner of the lattice."""
        column, row = (self.west - west) / self.cell, (north - self.north) / self.cell
        if abs(column - round(column)) > _ALIGNED or abs(row - round(row)) > _ALIGNED:
            raise GridError(tr("{0} has cells that lie between those of the first raster. Use results on the same cells",
                               self.path))
        return round(column), round(row)


def _check_alike(grids: list[Grid]) -> None:
    first = grids[0]
    crs = osr.SpatialReference(first.data.GetProjection())
    for grid in grids[1:]:
        if not math.isclose(grid.cell, first.cell, rel_tol=1e-9):
            raise GridError(tr("{0} has cells of {1:g}, the first raster of {2:g}. Use results on the same cells", grid.path,
                               grid.cell, first.cell))
        other = osr.SpatialReference(grid.data.GetProjection())
        if bool(first.data.GetProjection()) != bool(grid.data.GetProjection()) or not crs.IsSame(other):
            raise GridError(tr("{0} has another CRS than the first raster. Use results in the same CRS", grid.path))


def write_exceedance(paths: list[str], threshold: float, quantity: str, target: str,
                     advance: Callable[[float], bool]) -> tuple[float, float]:
    """Band 1: probability, 0 where no raster has a value; band 2: standard error sqrt(p (1 - p) / n), with equal weights.
    The extent is that of all rasters together. `advance` gets the fraction done and returns False to stop. Returns the
    area [square units of the CRS] that any raster reaches and the largest standard error. Throws GridError."""
    grids = [Grid(path) for path in paths]
    _check_alike(grids)
    first = grids[0]
    west, north = min(grid.west for grid in grids), max(grid.north for grid in grids)
    places = [grid.offset(west, north) for grid in grids]
    columns = max(place[0] + grid.columns for place, grid in zip(places, grids))
    rows = max(place[1] + grid.rows for place, grid in zip(places, grids))
    driver = gdal.GetDriverByName("GTiff")
    options = ["COMPRESS=DEFLATE", "PREDICTOR=3", "TILED=YES", "BIGTIFF=IF_SAFER"]
    result = driver.Create(target, columns, rows, 2, gdal.GDT_Float32, options)
    if result is None:
        raise GridError(tr("{0} could not be written: {1}", target, gdal.GetLastErrorMsg()))
    result.SetGeoTransform((west, first.cell, 0, north, 0, -first.cell))
    result.SetProjection(first.data.GetProjection())
    text = f"the {quantity} exceeds {threshold:g}"
    for index, meaning in ((1, f"Probability that {text}"), (2, "Standard error of the probability")):
        result.GetRasterBand(index).SetDescription(f"{meaning}, of {len(grids)} results with equal weights [-]")
        result.GetRasterBand(index).SetNoDataValue(NODATA)
    reached, largest = 0, 0.0
    for top in range(0, rows, _ROWS):
        height = min(_ROWS, rows - top)
        hits = numpy.zeros((height, columns), dtype=numpy.int64)
        for grid, place in zip(grids, places):
            _count(grid, place, top, height, threshold, hits)
        probability = hits / len(grids)
        error = numpy.sqrt(probability * (1 - probability) / len(grids))
        result.GetRasterBand(1).WriteArray(probability.astype(numpy.float32), 0, top)
        result.GetRasterBand(2).WriteArray(error.astype(numpy.float32), 0, top)
        reached += int(numpy.count_nonzero(hits))
        largest = max(largest, float(error.max()))
        if not advance((top + height) / rows):
            break
    result.FlushCache()
    return reached * first.cell * first.cell, largest


def _count(grid: Grid, place: tuple[int, int], top: int, height: int, threshold: float, hits: numpy.ndarray) -> None:
    """Adds one where the raster exceeds the threshold; nodata, which means that nothing came, does not."""
    begin, end = max(top, place[1]), min(top + height, place[1] + grid.rows)
    if begin >= end:
        return
    band = grid.data.GetRasterBand(1)
    values = band.ReadAsArray(0, begin - place[1], grid.columns, end - begin)
    if values is None:
        raise GridError(tr("{0} could not be read: {1}", grid.path, gdal.GetLastErrorMsg()))
    nodata = band.GetNoDataValue()
    over = values > threshold
    if nodata is not None:
        over &= values != values.dtype.type(nodata)
    hits[begin - top:end - top, place[0]:place[0] + grid.columns] += over
