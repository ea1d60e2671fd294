# SPDX-License-Identifier: Apache-2.0
"""The program frana: where it is, which commands, keys and presets it has. Everything is asked of it, nothing is known here."""
from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
from dataclasses import dataclass, field

from qgis.core import QgsApplication, QgsSettings

from .keys import Key, key_from_json
from .translation import catalogue, tr
from .wsl import command

SETTING = "FRANA_PROGRAM"  # of Processing's options
_INSTALLED_BY = os.path.join(os.path.dirname(__file__), "program.txt")  # written by `frana qgis-plugin --install`
_LIMIT = 60  # seconds for an answer, which takes a tenth of one


class ProgramError(Exception):
    """The program is missing or does not answer; a sentence for the user."""


@dataclass
class Program:
    path: str
    version: str
    commands: set[str]
    keys: list[Key]
    presets: dict[str, list[str]] = field(default_factory=dict)  # of a key: the names that a command lists

    def has(self, command: str) -> bool:
        return command in self.commands


def _is_program(path: str) -> bool:
    return os.path.isfile(path) and os.access(path, os.X_OK)


def find_program() -> str:
    """Returns the path: the setting, else PATH, else the program that installed the plugin. Throws ProgramError."""
    setting = QgsSettings().value("Processing/Configuration/" + SETTING, "") or ""
    if setting:
        if not _is_program(setting):
            raise ProgramError(tr("{0} is not a program that can be run. Correct the path under Settings, Options, "
                                  "Processing, Providers, frana, or empty it", setting))
        return setting
    found = shutil.which("frana") or (shutil.which("wsl.exe") if os.name == "nt" else None)
    if found:
        return found
    if os.path.isfile(_INSTALLED_BY):
        with open(_INSTALLED_BY, encoding="utf-8") as file:
            path = file.read().strip()
        if _is_program(path):
            return path
    raise ProgramError(tr("The program frana was not found. Install it, or give its path under Settings, Options, "
                          "Processing, Providers, frana"))


def _answer(path: str, *words: str) -> str:
    try:
        done = subprocess.run(command(path, list(words)), stdin=subprocess.DEVNULL, capture_output=True, timeout=_LIMIT, check=True)
    except (OSError, subprocess.SubprocessError) as error:
        raise ProgramError(tr("{0} does not answer: {1}", " ".join([path, *words]), error)) from error
    return done.stdout.decode("utf-8", "replace")


def ask_program() -> Program:
    """Finds the program and asks what it can. Throws ProgramError."""
    path = find_program()
    commands = set(re.findall(r"^ {1,8}([a-z][a-z-]*)\b", _answer(path, "--help"), re.MULTILINE))
    version = _answer(path, "--version").split("\n", 1)[0]
    if not version.startswith("frana "):
        raise ProgramError(tr("{0} is not frana: it says it is {1}", path, repr(version)))
    try:
        language = QgsApplication.locale()[:2]
        words = ["--language", language] if catalogue(language) else []  # the program has the plugin's languages
        rows = json.loads(_answer(path, "params", "--json", *words))
        keys = [key_from_json(row) for row in rows]
    except (ValueError, KeyError, TypeError) as error:
        raise ProgramError(tr("{0} params --json is not understood: {1}", path, error)) from error
    lists = (("material.preset", ["materials"]), ("hazard.scheme", ["schemes"]),
             ("material.friction-table", ["schemes", "--friction"]))
    presets = {key: re.findall(r"^([a-z][\w-]*)$", _answer(path, *words), re.MULTILINE)
               for key, words in lists if words[0] in commands}
    return Program(path, version.removeprefix("frana "), commands, keys, presets)
