# SPDX-License-Identifier: Apache-2.0
"""frana check."""
from __future__ import annotations

import os
import tempfile
from typing import Any

from qgis.core import (QgsProcessingContext, QgsProcessingFeedback, QgsProcessingOutputNumber,
                       QgsProcessingOutputString, QgsProcessingParameterFileDestination)

from ..process import run_or_refuse
from ..translation import tr
from .scene_algorithm import SceneAlgorithm


class CheckAlgorithm(SceneAlgorithm):
    COMMAND = NAME = "check"
    TITLE = "Check a scene"
    GROUP = "One run"
    HELP = ("Reads everything that a run would read and tells what it would compute: CRS of every layer and the accuracy of the "
            "transformation, extents, released volume, cells, particles, memory and time. Nothing is computed.\n\n"
            "Problems are listed with the field that they concern.")

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:  # noqa: N802
        self.add_scene()
        self.add_threads()
        self.addParameter(QgsProcessingParameterFileDestination("OUTPUT", "Report of the check", tr("Text (*.txt)"), None, True))
        self.addOutput(QgsProcessingOutputString("TEXT", "Report as text"))
        self.addOutput(QgsProcessingOutputString("WARNINGS", "Warnings"))
        self.addOutput(QgsProcessingOutputNumber("WARNING_COUNT", "Number of warnings"))

    def processAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext,  # noqa: N802
                         feedback: QgsProcessingFeedback) -> dict[str, Any]:
        values = self.values(parameters, context)
        with tempfile.TemporaryDirectory(prefix="frana_check_") as folder:
            scene = self.scene_words(values, folder, feedback)
            done = run_or_refuse([self.program.path, "check", *scene, *self.options(values)], feedback, self.fields, self.NAMES)
            text = done.output.replace(folder + os.sep, "")
        # A check has no folder of a result.
        text = "".join(line for line in text.splitlines(True) if not line.startswith("  result "))
        feedback.pushConsoleInfo(text)
        found = {"TEXT": text, "WARNINGS": "\n".join(done.warnings), "WARNING_COUNT": len(done.warnings)}
        page = self.parameterAsFileOutput(parameters, "OUTPUT", context)
        if page:
            with open(page, "w", encoding="utf-8") as file:
                file.write("".join(tr("Warning: {0}", warning) + "\n" for warning in done.warnings) + text)
            found["OUTPUT"] = page
        return found
