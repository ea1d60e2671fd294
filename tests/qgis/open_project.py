# SPDX-License-Identifier: Apache-2.0
"""Opens result.qgz as a user does, in a copy of the result in another place: open_project.py RESULT NAME...

A NAME is "project" (every layer is valid, in order, styled, frames with their times) or "outlines" (layers of extent.gpkg
opened alone take their styles from the file) or "sheets" (those of RESULT_it and the like hold their texts). Writes NAME.png into RESULT, to look at, and NAME.verdict."""
import find_qgis  # noqa: F401
from judge import judge_each
import csv
import math
import os
import shutil
import sys
import tempfile

from qgis.PyQt.QtCore import QPointF, QRectF, QSize, Qt
from qgis.PyQt.QtGui import QColor, QFont, QFontMetricsF, QImage, QPainter
from qgis.core import (QgsApplication, QgsDateTimeRange, QgsLayoutExporter, QgsLayoutItem, QgsLayoutItemLabel,
                       QgsLayoutItemLegend, QgsLayoutItemMap, QgsLayoutItemPage, QgsLayoutItemPicture, QgsLayoutItemScaleBar,
                       QgsMapRendererCustomPainterJob, QgsMapSettings, QgsProject, QgsRasterLayer, QgsUnitTypes,
                       QgsVectorLayer)

BACKGROUND = QColor(255, 0, 255)


def draw(layers, extent, path, width=1000):
    settings = QgsMapSettings()
    settings.setLayers(layers)
    settings.setDestinationCrs(layers[0].crs())
    settings.setExtent(extent)
    settings.setOutputSize(QSize(width, int(width * extent.height() / extent.width())))
    settings.setBackgroundColor(BACKGROUND)
    settings.setFlag(QgsMapSettings.DrawLabeling, True)
    image = QImage(settings.outputSize(), QImage.Format_RGB32)
    image.fill(BACKGROUND)
    painter = QPainter(image)
    QgsMapRendererCustomPainterJob(settings, painter).renderSynchronously()
    painter.end()
    image.save(path)
    return image


def check_outline(layer):
    symbol = layer.renderer().symbol()
    assert symbol.symbolLayer(0).properties()["style"] == "no", layer.name() + " is filled"
    return symbol.symbolLayer(0)


def check_frames(group, folder):
    with open(os.path.join(folder, "frames", "frames.csv"), newline="") as table:
        rows = list(csv.DictReader(table))
    column = next(key for key in rows[0] if key.startswith("time"))
    times = [float(row[column]) for row in rows]
    layers = [node.layer() for node in group.findLayers()]
    assert len(layers) == len(times), (len(layers), len(times))
    ranges = []
    for layer in layers:
        assert os.path.basename(layer.source()).startswith("depth_"), layer.source()
        properties = layer.temporalProperties()
        assert properties.isActive(), layer.name() + " has no time"
        ranges.append(properties.fixedTemporalRange())
    starts = [one.begin().toUTC().toMSecsSinceEpoch() / 1000 - 946684800 for one in ranges]  # 2000-01-01
    for found, wanted in zip(starts[:-1], times):  # the last one has a step of its own
        assert abs(found - wanted) < 1e-3, (starts, times)  # milliseconds
    # Each step of the controller shows one frame.
    project = QgsProject.instance()
    settings = project.timeSettings()
    step, begin = int(settings.timeStep()), settings.temporalRange().begin()
    assert settings.timeStepUnit() == QgsUnitTypes.TemporalMilliseconds, settings.timeStepUnit()
    for index in range(len(times)):
        shown = QgsDateTimeRange(begin.addMSecs(index * step), begin.addMSecs((index + 1) * step), True, False)
        found = [i for i, one in enumerate(ranges) if one.overlaps(shown)]
        assert found == [index], (index, found, starts)


