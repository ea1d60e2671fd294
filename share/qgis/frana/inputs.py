# SPDX-License-Identifier: Apache-2.0
"""A scene file and the layers that it names, in one folder."""
from __future__ import annotations

import os
import textwrap

from qgis.core import QgsProcessingException

from .fields import Field, Values
from .layers import Layer
from .translation import tr
from .wsl import inside

_ENDING = "-inputs"


class Given:
    """What the user gave, and what his process and country imply for the rest: keys with their texts or layers, in the
    order of the keys. Taken while the project may be read, written later."""

    def __init__(self, fields: list[Field], values: Values, implied: dict[str, str]) -> None:
        self.given: list[tuple[Field, str | tuple[str, Layer]]] = []
        for field in fields:
            value = field.value(values) or implied.get(field.key.name)
            if value is not None:
                self.given.append((field, value))

    def layer_of(self, key: str) -> Layer | None:
        return next((value[1] for field, value in self.given if field.key.name == key and not isinstance(value, str)), None)

    def text_of(self, key: str) -> str:
        return next((value for field, value in self.given if field.key.name == key and isinstance(value, str)), "")

    def texts(self, folder: str, layers: str) -> list[tuple[Field, str]]:
        """Writes the layers into the folder `layers` inside `folder`; returns each key's text, with paths from `folder`."""
        texts = []
        for field, value in self.given:
            if not isinstance(value, str):
                before, layer = value
                value = before + os.path.join(layers, layer.write(os.path.join(folder, layers), field.name))
            texts.append((field, inside(value)))
        return texts


def make_folder(folder: str) -> None:
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError as error:
        raise QgsProcessingException(tr("Folder of the result: {0} cannot be made ({1}). Choose another place", folder,
                                        error.strerror)) from error


def write_scene(folder: str, given: Given, title: str, name: str, layers: str = "",
                more: tuple[tuple[str, str], ...] = ()) -> str:
    """Writes the layers into the folder `layers` inside `folder`, and the scene, with `more` keys and texts in place of
    those given; returns the scene's path."""
    make_folder(folder)
    sections: dict[str, list[str]] = {}
    for key, text in more:
        section, _, word = key.partition(".")
        sections.setdefault(section, []).append(f"{word} = {text}")
    for field, text in given.texts(folder, layers):
        if field.key.name in dict(more):
            continue
        lines = sections.setdefault(field.key.section, [])
        lines += textwrap.wrap(field.key.meaning, 116, initial_indent="# ", subsequent_indent="# ")
        lines.append(f"{field.key.key} = {' '.join(text.split())}")
    lines = [f"# {title}. frana check {name} shows what would run."]
    for section, entries in sections.items():
        lines += ["", f"[{section}]", *entries]
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    return path


def settings(folder: str, given: Given) -> list[tuple[str, str]]:
    """Writes layers; returns key and text, with absolute paths, for a scene that is somewhere else."""
    make_folder(folder)
    return [(field.key.name, text) for field, text in given.texts("", folder)]


def inputs_folder(result: str) -> str:
    """The folder beside a result with what went into it, from which the run can be repeated and resumed."""
    return result.rstrip("/\\") + _ENDING


def result_of(inputs: str) -> str:
    """The name of the result whose inputs these are; empty for a temporary folder."""
    name = os.path.basename(inputs)
    return name[:-len(_ENDING)] if name.endswith(_ENDING) else ""
