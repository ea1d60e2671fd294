# SPDX-License-Identifier: Apache-2.0
"""The dialogue of a scene: QGIS's own, its advanced parameters under the titles of their sections."""
from __future__ import annotations

import itertools
import os

from processing.gui.AlgorithmDialog import AlgorithmDialog
from qgis.core import QgsProcessingParameterDefinition, QgsProcessingParameterFolderDestination, QgsProject, QgsRasterLayer
from qgis.gui import QgsCollapsibleGroupBox
from qgis.PyQt.QtCore import QEvent, QObject, Qt
from qgis.PyQt.QtWidgets import QAbstractSpinBox, QCheckBox, QComboBox, QVBoxLayout, QWidget

from .fields import Values
from .processes import COUNTRIES, PROCESSES

_RESULT = "manifest.json"  # a file of every result
_KEYS = {key for choices in (*PROCESSES.values(), *(one for country in COUNTRIES.values() for one in country.values()))
         for key in choices} | {"material.friction-table"}


class WheelNeedsFocus(QObject):
    """The mouse wheel turns the page, not the value under the pointer, until that field is clicked."""

    def eventFilter(self, field: QObject, event: QEvent) -> bool:  # noqa: N802
        if event.type() != QEvent.Type.Wheel or field.hasFocus():
            return False
        event.ignore()
        return True


def dialogue_by_sections(algorithm, parent: QWidget | None) -> AlgorithmDialog:
    dialogue = AlgorithmDialog(algorithm, parent=parent)
    wrappers = dialogue.mainWidget().wrappers
    sections = [key.section_title for key in algorithm.program.keys]
    boxes: dict[str, QgsCollapsibleGroupBox] = {}
    for definition in sorted(algorithm.parameterDefinitions(), key=lambda one: _place(algorithm, one, sections)):
        wrapper = wrappers.get(definition.name())
        widget = wrapper.wrappedWidget() if wrapper is not None else None
        if widget is None:
            continue
        field, label = algorithm.field_of(definition.name()), wrapper.wrappedLabel()
        is_hidden = bool(definition.flags() & QgsProcessingParameterDefinition.FlagAdvanced)
        text = field.label(definition.name(), is_hidden) if field else definition.description()
        if label is not None:  # QGIS adds "[optional]" to every one
            label.setText(text)
        elif isinstance(widget, QCheckBox):
            widget.setText(text)
        if not is_hidden:
            continue
        title = field.key.section_title if field else algorithm.displayName()
        if title not in boxes:
            group = widget.parentWidget()
            boxes[title] = QgsCollapsibleGroupBox(title, group)
            QVBoxLayout(boxes[title])
            group.layout().addWidget(boxes[title])
            boxes[title].setCollapsed(True)
        for part in (label, widget):
            if part is not None:
                boxes[title].layout().addWidget(part)
    _Implied(algorithm, dialogue)
    _preselect(algorithm, dialogue)
    guard = WheelNeedsFocus(dialogue)
    for kind in (QAbstractSpinBox, QComboBox):
        for field in dialogue.mainWidget().findChildren(kind):
            field.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
            field.installEventFilter(guard)
    return dialogue


class _Implied(QObject):
    """Tells in the brackets of a field what process and country imply where it stays empty. It holds none of the dialogue's
    parts: one that outlived its window would take QGIS along when the project changes."""

    def __init__(self, algorithm, dialogue: AlgorithmDialog) -> None:
        super().__init__(dialogue)
        self.algorithm = algorithm
        for wrapper in self._asked():
            wrapper.widgetValueHasChanged.connect(self.tell)

    def _asked(self) -> list:
        wrappers = self.parent().mainWidget().wrappers
        return [wrappers[name] for name in ("PROCESS", "COUNTRY", "material_return_period") if name in wrappers]

    def tell(self, *_) -> None:
        values = Values(self.algorithm, {one.parameterDefinition().name(): one.parameterValue() for one in self._asked()}, None)
        found = self.algorithm.implied(values)
        for field in self.algorithm.fields:
            wrapper = self.parent().mainWidget().wrappers.get(field.name)
            if field.key.name in _KEYS and wrapper is not None and wrapper.wrappedLabel() is not None:
                wrapper.wrappedLabel().setText(
                    f"{field.key.short_title()} ({found[field.key.name]})" if field.key.name in found else
                    field.label(field.name, not self.algorithm.is_first(field)))


def _preselect(algorithm, dialogue: AlgorithmDialog) -> None:
    """The only terrain model of the project, and a folder beside the project, which outlives QGIS."""
    project, page = QgsProject.instance(), dialogue.mainWidget()
    terrains = [layer for layer in project.mapLayers().values()
                if isinstance(layer, QgsRasterLayer) and layer.isValid() and layer.bandCount() == 1
                and not os.path.exists(os.path.join(os.path.dirname(layer.source()), _RESULT))]
    if "terrain_dtm" in page.wrappers and len(terrains) == 1:
        page.wrappers["terrain_dtm"].setParameterValue(terrains[0].id(), page.processing_context)
    output = algorithm.parameterDefinition("OUTPUT")
    if isinstance(output, QgsProcessingParameterFolderDestination) and project.homePath():
        stem = os.path.join(project.homePath(), f"frana-{algorithm.name()}-")
        number = next(one for one in itertools.count(1) if not os.path.exists(stem + str(one)))
        page.wrappers["OUTPUT"].setParameterValue(stem + str(number), page.processing_context)


def _place(algorithm, definition: QgsProcessingParameterDefinition, sections: list[str]) -> int:
    """Of its section; what is of the run itself comes first."""
    field = algorithm.field_of(definition.name())
    return sections.index(field.key.section_title) if field else -1
