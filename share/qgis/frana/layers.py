# SPDX-License-Identifier: Apache-2.0
"""Layers of a project as files that the program reads: any CRS, layers in memory, selected features only."""
from __future__ import annotations

import os
from contextlib import contextmanager
from typing import Iterator, Protocol

from osgeo import gdal
from qgis.core import (NULL, QgsCoordinateReferenceSystem, QgsCoordinateTransformContext, QgsFeatureRequest, QgsFeatureSink,
                       QgsProcessingException, QgsProcessingFeatureSource, QgsRasterFileWriter,
                       QgsRasterLayer, QgsRasterPipe, QgsVectorFileWriter, QgsWkbTypes)

from .translation import tr

VECTOR_DRIVER = "GPKG"


def is_null(value: object) -> bool:
    """Whether it is QGIS's own null, which is a QVariant with Qt 5 and a value of QGIS with Qt 6."""
    return value == NULL and not isinstance(value, (str, int, float, list, tuple, dict))


class Layer(Protocol):
    """A layer of the project, to be written as a file."""

    name: str

    def write(self, folder: str, stem: str) -> str:
        """Returns the file's path: relative to `folder` if it was written there, else absolute."""


@contextmanager
def _fixed_date() -> Iterator[None]:
    """GeoPackages contain the time of writing; with a fixed one the same layer gives the same bytes."""
    gdal.SetConfigOption("OGR_CURRENT_DATE", "2000-01-01T00:00:00.000Z")
    try:
        yield
    finally:
        gdal.SetConfigOption("OGR_CURRENT_DATE", None)


def _written_aside(folder: str, name: str) -> str:
    os.makedirs(folder, exist_ok=True)
    return os.path.join(folder, "writing_" + name)


class VectorSource:
    """Features as Processing gives them: the selected ones where the user asked for these."""

    def __init__(self, source: QgsProcessingFeatureSource, title: str) -> None:
        self.source, self.title, self.name = source, title, source.sourceName()
        if source.featureCount() == 0:
            raise QgsProcessingException(tr("{0}: the layer {1} has no features, or only its selected features are asked "
                                            "for and none is selected. Select features, or untick “Selected "
                                            "features only”", title, source.sourceName()))

    def has(self, column: str) -> bool:
        return self.source.fields().lookupField(column) >= 0

    def values_of(self, column: str) -> list[str | float]:
        """The different values of a column, sorted; without empty ones."""
        request = QgsFeatureRequest().setFlags(QgsFeatureRequest.NoGeometry)
        found = {feature[column] for feature in self.source.getFeatures(request)}
        return sorted((value for value in found if not (value is None or is_null(value))), key=str)

    def write(self, folder: str, stem: str) -> str:
        name = stem + ".gpkg"
        aside = _written_aside(folder, name)
        options = QgsVectorFileWriter.SaveVectorOptions()
        options.driverName, options.layerName, options.fileEncoding = VECTOR_DRIVER, stem, "UTF-8"
        if self.source.fields().lookupField("fid") >= 0:  # the user's column, not GeoPackage's key
            options.layerOptions = ["FID=frana_fid"]
        # A layer of polygons may contain areas of several parts.
        is_area = QgsWkbTypes.geometryType(self.source.wkbType()) == QgsWkbTypes.PolygonGeometry
        kind = QgsWkbTypes.multiType(self.source.wkbType()) if is_area else self.source.wkbType()
        with _fixed_date():
            writer = QgsVectorFileWriter.create(aside, self.source.fields(), kind, self.source.sourceCrs(),
                                                QgsCoordinateTransformContext(), options)
            if writer.hasError() != QgsVectorFileWriter.NoError:
                raise QgsProcessingException(tr("{0}: {1} could not be written: {2}", self.title, aside, writer.errorMessage()))
            # The program judges geometries, and its messages say which.
            for feature in self.source.getFeatures(QgsFeatureRequest(),
                                                   QgsProcessingFeatureSource.FlagSkipGeometryValidityChecks):
                if is_area and feature.hasGeometry():
                    area = feature.geometry()
                    area.convertToMultiType()
                    feature.setGeometry(area)
                if not writer.addFeature(feature, QgsFeatureSink.FastInsert):
                    raise QgsProcessingException(tr("{0}: feature {1} could not be written: {2}", self.title, feature.id(),
                                                    writer.errorMessage()))
            del writer  # writes the end of the file
        os.replace(aside, os.path.join(folder, name))
        return name


class RasterSource:
    """A raster layer: its file itself, or a copy where the program could not read it as QGIS shows it."""

    def __init__(self, layer: QgsRasterLayer, title: str) -> None:
        self.title, self.path, self.name = title, layer.source(), layer.name()
        self.is_gdal = layer.providerType() == "gdal"
        self.crs = QgsCoordinateReferenceSystem(layer.crs())
        own = QgsRasterLayer(self.path, "own", layer.providerType()).crs() if self.is_gdal else self.crs
        self.other_crs = self.crs.isValid() and own != self.crs  # the user corrected it in the project
        self.provider = None if self.is_gdal else layer.dataProvider().clone()

    def write(self, folder: str, stem: str) -> str:
        is_file = self.is_gdal and os.path.isfile(self.path)
        if is_file and not self.other_crs and not _is_awkward(self.path):
            return os.path.abspath(self.path)
        name = stem + ".tif"
        aside = _written_aside(folder, name)
        if self.is_gdal:
            self._copy_with_gdal(aside)
        else:
            self._copy_from_provider(aside)
        os.replace(aside, os.path.join(folder, name))
        return name

    def _copy_with_gdal(self, path: str) -> None:
        crs = self.crs.toWkt(QgsCoordinateReferenceSystem.WKT2_2019) if self.other_crs else None
        copy = gdal.Translate(path, self.path, format="GTiff", outputSRS=crs, creationOptions=["COMPRESS=DEFLATE"])
        if copy is None:
            raise QgsProcessingException(tr("{0}: {1} could not be copied to {2}: {3}", self.title, self.name, path,
                                            gdal.GetLastErrorMsg()))
        copy.FlushCache()

    def _copy_from_provider(self, path: str) -> None:
        provider = self.provider
        if not provider.isValid() or provider.xSize() <= 0:
            raise QgsProcessingException(tr("{0}: {1} has no cells that could be read. Save it as a GeoTIFF and use that "
                                            "layer", self.title, self.name))
        pipe = QgsRasterPipe()
        pipe.set(provider.clone())
        writer = QgsRasterFileWriter(path)
        done = writer.writeRaster(pipe, provider.xSize(), provider.ySize(), provider.extent(), self.crs,
                                  QgsCoordinateTransformContext())
        if done != QgsRasterFileWriter.NoError:
            raise QgsProcessingException(tr("{0}: {1} could not be copied to {2}", self.title, self.name, path))


def _is_awkward(path: str) -> bool:
    """Whether a scene file would read the path differently."""
    return " #" in path or "\n" in path or path != path.strip()
