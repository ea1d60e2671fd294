# SPDX-License-Identifier: Apache-2.0
"""Values given as text, from the command line, a script or a table of a batch. QGIS takes a text that is no number for 0
and any word for yes: here they are refused."""
from __future__ import annotations

import re
from typing import Any

from qgis.core import QgsProcessingParameterBoolean, QgsProcessingParameterDefinition, QgsProcessingParameterNumber

_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")
_WHOLE = re.compile(r"[-+]?\d+(\.0*)?")
_SWITCH = ("true", "false", "1", "0")


def problem_of(parameter: QgsProcessingParameterDefinition, value: Any) -> str | None:
    """Returns what is wrong with a value for a number or a box to tick; None: nothing, or not written as text."""
    if not isinstance(value, str) or not value.strip():
        return None
    text = value.strip()
    if isinstance(parameter, QgsProcessingParameterNumber):
        if not _NUMBER.fullmatch(text):
            comma = _NUMBER.fullmatch(text.replace(",", ".", 1))
            return f"is not a number (value {text})." + (" Write a point before the decimals" if comma else " Give a number")
        if parameter.dataType() == QgsProcessingParameterNumber.Integer and not _WHOLE.fullmatch(text):
            return f"is not a whole number (value {text}). Give one without decimals"
    if isinstance(parameter, QgsProcessingParameterBoolean) and text.lower() not in _SWITCH:
        return f"is neither true nor false (value {text}). Give one of the two"
    return None
