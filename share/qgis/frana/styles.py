# SPDX-License-Identifier: Apache-2.0
"""The classes of maps of probability, as in the program's own; a test compares."""
from __future__ import annotations

from qgis.core import (QgsColorRampShader, QgsMapLayer, QgsProcessingContext, QgsProcessingFeedback,
                       QgsProcessingLayerPostProcessorInterface, QgsRasterLayer, QgsRasterShader,
                       QgsSingleBandPseudoColorRenderer)
from qgis.PyQt.QtGui import QColor

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


class ProbabilityStyle(QgsProcessingLayerPostProcessorInterface):
    """Of a layer that QGIS will load."""

    waiting: list["ProbabilityStyle"] = []  # QGIS does not keep them alive

    @classmethod
    def attach(cls, details: QgsProcessingContext.LayerDetails) -> None:
        style = cls()
        cls.waiting.append(style)
        details.setPostProcessor(style)

    def postProcessLayer(self, layer: QgsMapLayer, context: QgsProcessingContext,  # noqa: N802
                         feedback: QgsProcessingFeedback) -> None:
        if isinstance(layer, QgsRasterLayer):
            style_probability(layer)
            layer.triggerRepaint()
        if self in self.waiting:
            self.waiting.remove(self)
