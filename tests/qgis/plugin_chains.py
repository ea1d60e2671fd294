# SPDX-License-Identifier: Apache-2.0
"""Outputs, models, loading, keys that the plugin does not know: plugin_chains.py TESTS FRANA SAMPLE PLUGINS."""
from plugin_ground import (FRANA, LOWER, SCAR, UPPER, Told, context, drawn, folder, main, polygons, processing, provider, refusal,
                          run, scene, use_program)
import ast
import csv
import json
import os
import pathlib
import re
import stat

import numpy
from frana import translation
from osgeo import gdal
from qgis.core import (QgsLayerTreeGroup, QgsProcessingFeatureSourceDefinition, QgsProcessingModelAlgorithm,
                       QgsProcessingModelChildAlgorithm, QgsProcessingModelChildParameterSource,
                       QgsProcessingModelOutput, QgsProcessingModelParameter, QgsProcessingParameterDefinition,
                       QgsProcessingParameterFeatureSource, QgsProcessingParameterNumber,
                       QgsProcessingParameterRasterLayer, QgsProject, QgsRasterLayer, QgsSettings, QgsVectorLayer)

SMALL = {"output_report": True, "output_map_size": "640x480"}
OBSERVED = {"observed_perimeter": SCAR, "hazard_scheme": "swiss-flood", **SMALL}


def check_outputs(name, found, without=()):
    """Every declared output is there and opens as what it is declared."""
    for output in provider.algorithm(name).outputDefinitions():
        if output.name() in without:
            continue
        assert output.name() in found, f"frana:{name} has no {output.name()}"
        value, kind = found[output.name()], output.type()
        if kind == "outputRaster":
            assert QgsRasterLayer(value, "raster").isValid(), (output.name(), value)
        elif kind == "outputVector":
            layer = QgsVectorLayer(value, "layer", "ogr")
            assert layer.isValid() and layer.featureCount() > 0, (output.name(), value)
        elif kind == "outputNumber":
            float(value)
        elif kind == "outputFolder":
            assert os.path.isdir(value), (output.name(), value)
        elif kind == "outputMultilayer":
            assert value and all(QgsRasterLayer(one, "raster").isValid() for one in value), (output.name(), value)
        elif kind == "outputFile":
            assert os.path.getsize(value) > 0, (output.name(), value)
        else:
            assert kind == "outputString" and isinstance(value, str), (output.name(), kind, value)


def test_no_output_breaks_a_batch():
    """QGIS 3.22 ends a batch of an algorithm with an output of HTML in an error."""
    for algorithm in provider.algorithms():
        kinds = [output.type() for output in algorithm.outputDefinitions()]
        assert "outputHtml" not in kinds, algorithm.name()


def test_outputs_of_one_run():
    first = run("run", scene("first", output_maps=["max_depth"], output_animation=True, output_charts=True,
                             output_gauges=drawn("Point", "POINT(529400 5094450)"),
                             output_cross_sections=drawn("LineString", "LINESTRING(529300 5094400, 529500 5094400)"),
                             output_exposure=polygons(UPPER, LOWER), material_friction_table="ngi-avalanche",
                             material_return_period=300, **OBSERVED))
    check_outputs("run", first, {"EXPOSED_POINTS", "EXPOSED_LINES"})
    assert first["EXPOSED_REACHED"] >= 1
    checked = run("check", {**scene("checked"), "OUTPUT": os.path.join(folder, "check.txt")})
    check_outputs("check", checked)
    assert "45" in checked["TEXT"] and "UTM zone 32N" in checked["TEXT"], checked["TEXT"]
    compared = run("compare", {"RESULT": first["OUTPUT"], "OBSERVED": SCAR, "THRESHOLD": 0.5, "OVERWRITE": True})
    check_outputs("compare", compared)
    raster = run("compare", {"RASTER": first["MAX_DEPTH"], "OBSERVED": SCAR, "OUTPUT": os.path.join(folder, "raster")})
    check_outputs("compare", raster, {"RUNOUT_DIFFERENCE_M"})  # a raster alone has no path
    pages = run("render", {"RESULT": first["OUTPUT"], "MAPS": "max_depth, max_velocity", "SIZE": "640x480",
                           "FORMATS": ["png", "pdf"], "OUTPUT": os.path.join(folder, "drawn")})
    check_outputs("render", pages, {"ANIMATION"})
    assert pages["COUNT"] == 4 and all(os.path.isfile(path) for path in pages["FILES"].split("\n")), pages
    film = os.path.join(folder, "film.gif")
    check_outputs("render", run("render", {"RESULT": first["OUTPUT"], "ANIMATION": film, "SIZE": "640x480"}))
    check_outputs("converge", run("converge", {**scene("levels"), "terrain_cell_size": 10, "time_end": 2}))
    check_outputs("newscene", run("newscene", {**scene("new"), "OUTPUT": os.path.join(folder, "new", "slope.ini")}))


