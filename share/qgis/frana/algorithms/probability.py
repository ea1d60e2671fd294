# SPDX-License-Identifier: Apache-2.0
"""Probability from results that exist already."""
from __future__ import annotations

import os
from typing import Any

from qgis.core import (QgsColorRampShader, QgsProcessing, QgsProcessingContext, QgsProcessingException,
                       QgsProcessingFeedback, QgsProcessingOutputNumber, QgsProcessingParameterMultipleLayers,
                       QgsProcessingParameterNumber, QgsProcessingParameterRasterDestination, QgsRasterLayer,
                       QgsRasterShader, QgsSingleBandPseudoColorRenderer)
from qgis.PyQt.QtGui import QColor

from ..exceedance import GridError, write_exceedance
from ..loading import After
from ..translation import tr
from .base import FranaAlgorithm

# The classes of maps of probability, as in the program's own; a test compares.
# Upper limit of each class, its colour; no colour: transparent.
PROBABILITY = ((0.0, ""), (0.01, "#fde725"), (0.05, "#93d641"), (0.25, "#3ab776"), (0.5, "#21918c"), (0.75, "#31678d"),
               (0.95, "#433980"), (float("inf"), "#440154"))


def style_probability(layer: QgsRasterLayer) -> None:
    items, below = [], 0.0
    for limit, colour in PROBABILITY:
        shown = QColor(colour) if colour else QColor(255, 255, 255, 0)
        label = "0" if limit == 0 else f"{below:g} – {min(limit, 1.0):g}"
        items.append(QgsColorRampShader.ColorRampItem(limit, shown, label))
        below = limit
    ramp = QgsColorRampShader(0, 1, None, QgsColorRampShader.Discrete)
    ramp.setColorRampItemList(items)
    shader = QgsRasterShader(0, 1)
    shader.setRasterShaderFunction(ramp)
    layer.setRenderer(QgsSingleBandPseudoColorRenderer(layer.dataProvider(), 1, shader))


class ProbabilityAlgorithm(FranaAlgorithm):
    NAME = "probability"
    TITLE = "Probability from existing results"
    GROUP = "Many runs"
    HELP = ("In which fraction of several results each cell exceeds a threshold: for example the max_depth.tif of runs that "
            "you consider equally likely. Band 1 is the probability, 0 where no run came; band 2 its standard error "
            "sqrt(p (1 - p) / n).\n\nThe rasters have the same cells and CRS; their extents may differ. To draw the values of "
            "the runs from distributions, use “Give a range”.")
    TAGS = ("exceedance", "threshold")

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:  # noqa: N802
        rasters = QgsProcessingParameterMultipleLayers("RASTERS", "Rasters of the results, for example of maximum depth",
                                                       QgsProcessing.TypeRaster)
        rasters.setMinimumNumberInputs(2)
        self.addParameter(rasters)
        self.addParameter(QgsProcessingParameterNumber("THRESHOLD", "Threshold, in the rasters' unit",
                                                       QgsProcessingParameterNumber.Double, 0.5, False, 0))
        self.addParameter(QgsProcessingParameterRasterDestination("OUTPUT", "Probability"))
        self.addOutput(QgsProcessingOutputNumber("REACHED_AREA", "Area where any result exceeds the threshold [m2]"))
        self.addOutput(QgsProcessingOutputNumber("LARGEST_STANDARD_ERROR", "Largest standard error"))
        self.addOutput(QgsProcessingOutputNumber("RESULTS", "Number of results"))

    def prepareAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext,  # noqa: N802
                         feedback: QgsProcessingFeedback) -> bool:
        layers = self.parameterAsLayerList(parameters, "RASTERS", context)
        self.paths = [layer.source() for layer in layers]
        if len(self.paths) < 2:
            raise QgsProcessingException(tr("Rasters of the results: choose at least two that can be opened"))
        return True

    def processAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext,  # noqa: N802
                         feedback: QgsProcessingFeedback) -> dict[str, Any]:
        threshold = self.parameterAsDouble(parameters, "THRESHOLD", context)
        target = self.parameterAsOutputLayer(parameters, "OUTPUT", context)
        doubled = sorted({path for path in self.paths if self.paths.count(path) > 1})
        if doubled:
            raise QgsProcessingException(tr("Rasters of the results: {0} is chosen twice", doubled[0]))

        def advance(done: float) -> bool:
            feedback.setProgress(100 * done)
            return not feedback.isCanceled()

        try:
            area, error = write_exceedance(self.paths, threshold, _quantity(self.paths), target, advance)
        except GridError as problem:
            raise QgsProcessingException(tr("Rasters of the results: {0}", problem)) from problem
        if context.willLoadLayerOnCompletion(target):
            style = After(lambda layer, at: style_probability(layer))
            context.layerToLoadOnCompletionDetails(target).setPostProcessor(style)
        return {"OUTPUT": target, "REACHED_AREA": area, "LARGEST_STANDARD_ERROR": error, "RESULTS": len(self.paths)}


def _quantity(paths: list[str]) -> str:
    names = {os.path.splitext(os.path.basename(path))[0].replace("_", " ") for path in paths}
    return names.pop() if len(names) == 1 else "value"
