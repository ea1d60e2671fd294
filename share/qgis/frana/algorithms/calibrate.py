# SPDX-License-Identifier: Apache-2.0
"""frana calibrate."""
from __future__ import annotations

import os
from typing import Any

from qgis.core import (QgsProcessing, QgsProcessingContext, QgsProcessingException, QgsProcessingFeedback,
                       QgsProcessingParameterFile, QgsProcessingParameterMultipleLayers)

from ..fields import Values, number_parameter
from ..inputs import inputs_folder, make_folder
from ..outputs import CALIBRATE, collect, declare
from ..process import run_or_refuse
from .base import FranaAlgorithm
from .study_text import objective_parameter, rows, section, varied, vary_parameter


class CalibrateAlgorithm(FranaAlgorithm):
    COMMAND = NAME = "calibrate"
    TITLE = "Calibrate on surveyed events"
    GROUP = "Many runs"
    HELP = ("Finds the values of uncertain keys that explain one or several surveyed events, and how uncertain they stay. Each "
            "scene has an observed outline; “New scene from layers” writes one. Give scenes and uncertain values, or a "
            "study file.")
    TAGS = ("back-calculation", "inverse")
    NAMES = {**FranaAlgorithm.NAMES, "vary": "Uncertain values", "objective": "Measures", "study": "Study"}

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:  # noqa: N802
        self.addParameter(QgsProcessingParameterMultipleLayers("SCENES", "Scenes of the events", QgsProcessing.TypeFile, None,
                                                               True))
        self.addParameter(vary_parameter())
        self.addParameter(objective_parameter())
        self.addParameter(number_parameter("SAMPLES", "First runs, on coarse cells", (2, 1_000_000), True, 200))
        self.addParameter(number_parameter("REFINE", "Runs on the scenes' own cells", (0, 1_000_000), True, 100))
        self.addParameter(QgsProcessingParameterFile("STUDY", "Study file, instead of the fields above",
                                                     QgsProcessingParameterFile.File, "ini", None, True))
        self.add_advanced(number_parameter("COARSE", "Coarse cells, in units of the scene's (otherwise 2)", (1, 16), True),
                          "1: the first runs are on the scenes' own cells.")
        self.add_advanced(number_parameter("SEED", "Seed (otherwise 1)", (0, 2147483647), True),
                          "The same seed gives the same runs.")
        self.add_threads()
        self.add_resume()
        self.add_overwrite()
        self.add_result_folder("Folder of the calibration")
        declare(self, CALIBRATE)

    def study(self, values: Values, folder: str) -> str:
        if values.has("STUDY"):
            return os.path.abspath(values.text("STUDY"))
        scenes = self.parameterAsFileList(values.parameters, "SCENES", values.context) if values.has("SCENES") else []
        if not scenes:
            raise QgsProcessingException("Scenes of the events: none is given. Add scene files, or a study file")
        entries = [("scene", ", ".join(os.path.abspath(scene) for scene in scenes)),
                   ("samples", str(values.whole("SAMPLES"))), ("refine", str(values.whole("REFINE")))]
        entries += [(name.lower(), str(values.whole(name))) for name in ("COARSE", "SEED") if values.has(name)]
        make_folder(folder)
        path = os.path.join(folder, "study.ini")
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(["# A calibration from QGIS.", *section("study", entries),
                                  *section("objective", rows(values, "OBJECTIVE", "Measures")),
                                  *section("vary", varied(values, self.program.keys))]) + "\n")
        return path

    def checkParameterValues(self, parameters: dict[str, Any],  # noqa: N802
                             context: QgsProcessingContext) -> tuple[bool, str]:
        good, message = super().checkParameterValues(parameters, context)
        values = self.values(parameters, context)
        if good and not values.has("STUDY"):
            needed = {"SCENES": "Scenes of the events", "OBJECTIVE": "Measures", "VARY": "Uncertain values"}
            missing = [f"{title}: none is given. Add one, or a study file"
                       for name, title in needed.items() if not values.has(name)]
            if missing:
                return False, "\n".join(missing)
        return good, message

    def processAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext,  # noqa: N802
                         feedback: QgsProcessingFeedback) -> dict[str, Any]:
        values = self.values(parameters, context)
        folder = values.path("OUTPUT")
        study = self.study(values, inputs_folder(folder))
        done = run_or_refuse([self.program.path, "calibrate", study, "--out", folder, *self.options(values)], feedback, [],
                             self.NAMES, self.resume_hint(folder))
        feedback.pushConsoleInfo(done.output)
        return {"OUTPUT": folder, **collect(folder, CALIBRATE)}