def test_outputs_of_many_runs():
    vary = ["Material: friction angle", "uniform(8, 16)", "release.volume", "uniform(3e4, 5e4)"]
    range_of_runs = run("ensemble", {**scene("range"), "VARY": vary, "SAMPLES": 4, **SMALL})
    check_outputs("ensemble", range_of_runs, {"EXPOSED_POINTS", "EXPOSED_LINES", "EXPOSED_AREAS", "EXPOSURE_TABLE",
                                              "EXPOSED_REACHED"})
    assert range_of_runs["FINISHED"] == 4
    # The plugin's classes of probability are the program's.
    from frana.algorithms.probability import style_probability
    theirs, ours = (QgsRasterLayer(range_of_runs["PROBABILITY"], "styled") for _ in range(2))
    style_probability(ours)
    classes = [[(item.value, item.color.name(), item.color.alpha()) for item in
                layer.renderer().shader().rasterShaderFunction().colorRampItemList()] for layer in (theirs, ours)]
    assert classes[0] == classes[1], classes
    event = run("newscene", {**scene("event", **OBSERVED), "OUTPUT": os.path.join(folder, "event", "event.ini")})
    check_outputs("calibrate", run("calibrate", {
        "SCENES": [event["OUTPUT"]], "VARY": ["material.friction-angle", "uniform(8, 16)"], "OBJECTIVE": ["jaccard", "1"],
        "SAMPLES": 8, "OUTPUT": os.path.join(folder, "calibrated")}))


def test_probability():
    """Two of three runs: cells that two of three exceed have 2/3, error sqrt(2/27); where none came, 0."""
    depths = [run("run", scene(f"run{angle}", material_friction_angle=angle, output_extent="reached"))["MAX_DEPTH"]
              for angle in (5, 15, 30)]
    found = run("probability", {"RASTERS": depths, "THRESHOLD": 0.5, "OUTPUT": os.path.join(folder, "probability.tif")})
    check_outputs("probability", found)
    data = gdal.Open(found["OUTPUT"])
    west, cell, _, north, _, _ = data.GetGeoTransform()
    expected = numpy.zeros((data.RasterYSize, data.RasterXSize))
    for path in depths:
        grid = gdal.Open(path)
        place = grid.GetGeoTransform()
        column, row = round((place[0] - west) / cell), round((north - place[3]) / cell)
        expected[row:row + grid.RasterYSize, column:column + grid.RasterXSize] += grid.ReadAsArray() > 0.5
    expected /= 3
    bands = data.ReadAsArray()
    assert numpy.allclose(bands[0], expected, atol=1e-7) and len(numpy.unique(bands[0])) == 4
    assert numpy.allclose(bands[1], numpy.sqrt(expected * (1 - expected) / 3), atol=1e-7)
    # The same for the program: it scores the map against an outline.
    check_outputs("compare", run("compare", {"RASTER": found["OUTPUT"], "OBSERVED": SCAR,
                                             "OUTPUT": os.path.join(folder, "scored")}), {
        "COMPARISON", "COMPARISON_PICTURE", "JACCARD", "AREA_DIFFERENCE_PERCENT", "TRUE_POSITIVE_RATE",
        "RUNOUT_DIFFERENCE_M"})


