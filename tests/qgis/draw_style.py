# SPDX-License-Identifier: Apache-2.0
"""Draws files of a result with QGIS's own engine and compares every cell's colour with its class's.

draw_style.py RESULT NAME...: each once as it looks when dropped into QGIS (which finds the .qml by itself), once with the .sld.
What a colour must be is worked out here from the values and the style's text, without QGIS. Writes NAME_qml.png and
NAME_sld.png into RESULT, to look at."""
import find_qgis  # noqa: F401
from judge import judge_each
import os
import sys
import xml.etree.ElementTree as xml

from qgis.PyQt.QtCore import QSize
from qgis.PyQt.QtGui import QColor, QImage, QPainter
from qgis.core import (QgsApplication, QgsMapRendererCustomPainterJob, QgsMapSettings, QgsRasterLayer,
                       QgsVectorLayer)

BACKGROUND = QColor(255, 0, 255)  # in no palette
SCALE = 4  # pixels per cell


def rgb(text):
    return tuple(int(text[i:i + 2], 16) for i in (1, 3, 5))


def classes_of(qml):
    """[(upper bound or value, colour)] and whether the classes are exact values."""
    shader = xml.parse(qml).getroot().find(".//colorrampshader")
    items = [(float(item.get("value")), rgb(item.get("color"))) for item in shader.findall("item")]
    return items, shader.get("colorRampType") == "EXACT"


def sld_classes(sld):
    entries = xml.parse(sld).getroot().iter("{http://www.opengis.net/sld}ColorMapEntry")
    return [(float(entry.get("quantity")), rgb(entry.get("color"))) for entry in entries]


def sld_like(items):
    """An open end is written as the largest number of a raster."""
    return [(3.4e38 if bound == float("inf") else bound, colour) for bound, colour in items]


def expected_colour(value, items, exact):
    for bound, colour in items:
        if (value == bound) if exact else (value <= bound):
            return colour
    return None


def draw(layer, extent, columns, rows, path):
    settings = QgsMapSettings()
    settings.setLayers([layer])
    settings.setDestinationCrs(layer.crs())
    settings.setExtent(extent)
    settings.setOutputSize(QSize(columns * SCALE, rows * SCALE))
    settings.setBackgroundColor(BACKGROUND)
    settings.setFlag(QgsMapSettings.Antialiasing, False)
    image = QImage(settings.outputSize(), QImage.Format_RGB32)
    image.fill(BACKGROUND)
    painter = QPainter(image)
    job = QgsMapRendererCustomPainterJob(settings, painter)
    job.renderSynchronously()
    painter.end()
    image.save(path)
    return image


def check(image, layer_values, columns, rows, colour_of, tolerance):
    """Compares the pixel in the middle of every cell; returns complaints and the number of coloured cells."""
    wrong, coloured = [], 0
    for row in range(rows):
        for column in range(columns):
            value = layer_values(row, column)
            pixel = image.pixelColor(column * SCALE + SCALE // 2, row * SCALE + SCALE // 2)
            found = (pixel.red(), pixel.green(), pixel.blue())
            wanted = colour_of(value)
            coloured += wanted is not None
            if any(abs(a - b) > tolerance for a, b in zip(found, wanted or (255, 0, 255))):
                wrong.append("row %d column %d value %s: %s instead of %s" % (row, column, value, found, wanted))
    return wrong, coloured


def values_of(path):
    layer = QgsRasterLayer(path, "values")
    provider = layer.dataProvider()
    block = provider.block(1, layer.extent(), layer.width(), layer.height())
    return lambda row, column: None if block.isNoData(row, column) else block.value(row, column)


def check_styles(result, name):
    zones = name == "hazard_zones"
    grid = QgsRasterLayer(os.path.join(result, ("hazard" if zones else name) + ".tif"), "grid")
    assert grid.isValid(), "the raster does not open"
    columns, rows, extent = grid.width(), grid.height(), grid.extent()
    if zones:
        values = values_of(os.path.join(result, "hazard.tif"))
        items, _ = classes_of(os.path.join(result, "hazard.qml"))
        opacity = 0.6
        blend = {int(v): tuple(round(opacity * c + (1 - opacity) * b) for c, b in zip(colour, (255, 0, 255)))
                 for v, colour in items}
        open_layer = lambda: QgsVectorLayer(os.path.join(result, "hazard_zones.gpkg"), name, "ogr")
        colour_of = lambda value: None if value is None else blend[int(value)]
    else:
        values = values_of(os.path.join(result, name + ".tif"))
        items, exact = classes_of(os.path.join(result, name + ".qml"))
        open_layer = lambda: QgsRasterLayer(os.path.join(result, name + ".tif"), name)
        colour_of = lambda value: None if value is None else expected_colour(value, items, exact)
    for style in ("qml", "sld"):
        layer = open_layer()
        assert layer.isValid(), "the layer does not open"
        if style == "sld":
            message, good = layer.loadSldStyle(os.path.join(result, name + ".sld"))
            if not good and "not supported" in message and not zones:
                # QGIS 3.22 reads no SLD for rasters; its text must agree with the .qml.
                assert sld_classes(os.path.join(result, name + ".sld")) == sld_like(items), "the styles differ"
                print("%s, sld: not read by this QGIS, same classes as the qml" % name)
                continue
            assert good, "QGIS does not read the .sld: " + message
        image = draw(layer, extent, columns, rows, os.path.join(result, "%s_%s.png" % (name, style)))
        wrong, coloured = check(image, values, columns, rows, colour_of, 2 if zones else 0)  # a blend rounds
        print("%s, %s: %d cells coloured, %d wrong" % (name, style, coloured, len(wrong)))
        assert coloured > 0, "no cell has a colour"
        assert not wrong, "\n".join(wrong[:10])


def main(result, *names):
    application = QgsApplication([], False)
    application.initQgis()
    judge_each(result, names, check_styles)


if __name__ == "__main__":
    main(*sys.argv[1:])
