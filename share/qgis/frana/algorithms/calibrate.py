# SPDX-License-Identifier: Apache-2.0
"""frana calibrate."""
from __future__ import annotations

import os
import re
from typing import Any

from qgis.core import (QgsProcessing, QgsProcessingContext, QgsProcessingException, QgsProcessingFeedback,
                       QgsProcessingParameterField, QgsProcessingParameterMultipleLayers)

from ..fields import Values, number_parameter, number_text
from ..inputs import settings, write_scene
from ..outputs import CALIBRATE, declare
from ..translation import tr
from ..wsl import inside
from .study import StudyAlgorithm, by_key, rows, section, table, vary_parameter

_RELEASE, _SURVEY = "release.perimeter", "observed.perimeter"


class CalibrateAlgorithm(StudyAlgorithm):
    COMMAND = NAME = "calibrate"
    TITLE = "Calibrate on surveyed events"
    GROUP = "Many runs"
    HELP = ("Finds the values of uncertain keys that explain one or several surveyed events, and how uncertain they stay.\n\n"
            "An event is a scene with its surveyed outline: the layers of the fields; or, with a column of the release "
            "polygons that names events, one for each of its values, with the outlines that have the same value; and scene "
            "files (“New scene from layers” writes one). Without a layer of the release area the other fields count for "
            "these, too.")
    TAGS = ("back-calculation", "inverse")
    TAKES_SCENE_FILE = False
    NOT_FIRST = ("output.exposure", "material.return-period")
    NAMES = {**StudyAlgorithm.NAMES, "vary": "Uncertain values", "objective": "Measures", "study": "Study"}

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:  # noqa: N802
        self.addParameter(vary_parameter())
        self.addParameter(table("OBJECTIVE", "Measures: name and weight", ["Measure", "Weight"],
                                "For example jaccard and 2, runout and 1; see “Calibration” in frana's documents."))
        self.add_scene()
        for name, label, key in (("EVENT", "Events: column of the release area", _RELEASE),
                                 ("SURVEYED_EVENT", "Events: column of the surveyed outline", _SURVEY)):
            column = QgsProcessingParameterField(name, label, None, key.replace(".", "_"), QgsProcessingParameterField.Any,
                                                 False, True)
            column.setHelp("Each value is an event of its own. Without a column the layers are one event.")
            self.addParameter(column)
        self.addParameter(QgsProcessingParameterMultipleLayers("SCENES", "Scene files of further events",
                                                               QgsProcessing.TypeFile, None, True))
        self.addParameter(number_parameter("SAMPLES", "Runs of each event at most", (2, 1_000_000), True, 200))
        self.add_seed()
        self.add_file()
        self.add_threads()
        self.add_resume()
        self.add_overwrite()
        self.add_result_folder("Folder of the calibration")
        declare(self, CALIBRATE)

    def events(self, values: Values, folder: str) -> list[tuple[str, str]]:
        """Writes the scenes of the layers; returns name and file of each."""
        release, survey = (self.given.layer_of(key) for key in (_RELEASE, _SURVEY))
        column = values.column("EVENT")
        if release is None or not column:
            return [] if release is None else [("layers", os.path.basename(
                write_scene(folder, self.given, f"{self.TITLE}, from QGIS", self.scene_name(folder))))]
        surveyed = values.column("SURVEYED_EVENT") or (column if survey is not None and survey.has(column) else "")
        if survey is not None and not surveyed:
            raise QgsProcessingException(tr("Events: column of the surveyed outline: is missing. Choose the one that has the "
                                            "event's value"))
        written: dict[str, str] = {}
        for value in release.values_of(column):
            label = number_text(value) if isinstance(value, float) else str(value)
            name = re.sub(r"[^A-Za-z0-9_-]+", "_", label)[:50].strip("_") or "event"
            while name in written:
                name += "_"
            text = "'" + value.replace("'", "''") + "'" if isinstance(value, str) else label
            filters = []
            for key, of_event in ((_RELEASE, column), (_SURVEY, surveyed)):
                if of_event:
                    own = self.given.text_of(key + "-filter")
                    filters.append((key + "-filter", (f"({own}) AND " if own else "") + f'"{of_event}" = {text}'))
            written[name] = os.path.basename(write_scene(folder, self.given, f"Event {label}, from QGIS", f"event-{name}.ini",
                                                         more=tuple(filters)))
        return list(written.items())

    def sections(self, values: Values, folder: str) -> list[str]:
        files = self.parameterAsFileList(values.parameters, "SCENES", values.context) if values.has("SCENES") else []
        events = self.events(values, folder)
        objective = rows(values, "OBJECTIVE", "Measures")
        vary = by_key(values, self.program.keys, "VARY", "Uncertain values")
        needed = ((events or files, tr("Events: none is given. Choose layers, or scene files, or a study file")),
                  (objective, tr("Measures: none is given. Add one, or a study file")),
                  (vary, tr("Uncertain values: none is given. Add one, or a study file")))
        missing = [sentence for there, sentence in needed if not there]
        if missing:
            raise QgsProcessingException("\n".join(missing))
        entries = [("samples", str(values.whole("SAMPLES")))]
        entries += [("seed", str(values.whole("SEED")))] if values.has("SEED") else []
        if files:
            entries.insert(0, ("scene", ", ".join(inside(os.path.abspath(file)) for file in files)))
        lines = section("study", entries)
        for name, scene in events:
            lines += section("event " + name, [("scene", scene)])
        if not events:
            lines += section("set", settings(folder, self.given))
        return [*lines, *section("objective", objective), *section("vary", vary)]

    def processAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext,  # noqa: N802
                         feedback: QgsProcessingFeedback) -> dict[str, Any]:
        return self.compute(self.values(parameters, context), feedback, CALIBRATE)
