# SPDX-License-Identifier: Apache-2.0
"""Algorithms of many runs: their file, its sections from the tables of a dialogue, its check."""
from __future__ import annotations

import os
from typing import Any

from qgis.core import (QgsProcessingException, QgsProcessingFeedback, QgsProcessingParameterFile,
                       QgsProcessingParameterMatrix)

from ..fields import Values
from ..inputs import inputs_folder, make_folder, settings, write_scene
from ..keys import Key
from ..outputs import Output, collect
from ..process import run_or_refuse
from ..translation import tr
from ..wsl import inside
from .scene_algorithm import SceneAlgorithm


def table(name: str, label: str, columns: list[str], text: str) -> QgsProcessingParameterMatrix:
    parameter = QgsProcessingParameterMatrix(name, label, 1, False, columns, None, True)
    parameter.setHelp(text)
    return parameter


def vary_parameter() -> QgsProcessingParameterMatrix:
    return table("VARY", "Uncertain values: key and distribution", ["Key", "Distribution"],
                 "One row for each uncertain key, for example material.friction-angle and uniform(10, 20). "
                 "Distributions: uniform(a, b), log-uniform(a, b), normal(m, s), log-normal(m, s), "
                 "triangular(a, c, b), choice(v: w, ...); of terrain.error: gaussian-field(deviation, range).")


def rows(values: Values, name: str, title: str) -> list[tuple[str, str]]:
    """The rows of a matrix of two columns; empty ones are left out."""
    cells: list[Any] = values.algorithm.parameterAsMatrix(values.parameters, name, values.context) if values.has(name) else []
    texts = ["" if cell is None else str(cell).strip() for cell in cells]
    pairs = [pair for pair in zip(texts[0::2], texts[1::2]) if any(pair)]
    for key, text in pairs:
        if not key or not text:
            raise QgsProcessingException(tr("{0}: a row has only one of its two cells ({1}). Fill the other one, or "
                                            "remove the row", tr(title), key or text))
    return pairs


def by_key(values: Values, keys: list[Key], name: str, title: str) -> list[tuple[str, str]]:
    """Key and text; a key may also be written as the dialogue's field shows it ("Material: Density")."""
    titles = {text.lower(): key.name for key in keys for text in (key.title(), f"{key.section_title}: {key.short_title()}")}
    return [(titles.get(key.lower(), key), text) for key, text in rows(values, name, title)]


def section(name: str, entries: list[tuple[str, str]]) -> list[str]:
    return ["", f"[{name}]", *(f"{key} = {text}" for key, text in entries)] if entries else []


class StudyAlgorithm(SceneAlgorithm):
    """The dialogue is a scene and what is done with it, or a file that says both."""

    FILE = "Study file, instead of the fields"

    def add_file(self) -> None:
        self.add_advanced(QgsProcessingParameterFile("STUDY", self.FILE, QgsProcessingParameterFile.File, "ini", None, True),
                          "A file of frana. The fields do not count then.")

    def sections(self, values: Values, folder: str) -> list[str]:
        """The file's lines; what it names is written into the folder. Throws QgsProcessingException."""
        raise NotImplementedError

    def scene(self, values: Values, folder: str) -> tuple[str, list[str]]:
        """Writes the scene; returns its name for a file in the folder, and the lines of its changes."""
        if values.has("SCENE"):
            return inside(os.path.abspath(values.text("SCENE"))), section("set", settings(folder, self.given))
        return os.path.basename(write_scene(folder, self.given, f"{self.TITLE}, from QGIS", self.scene_name(folder))), []

    def study(self, values: Values, folder: str) -> str:
        """Writes the file unless one is given; returns its path."""
        if values.has("STUDY"):
            return os.path.abspath(values.text("STUDY"))
        make_folder(folder)
        lines = self.sections(values, folder)
        stem = os.path.splitext(self.scene_name(folder))[0]
        path = os.path.join(folder, f"{stem}-{self.COMMAND}.ini")
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join([f"# {self.TITLE}, from QGIS.", *lines]) + "\n")
        return path

    def words_of_check(self, values: Values, folder: str) -> list[str]:
        return [self.study(values, folder)]

    def compute(self, values: Values, feedback: QgsProcessingFeedback, outputs: tuple[Output, ...]) -> dict[str, Any]:
        """Runs it and returns the results."""
        folder = values.path("OUTPUT")
        study = self.study(values, inputs_folder(folder))
        done = run_or_refuse([self.program.path, self.COMMAND, study, "--out", folder, *self.options(values)], feedback,
                             self.fields, self.NAMES, self.resume_hint(folder))
        feedback.pushConsoleInfo(done.output)
        return {"OUTPUT": folder, **collect(folder, outputs)}
