# SPDX-License-Identifier: Apache-2.0
"""From a key to the parameters of a dialogue, and from their values to the key's text. Not given stays not given."""
from __future__ import annotations

import os
import re
from typing import Any

from qgis.core import (QgsProcessing, QgsProcessingAlgorithm, QgsProcessingContext, QgsProcessingException,
                       QgsProcessingParameterBoolean, QgsProcessingParameterDefinition, QgsProcessingParameterEnum,
                       QgsProcessingParameterFeatureSource, QgsProcessingParameterField, QgsProcessingParameterFile,
                       QgsProcessingParameterMapLayer, QgsProcessingParameterNumber, QgsProcessingParameterRasterLayer,
                       QgsProcessingParameterString, QgsRasterLayer)

from .keys import Key
from .layers import Layer, RasterSource, VectorSource, is_null
from .translation import tr

_GEOMETRY = {"polygons": [QgsProcessing.TypeVectorPolygon], "lines": [QgsProcessing.TypeVectorLine],
             "points": [QgsProcessing.TypeVectorPoint],
             "lines or points": [QgsProcessing.TypeVectorLine, QgsProcessing.TypeVectorPoint],
             "points, lines or polygons": [QgsProcessing.TypeVectorAnyGeometry]}
_MOST_DECIMALS = 12


