# SPDX-License-Identifier: Apache-2.0
"""Values that QGIS would replace without a word: a text that is no number by 0, any word by yes, a wrong choice by none.
They come from the command line, a script or the table of a batch."""
from __future__ import annotations

import re
from typing import Any

from qgis.core import (QgsProcessingParameterBoolean, QgsProcessingParameterDefinition, QgsProcessingParameterEnum,
                       QgsProcessingParameterNumber)

from .fields import chosen, word_of
from .translation import tr

_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")
_WHOLE = re.compile(r"[-+]?\d+(\.0*)?")
_SWITCH = ("true", "false", "1", "0")


def problem_of(parameter: QgsProcessingParameterDefinition, value: Any) -> str | None:
    """Returns what is wrong with a value for a number, a box to tick or a choice; None: nothing."""
    if isinstance(parameter, QgsProcessingParameterEnum) and parameter.usesStaticStrings():
        return _choice_problem(parameter, value)
    if not isinstance(value, str) or not value.strip():
        return None
    text = value.strip()
    if isinstance(parameter, QgsProcessingParameterNumber):
        if not _NUMBER.fullmatch(text):
            comma = _NUMBER.fullmatch(text.replace(",", ".", 1))
            return (tr("is not a number (value {0}). Write a point before the decimals", text) if comma else
                    tr("is not a number (value {0}). Give a number", text))
        if parameter.dataType() == QgsProcessingParameterNumber.Integer and not _WHOLE.fullmatch(text):
            return tr("is not a whole number (value {0}). Give one without decimals", text)
    if isinstance(parameter, QgsProcessingParameterBoolean) and text.lower() not in _SWITCH:
        return tr("is neither true nor false (value {0}). Give one of the two", text)
    return None


def _choice_problem(parameter: QgsProcessingParameterEnum, value: Any) -> str | None:
    if value is None or value == "" or value == [] or not isinstance(value, (str, int, list, tuple)):
        return None
    wrong = [str(one) for one in chosen(value) if word_of(one, parameter.options()) not in parameter.options()]
    if not wrong and not parameter.allowMultiple() and len(chosen(value)) > 1:
        wrong = [str(value)]
    if not wrong:
        return None
    return tr("is not one of the choices (value {0}; allowed {1})", ", ".join(wrong), ", ".join(parameter.options()))


def range_problem(parameter: QgsProcessingParameterDefinition, value: Any) -> str | None:
    """Returns what is wrong with a number's size; None: nothing, or no number."""
    if not isinstance(parameter, QgsProcessingParameterNumber) or isinstance(value, bool):
        return None
    try:
        number = float(value)
    except (TypeError, ValueError):
        return None
    if parameter.minimum() <= number <= parameter.maximum():
        return None
    return tr("is out of range (value {0:g}; allowed {1:g} to {2:g})", number, parameter.minimum(), parameter.maximum())
