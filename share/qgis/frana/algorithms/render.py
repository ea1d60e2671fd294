# SPDX-License-Identifier: Apache-2.0
"""frana render."""
from __future__ import annotations

import os
from typing import Any

from qgis.core import (QgsProcessingContext, QgsProcessingFeedback, QgsProcessingOutputNumber,
                       QgsProcessingOutputString, QgsProcessingParameterEnum, QgsProcessingParameterFile,
                       QgsProcessingParameterFileDestination, QgsProcessingParameterFolderDestination,
                       QgsProcessingParameterRasterLayer, QgsProcessingParameterString)

from ..inputs import inputs_folder
from ..process import run_or_refuse
from ..translation import tr
from .base import FranaAlgorithm

_TEXTS = (("MAPS", "--map", "Rasters to draw, separated by commas (otherwise all)",
           "For example max_depth, max_velocity; depth@12.5 is the frame nearest to 12.5 s."),
          ("SIZE", "--size", "Size (otherwise the scene's)",
           "auto, WIDTHxHEIGHT in pixels, or A4, A3, A4-portrait, A4-landscape, with @DPI: A4@300."),
          ("TITLE", "--title", "Title of the maps (otherwise the scene's)", "A text."),
          ("ATTRIBUTION", "--attribution", "Sources of the data and author, at the foot", "A text."),
          ("CAMERA", "--camera", "Camera of 3-D views: azimuth, elevation[, zoom]", "For example 220, 35."))


class RenderAlgorithm(FranaAlgorithm):
    COMMAND = NAME = "render"
    TITLE = "Draw maps, views or an animation of a result"
    GROUP = "One run"
    HELP = "Draws the maps, charts, 3-D views or the animation of a result again, in another size, format or style."
    TAGS = ("map", "pdf", "animation", "3d")
    NAMES = {"RESULT_DIR": "Folder of the result", "map": "Rasters to draw", "--size": "Size", "--camera": "Camera",
             "background": "Background", "--background": "Background", "--animation": "Animation",
             "--out": "Folder of the pictures"}

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:  # noqa: N802
        self.addParameter(QgsProcessingParameterFile("RESULT", "Folder of the result", QgsProcessingParameterFile.Folder))
        for name, _, label, text in _TEXTS:
            parameter = QgsProcessingParameterString(name, label, None, False, True)
            parameter.setHelp(text)
            self.addParameter(parameter)
        self.addParameter(QgsProcessingParameterEnum("VIEW", "View", ["2d", "3d"], False, "2d", True, True))
        self.addParameter(QgsProcessingParameterEnum("FORMATS", "Formats (otherwise png)", ["png", "pdf", "svg"], True,
                                                     None, True, True))
        self.addParameter(QgsProcessingParameterEnum("KIND", "What to draw", ["maps", "charts"], False, "maps",
                                                     True, True))
        self.addParameter(QgsProcessingParameterRasterLayer("BACKGROUND", "Orthophoto or topographic map under the result",
                                                            None, True))
        self.addParameter(QgsProcessingParameterFileDestination("ANIMATION", "Animation, instead of maps",
                                                                "MP4 (*.mp4);;GIF (*.gif)", None, True, False))
        self.addParameter(QgsProcessingParameterFolderDestination("OUTPUT", "Folder of the pictures (otherwise the result's)",
                                                                  None, True, False))
        self.addOutput(QgsProcessingOutputString("FILES", "Files, one a line"))
        self.addOutput(QgsProcessingOutputNumber("COUNT", "Number of files"))

    def prepareAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext,  # noqa: N802
                         feedback: QgsProcessingFeedback) -> bool:
        values = self.values(parameters, context)
        self.background = values.raster("BACKGROUND", tr("Background")) if values.has("BACKGROUND") else None
        return True

    def processAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext,  # noqa: N802
                         feedback: QgsProcessingFeedback) -> dict[str, Any]:
        values = self.values(parameters, context)
        result = values.text("RESULT")
        words = [self.program.path, "render", result]
        for name, option, _, _ in _TEXTS:
            if values.has(name):
                parts = values.text(name).split(",") if name == "MAPS" else [values.text(name)]
                for part in parts:
                    words += [option, part.strip()]
        if values.word("VIEW") == "3d":
            words += ["--view", "3d"]
        if values.word("KIND") == "charts":
            words.append("--charts")
        for word in values.words("FORMATS") if values.has("FORMATS") else []:
            words += ["--format", word]
        if self.background is not None:
            inputs = inputs_folder(result)
            words += ["--background", os.path.join(inputs, self.background.write(inputs, "background"))]
        animation = self.parameterAsFileOutput(parameters, "ANIMATION", context) if values.has("ANIMATION") else ""
        folder = values.path("OUTPUT")
        if animation:
            words += ["--animation", animation]
        elif folder:
            words += ["--out", folder]
        files = run_or_refuse(words, feedback, [], self.NAMES).output.splitlines()
        found = {"OUTPUT": folder or (os.path.dirname(files[0]) if files else result), "FILES": "\n".join(files),
                 "COUNT": len(files)}
        return {**found, "ANIMATION": animation} if animation else found
