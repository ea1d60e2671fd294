# SPDX-License-Identifier: Apache-2.0
"""Algorithms whose dialogue is a scene: the keys as fields, or a scene file, or a file with some keys changed."""
from __future__ import annotations

import configparser
import os
import re
import tempfile
from typing import Any

from qgis.core import (QgsProcessingContext, QgsProcessingException, QgsProcessingFeedback,
                       QgsProcessingParameterDefinition, QgsProcessingParameterEnum, QgsProcessingParameterFile)
from qgis.PyQt.QtWidgets import QWidget

from ..fields import Field, Values, fields_of
from ..inputs import Given, result_of, settings, write_scene
from ..messages import problems_of
from ..processes import COUNTRIES, PROCESSES, implied
from ..process import run_program
from ..translation import tr
from .base import FranaAlgorithm


class SceneAlgorithm(FranaAlgorithm):
    TAKES_SCENE_FILE = True
    NOT_FIRST: tuple[str, ...] = ()  # keys whose fields this dialogue hides

    def __init__(self, program) -> None:
        super().__init__(program)
        self.fields: list[Field] = fields_of(program.keys, program.presets)
        self.given: Given | None = None

    def add_scene(self) -> None:
        """Process and country, the fields of the keys that matter most, the others under the advanced parameters."""
        for name, label, words, text in (
                ("PROCESS", "Process", PROCESSES, "Decides the preset with its density and friction, and the longest "
                 "simulated time; for an avalanche with a return period also the friction table. A field of yours counts more."),
                ("COUNTRY", "Country", COUNTRIES, "Decides, with the process, the scheme of intensity classes.")):
            choice = QgsProcessingParameterEnum(name, label, list(words), False, None, True, True)
            choice.setHelp(text)
            self.addParameter(choice)
        for field in self.fields:
            for parameter in field.parameters(self.is_first(field)):
                self.addParameter(parameter)
        if self.TAKES_SCENE_FILE:
            self.add_advanced(QgsProcessingParameterFile(
                "SCENE", "Scene file, instead of the fields or to change some of its values", QgsProcessingParameterFile.File,
                "ini", None, True), "A scene file of frana. Fields that are given replace its values; a box to tick does so "
                "where it differs from its default.")

    def is_first(self, field: Field) -> bool:
        """Whether the dialogue does not hide a field."""
        name = field.key.name
        return field.key.place is not None and name not in self.NOT_FIRST

    def createCustomParametersWidget(self, parent: QWidget | None) -> QWidget:  # noqa: N802
        from ..dialogue import dialogue_by_sections  # needs a window
        return dialogue_by_sections(self, parent)

    def field_of(self, parameter: str) -> Field | None:
        return next((one for one in self.fields if parameter in one.names), None)

    def is_own(self, parameter: QgsProcessingParameterDefinition) -> bool:
        return self.field_of(parameter.name()) is None

    def title_of(self, parameter: QgsProcessingParameterDefinition) -> str:
        field = self.field_of(parameter.name())
        return field.key.title() if field else super().title_of(parameter)

    def prepareAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext,  # noqa: N802
                         feedback: QgsProcessingFeedback) -> bool:
        # In the main thread, where layers of the project may be read.
        values = self.values(parameters, context)
        self.given = Given(self.fields, values, self.implied(values))
        return True

    def implied(self, values: Values) -> dict[str, str]:
        """Texts of keys by process and country, of those keys that the program has."""
        words = [values.word(name) if values.has(name) else "" for name in ("PROCESS", "COUNTRY")]
        return implied(*words, self.has_return_period(values))

    def has_return_period(self, values: Values) -> bool:
        return values.has("material_return_period")

    def scene_words(self, values: Values, folder: str, feedback: QgsProcessingFeedback | None = None) -> list[str]:
        """Writes the inputs into the folder; returns the scene's path and the --set words."""
        if not self.TAKES_SCENE_FILE or not values.has("SCENE"):
            return [write_scene(folder, self.given, f"{self.TITLE}, from QGIS", self.scene_name(folder))]
        words = [os.path.abspath(values.text("SCENE"))]
        changed = settings(folder, self.given)
        for name, text in changed:
            words += ["--set", f"{name}={text}"]
        if feedback is not None:
            self._tell_switches(words[0], {name for name, _ in changed}, feedback)
        return words

    def scene_name(self, folder: str) -> str:
        """The name of the scene, which its maps show: the result's, or the release layer's if the result is temporary."""
        result = result_of(folder)
        if result in ("", "OUTPUT"):
            layer = self.given.layer_of("release.perimeter") if self.given else None
            result = layer.name if layer else ""
        return (re.sub(r"[^\w. -]", "_", result).strip(" .") or "scene") + ".ini"

    def _tell_switches(self, scene: str, changed: set[str], feedback: QgsProcessingFeedback) -> None:
        """Boxes show defaults; the file may say otherwise, and then it counts."""
        text = configparser.RawConfigParser(strict=False, delimiters=("=",), comment_prefixes=("#",),
                                            inline_comment_prefixes=("#",))
        try:
            text.read(scene, encoding="utf-8")
        except (OSError, ValueError, configparser.Error):
            return  # the program says what is wrong with it
        for field in self.fields:
            key = field.key
            if not field.is_switch or key.name in changed or not text.has_option(key.section, key.key):
                continue
            value = text.get(key.section, key.key)
            if value != key.default:
                feedback.pushInfo(tr("{0}: {1}, as in the scene file", key.title(), value))

    def checkParameterValues(self, parameters: dict[str, Any],  # noqa: N802
                             context: QgsProcessingContext) -> tuple[bool, str]:
        """The program's own check, before anything runs; each problem names its field. QGIS's check, which names a
        parameter only, comes after it."""
        if written := self.written_problems(parameters):
            return False, "\n".join(written)
        values = self.values(parameters, context)
        try:
            with tempfile.TemporaryDirectory(prefix="frana_check_") as folder:
                self.given = Given(self.fields, values, self.implied(values))
                problems = self.problems(values, folder)
        except QgsProcessingException as error:
            return False, str(error)
        finally:
            self.given = None
        return (False, "\n".join(problems)) if problems else super().checkParameterValues(parameters, context)

    def words_of_check(self, values: Values, folder: str) -> list[str]:
        return self.scene_words(values, folder)

    def problems(self, values: Values, folder: str) -> list[str]:
        """Of the scene; written into a temporary folder."""
        words = [self.program.path, "check", *self.words_of_check(values, folder)]
        done = run_program(words, QgsProcessingFeedback(False))
        if done.code == 0:
            return []
        found = problems_of(done.lines, self.fields, self.NAMES) or [tr("{0} ended with exit code {1}", "frana check", done.code)]
        return [problem.replace(folder + os.sep, "") for problem in found]
