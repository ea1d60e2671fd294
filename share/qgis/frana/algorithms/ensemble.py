# SPDX-License-Identifier: Apache-2.0
"""frana ensemble."""
from __future__ import annotations

import os
from typing import Any

from qgis.core import (QgsProcessingContext, QgsProcessingException, QgsProcessingFeedback,
                       QgsProcessingOutputRasterLayer, QgsProcessingParameterEnum, QgsProcessingParameterString)

from ..fields import Values, number_parameter, number_text
from ..loading import load_result
from ..outputs import ENSEMBLE, declare
from ..translation import tr
from .study import StudyAlgorithm, by_key, section, vary_parameter

_SAMPLINGS = ["sobol", "random", "importance", "morris"]


class EnsembleAlgorithm(StudyAlgorithm):
    COMMAND = NAME = "ensemble"
    TITLE = "Give a range: many runs with uncertain values"
    GROUP = "Many runs"
    HELP = ("Runs the scene many times with values drawn from the ranges that you state, and tells how likely each place is to be "
            "reached: probabilities with their intervals, quantiles of depth and speed, sensitivities.\n\n"
            "Give the scene and at least one uncertain value, or a study file.")
    TAGS = ("probability", "uncertainty", "sensitivity", "monte carlo")
    NAMES = {**StudyAlgorithm.NAMES, "vary": "Uncertain values", "study": "Study"}

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:  # noqa: N802
        self.addParameter(vary_parameter())
        self.addParameter(number_parameter("SAMPLES", "Number of runs", (2, 1_000_000), True, 100))
        self.add_scene()
        self.add_file()
        self.add_advanced(QgsProcessingParameterEnum("SAMPLING", "Sampling (sobol)", _SAMPLINGS, False, None,
                                                     True, True), "How the values of the runs are drawn.")
        self.add_advanced(QgsProcessingParameterString("RARE_PLACE", "Gauge that few runs reach", None, False, True),
                          "With the sampling importance: half of the runs are drawn near what makes the flow come there.")
        self.add_seed()
        self.add_advanced(number_parameter("UNTIL", "Standard error at which no more runs are made", (0, 0.5)),
                          "The number of runs is then the most.")
        self.add_threads()
        self.add_resume()
        self.add_overwrite()
        self.add_load()
        self.add_result_folder()
        self.addOutput(QgsProcessingOutputRasterLayer("PROBABILITY",
                                                      "Probability of the least of the depth thresholds, and margin"))
        declare(self, ENSEMBLE)

    def sections(self, values: Values, folder: str) -> list[str]:
        scene, changed = self.scene(values, folder)
        pairs = by_key(values, self.program.keys, "VARY", "Uncertain values")
        if not pairs:
            raise QgsProcessingException(tr("Uncertain values: no row is given. Add a key and its distribution, or a "
                                            "study file"))
        entries = [("scene", scene), ("samples", str(values.whole("SAMPLES")))]
        entries += [("sampling", values.word("SAMPLING"))] if values.has("SAMPLING") else []
        entries += [("rare-place", values.text("RARE_PLACE"))] if values.has("RARE_PLACE") else []
        entries += [("seed", str(values.whole("SEED")))] if values.has("SEED") else []
        entries += [("until", number_text(values.number("UNTIL")))] if values.has("UNTIL") else []
        return [*section("study", entries), *changed, *section("vary", pairs)]

    def processAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext,  # noqa: N802
                         feedback: QgsProcessingFeedback) -> dict[str, Any]:
        values = self.values(parameters, context)
        found = self.compute(values, feedback, ENSEMBLE)
        folder = found["OUTPUT"]
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
