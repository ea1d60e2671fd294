# SPDX-License-Identifier: Apache-2.0
"""The algorithms, one file each."""
from __future__ import annotations

from qgis.core import QgsProcessingAlgorithm

from ..program import Program
from .batch import BatchAlgorithm
from .calibrate import CalibrateAlgorithm
from .check import CheckAlgorithm
from .compare import CompareAlgorithm
from .converge import ConvergeAlgorithm
from .ensemble import EnsembleAlgorithm
from .new_scene import NewSceneAlgorithm
from .probability import ProbabilityAlgorithm
from .render import RenderAlgorithm
from .run import RunAlgorithm

_ALL = (RunAlgorithm, CheckAlgorithm, CompareAlgorithm, RenderAlgorithm, ConvergeAlgorithm, EnsembleAlgorithm,
        BatchAlgorithm, CalibrateAlgorithm, NewSceneAlgorithm, ProbabilityAlgorithm)


def algorithms_of(program: Program) -> list[QgsProcessingAlgorithm]:
    """Those whose command the program has."""
    return [kind(program) for kind in _ALL if not kind.COMMAND or program.has(kind.COMMAND)]
