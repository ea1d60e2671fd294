# SPDX-License-Identifier: Apache-2.0
"""A result into the project: a group with everything that the result's own QGIS project shows, its styles, its times."""
from __future__ import annotations

import os
from typing import Callable

from qgis.core import (QgsInterval, QgsLayerTreeGroup, QgsLayerTreeLayer, QgsMapLayer, QgsProcessingContext,
                       QgsProcessingFeedback, QgsProcessingLayerPostProcessorInterface, QgsProject,
                       QgsTemporalNavigationObject)
from qgis.PyQt.QtXml import QDomDocument

PROJECT_FILE = "result.qgz"


class After(QgsProcessingLayerPostProcessorInterface):
    """Does something with a layer when QGIS has loaded it, in the main thread."""

    waiting: list["After"] = []  # QGIS does not keep them alive

    def __init__(self, action: Callable[[QgsMapLayer, QgsProcessingContext], None]) -> None:
        super().__init__()
        self.action = action
        self.waiting.append(self)

    def postProcessLayer(self, layer: QgsMapLayer, context: QgsProcessingContext,  # noqa: N802
                         feedback: QgsProcessingFeedback) -> None:
        if self in self.waiting:
            self.waiting.remove(self)
        self.action(layer, context)
        layer.triggerRepaint()


def load_result(folder: str, first: str, context: QgsProcessingContext) -> None:
    """Asks QGIS to load `first`, a file of the result, when the algorithm has ended; the whole result follows it."""
    if not os.path.isfile(os.path.join(folder, PROJECT_FILE)) or not os.path.isfile(first):
        return
    load_layer(first, os.path.basename(first), context,
               lambda layer, at: add_result(folder, layer, at.project()))


def load_layer(path: str, name: str, context: QgsProcessingContext,
               action: Callable[[QgsMapLayer, QgsProcessingContext], None] | None = None) -> None:
    """`action`: on the layer; otherwise it gets the style beside its file again, in place of Processing's own."""
    if context.project() is None:
        return
    details = QgsProcessingContext.LayerDetails(name, context.project())
    details.setPostProcessor(After(action or (lambda layer, at: layer.loadDefaultStyle())))
    context.addLayerToLoadOnCompletion(path, details)


def add_result(folder: str, layer: QgsMapLayer, project: QgsProject) -> None:
    """Adds all layers of the result's project; `layer`, which is one of them, is in the project already."""
    source = QgsProject()
    if not source.read(os.path.join(folder, PROJECT_FILE)):
        return
    root = project.layerTreeRoot()
    alone = root.findLayer(layer.id())
    group = root.insertGroup(0, source.title() or os.path.basename(folder))
    for child in source.layerTreeRoot().children():
        _copy(child, group, layer, project)
    if alone is not None and alone.parent() is not None:
        alone.parent().removeChildNode(alone)
    _show()
    _set_time(source, project)


def _show() -> None:
    """The map canvas, where there is one, does not follow a whole group by itself."""
    from qgis.utils import iface
    if iface is not None and iface.layerTreeCanvasBridge() is not None:
        iface.layerTreeCanvasBridge().setCanvasLayers()


def _copy(node, target: QgsLayerTreeGroup, loaded: QgsMapLayer, project: QgsProject) -> None:
    if isinstance(node, QgsLayerTreeGroup):
        group = target.addGroup(node.name())
        for child in node.children():
            _copy(child, group, loaded, project)
        copied = group
    else:
        layer = node.layer()
        if layer is None:
            return
        if os.path.realpath(layer.source()) == os.path.realpath(loaded.source()):
            own = loaded
            own.setName(layer.name())
        else:
            own = layer.clone()
            project.addMapLayer(own, False)
        # A clone has no times, and Processing has given the loaded layer its own style.
        style = QDomDocument()
        layer.exportNamedStyle(style)
        own.importNamedStyle(style)
        own.triggerRepaint()
        copied = target.addChildNode(QgsLayerTreeLayer(own)) or target.findLayer(own.id())
    copied.setItemVisibilityChecked(node.itemVisibilityChecked())
    copied.setExpanded(node.isExpanded())


def _set_time(source: QgsProject, project: QgsProject) -> None:
    """The project's time and, where there is a map, the temporal controller: the frames' span, in steps of a frame."""
    span = source.timeSettings().temporalRange()
    if not span.begin().isValid():
        return
    project.timeSettings().setTemporalRange(span)
    from qgis.utils import iface
    if iface is None or iface.mapCanvas() is None:
        return
    controller = iface.mapCanvas().temporalController()
    if not isinstance(controller, QgsTemporalNavigationObject):
        return
    step = _step(source)
    controller.setNavigationMode(QgsTemporalNavigationObject.Animated)
    controller.setTemporalExtents(span)
    if step > 0:
        controller.setFrameDuration(QgsInterval(step))
    controller.rewindToStart()


def _step(source: QgsProject) -> float:
    """The step [s] of the project's controller, which a project of frana has in milliseconds."""
    return (source.timeSettings().timeStep() or 0) / 1000
