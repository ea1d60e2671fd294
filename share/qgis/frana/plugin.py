# SPDX-License-Identifier: Apache-2.0
"""What QGIS starts and stops."""
from __future__ import annotations

from qgis.core import QgsApplication

from .provider import FranaProvider


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
