# SPDX-License-Identifier: Apache-2.0
"""The plugin's own texts in the language of QGIS, from po/LANGUAGE.po; English where there is none. Texts of keys come
translated from the program, whose messages are English."""
from __future__ import annotations

import ast
import functools
import os
import re

from qgis.core import QgsApplication

_FOLDER = os.path.join(os.path.dirname(__file__), "po")
_STRINGS = r'((?:"(?:[^"\\]|\\.)*"\s*)+)'


@functools.cache
def catalogue(language: str) -> dict[str, str]:
    """English text and translation of each entry; empty for a language that has no file."""
    try:
        with open(os.path.join(_FOLDER, language + ".po"), encoding="utf-8") as file:
            entries = re.findall(rf"^msgid {_STRINGS}^msgstr {_STRINGS}", file.read(), re.MULTILINE)
    except FileNotFoundError:
        return {}
    return {ast.literal_eval(f"({english})"): ast.literal_eval(f"({text})") for english, text in entries}


def tr(text: str, *values: object) -> str:
    """The text in the language of QGIS, with the values at {0}, {1}, ..."""
    found = catalogue(QgsApplication.locale()[:2]).get(text) or text
    return found.format(*values) if values else found