def source(kind, *place):
    return [getattr(QgsProcessingModelChildParameterSource, kind)(*place)]


def child(name, algorithm, **parameters):
    step = QgsProcessingModelChildAlgorithm(algorithm)
    step.setChildId(name)
    for parameter, sources in parameters.items():
        step.addParameterSources(parameter, sources)
    return step


def test_model():
    """Three steps: the release from a layer by its column, a run of it, a comparison of the run."""
    model = QgsProcessingModelAlgorithm("slope", "tests", "")
    for definition in (QgsProcessingParameterFeatureSource("areas", "Areas"), QgsProcessingParameterRasterLayer("dtm", "DTM"),
                       QgsProcessingParameterFeatureSource("survey", "Survey"),
                       QgsProcessingParameterNumber("thickness", "Thickness", QgsProcessingParameterNumber.Double)):
        model.addModelParameter(definition, QgsProcessingModelParameter(definition.name()))
    given, value, output = "fromModelParameter", "fromStaticValue", "fromChildOutput"
    model.addChildAlgorithm(child("pick", "native:extractbyattribute", INPUT=source(given, "areas"),
                                  FIELD=source(value, "thick"), OPERATOR=source(value, 0), VALUE=source(value, "3")))
    fixed = {name: source(value, text) for name, text in scene("model").items()
             if name not in ("terrain_dtm", "release_perimeter", "release_thickness", "OUTPUT")}
    slide = child("slide", "frana:run", terrain_dtm=source(given, "dtm"), release_perimeter=source(output, "pick", "OUTPUT"),
                  release_thickness=source("fromExpression", "to_string(@thickness)"), **fixed)
    result = QgsProcessingModelOutput("result", "result")
    result.setChildId("slide")
    result.setChildOutputName("OUTPUT")
    slide.setModelOutputs({"result": result})
    model.addChildAlgorithm(slide)
    last = child("score", "frana:compare", RESULT=source(output, "slide", "OUTPUT"), OBSERVED=source(given, "survey"))
    model.addChildAlgorithm(last)
    stored = os.path.join(folder, "slope.model3")
    assert model.toFile(stored)
    again = QgsProcessingModelAlgorithm()
    assert again.fromFile(stored)
    areas = polygons("POLYGON((529330 5094500, 529480 5094500, 529480 5094600, 529330 5094600, 529330 5094500))",
                     "POLYGON((529400 5094250, 529500 5094250, 529500 5094300, 529400 5094300, 529400 5094250))")
    told = Told()
    found = processing.run(again, {"areas": QgsProcessingFeatureSourceDefinition(areas.id(), False),
                                   "dtm": scene("model")["terrain_dtm"], "survey": SCAR, "thickness": 2,
                                   "slide:result": os.path.join(folder, "model"),
                                   "result": os.path.join(folder, "model")}, feedback=told)
    results = found["CHILD_RESULTS"]
    assert abs(results["slide"]["VOLUME_M3"] - 2 * 5000) < 1, results["slide"]
    check_outputs("compare", results["score"])
    assert results["score"]["OUTPUT"] == results["slide"]["OUTPUT"]


def load(name, parameters):
    """As the toolbox does: the algorithm, then what it asked QGIS to load."""
    from processing.gui.Postprocessing import handleAlgorithmResults
    algorithm = provider.algorithm(name).create()
    context = processing.createContext()
    context.setProject(QgsProject.instance())
    found, done = algorithm.run(parameters, context, Told())
    assert done
    assert handleAlgorithmResults(algorithm, context, Told(), False)
    return found