class Values:
    """The parameters that an algorithm got."""

    def __init__(self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        self.algorithm, self.parameters, self.context = algorithm, parameters, context

    def has(self, name: str) -> bool:
        value = self.parameters.get(name)
        return not (value is None or value == "" or value == [] or is_null(value))

    def text(self, name: str) -> str:
        return self.algorithm.parameterAsString(self.parameters, name, self.context).strip()

    def path(self, name: str) -> str:
        """Absolute: a name that begins with "-" would be an option of the program. Empty: not given."""
        return os.path.abspath(self.text(name)) if self.has(name) else ""

    def number(self, name: str) -> float:
        return self.algorithm.parameterAsDouble(self.parameters, name, self.context)

    def whole(self, name: str) -> int:
        return self.algorithm.parameterAsInt(self.parameters, name, self.context)

    def is_on(self, name: str) -> bool:
        return self.algorithm.parameterAsBoolean(self.parameters, name, self.context)

    def word(self, name: str) -> str:
        return ", ".join(self.words(name))

    def words(self, name: str) -> list[str]:
        """Of a choice, given by words or by their numbers from 0."""
        options = self.algorithm.parameterDefinition(name).options()
        return [word_of(one, options) for one in chosen(self.parameters.get(name))]

    def column(self, name: str) -> str:
        columns = self.algorithm.parameterAsFields(self.parameters, name, self.context)
        return columns[0] if columns else ""

    def vector(self, name: str, title: str) -> VectorSource | None:
        source = self.algorithm.parameterAsSource(self.parameters, name, self.context)
        return VectorSource(source, title) if source is not None else None

    def raster(self, name: str, title: str) -> RasterSource | None:
        layer = self.algorithm.parameterAsRasterLayer(self.parameters, name, self.context)
        return RasterSource(layer, title) if layer is not None and layer.isValid() else None

    def layer(self, name: str, title: str) -> Layer | None:
        if isinstance(self.algorithm.parameterAsLayer(self.parameters, name, self.context), QgsRasterLayer):
            return self.raster(name, title)
        return self.vector(name, title)


def chosen(value: Any) -> list[Any]:
    """What is chosen of a choice: one, several, or several in a text."""
    if isinstance(value, str):
        return [one.strip() for one in value.split(",") if one.strip()]
    return list(value) if isinstance(value, (list, tuple)) else [value]


def word_of(value: Any, options: list[str]) -> str:
    """The word that a word or a number from 0 means; itself if it means none."""
    text = str(value).strip()
    return options[int(text)] if text not in options and text.isdigit() and int(text) < len(options) else text


def number_text(value: float) -> str:
    """The shortest text that reads as the same number: 10, 0.1."""
    return repr(value).removesuffix(".0")


def _decimals(lowest: float) -> int:
    """Enough to enter the smallest value and three digits of it."""
    match = re.search(r"e-(\d+)", f"{lowest:e}") if lowest > 0 else None
    return min(_MOST_DECIMALS, max(6, int(match.group(1)) + 2)) if match else 6


def number_parameter(name: str, label: str, limits: tuple[float, float] | None, whole: bool = False,
                     default: float | None = None) -> QgsProcessingParameterNumber:
    kind = QgsProcessingParameterNumber.Integer if whole else QgsProcessingParameterNumber.Double
    parameter = QgsProcessingParameterNumber(name, label, kind, default, True)
    if limits:
        parameter.setMinimum(limits[0])
        parameter.setMaximum(limits[1])
        if not whole:
            parameter.setMetadata({"widget_wrapper": {"decimals": _decimals(limits[0])}})
    return parameter


class Field:
    """A key with its parameters: its own, and where a value may come from a raster or a column, one for each."""

    def __init__(self, key: Key, presets: dict[str, list[str]], column_of: Key | None) -> None:
        self.key, self.presets = key, presets.get(key.name, [])
        self.name = key.parameter
        self.raster_name = self.name + "_raster" if "raster:FILE" in key.limits else ""
        self.column_of = column_of if "attribute:NAME" in key.limits else None
        self.column_name = self.name + "_column" if self.column_of else ""

    @property
    def names(self) -> list[str]:
        """Of its parameters."""
        return [name for name in (self.name, self.raster_name, self.column_name) if name]

    @property
    def is_switch(self) -> bool:
        """A box to tick. One whose default depends on other keys has three states: it is a choice."""
        return self.key.type == "on | off" and self.key.default is not None

    def label(self, name: str, is_within_section: bool = False) -> str:
        """What the dialogue calls one of its parameters, under the section's title or without it."""
        title = self.key.short_title() if is_within_section else self.key.title()
        if name == self.name:
            return title if self.is_switch else self.key.label(title)
        return tr("{0}, from a column" if name == self.column_name else "{0}, from a raster layer", title)

    def parameters(self, is_first: bool) -> list[QgsProcessingParameterDefinition]:
        made = [self._own()]
        if self.column_name:
            made.append(QgsProcessingParameterField(
                self.column_name, self.label(self.column_name), None, self.column_of.parameter,
                QgsProcessingParameterField.Numeric, False, True))
        if self.raster_name:
            made.append(QgsProcessingParameterRasterLayer(self.raster_name, self.label(self.raster_name), None, True))
        for parameter in made:
            parameter.setHelp(self.key.help())
            if not is_first or parameter.name() == self.raster_name:
                parameter.setFlags(parameter.flags() | QgsProcessingParameterDefinition.FlagAdvanced)
        return made

    def _own(self) -> QgsProcessingParameterDefinition:
        key, name, label = self.key, self.name, self.label(self.name)
        if key.type in ("number", "integer") and key.range():
            return number_parameter(name, label, key.range(), key.type == "integer")
        if self.is_switch:
            return QgsProcessingParameterBoolean(name, label, key.default == "on", True)
        if key.type in ("choice", "on | off", "integer") and key.words():
            return QgsProcessingParameterEnum(name, label, key.words(), False, None, True, True)
        if key.type == "list" and key.words():
            return QgsProcessingParameterEnum(name, label, key.words(), True, None, True, True)
        if self.presets:
            return QgsProcessingParameterEnum(name, label, self.presets, False, None, True, True)
        if key.type == "folder":
            return QgsProcessingParameterFile(name, label, QgsProcessingParameterFile.Folder, "", None, True)
        if key.type != "file":
            return QgsProcessingParameterString(name, label, None, False, True)
        if key.content == "raster":
            return QgsProcessingParameterRasterLayer(name, label, None, True)
        if key.content in _GEOMETRY:
            return QgsProcessingParameterFeatureSource(name, label, _GEOMETRY[key.content], None, True)
        if key.content == "raster or polygons":
            return QgsProcessingParameterMapLayer(name, label, None, True,
                                                  [QgsProcessing.TypeRaster, QgsProcessing.TypeVectorPolygon])
        return QgsProcessingParameterFile(name, label, QgsProcessingParameterFile.File, "", None, True)

    def value(self, values: Values) -> str | tuple[str, Layer] | None:
        """Returns the key's text, or what stands before a layer's path and the layer; None: not given."""
        key, title = self.key, self.key.title()
        if self.raster_name and values.has(self.raster_name):
            return "raster:", self._needed(values.raster(self.raster_name, title))
        if self.column_name and values.has(self.column_name):
            return "attribute:" + values.column(self.column_name)
        if self.is_switch:
            is_on = values.is_on(self.name) if values.has(self.name) else key.default == "on"
            return None if is_on == (key.default == "on") else ("on" if is_on else "off")
        if not values.has(self.name):
            return None
        own = self._own()
        if isinstance(own, QgsProcessingParameterNumber):
            return str(values.whole(self.name)) if key.type == "integer" else number_text(values.number(self.name))
        if isinstance(own, QgsProcessingParameterEnum):
            return ", ".join(values.words(self.name)) if own.allowMultiple() else values.word(self.name)
        if isinstance(own, QgsProcessingParameterRasterLayer):
            return "", self._needed(values.raster(self.name, title))
        if isinstance(own, QgsProcessingParameterFeatureSource):
            return "", self._needed(values.vector(self.name, title))
        if isinstance(own, QgsProcessingParameterMapLayer):
            return "", self._needed(values.layer(self.name, title))
        return values.text(self.name)

    def _needed(self, layer: Layer | None) -> Layer:
        if layer is None:
            raise QgsProcessingException(tr("{0}: the layer could not be opened. Choose one that is in the project, or a "
                                            "file", self.key.title()))
        return layer


def _layer_of_columns(key: Key, keys: list[Key]) -> Key | None:
    """The polygons whose columns a key of the same section may name: the last ones before it; of [zones] the friction zones."""
    if key.section == "zones":
        return next((other for other in keys if other.name == "terrain.friction-zones"), None)
    before = [other for other in keys[:keys.index(key)] if other.section == key.section and other.content == "polygons"]
    return before[-1] if before else None


def fields_of(keys: list[Key], presets: dict[str, list[str]]) -> list[Field]:
    """In the order of the dialogue: first those with a place in it, then the others section by section. The folder of the
    result and fixed values are not asked for."""
    sections = list(dict.fromkeys(key.section for key in keys))
    asked = [key for key in keys if not key.is_fixed() and key.name != "output.directory"]
    asked.sort(key=lambda key: (len(keys) if key.place is None else key.place, sections.index(key.section)))
    return [Field(key, presets, _layer_of_columns(key, keys)) for key in asked]
