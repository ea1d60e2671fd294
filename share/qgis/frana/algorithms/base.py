# SPDX-License-Identifier: Apache-2.0
"""What all algorithms share."""
from __future__ import annotations

import os
from typing import Any

from qgis.core import (QgsProcessingAlgorithm, QgsProcessingContext, QgsProcessingOutputDefinition,
                       QgsProcessingParameterBoolean, QgsProcessingParameterDefinition, QgsProcessingParameterEnum,
                       QgsProcessingParameterFolderDestination, QgsProcessingParameterMatrix)
from qgis.PyQt.QtGui import QIcon

from ..fields import Values, chosen, number_parameter, word_of
from ..inputs import inputs_folder
from ..program import Program
from ..translation import tr
from ..written_values import problem_of, range_problem

_ICON = os.path.join(os.path.dirname(os.path.dirname(__file__)), "icon.svg")


class FranaAlgorithm(QgsProcessingAlgorithm):
    """One command of the program."""

    COMMAND = ""  # of the program; empty: needs none
    NAME = ""  # frana:NAME
    TITLE = ""
    GROUP = ""
    HELP = ""
    TAGS: tuple[str, ...] = ()
    # What the program calls a field of the dialogue in its messages.
    NAMES = {"--out": "Folder of the result", "--threads": "Threads"}

    def __init__(self, program: Program) -> None:
        super().__init__()
        self.program = program

    def createInstance(self) -> "FranaAlgorithm":  # noqa: N802
        return type(self)(self.program)

    def name(self) -> str:
        return self.NAME

    def displayName(self) -> str:  # noqa: N802
        return tr(self.TITLE)

    def group(self) -> str:
        return tr(self.GROUP)

    def groupId(self) -> str:  # noqa: N802
        return self.GROUP.lower().replace(" ", "_")

    def shortHelpString(self) -> str:  # noqa: N802
        return tr(self.HELP)

    def tags(self) -> list[str]:
        return ["frana", "landslide", "run-out", *self.TAGS]

    def icon(self) -> QIcon:
        return QIcon(_ICON)

    def canExecute(self) -> tuple[bool, str]:  # noqa: N802
        if os.access(self.program.path, os.X_OK):
            return True, ""
        return False, tr("The program {0} is not there any more. Install frana again, or correct its path", self.program.path)

    def values(self, parameters: dict[str, Any], context: QgsProcessingContext) -> Values:
        return Values(self, parameters, context)

    def title_of(self, parameter: QgsProcessingParameterDefinition) -> str:
        """The name of a field in messages."""
        return parameter.description()

    def written_problems(self, parameters: dict[str, Any]) -> list[str]:
        """Of values that QGIS would take for others, and of numbers out of range."""
        problems = []
        for one in self.parameterDefinitions():
            value = parameters.get(one.name())
            problem = problem_of(one, value) or (range_problem(one, value) if self.is_own(one) else None)
            if problem:
                problems.append(f"{self.title_of(one)}: {problem}")
        return problems

    def is_own(self, parameter: QgsProcessingParameterDefinition) -> bool:
        """Whether the program knows nothing of the parameter and its limits."""
        return True

    def checkParameterValues(self, parameters: dict[str, Any],  # noqa: N802
                             context: QgsProcessingContext) -> tuple[bool, str]:
        problems = self.written_problems(parameters)
        return (False, "\n".join(problems)) if problems else super().checkParameterValues(self.with_words(parameters), context)

    def with_words(self, parameters: dict[str, Any]) -> dict[str, Any]:
        """Choices given by numbers as the words that QGIS knows."""
        words = {}
        for one in self.parameterDefinitions():
            if isinstance(one, QgsProcessingParameterEnum) and isinstance(parameters.get(one.name()), (int, str)):
                found = [word_of(value, one.options()) for value in chosen(parameters[one.name()])]
                words[one.name()] = found if one.allowMultiple() else ",".join(found)
        return {**parameters, **words}

    # What an algorithm declares is shown in the language of QGIS.

    def addParameter(self, parameter: QgsProcessingParameterDefinition, *more: Any) -> bool:  # noqa: N802
        if self.is_own(parameter):  # of the others the program tells the texts
            parameter.setDescription(tr(parameter.description()))
            parameter.setHelp(tr(parameter.help()) if parameter.help() else "")
            if isinstance(parameter, QgsProcessingParameterMatrix):
                parameter.setHeaders([tr(one) for one in parameter.headers()])
        return super().addParameter(parameter, *more)

    def addOutput(self, output: QgsProcessingOutputDefinition) -> bool:  # noqa: N802
        output.setDescription(tr(output.description()))
        return super().addOutput(output)

    # Parameters that several algorithms have.

    def add_advanced(self, parameter: QgsProcessingParameterDefinition, text: str) -> None:
        parameter.setHelp(text)
        parameter.setFlags(parameter.flags() | QgsProcessingParameterDefinition.FlagAdvanced)
        self.addParameter(parameter)

    def add_threads(self) -> None:
        self.add_advanced(number_parameter("THREADS", "Threads (all processors)", (1, 1024), True),
                          "Number of threads. The result is the same for any number.")

    def add_seed(self) -> None:
        self.add_advanced(number_parameter("SEED", "Seed (1)", (0, 2147483647), True), "The same seed gives the same runs.")

    def add_result_folder(self, label: str = "Folder of the result") -> None:
        self.addParameter(QgsProcessingParameterFolderDestination("OUTPUT", label))

    def add_box(self, name: str, label: str, text: str, is_on: bool = False) -> None:
        self.add_advanced(QgsProcessingParameterBoolean(name, label, is_on, True), text)

    def add_resume(self) -> None:
        self.add_box("RESUME", "Resume a stopped run",
                     "Continues a run that was cancelled or killed, in the same folder and with the same values; the result "
                     "is that of an undisturbed run, to the bit.")

    def add_overwrite(self) -> None:
        self.add_box("OVERWRITE", "Replace an existing result",
                     "Replaces a result of frana in this folder. If it contains other files, or files that were changed, the run "
                     "is refused and names them.")

    def add_load(self) -> None:
        self.add_box("LOAD", "Load the whole result into the project",
                     "Adds a group with outlines, maps and frames, with their styles, and sets the temporal controller.", True)

    def options(self, values: Values) -> list[str]:
        """The words of the command line for THREADS, RESUME and OVERWRITE."""
        words = ["--threads", str(values.whole("THREADS"))] if values.has("THREADS") else []
        for name in ("RESUME", "OVERWRITE"):
            if self.parameterDefinition(name) is not None and values.is_on(name):
                words.append("--" + name.lower())
        return words

    @staticmethod
    def resume_hint(folder: str) -> str:
        return tr("What was computed so far is in {0}. To continue, run again with the same values and this folder, and "
                  "tick “Resume a stopped run”. The inputs are kept in {1}", folder, inputs_folder(folder))