def test_loading():
    """The result's layers come in one group, styled, in order, the frames with their times."""
    project = QgsProject.instance()
    found = load("run", scene("loaded", **OBSERVED, output_title="My slope"))
    root = project.layerTreeRoot()
    groups = [child for child in root.children() if isinstance(child, QgsLayerTreeGroup)]
    assert [group.name() for group in groups] == ["My slope"], root.dump()
    inside = [child.name().split(" – ")[0] for child in groups[0].children()]
    assert inside == ["Outlines", "Maps", "Flow depth, t [s]", "Terrain"], inside
    layers = [node.layer() for node in root.findLayers()]
    assert len(layers) == len({layer.id() for layer in layers}) and all(layer.isValid() for layer in layers)
    by_file = {}
    for layer in layers:
        by_file.setdefault(os.path.basename(layer.source().split("|")[0]), []).append(layer)
    assert len(by_file["max_depth.tif"]) == 1, "max_depth.tif is there twice"
    assert len([node for node in root.findLayers() if node.parent() is root]) == 1, "only the drawn layer is outside"
    alone = QgsRasterLayer(found["MAX_DEPTH"], "alone")
    colours = [[item.color.name() for item in layer.renderer().shader().rasterShaderFunction().colorRampItemList()]
               for layer in (alone, by_file["max_depth.tif"][0])]
    assert colours[0] == colours[1] and len(colours[0]) > 3
    frames = [layer for layer in layers if os.path.basename(layer.source()).startswith("depth_")]
    assert len(frames) >= 4, [layer.source() for layer in layers]
    assert all(layer.temporalProperties().isActive() for layer in frames)
    assert project.timeSettings().temporalRange().begin() == frames[0].temporalProperties().fixedTemporalRange().begin()
    load("run", {**scene("quiet"), "LOAD": False})
    assert len([child for child in root.children() if isinstance(child, QgsLayerTreeGroup)]) == 1


def test_compared_later():
    """The outline of a later comparison is in the result's project and on its sheets."""
    found = run("run", scene("later"))
    run("compare", {"RESULT": found["OUTPUT"], "OBSERVED": SCAR})
    project = QgsProject()
    assert project.read(found["PROJECT"])
    survey = [layer for layer in project.mapLayers().values() if layer.name().startswith("Observed outline")]
    assert len(survey) == 1 and survey[0].isValid() and survey[0].featureCount() == 1, survey
    assert survey[0].crs().authid() == "EPSG:32632"
    layouts = project.layoutManager().printLayouts()
    assert layouts and all(survey[0] in layout.itemById("map").layers() for layout in layouts)


def test_region():
    """A polygon is a slope, its columns are the slope's: union, degree of hazard, exposure, all in the project."""
    slopes = polygons(UPPER, LOWER, mu=[0.15, 0.3], scen=["often", "rare"], years=[30, 300], label=["up", "low"])
    parameters = scene("region", release_perimeter=slopes, release_thickness_column="thick", FRICTION="mu", SCENARIO="scen",
                       RETURN_PERIOD="years", NAME="label", hazard_scheme="swiss-hillslope-debris-flow",
                       hazard_process="hillslope-debris-flow",
                       output_exposure=polygons(LOWER), **SMALL)
    del parameters["release_thickness"]
    assert "Scenario, from a column: " in refusal("batch", {**parameters, "SCENARIO": "nothing"})
    found = load("batch", parameters)
    check_outputs("batch", found, {"EXPOSED_POINTS", "EXPOSED_LINES"})
    assert (found["FINISHED"], found["FAILED"], found["EXPOSED_REACHED"]) == (2, 0, 1), found
    with open(found["MEMBERS"], encoding="utf-8", newline="") as table:
        rows = list(csv.DictReader(table))
    assert [row["name"] for row in rows] == ["up", "low"], rows
    assert [float(row["material.friction-coefficient"]) for row in rows] == [0.15, 0.3], rows
    released = [float(row["volume_m3"]) for row in rows]
    assert all(abs(one / wanted - 1) < 1e-6 for one, wanted in zip(released, (2 * 15000, 3 * 5000))), released
    depths, degrees = (gdal.Open(found[name]).ReadAsArray() for name in ("UNION_MAX_DEPTH", "HAZARD_DEGREE"))
    assert (degrees[depths > 1] >= 2).all() and (depths > 1).any()
    names = [node.layer().name() for node in QgsProject.instance().layerTreeRoot().findLayers()]
    for shown in ("Degree of hazard", "Exposed features"):
        assert any(name.startswith(shown) for name in names), names
    # The union is what the slopes do alone.
    alone = [run("run", scene(f"slope{mu}", release_perimeter=polygons(text), release_thickness=str(thickness),
                              material_friction_coefficient=mu))["MAX_DEPTH"]
             for text, mu, thickness in ((UPPER, 0.15, 2), (LOWER, 0.3, 3))]
    highest = max(gdal.Open(path).ReadAsArray().max() for path in alone)
    assert abs(depths.max() - highest) < 1e-6 * highest, (depths.max(), highest)


