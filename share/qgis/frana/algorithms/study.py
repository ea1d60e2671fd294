# SPDX-License-Identifier: Apache-2.0
"""Studies of many runs as text: the table of a dialogue as sections of a study file."""
from __future__ import annotations

from typing import Any

from qgis.core import QgsProcessingException, QgsProcessingParameterMatrix

from ..fields import Values
from ..keys import Key


def vary_parameter() -> QgsProcessingParameterMatrix:
    parameter = QgsProcessingParameterMatrix("VARY", "Uncertain values: key and distribution", 1, False,
                                             ["Key", "Distribution"], None, True)
    parameter.setHelp("One row for each uncertain key, for example material.friction-angle and uniform(10, 20). "
                      "Distributions: uniform(a, b), log-uniform(a, b), normal(m, s), log-normal(m, s), "
                      "triangular(a, c, b), choice(v: w, ...); of terrain.error: gaussian-field(deviation, range).")
    return parameter


def objective_parameter() -> QgsProcessingParameterMatrix:
    parameter = QgsProcessingParameterMatrix("OBJECTIVE", "Measures: name and weight", 1, False, ["Measure", "Weight"],
                                             None, True)
    parameter.setHelp("For example jaccard and 2, runout and 1; see “Calibration” in frana's documents.")
    return parameter


def rows(values: Values, name: str, title: str) -> list[tuple[str, str]]:
    """The rows of a matrix of two columns; empty ones are left out."""
    cells: list[Any] = values.algorithm.parameterAsMatrix(values.parameters, name, values.context) if values.has(name) else []
    texts = ["" if cell is None else str(cell).strip() for cell in cells]
    pairs = [pair for pair in zip(texts[0::2], texts[1::2]) if any(pair)]
    for key, text in pairs:
        if not key or not text:
            raise QgsProcessingException(f"{title}: a row has only one of its two cells ({key or text}). Fill the other one, "
                                         "or remove the row")
    return pairs


def varied(values: Values, keys: list[Key]) -> list[tuple[str, str]]:
    """Key and distribution; a key may also be written as the dialogue's field shows it ("Material: density")."""
    titles = {key.title().lower(): key.name for key in keys}
    return [(titles.get(key.lower(), key), text) for key, text in rows(values, "VARY", "Uncertain values")]


def section(name: str, entries: list[tuple[str, str]]) -> list[str]:
    return ["", f"[{name}]", *(f"{key} = {text}" for key, text in entries)] if entries else []