def check_relief(layer, picture):
    """Enlarged, the relief is smoother from pixel to pixel than with one pixel for each cell; otherwise it shows a
    waffle of the cells."""
    def contrast(width):
        image = draw([layer], layer.extent(), picture, width)
        columns, rows = (range(size // 4, 3 * size // 4) for size in (image.width(), image.height()))
        greys = [[image.pixelColor(x, y).red() for x in columns] for y in rows[::3]]
        return sum(abs(a - 2 * b + c) for row in greys for a, b, c in zip(row, row[1:], row[2:])) / len(rows[::3]) / len(columns)
    of_cells = contrast(layer.width())
    enlarged = [contrast(times * layer.width()) for times in (2, 4, 7)]  # without smoothing 8 to 28 where the cells have 6
    assert max(enlarged) < of_cells and enlarged[-1] < 0.25 * of_cells, (of_cells, enlarged)  # bilinear 0.29, cubic 0.17
    for parts in (1, 4):  # slopes that face the sun keep their shades, reduced too; a fifth was white
        image = draw([layer], layer.extent(), picture, layer.width() // parts)
        greys = [image.pixelColor(x, y).red() for x in range(image.width()) for y in range(image.height())]
        assert sum(grey > 252 for grey in greys) < 0.01 * len(greys), (parts, max(greys))


def check_texts(layout):
    """No text of a sheet is cut, and none lies on another part."""
    pixels = 20  # of a point
    per_mm = pixels / 0.3528
    items = [item for item in layout.items() if isinstance(item, QgsLayoutItem) and not
             isinstance(item, QgsLayoutItemPage)]
    for item in items:
        if isinstance(item, QgsLayoutItemLegend):
            item.adjustBoxSize()
        if not isinstance(item, QgsLayoutItemLabel):
            continue
        font = QFont(item.font())
        font.setPixelSize(round(item.font().pointSizeF() * pixels))
        room = item.rect()
        needed = QFontMetricsF(font).boundingRect(QRectF(0, 0, room.width() * per_mm, 1e9), int(Qt.TextWordWrap),
                                                  item.currentText())
        assert needed.height() / per_mm <= room.height() + 0.1 and needed.width() / per_mm <= room.width() + 0.1, (
            layout.name(), item.currentText(), needed.height() / per_mm, room)
        assert needed.height() / per_mm > room.height() / 4 or room.height() < 30, (layout.name(), item.currentText())
    places = [(item, item.mapRectToScene(item.rect()).adjusted(0.05, 0.05, -0.05, -0.05)) for item in items]
    for i, (item, place) in enumerate(places):
        for other, room in places[i + 1:]:
            assert not place.intersects(room), (layout.name(), item.displayName(), other.displayName(), place, room)


def check_layouts(project, folder, picture):
    """A sheet for each map, with all its parts inside the page, which QGIS exports as it is."""
    maps = [node.layer() for node in project.layerTreeRoot().children()[1].findLayers()
            if isinstance(node.layer(), QgsRasterLayer)]
    layouts = project.layoutManager().printLayouts()
    assert len(layouts) == len(maps) > 5, ([layout.name() for layout in layouts], len(maps))
    trace = QgsVectorLayer(os.path.join(folder, "extent.gpkg") + "|layername=trace", "trace", "ogr").extent()
    for layout, layer in zip(layouts, maps):
        page = QRectF(QPointF(0, 0), layout.pageCollection().page(0).rect().size())
        items = [item for item in layout.items() if isinstance(item, QgsLayoutItem) and not
                 isinstance(item, QgsLayoutItemPage)]
        kinds = {type(item) for item in items}
        assert {QgsLayoutItemMap, QgsLayoutItemLegend, QgsLayoutItemScaleBar, QgsLayoutItemPicture, QgsLayoutItemLabel} <= kinds
        sheet = layout.itemById("map")
        assert sheet.extent().contains(trace), (sheet.extent(), trace)
        mantissa = round(sheet.scale()) / 10 ** math.floor(math.log10(round(sheet.scale())))
        assert min(abs(mantissa - one) for one in (1, 1.5, 2, 2.5, 3, 4, 5, 7.5)) < 1e-6, sheet.scale()
        assert layer in sheet.layers() and os.path.basename(sheet.layers()[-1].source()) == "dtm.tif", layout.name()
        legend = next(item for item in items if isinstance(item, QgsLayoutItemLegend))
        shown = [node.layer() for node in legend.model().rootGroup().findLayers()]
        assert layer in shown and len(shown) > 2, [one.name() for one in shown]
        check_texts(layout)
        for item in items:
            assert page.adjusted(-0.1, -0.1, 0.1, 0.1).contains(item.mapRectToScene(item.rect())), (layout.name(), item)
        texts = " ".join(item.currentText() for item in items if isinstance(item, QgsLayoutItemLabel))
        assert "frana " in texts and "dtm.tif" in texts and project.title() in texts, texts
        if layer.source().endswith("hazard.tif"):
            assert "without its frequency" in texts and "Source: " in texts, texts
        if os.path.basename(layer.source()) in ("mu.tif", "xi.tif"):
            assert "Friction table: NGI, Voellmy friction" in texts and "Source: NGI" in texts, texts
        scale = round(1000 * sheet.extent().width() / sheet.rect().width())
        assert "1 : " + f"{scale:,}".replace(",", " ") in texts, (scale, texts)
    pictures = QgsLayoutExporter.ImageExportSettings()
    pictures.dpi = 150
    exporter = QgsLayoutExporter(layouts[[layer.source().endswith("max_depth.tif") for layer in maps].index(True)])
    stem = picture.replace(".png", "_sheet")
    assert exporter.exportToImage(stem + ".png", pictures) == QgsLayoutExporter.Success, exporter.errorFile()
    assert exporter.exportToPdf(stem + ".pdf", QgsLayoutExporter.PdfExportSettings()) == QgsLayoutExporter.Success
    image = QImage(stem + ".png")
    seen = {image.pixelColor(x, y).name() for x in range(0, image.width(), 2) for y in range(0, image.height(), 2)}
    items = next(layer for layer in maps if layer.source().endswith("max_depth.tif")).renderer().shader(
        ).rasterShaderFunction().colorRampItemList()
    assert sum(item.color.name() in seen for item in items) >= 3, "the depths are not on the sheet"


def check_project(folder, picture):
    project = QgsProject.instance()
    assert project.read(os.path.join(folder, "result.qgz")), project.error()
    assert project.crs().authid() == "EPSG:32632", project.crs().authid()
    layers = project.mapLayers().values()
    invalid = [layer.name() + ": " + layer.source() for layer in layers if not layer.isValid()]
    assert layers and not invalid, invalid
    for layer in layers:
        assert os.path.realpath(layer.source()).startswith(os.path.realpath(folder)), layer.source()
        assert project.title() in layer.name(), layer.name()
        assert layer.crs().authid() == "EPSG:32632", layer.crs().authid()
    groups = project.layerTreeRoot().children()
    names = [group.name().split(" – ")[0] for group in groups]
    assert names == ["Outlines", "Maps", "Flow depth, t [s]", "Terrain"], names
    assert not groups[2].isVisible()
    check_frames(groups[2], folder)
    assert project.timeSettings().temporalRange().begin().isValid(), "no temporal range"
    rasters = {os.path.basename(layer.source()): layer for layer in layers if isinstance(layer, QgsRasterLayer)}
    written = {name for name in os.listdir(folder) if name.endswith(".tif") and name != "bed.tif"}
    assert written <= set(rasters), written - set(rasters)
    for name in sorted(written - {"dtm.tif"}):
        alone = QgsRasterLayer(os.path.join(folder, name), name)  # finds the .qml beside it
        colours = [[(item.value, item.color.name()) for item in
                    layer.renderer().shader().rasterShaderFunction().colorRampItemList()]
                   for layer in (alone, rasters[name])]
        assert colours[0] == colours[1] and len(colours[0]) > 1, (name, colours)
    shared = [rasters[name].renderer().shader().rasterShaderFunction().colorRampItemList()
              for name in sorted(rasters) if name.startswith("depth_")]
    assert all([item.color for item in one] == [item.color for item in shared[0]] for one in shared)
    for layer in layers:
        if layer.source().split("|")[0].endswith("extent.gpkg"):
            check_outline(layer)
    # Otherwise the relief is striped in a project of another CRS.
    assert rasters["dtm.tif"].dataProvider().isProviderResamplingEnabled()
    assert "dtm.tif" in rasters["dtm.tif"].attribution(), rasters["dtm.tif"].attribution()
    check_layouts(project, folder, picture)
    check_relief(rasters["dtm.tif"], picture.replace(".png", "_relief.png"))
    visible = [layer for layer in project.layerTreeRoot().layerOrder()
               if project.layerTreeRoot().findLayer(layer.id()).isVisible()]
    shown = [os.path.basename(layer.source()) for layer in visible if isinstance(layer, QgsRasterLayer)]
    assert shown == ["max_depth.tif", "dtm.tif"], shown
    image = draw(visible, rasters["dtm.tif"].extent(), picture)
    seen = {image.pixelColor(x, y).name() for x in range(0, image.width(), 2) for y in range(0, image.height(), 2)}
    items = rasters["max_depth.tif"].renderer().shader().rasterShaderFunction().colorRampItemList()
    assert sum(item.color.name() in seen for item in items) >= 3, "the depths are not visible: " + str(len(seen))


def check_outlines(folder, picture):
    layers = []
    for name in ("release", "trace", "deposit", "scar"):
        layer = QgsVectorLayer(os.path.join(folder, "extent.gpkg") + "|layername=" + name, name, "ogr")
        assert layer.isValid() and layer.featureCount() > 0, name
        check_outline(layer)
        layers.append(layer)
    assert layers[0].labelsEnabled() and layers[0].labeling().settings().fieldName == "name", "no names"
    dashed = [layer.renderer().symbol().symbolLayer(0).strokeStyle() == Qt.DashLine for layer in layers]
    assert dashed == [True, False, False, False], dashed
    extent = layers[1].extent()
    extent.scale(1.2)
    image = draw(layers, extent, picture)
    inside = sum(image.pixelColor(x, y) == BACKGROUND for x in range(0, image.width(), 4)
                 for y in range(0, image.height(), 4))
    assert inside > 0.8 * (image.width() // 4) * (image.height() // 4), "areas are covered"


def check_moved(result, name):
    QgsProject.instance().clear()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as elsewhere:
        moved = os.path.join(elsewhere, "moved result")
        shutil.copytree(result, moved)
        {"project": check_project, "outlines": check_outlines}[name](moved, os.path.join(result, name + ".png"))
        shutil.rmtree(elsewhere, ignore_errors=True)


def check_sheets(result, _name):
    scales = set()
    for language in ("en", "it", "de", "fr", "es"):
        project = QgsProject.instance()
        assert project.read(result + "_" + language + "/result.qgz"), project.error()
        layouts = project.layoutManager().printLayouts()
        assert len(layouts) > 5, language
        for layout in layouts:
            check_texts(layout)
        texts = [item.currentText() for item in layouts[0].items() if isinstance(item, QgsLayoutItemLabel)]
        assert any("order number 2025/1234" in text for text in texts), texts
        assert any("passed on to a third party" in text for text in texts), texts
        scales.add(next(text for text in texts if text.startswith("1 : ")))
        frame = layouts[0].itemById("map").rect()
        page = layouts[0].pageCollection().page(0).rect()
        assert frame.width() * frame.height() > 0.3 * page.width() * page.height(), (language, frame, page)
        QgsLayoutExporter(layouts[0]).exportToPdf(result + "_" + language + "/sheet.pdf",
                                                  QgsLayoutExporter.PdfExportSettings())
    assert len({scale[-4:-3] for scale in scales}) == 3, scales  # a dot, a space and a narrow one


def main(result, *names):
    application = QgsApplication([], False)
    application.initQgis()
    judge_each(result, names, lambda folder, name: (check_sheets if name == "sheets" else check_moved)(folder, name))


if __name__ == "__main__":
    main(*sys.argv[1:])