def test_events():
    """A column of the release area names events, each with its own outline; what is missing is told."""
    for upper, lower, names in (("Bürg", "lower's", ["B_rg", "lower_s"]), (20170823, 20180101, ["20170823", "20180101"])):
        layers = {name: polygons(*texts, event=[upper, lower]) for name, texts in (
            ("release", (UPPER, LOWER)), ("survey", (LOWER, UPPER)))}
        parameters = {**scene("events" + names[0], release_perimeter=layers["release"], observed_perimeter=layers["survey"],
                              EVENT="event", **SMALL),
                      "VARY": ["Material: Friction angle", "uniform(8, 16)"], "OBJECTIVE": ["jaccard", "1"],
                      "SAMPLES": 8}
        assert "Measures: none is given" in refusal("calibrate", {**parameters, "OBJECTIVE": None})
        assert "column of the surveyed outline: is missing" in refusal("calibrate", {
            **parameters, "observed_perimeter": polygons(LOWER)})
        found = run("calibrate", parameters)
        check_outputs("calibrate", found, {"BEST_SCENE"})  # each event has its own
        with open(found["CALIBRATION"], encoding="utf-8") as file:
            events = json.load(file)["events"]
        assert [event["name"] for event in events] == names, events
        best = run("run", {"SCENE": os.path.join(found["OUTPUT"], f"best_{names[0]}.ini"),
                           "OUTPUT": os.path.join(folder, "best" + names[0])})
        assert abs(best["VOLUME_M3"] / 45000 - 1) < 1e-6, best["VOLUME_M3"]


def test_dialogue():
    """The twelve are visible, the others under their sections' titles; nothing is needed and optional at once."""
    from qgis.PyQt.QtWidgets import QGroupBox, QLabel
    for name, seen in (("run", "Release area"), ("batch", "Return period [years], from a column"), ("calibrate", "Events: ")):
        dialogue = provider.algorithm(name).create().createCustomParametersWidget(None)
        boxes = {box.title(): box for box in dialogue.findChildren(QGroupBox)}
        sections = [title for title in boxes if title in ("Terrain", "Release", "Material", "Numerical method", "Output")]
        assert sections == ["Terrain", "Release", "Material", "Numerical method", "Output"], list(boxes)
        labels = [label.text() for label in dialogue.mainWidget().findChildren(QLabel)]
        assert any(text.startswith(seen) for text in labels), labels
        assert not any("optional" in text or "needed" in text for text in labels), labels
        inside = [label.text() for label in boxes["Numerical method"].findChildren(QLabel)]
        assert "Courant number (0.8; 0.5 for scheme paper; 0.9 for finite-volume and material.model = structured)" in inside or \
            "Courant number" in inside, inside
        dialogue.deleteLater()


