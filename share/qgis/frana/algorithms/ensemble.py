# SPDX-License-Identifier: Apache-2.0
"""frana ensemble."""
from __future__ import annotations

import os
from typing import Any

from qgis.core import (QgsProcessingContext, QgsProcessingException, QgsProcessingFeedback,
                       QgsProcessingOutputRasterLayer, QgsProcessingParameterEnum, QgsProcessingParameterFile,
                       QgsProcessingParameterNumber)

from ..fields import Values, number_parameter, number_text
from ..inputs import inputs_folder, settings, write_scene
from ..loading import load_result
from ..messages import problems_of
from ..outputs import ENSEMBLE, collect, declare
from ..process import run_or_refuse, run_program
from .scene_algorithm import SceneAlgorithm
from .study_text import section, varied, vary_parameter

_SAMPLINGS = ["sobol", "latin-hypercube", "random", "grid", "saltelli"]


class EnsembleAlgorithm(SceneAlgorithm):
    COMMAND = NAME = "ensemble"
    TITLE = "Give a range: many runs with uncertain values"
    GROUP = "Many runs"
    HELP = ("Runs the scene many times with values drawn from the ranges that you state, and tells how likely each place is to be "
            "reached: probabilities with their intervals, quantiles of depth and speed, sensitivities.\n\n"
            "Give the scene and at least one uncertain value, or a study file.")
    TAGS = ("probability", "uncertainty", "sensitivity", "monte carlo")
    NAMES = {**SceneAlgorithm.NAMES, "vary": "Uncertain values", "study": "Study"}

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:  # noqa: N802
        self.addParameter(vary_parameter())
        self.addParameter(number_parameter("SAMPLES", "Number of runs", (2, 1_000_000), True, 100))
        self.add_scene()
        self.addParameter(QgsProcessingParameterFile("STUDY", "Study file, instead of scene and uncertain values",
                                                     QgsProcessingParameterFile.File, "ini", None, True))
        self.add_advanced(QgsProcessingParameterEnum("SAMPLING", "Study: sampling (otherwise sobol)", _SAMPLINGS, False, None,
                                                     True, True), "How the values of the runs are drawn.")
        self.add_advanced(QgsProcessingParameterNumber("SEED", "Study: seed (otherwise 1)",
                                                       QgsProcessingParameterNumber.Integer, None, True, 0, 2147483647),
                          "The same seed gives the same runs.")
        self.add_advanced(number_parameter("UNTIL", "Study: standard error at which no more runs are made", (0, 0.5)),
                          "The number of runs is then the most.")
        self.add_advanced(number_parameter("LEVELS", "Study: number of cell sizes (multilevel)", (2, 6), True),
                          "Many runs on coarse cells, few on the scene's own.")
        self.add_threads()
        self.add_resume()
        self.add_overwrite()
        self.add_load()
        self.add_result_folder()
        self.addOutput(QgsProcessingOutputRasterLayer("PROBABILITY",
                                                      "Probability of the least of the depth thresholds, and margin"))
        declare(self, ENSEMBLE)

    def study(self, values: Values, folder: str) -> str:
        """Writes study and scene unless a study file is given; returns its path."""
        if values.has("STUDY"):
            return os.path.abspath(values.text("STUDY"))
        if values.has("SCENE"):
            scene, changed = os.path.abspath(values.text("SCENE")), settings(folder, self.given)
        else:
            scene, changed = os.path.basename(write_scene(folder, self.given, f"{self.TITLE}, from QGIS",
                                                          self.scene_name(folder))), []
        pairs = varied(values, self.program.keys)
        if not pairs:
            raise QgsProcessingException("Uncertain values: no row is given. Add a key and its distribution, or a study file")
        entries = [("scene", scene), ("samples", str(values.whole("SAMPLES"))),
                   ("sampling", values.word("SAMPLING") or _SAMPLINGS[0]),
                   ("seed", str(values.whole("SEED") if values.has("SEED") else 1))]
        entries += [("until", number_text(values.number("UNTIL")))] if values.has("UNTIL") else []
        entries += [("levels", str(values.whole("LEVELS")))] if values.has("LEVELS") else []
        path = os.path.join(folder, os.path.splitext(os.path.basename(scene))[0] + "-study.ini")
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(["# A study from QGIS.", *section("study", entries), *section("set", changed),
                                  *section("vary", pairs)]) + "\n")
        return path

    def problems(self, values: Values, folder: str) -> list[str]:
        words = [self.program.path, "check", self.study(values, folder)]
        done = run_program(words, QgsProcessingFeedback(False))
        if done.code == 0:
            return []
        found = problems_of(done.lines, self.fields, self.NAMES) or [f"frana check ended with exit code {done.code}"]
        return [problem.replace(folder + os.sep, "") for problem in found]

    def processAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext,  # noqa: N802
                         feedback: QgsProcessingFeedback) -> dict[str, Any]:
        values = self.values(parameters, context)
        folder = values.path("OUTPUT")
        study = self.study(values, inputs_folder(folder))
        run_or_refuse([self.program.path, "ensemble", study, "--out", folder, *self.options(values)], feedback, self.fields,
                      self.NAMES, self.resume_hint(folder))
        found = {"OUTPUT": folder, **collect(folder, ENSEMBLE)}
        first = least_threshold(folder)
        if first:
            found["PROBABILITY"] = first
            if values.is_on("LOAD"):
                load_result(folder, first, context)
        return found


def least_threshold(folder: str) -> str:
    """The raster of probability of the least depth threshold; empty if there is none."""
    prefix = "probability_depth_"
    names = [name for name in os.listdir(folder) if name.startswith(prefix) and name.endswith(".tif")]
    names.sort(key=lambda name: float(name[len(prefix):-len(".tif")]))
    return os.path.join(folder, names[0]) if names else ""
