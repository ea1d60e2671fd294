# SPDX-License-Identifier: Apache-2.0
"""frana run."""
from __future__ import annotations

import os
from typing import Any

from qgis.core import QgsProcessingContext, QgsProcessingFeedback

from ..inputs import inputs_folder
from ..loading import load_result
from ..outputs import RUN, collect, declare
from ..process import run_or_refuse
from .scene_algorithm import SceneAlgorithm


class RunAlgorithm(SceneAlgorithm):
    COMMAND = NAME = "run"
    TITLE = "Run a scene"
    GROUP = "One run"
    HELP = ("Computes how far, how deep and how fast a slope that fails flows: rasters of the greatest depth, speed and "
            "pressure, of arrival time and final depth, outlines, maps, a report and frames over time.\n\n"
            "Needed are a terrain, a release area with its thickness, and a material: a preset, or a friction. A field that is "
            "left empty takes the value in brackets.\n\n"
            "Layers may be in any CRS. What went in is kept in a folder beside the result, FOLDER-inputs.\n\n"
            "Cancel stops the run and keeps what it has; the same values with “Resume a stopped run” continue it.")
    TAGS = ("debris flow", "avalanche", "mudflow", "hazard")

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:  # noqa: N802
        self.add_scene()
        self.add_threads()
        self.add_resume()
        self.add_overwrite()
        self.add_load()
        self.add_result_folder()
        declare(self, RUN)

    def processAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext,  # noqa: N802
                         feedback: QgsProcessingFeedback) -> dict[str, Any]:
        values = self.values(parameters, context)
        folder = values.path("OUTPUT")
        scene = self.scene_words(values, inputs_folder(folder), feedback)
        run_or_refuse([self.program.path, "run", *scene, "--out", folder, *self.options(values)], feedback, self.fields,
                      self.NAMES, self.resume_hint(folder))
        found = {"OUTPUT": folder, **collect(folder, RUN)}
        if values.is_on("LOAD"):
            load_result(folder, os.path.join(folder, "max_depth.tif"), context)
        return found