def test_process_and_country():
    """They stand for preset, time and scheme, which the fields tell; what is filled in counts more; words and numbers."""
    from qgis.PyQt.QtWidgets import QLabel
    own = {name: None for name in ("material_preset", "time_end")}
    chosen = scene("process", PROCESS="debris-flow", COUNTRY="switzerland", **own)
    chosen = {name: value for name, value in chosen.items() if value is not None}
    found = run("run", {**chosen, "time_end": 6})
    with open(os.path.join(folder, "process-inputs", "process.ini"), encoding="utf-8") as file:
        text = file.read()
    for line in ("preset = debris-flow", "end = 6", "scheme = swiss-debris-flow", "process = channel-debris-flow"):
        assert "\n" + line + "\n" in text, text
    assert os.path.exists(os.path.join(found["OUTPUT"], "hazard.tif"))
    from frana.processes import COUNTRIES, PROCESSES, implied
    presets = provider.algorithm("run").program.presets
    for process in PROCESSES:
        for country in COUNTRIES:
            for key, text in implied(process, country, True).items():
                assert key not in presets or text in presets[key], (process, country, key, text)
            # By their numbers too, as scripts give choices; the program takes what they imply.
            numbers = {"PROCESS": list(PROCESSES).index(process), "COUNTRY": str(list(COUNTRIES).index(country))}
            years = {"material_return_period": 300} if process == "avalanche" else {}
            good, said = provider.algorithm("run").create().checkParameterValues(
                {**chosen, **numbers, **years, "terrain_cell_size": 40}, context())
            assert good, (process, country, said)
    assert "Process: is not one of the choices (value 9" in refusal("run", {**chosen, "PROCESS": 9})
    dialogue = provider.algorithm("run").create().createCustomParametersWidget(None)
    wrappers = dialogue.mainWidget().wrappers
    wrappers["PROCESS"].setParameterValue("mud", dialogue.mainWidget().processing_context)
    assert wrappers["material_preset"].wrappedLabel().text() == "Material preset (mudflow)"
    wrappers["PROCESS"].setParameterValue("avalanche", dialogue.mainWidget().processing_context)
    wrappers["COUNTRY"].setParameterValue("italy", dialogue.mainWidget().processing_context)
    labels = [label.text() for label in dialogue.mainWidget().findChildren(QLabel)]
    assert any(text.endswith("(italian-avalanche)") for text in labels), labels
    dialogue.deleteLater()


def test_dialogue_of_a_project():
    """The only terrain model is chosen, the folder lies beside the project, and the mouse wheel changes a clicked field alone."""
    from qgis.PyQt.QtCore import QPoint, QPointF, Qt
    from qgis.PyQt.QtGui import QWheelEvent
    from qgis.PyQt.QtWidgets import QAbstractSpinBox, QApplication, QComboBox
    project = QgsProject.instance()
    project.write(os.path.join(folder, "project.qgz"))
    layer = QgsRasterLayer(scene("x")["terrain_dtm"], "ground")
    project.addMapLayer(layer)
    dialogue = provider.algorithm("run").create().createCustomParametersWidget(None)
    page = dialogue.mainWidget()
    assert page.wrappers["terrain_dtm"].parameterValue() == layer.id()
    assert page.wrappers["OUTPUT"].parameterValue() == os.path.join(folder, "frana-run-1")
    dialogue.show()
    fields = page.findChildren(QAbstractSpinBox) + page.findChildren(QComboBox)
    assert len(fields) > 60, len(fields)
    before = page.createProcessingParameters()
    for field in fields:
        for turn in (120, -120):
            QApplication.sendEvent(field, QWheelEvent(QPointF(3, 3), QPointF(3, 3), QPoint(0, 0), QPoint(0, turn), Qt.NoButton,
                                                      Qt.NoModifier, Qt.NoScrollPhase, False))
    assert page.createProcessingParameters() == before
    dialogue.activateWindow()
    size = page.wrappers["terrain_cell_size"].wrappedWidget()
    size = size if isinstance(size, QAbstractSpinBox) else size.findChildren(QAbstractSpinBox)[0]
    size.setFocus()
    QApplication.processEvents()
    QApplication.sendEvent(size, QWheelEvent(QPointF(3, 3), QPointF(3, 3), QPoint(0, 0), QPoint(0, 120), Qt.NoButton,
                                             Qt.NoModifier, Qt.NoScrollPhase, False))
    assert not size.hasFocus() or page.createProcessingParameters() != before
    assert size.hasFocus(), "the platform gives no focus: the second half was not tried"
    project.addMapLayer(QgsRasterLayer(scene("x")["terrain_dtm"], "other ground"))
    other = provider.algorithm("run").create().createCustomParametersWidget(None)
    assert not other.mainWidget().wrappers["terrain_dtm"].parameterValue(), "one of two was chosen"
    project.clear()


