# SPDX-License-Identifier: Apache-2.0
"""frana converge."""
from __future__ import annotations

import os
from typing import Any

from qgis.core import QgsProcessingContext, QgsProcessingFeedback, QgsProcessingParameterNumber

from ..inputs import inputs_folder
from ..loading import load_layer
from ..outputs import CONVERGE, collect, declare
from ..process import run_or_refuse
from ..translation import tr
from .scene_algorithm import SceneAlgorithm


class ConvergeAlgorithm(SceneAlgorithm):
    COMMAND = NAME = "converge"
    TITLE = "Estimate the error of the cell size"
    GROUP = "One run"
    HELP = ("Computes the scene at several resolutions, the scene's own being the finest, and estimates the error of the finest: "
            "of depth, velocity, area and run-out, and of the depth in each cell.")
    TAGS = ("convergence", "accuracy", "resolution")

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:  # noqa: N802
        self.add_scene()
        self.addParameter(QgsProcessingParameterNumber("LEVELS", "Number of resolutions",
                                                       QgsProcessingParameterNumber.Integer, 3, False, 3, 6))
        self.add_threads()
        self.add_overwrite()
        self.add_load()
        self.add_result_folder("Folder of the study")
        declare(self, CONVERGE)

    def processAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext,  # noqa: N802
                         feedback: QgsProcessingFeedback) -> dict[str, Any]:
        values = self.values(parameters, context)
        folder = values.path("OUTPUT")
        scene = self.scene_words(values, inputs_folder(folder), feedback)
        done = run_or_refuse([self.program.path, "converge", *scene, "--out", folder, "--levels",
                              str(values.whole("LEVELS")), *self.options(values)], feedback, self.fields, self.NAMES)
        feedback.pushConsoleInfo(done.output)
        if values.is_on("LOAD"):
            load_layer(os.path.join(folder, "uncertainty.tif"), tr("Estimated error of the depth"), context)
        return {"OUTPUT": folder, **collect(folder, CONVERGE)}
