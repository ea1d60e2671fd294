# SPDX-License-Identifier: Apache-2.0
"""A scene file from layers, for the terminal, for a study, or to keep."""
from __future__ import annotations

import os
from typing import Any

from qgis.core import (QgsProcessingContext, QgsProcessingFeedback, QgsProcessingOutputFolder,
                       QgsProcessingParameterFileDestination)

from ..inputs import inputs_folder, write_scene
from ..process import run_or_refuse
from ..translation import tr
from .scene_algorithm import SceneAlgorithm


class NewSceneAlgorithm(SceneAlgorithm):
    COMMAND = "check"
    NAME = "newscene"
    TITLE = "New scene from layers"
    GROUP = "Scenes"
    HELP = ("Writes a scene file with the values of the fields, and the layers as files beside it: one folder, which "
            "can be run, checked and calibrated here or in a terminal, also on another machine if the terrain is copied too.")
    TAKES_SCENE_FILE = False

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:  # noqa: N802
        self.add_scene()
        self.addParameter(QgsProcessingParameterFileDestination("OUTPUT", "Scene file", tr("Scene (*.ini)")))
        self.addOutput(QgsProcessingOutputFolder("FOLDER", "Folder of the scene and its layers"))

    def processAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext,  # noqa: N802
                         feedback: QgsProcessingFeedback) -> dict[str, Any]:
        path = os.path.abspath(self.parameterAsFileOutput(parameters, "OUTPUT", context))
        stem, ending = os.path.splitext(os.path.basename(path))
        folder = os.path.dirname(path)
        os.makedirs(folder, exist_ok=True)
        write_scene(folder, self.given, f"{self.TITLE}, from QGIS", stem + ending, inputs_folder(stem))
        run_or_refuse([self.program.path, "check", path], feedback, self.fields, self.NAMES)
        return {"OUTPUT": path, "FOLDER": folder}