def test_language():
    """Fields are named in the language of QGIS, messages too."""
    settings = QgsSettings()
    settings.setValue("locale/overrideFlag", True)
    settings.setValue("locale/userLocale", "de_AT")
    try:
        provider.refreshAlgorithms()
        algorithm = provider.algorithm("run")
        assert algorithm.parameterDefinition("release_perimeter").description() == "Anrissgebiet"
        number = algorithm.parameterDefinition("numerics_cfl").description()
        assert number.startswith("Numerisches Verfahren: Courant-Zahl"), number
        assert (algorithm.displayName(), algorithm.group(), algorithm.groupId()) == ("Eine Szene rechnen", "Ein Lauf", "one_run")
        assert algorithm.parameterDefinition("RESUME").description() == "Abgebrochenen Lauf fortsetzen"
        assert "Zahl der Auflösungen: liegt außerhalb" in refusal("converge", scene("few", LEVELS=2))
        said = refusal("run", {"terrain_dtm": scene("x")["terrain_dtm"], "material_preset": "debris-flow",
                               "release_thickness": "2", "OUTPUT": os.path.join(folder, "x")})
        assert said.startswith("Anrissgebiet: "), said
    finally:
        settings.setValue("locale/userLocale", "en")
        provider.refreshAlgorithms()


def test_every_text_is_translated():
    """The catalogues have what the algorithms declare and what the sources translate, no more and no less."""
    shown, catalogue = set(), translation.catalogue
    translation.catalogue = lambda language: type("Asked", (), {"get": staticmethod(shown.add)})
    try:
        provider.refreshAlgorithms()
        for algorithm in provider.algorithms():
            algorithm.displayName(), algorithm.group(), algorithm.shortHelpString()
            shown.update(algorithm.NAMES.values())
    finally:
        translation.catalogue = catalogue
        provider.refreshAlgorithms()
    package = pathlib.Path(translation.__file__).parent
    for source in package.rglob("*.py"):
        for call in ast.walk(ast.parse(source.read_text(encoding="utf-8"))):
            if isinstance(call, ast.Call) and isinstance(call.func, ast.Name) and call.func.id == "tr":
                shown.update(one.value for one in ast.walk(call.args[0]) if isinstance(one, ast.Constant))
    assert len(shown) > 250, "the search has found the texts"
    languages = sorted(file.stem for file in package.glob("po/*.po"))
    assert languages == ["de", "es", "fr", "it"], languages
    for language in languages:
        texts = {english: text for english, text in catalogue(language).items() if english}
        assert set(texts) == shown, (language, sorted(set(texts) ^ shown))
        for english, text in texts.items():
            assert text and sorted(re.findall("{.*?}", text)) == sorted(re.findall("{.*?}", english)), (language, text)


