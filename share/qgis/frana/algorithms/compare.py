# SPDX-License-Identifier: Apache-2.0
"""frana compare."""
from __future__ import annotations

import os
from typing import Any

from qgis.core import (QgsProcessing, QgsProcessingContext, QgsProcessingException, QgsProcessingFeedback,
                       QgsProcessingParameterFeatureSource, QgsProcessingParameterFile,
                       QgsProcessingParameterFolderDestination, QgsProcessingParameterMapLayer,
                       QgsProcessingParameterRasterLayer, QgsProcessingUtils)

from ..fields import number_parameter, number_text
from ..inputs import inputs_folder
from ..loading import load_layer
from ..outputs import COMPARISON, collect, declare
from ..process import run_or_refuse
from ..translation import tr
from .base import FranaAlgorithm


class CompareAlgorithm(FranaAlgorithm):
    COMMAND = NAME = "compare"
    TITLE = "Compare with a surveyed outline"
    GROUP = "One run"
    HELP = ("Compares a result, or any raster of depths, with a surveyed outline, front or tip, in any CRS: "
            "hits, false alarms, misses, scores. Without a folder of its own the comparison becomes a part of the result.")
    TAGS = ("survey", "validation", "scar")
    NAMES = {"RESULT_DIR": "Folder of a result", "RESULT_DIR|RASTER": "Folder of a result",
             "raster": "Raster", "observed": "Surveyed areas", "deposit": "Surveyed deposit",
             "--observed": "Surveyed areas", "--deposit": "Surveyed deposit", "--threshold": "Depth over which ground counts",
             "--out": "Folder of the comparison"}

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:  # noqa: N802
        self.addParameter(QgsProcessingParameterFile("RESULT", "Folder of a result", QgsProcessingParameterFile.Folder,
                                                     "", None, True))
        self.addParameter(QgsProcessingParameterRasterLayer("RASTER", "or a raster", None, True))
        self.addParameter(QgsProcessingParameterFeatureSource(
            "OBSERVED", "Surveyed areas, lines of a front, or points of a tip", [QgsProcessing.TypeVectorAnyGeometry]))
        self.addParameter(QgsProcessingParameterMapLayer(
            "DEPOSIT", "Surveyed deposit: polygons, or a raster of elevation after minus before", None, True,
            [QgsProcessing.TypeRaster, QgsProcessing.TypeVectorPolygon]))
        self.addParameter(number_parameter("THRESHOLD", "Depth over which ground counts as covered [m] (otherwise the "
                                           "result's, else 0.1)", (1e-6, 100)))
        self.add_overwrite()
        self.add_load()
        self.addParameter(QgsProcessingParameterFolderDestination("OUTPUT", "Folder of the comparison (otherwise the result's)",
                                                                  None, True, False))
        declare(self, COMPARISON)

    def checkParameterValues(self, parameters: dict[str, Any],  # noqa: N802
                             context: QgsProcessingContext) -> tuple[bool, str]:
        good, message = super().checkParameterValues(parameters, context)
        values = self.values(parameters, context)
        if good and values.has("RESULT") == values.has("RASTER"):
            return False, tr("Folder of a result, or a raster: give one of the two")
        return good, message

    def prepareAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext,  # noqa: N802
                         feedback: QgsProcessingFeedback) -> bool:
        values = self.values(parameters, context)
        self.observed = values.vector("OBSERVED", tr("Surveyed areas"))
        self.deposit = values.layer("DEPOSIT", tr("Surveyed deposit")) if values.has("DEPOSIT") else None
        self.raster = values.raster("RASTER", tr("Raster")) if values.has("RASTER") else None
        if self.observed is None:
            raise QgsProcessingException(tr("Surveyed areas: the layer could not be opened"))
        return True

    def processAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext,  # noqa: N802
                         feedback: QgsProcessingFeedback) -> dict[str, Any]:
        values = self.values(parameters, context)
        result = values.text("RESULT")
        own = values.path("OUTPUT")
        folder = own or result or QgsProcessingUtils.generateTempFilename("comparison")
        inputs = inputs_folder(folder)
        words = [self.program.path, "compare", result or os.path.join(inputs, self.raster.write(inputs, "raster")),
                 "--observed", os.path.join(inputs, self.observed.write(inputs, "observed"))]
        if self.deposit is not None:
            words += ["--deposit", os.path.join(inputs, self.deposit.write(inputs, "deposit"))]
        if values.has("THRESHOLD"):
            words += ["--threshold", number_text(values.number("THRESHOLD"))]
        if own or not result:
            words += ["--out", folder]
        words += self.options(values)
        done = run_or_refuse(words, feedback, [], self.NAMES)
        feedback.pushConsoleInfo(done.output)
        found = {"OUTPUT": folder, **collect(folder, COMPARISON)}
        if values.is_on("LOAD") and "COMPARISON" in found:
            load_layer(found["COMPARISON"], tr("Comparison"), context)
        return found
