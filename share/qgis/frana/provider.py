# SPDX-License-Identifier: Apache-2.0
"""What QGIS starts and stops: a provider with one algorithm for each command that the program has."""
from __future__ import annotations

import os
import sys

from processing.core.ProcessingConfig import ProcessingConfig, Setting
from qgis.core import Qgis, QgsApplication, QgsMessageLog, QgsProcessingProvider
from qgis.PyQt.QtGui import QIcon

from .algorithms import algorithms_of
from .program import SETTING, ProgramError, ask_program
from .translation import tr

ICON = os.path.join(os.path.dirname(__file__), "icon.svg")


def _tell(problem: str) -> None:
    """QGIS does not list a provider without algorithms, nor its message: where it has a window it is told there."""
    QgsMessageLog.logMessage(problem, "frana", Qgis.Warning)
    from qgis.utils import iface
    if iface is not None and iface.messageBar() is not None:
        iface.messageBar().pushWarning("frana", problem)
    else:
        print(f"frana: {problem}", file=sys.stderr)


class FranaProvider(QgsProcessingProvider):
    def __init__(self) -> None:
        super().__init__()
        self.problem = ""

    def id(self) -> str:
        return "frana"

    def name(self) -> str:
        return "frana"

    def longName(self) -> str:  # noqa: N802
        return tr("frana – run-out of landslides")

    def icon(self) -> QIcon:
        return QIcon(ICON)

    def load(self) -> bool:
        ProcessingConfig.settingIcons[self.name()] = self.icon()
        ProcessingConfig.addSetting(Setting(self.name(), SETTING, tr("Path of the program frana (empty: the one in PATH)"),
                                            "", valuetype=Setting.FILE))
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
            _tell(self.problem)
            return
        for algorithm in algorithms_of(program):
            self.addAlgorithm(algorithm)

    def warningMessage(self) -> str:  # noqa: N802 (the toolbox shows it)
        return self.problem


class FranaPlugin:
    def __init__(self) -> None:
        self.provider: FranaProvider | None = None

    def initProcessing(self) -> None:  # noqa: N802 (called alone by qgis_process)
        self.provider = FranaProvider()
        QgsApplication.processingRegistry().addProvider(self.provider)

    def initGui(self) -> None:  # noqa: N802
        self.initProcessing()

    def unload(self) -> None:
        if self.provider is not None:
            QgsApplication.processingRegistry().removeProvider(self.provider)
            self.provider = None