def test_new_key():
    """A key that a newer program has appears by itself; a command that an older one lacks has no algorithm."""
    row = {"name": "material.stickiness", "section": "material", "key": "stickiness", "type": "number", "unit": "N",
           "default": None, "when_absent": "not sticky", "limits": "0.5 to 9", "meaning": "How sticky it is.", "title": "stickiness",
           "section_title": "Material", "required": False}
    choice = {**row, "name": "novel.colour", "section": "novel", "key": "colour", "type": "choice", "unit": "",
              "limits": "red, dark-blue"}
    layer = {**row, "name": "novel.trees", "section": "novel", "key": "trees", "type": "file", "content": "points",
             "limits": ""}
    program = os.path.join(folder, "newer")
    keys = json.dumps([row, choice, layer])
    with open(program, "w", encoding="utf-8") as file:
        file.write(f"""#!/usr/bin/python3
import json, subprocess, sys
answer = subprocess.run([{FRANA!r}, *sys.argv[1:]], capture_output=True)
text = answer.stdout.decode()
if sys.argv[1:3] == ["params", "--json"]:
    text = json.dumps(json.loads(text) + {keys.replace("null", "None").replace("false", "False")})
if sys.argv[1:] == ["--help"]:
    text = "\\n".join(line for line in text.split("\\n") if not line.startswith("  calibrate"))
sys.stdout.write(text)
sys.stderr.write(answer.stderr.decode())
sys.exit(answer.returncode)
""")
    os.chmod(program, os.stat(program).st_mode | stat.S_IXUSR)
    assert provider.algorithm("calibrate") is not None
    use_program(program)
    assert provider.algorithm("calibrate") is None and provider.algorithm("run") is not None
    algorithm = provider.algorithm("run")
    number = algorithm.parameterDefinition("material_stickiness")
    assert number.type() == "number" and (number.minimum(), number.maximum()) == (0.5, 9)
    assert number.description() == "Material: Stickiness [N] (not sticky)", number.description()
    assert number.defaultValue() is None and number.flags() & QgsProcessingParameterDefinition.FlagAdvanced
    assert algorithm.parameterDefinition("novel_colour").options() == ["red", "dark-blue"]
    assert algorithm.parameterDefinition("novel_trees").type() == "source"
    from frana.fields import Values, fields_of
    from frana.program import ask_program
    fields = {field.key.name: field for field in fields_of(ask_program().keys, {})}
    from qgis.core import QgsProcessingContext
    values = Values(algorithm, {"material_stickiness": 2.5, "novel_colour": "dark-blue"}, QgsProcessingContext())
    assert fields["material.stickiness"].value(values) == "2.5" and fields["novel.colour"].value(values) == "dark-blue"
    use_program("/nowhere/frana")
    assert not provider.algorithms() and "/nowhere/frana" in provider.warningMessage(), provider.warningMessage()


def test_every_key():
    """Every key of the program but the folder of the result and fixed values has a parameter of its kind."""
    import subprocess
    keys = json.loads(subprocess.run([FRANA, "params", "--json"], capture_output=True, check=True).stdout)
    algorithm = provider.algorithm("run")
    kinds = {"raster": "raster", "polygons": "source", "lines": "source", "points": "source", "lines or points": "source",
             "points, lines or polygons": "source", "raster or polygons": "layer", "table": "file"}
    first = [definition.name() for definition in algorithm.parameterDefinitions()
             if not definition.flags() & QgsProcessingParameterDefinition.FlagAdvanced]
    assert first == ["PROCESS", "COUNTRY", "terrain_dtm", "release_perimeter", "release_thickness", "release_thickness_column",
                     "release_dtm_contains_release", "material_return_period", "terrain_cell_size", "observed_perimeter",
                     "output_exposure", "OUTPUT"], first
    for key in keys:
        if key["name"] in ("scene.format", "output.directory"):
            continue
        name = key["name"].replace(".", "_").replace("-", "_")
        parameter = algorithm.parameterDefinition(name)
        assert parameter is not None, key["name"]
        assert parameter.flags() & QgsProcessingParameterDefinition.FlagOptional
        if key["type"] == "file":
            assert parameter.type() == kinds[key["content"]], (key["name"], parameter.type())
        elif key["type"] == "choice":
            assert parameter.type() == "enum", key["name"]
        elif key["type"] == "on | off":
            assert parameter.type() == ("boolean" if key["default"] else "enum"), key["name"]
        if parameter.type() != "boolean":
            assert parameter.defaultValue() is None, (key["name"], parameter.defaultValue())


main({name[len("test_"):]: test for name, test in list(globals().items()) if name.startswith("test_")})
