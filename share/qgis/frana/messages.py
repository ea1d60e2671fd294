# SPDX-License-Identifier: Apache-2.0
"""What the program writes to stderr: problems, each at the field that it concerns, warnings, progress."""
from __future__ import annotations

import re

from .fields import Field
from .translation import tr

_BEFORE_SENTENCE = re.compile(r"^frana: (?!warning: )|^ +- ")
_RUN = re.compile(r"([\d.]+(?:e[-+]?\d+)?) of at most ([\d.]+(?:e[-+]?\d+)?) s simulated")
_MEMBERS = re.compile(r"member (\d+) of at most (\d+)")
_WARNING = "frana: warning: "
_REMEDIES = (("Choose another folder with --out, or add --overwrite", "Choose another folder, or tick “{0}”"),
             ("add --overwrite", "tick “{0}”"), ("add --resume", "tick “{1}”"),
             ("see `frana materials`", "the field lists them"))  # {0}, {1}: the boxes, as the dialogue calls them


def progress_of(line: str) -> float | None:
    """Returns the percentage that a line of progress tells; None for other lines."""
    match = _RUN.search(line) or _MEMBERS.search(line)
    if not match or float(match.group(2)) <= 0:
        return None
    return min(100.0, 100.0 * float(match.group(1)) / float(match.group(2)))


def warning_of(line: str) -> str | None:
    return line[len(_WARNING):] if line.startswith(_WARNING) else None


def problems_of(lines: list[str], fields: list[Field], names: dict[str, str]) -> list[str]:
    """Returns the program's problems as sentences that begin with the name of a field, where one is concerned. `names`: of
    options ("--out"), sections of a study ("vary") and files' names ("observed"), the field."""
    problems = []
    for line in lines:
        if not _BEFORE_SENTENCE.search(line) or re.match(r"frana: \d+ problems:$", line):
            continue
        problems.append(_in_dialogue(_at_field(_BEFORE_SENTENCE.sub("", line, count=1), fields, names), fields))
    return problems


def _in_dialogue(sentence: str, fields: list[Field]) -> str:
    """Remedies of the terminal as what a dialogue has."""
    boxes = tr("Replace an existing result"), tr("Resume a stopped run")
    for text, instead in _REMEDIES:
        sentence = sentence.replace(text, instead.format(*boxes))
    titles = {field.key.name: field.key.title() for field in fields}
    return re.sub(r"[a-z]+\.[a-z][a-z-]+(?!\.?\w)", lambda match: titles.get(match.group(), match.group()), sentence)


def _at_field(sentence: str, fields: list[Field], names: dict[str, str]) -> str:
    for field in fields:
        # "FILE: section.key: sentence" or "--set section.key: sentence"
        match = re.match(rf"(?:--set |\S.*?: )?{re.escape(field.key.name)}: (.*)$", sentence)
        if match:
            return f"{field.key.title()}: {match.group(1)}"
    names = {word: tr(title) for word, title in names.items()}
    files = {field.name: field.key.title() for field in fields}
    for stem, title in {**files, **names}.items():  # a message that names the file which the field's layer became
        match = re.match(rf"(?:--\w+: )?(?:\S.*/)?{re.escape(stem)}\.(?:gpkg|tif): (.*)$", sentence)
        if match:
            return f"{title}: {match.group(1)}"
    for word, title in names.items():
        # "--out: sentence", "FILE: vary.material.density: sentence"
        match = re.match(rf"(?:\S.*?: )?{re.escape(word)}(?:: |\.(?=\S+: ))(.*)$", sentence)
        if match:
            return f"{title}: {match.group(1)}"
    return sentence
