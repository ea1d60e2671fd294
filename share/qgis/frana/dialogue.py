# SPDX-License-Identifier: Apache-2.0
"""The dialogue of a scene: QGIS's own, its advanced parameters under the titles of their sections."""
from __future__ import annotations

from processing.gui.AlgorithmDialog import AlgorithmDialog
from qgis.core import QgsProcessingParameterDefinition
from qgis.gui import QgsCollapsibleGroupBox
from qgis.PyQt.QtWidgets import QCheckBox, QVBoxLayout, QWidget


def dialogue_by_sections(algorithm, parent: QWidget | None) -> AlgorithmDialog:
    dialogue = AlgorithmDialog(algorithm, parent=parent)
    sections = [key.section_title for key in algorithm.program.keys]
    boxes: dict[str, QgsCollapsibleGroupBox] = {}
    for definition in sorted(algorithm.parameterDefinitions(), key=lambda one: _place(algorithm, one, sections)):
        wrapper = dialogue.mainWidget().wrappers.get(definition.name())
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
    return dialogue


def _place(algorithm, definition: QgsProcessingParameterDefinition, sections: list[str]) -> int:
    """Of its section; what is of the run itself comes first."""
    field = algorithm.field_of(definition.name())
    return sections.index(field.key.section_title) if field else -1
