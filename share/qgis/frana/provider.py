# SPDX-License-Identifier: Apache-2.0
"""The provider: one algorithm for each command that the program has."""
from __future__ import annotations

import os

from processing.core.ProcessingConfig import ProcessingConfig, Setting
from qgis.core import QgsProcessingProvider
from qgis.PyQt.QtGui import QIcon

from .algorithms import algorithms_of
from .program import SETTING, ProgramError, ask_program

ICON = os.path.join(os.path.dirname(__file__), "icon.svg")


class FranaProvider(QgsProcessingProvider):
    def __init__(self) -> None:
        super().__init__()
        self.problem = ""

    def id(self) -> str:
        return "frana"

    def name(self) -> str:
        return "frana"

    def longName(self) -> str:  # noqa: N802
        return "frana – run-out of landslides"

    def icon(self) -> QIcon:
        return QIcon(ICON)

    def load(self) -> bool:
        ProcessingConfig.settingIcons[self.name()] = self.icon()
        ProcessingConfig.addSetting(Setting(self.name(), SETTING, "Path of the program frana (empty: the one in PATH)", "",
                                            valuetype=Setting.FILE))
        ProcessingConfig.readSettings()
        self.refreshAlgorithms()
        return True

    def unload(self) -> None:
        ProcessingConfig.removeSetting(SETTING)

    def loadAlgorithms(self) -> None:  # noqa: N802
        self.problem = ""
        try:
            program = ask_program()
        except ProgramError as error:
            self.problem = str(error)
            return
        for algorithm in algorithms_of(program):
            self.addAlgorithm(algorithm)

    def warningMessage(self) -> str:  # noqa: N802 (the toolbox shows it)
        return self.problem
