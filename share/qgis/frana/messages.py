# SPDX-License-Identifier: Apache-2.0
"""What the program writes to stderr: problems, each at the field that it concerns, warnings, progress."""
from __future__ import annotations

import os
import re

from .fields import Field

_BEFORE_SENTENCE = re.compile(r"^frana: (?!warning: )|^ +- ")
_RUN = re.compile(r"([\d.]+(?:e[-+]?\d+)?) of at most ([\d.]+(?:e[-+]?\d+)?) s simulated")
_MEMBERS = re.compile(r"member (\d+) of at most (\d+)")
_WARNING = "frana: warning: "


def progress_of(line: str) -> float | None:
    """Returns the percentage that a line of progress tells; None for other lines."""
    match = _RUN.search(line) or _MEMBERS.search(line)
    if not match or float(match.group(2)) <= 0:
        return None
    return min(100.0, 100.0 * float(match.group(1)) / float(match.group(2)))


def warning_of(line: str) -> str | None:
    return line[len(_WARNING):] if line.startswith(_WARNING) else None


def problems_of(lines: list[str], fields: list[Field]) -> list[str]:
    """Returns the program's problems as sentences that begin with the name of a field, where one is concerned."""
    problems = []
    for line in lines:
        if not _BEFORE_SENTENCE.search(line) or re.match(r"frana: \d+ problems:$", line):
            continue
        problems.append(_at_field(_BEFORE_SENTENCE.sub("", line, count=1), fields))
    return problems


def _at_field(sentence: str, fields: list[Field]) -> str:
    for field in fields:
        # "FILE: section.key: sentence" or "--set section.key: sentence"
        match = re.match(rf"(?:--set |\S.*?: )?{re.escape(field.key.name)}: (.*)$", sentence)
        if match:
            return f"{field.key.title()}: {match.group(1)}"
    for field in fields:  # a message that names the file which the field's layer became
        match = re.match(rf"(\S.*/)?{re.escape(field.name)}\.(gpkg|tif): (.*)$", sentence)
        if match:
            return f"{field.key.title()}: {match.group(3)}"
    return sentence


def shortened(sentence: str, folder: str) -> str:
    """Without the names of temporary folders."""
    return sentence.replace(folder + os.sep, "")
