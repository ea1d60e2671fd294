# SPDX-License-Identifier: Apache-2.0
"""frana batch."""
from __future__ import annotations

import os
from typing import Any

from qgis.core import (QgsProcessingContext, QgsProcessingException, QgsProcessingFeedback, QgsProcessingParameterEnum,
                       QgsProcessingParameterField, QgsProcessingParameterString)

from ..fields import Values
from ..loading import load_result
from ..outputs import BATCH, declare
from ..translation import tr
from .study import StudyAlgorithm, by_key, rows, section, table

_KEEP = ["none", "failed", "all"]
# Of [region], and [columns]: the parameter, its label, its meaning.
_COLUMNS = (
    ("scenario", "SCENARIO", "Scenario, from a column", "Which of several events a polygon is; each value has maps of its own."),
    ("return-period", "RETURN_PERIOD", "Return period [years], from a column",
     "Of the event, one for each scenario: with it the degree of hazard is mapped."),
    ("name", "NAME", "Name of a slope, from a column", "It is carried into the tables."),
    ("group", "GROUP", "Group of a slope, from a column", "For example a valley; it is carried into the tables."),
    ("material.friction-coefficient", "FRICTION", "Friction coefficient, from a column", "In place of that of the preset."),
    ("material.turbulence", "TURBULENCE", "Turbulence [m/s2], from a column", "In place of that of the preset."),
)


def _years(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return float("inf")  # the program says what is wrong with it


class BatchAlgorithm(StudyAlgorithm):
    COMMAND = NAME = "batch"
    TITLE = "Run a region of many slopes"
    GROUP = "Many runs"
    HELP = ("Each polygon of the release area is a slope that fails alone. What any of them causes is united: greatest depth, speed and pressure, earliest arrival, number of slopes that reach a place; "
            "with a hazard scheme and return periods the degree of hazard; with exposed features what reaches each.\n\n"
            "Columns of the polygons give what differs from slope to slope.")
    TAGS = ("region", "hazard map", "indication map", "exposure")
    FILE = "Region file, instead of the fields"
    NOT_FIRST = ("observed.perimeter", "material.return-period")  # the return period is the scenario's
    NAMES = {**StudyAlgorithm.NAMES, "columns": "Other keys from columns",
             **{(name if "." in name else "region." + name): label for name, _, label, _ in _COLUMNS}}

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:  # noqa: N802
        self.add_scene()
        self.addParameter(table("SCENARIO_TABLE", "Scenarios: return period [years] and column", ["Years", "Column"],
                                "One row for each scenario, for example 30 and D30: every polygon fails in each of which its "
                                "column has a value. The return period is also that by which a friction table is read."))
        what = QgsProcessingParameterEnum("SCENARIO_KEY", "What the columns of the scenarios have (release.thickness)",
                                          self.scenario_keys(), False, None, True, True)
        what.setHelp("The key whose value is in these columns.")
        self.addParameter(what)
        for _, parameter, label, text in _COLUMNS:
            column = QgsProcessingParameterField(parameter, label, None, "release_perimeter", QgsProcessingParameterField.Any,
                                                 False, True)
            column.setHelp(text)
            self.addParameter(column)
        self.add_advanced(table("COLUMNS", "Other keys from columns: key and column", ["Key", "Column"], ""),
                          "One row for each key, for example material.density and RHO.")
        self.add_advanced(QgsProcessingParameterEnum("KEEP", "Slopes whose scene and maps are kept (none)", _KEEP, False, None,
                                                     True, True), "They are in the folder members of the result.")
        self.add_file()
        self.add_threads()
        self.add_resume()
        self.add_overwrite()
        self.add_load()
        self.add_result_folder()
        declare(self, BATCH)

    def has_return_period(self, values: Values) -> bool:
        return any(values.has(name) for name in ("SCENARIO_TABLE", "RETURN_PERIOD", "material_return_period"))

    def scenario_keys(self) -> list[str]:
        """Keys of the release that differ from scenario to scenario: those that a column may give."""
        return [key.name for key in self.program.keys if key.section == "release" and "attribute:NAME" in key.limits]

    def scenarios(self, values: Values) -> list[str]:
        """A section for each scenario, from the most frequent."""
        key = values.word("SCENARIO_KEY") if values.has("SCENARIO_KEY") else "release.thickness"
        found = sorted(rows(values, "SCENARIO_TABLE", "Scenarios: return period [years] and column"), key=lambda row: _years(row[0]))
        return [line for years, column in found for line in section(f"scenario {years}", [(key, column)])]

    def sections(self, values: Values, folder: str) -> list[str]:
        scene, changed = self.scene(values, folder)
        if not values.has("SCENE") and self.given.layer_of("release.perimeter") is None:
            raise QgsProcessingException(tr("Release area: is missing. Choose a layer of polygons, one for each slope"))
        given = [(name, values.column(parameter)) for name, parameter, _, _ in _COLUMNS if values.has(parameter)]
        region = [("scene", scene), *((name, column) for name, column in given if "." not in name)]
        region += [("keep", values.word("KEEP"))] if values.has("KEEP") else []
        columns = [pair for pair in given if "." in pair[0]]
        columns += by_key(values, self.program.keys, "COLUMNS", "Other keys from columns")
        return [*section("region", region), *changed, *section("columns", columns), *self.scenarios(values)]

    def processAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext,  # noqa: N802
                         feedback: QgsProcessingFeedback) -> dict[str, Any]:
        values = self.values(parameters, context)
        found = self.compute(values, feedback, BATCH)
        if values.is_on("LOAD"):
            load_result(found["OUTPUT"], os.path.join(found["OUTPUT"], "union_max_depth.tif"), context)
        return found
