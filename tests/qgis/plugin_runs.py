# SPDX-License-Identifier: Apache-2.0
"""Runs through the plugin: plugin_runs.py TESTS FRANA SAMPLE PLUGINS."""
from plugin_ground import (DTM, FRANA, LOWER, SCAR, UPPER, Told, folder, main, polygons, processing, provider, refusal, run,
                           scene, use_program)
import os

from osgeo import gdal
from qgis.core import (QgsCoordinateReferenceSystem, QgsCoordinateTransform, QgsGeometry, QgsProcessingException,
                       QgsProcessingFeatureSourceDefinition, QgsProject, QgsRasterLayer)


def values(path):
    return gdal.Open(path).ReadAsArray()


def test_progress_and_cancel():
    """Progress is told; a cancelled run is resumed and gives the bits of an undisturbed one."""
    parameters = dict(terrain_cell_size=5, time_end=200, release_thickness="8", time_stop_change=0)
    told = Told()
    straight = run("run", scene("straight", **parameters), told)
    assert len(told.seen) >= 3 and told.seen == sorted(told.seen), told.seen
    assert all(0 <= percent <= 100 for percent in told.seen)
    feedback = Told()
    feedback.progressChanged.connect(lambda percent: feedback.cancel() if percent > 20 else None)
    stopped = scene("stopped", **parameters)
    try:
        run("run", stopped, feedback)
    except QgsProcessingException as error:
        said = str(error)
    else:
        raise AssertionError("the cancelled run ended as if nothing had been")
    assert "Stopped" in said and "Resume" in said and stopped["OUTPUT"] in said, said
    assert os.path.isdir(os.path.join(stopped["OUTPUT"], "checkpoint"))
    told = Told()
    resumed = run("run", {**stopped, "RESUME": True}, told)
    assert any("resum" in line for line in told.infos), told.infos
    assert resumed["SIMULATED_SECONDS"] == straight["SIMULATED_SECONDS"]
    assert (values(resumed["MAX_DEPTH"]) == values(straight["MAX_DEPTH"])).all()


def test_other_crs():
    """A polygon drawn in degrees is released where it lies."""
    there = QgsCoordinateTransform(QgsCoordinateReferenceSystem("EPSG:32632"), QgsCoordinateReferenceSystem("EPSG:4326"),
                                   QgsProject.instance())
    shape = QgsGeometry.fromWkt(UPPER).densifyByCount(20)
    shape.transform(there)
    own, other = run("run", scene("own")), run("run", scene("other", release_perimeter=polygons(
        shape.asWkt(12), crs="EPSG:4326")))
    assert abs(own["VOLUME_M3"] / 45000 - 1) < 1e-6, own["VOLUME_M3"]  # 150 m x 100 m x 3 m
    assert abs(other["VOLUME_M3"] / own["VOLUME_M3"] - 1) < 1e-4, other["VOLUME_M3"]
    assert abs(QgsRasterLayer(other["RELEASE"]).extent().center().x() -
               QgsRasterLayer(own["RELEASE"]).extent().center().x()) < 1


def test_corrected_crs():
    """A terrain whose CRS the user sets in the project is read with that one."""
    bare = os.path.join(folder, "bare.tif")
    own = gdal.Open(DTM)
    copy = gdal.GetDriverByName("GTiff").Create(bare, own.RasterXSize, own.RasterYSize, 1, gdal.GDT_Float32)
    copy.SetGeoTransform(own.GetGeoTransform())
    copy.GetRasterBand(1).WriteArray(own.ReadAsArray())
    del copy
    layer = QgsRasterLayer(bare, "bare")
    assert "Terrain model (DTM)" in refusal("run", scene("bare", terrain_dtm=layer, release_perimeter=polygons(UPPER, crs="")))
    layer.setCrs(QgsCoordinateReferenceSystem("EPSG:32632"))
    assert "32632" in run("run", scene("bare", terrain_dtm=layer))["CRS_USED"]


def test_selected():
    """Only the selected polygon fails; none selected is refused with a sentence."""
    layer = polygons(UPPER, LOWER)
    chosen = QgsProcessingFeatureSourceDefinition(layer.id(), True)
    message = refusal("run", scene("none", release_perimeter=chosen))
    assert message.startswith("Release area: ") and "selected" in message, message
    layer.selectByIds([max(layer.allFeatureIds())])
    both = run("run", scene("both", release_perimeter=layer))
    one = run("run", scene("one", release_perimeter=chosen))
    assert abs(both["VOLUME_M3"] - 60000) < 1 and abs(one["VOLUME_M3"] - 15000) < 1, (both["VOLUME_M3"], one["VOLUME_M3"])


def test_column():
    """A thickness from a column, of a layer whose column fid repeats."""
    parameters = scene("column", release_perimeter=polygons(UPPER, LOWER), release_thickness_column="thick")
    del parameters["release_thickness"]
    found = run("run", parameters)
    assert abs(found["VOLUME_M3"] - 2 * 15000 - 3 * 5000) < 1, found["VOLUME_M3"]


def test_bad_value():
    """Each sentence begins with the field's name; nothing is written."""
    parameters = scene("bad", numerics_cfl=3, release_thickness="-3", terrain_bounds="1 2 3")
    message = refusal("run", parameters)
    lines = message.split("\n")
    assert len(lines) == 3, message
    for field in ("Numerical method: Courant number: is out of range (value 3", "Release thickness: ", "Terrain: Part of the DTM: "):
        assert any(line.startswith(field) for line in lines), message
    try:
        run("run", parameters)
    except QgsProcessingException as error:
        assert "Courant number" in str(error), error
    else:
        raise AssertionError("not refused")
    assert not os.path.exists(parameters["OUTPUT"])
    empty = refusal("run", {"OUTPUT": parameters["OUTPUT"]})
    assert "Terrain model (DTM): is missing" in empty, empty
    # A problem found only when the files are read, too.
    outside = "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0))"
    assert "Release area: " in refusal("run", scene("bad", release_perimeter=polygons(outside)))


def test_written_values():
    """Texts, as a command line and a batch give them: one that is no number is not 0, "no" is not yes."""
    texts = {"material_friction_coefficient": "0,2", "material_viscosity": "abc", "output_report": "no", "THREADS": "1.5"}
    message = refusal("run", scene("texts", **texts))
    for sentence in ("Material: Friction coefficient: is not a number (value 0,2). Write a point",
                     "Material: Viscosity: is not a number (value abc)", "is neither true nor false (value no)",
                     "is not a whole number (value 1.5)"):
        assert sentence in message, message
    message = refusal("run", scene("choices", material_preset="mudflo", output_maps=["off", "depth_of"]))
    assert "Material: Material preset: is not one of the choices (value mudflo; allowed " in message, message
    assert "Maps: is not one of the choices (value depth_of; " in message and message.count("\n") == 1, message
    assert "Number of resolutions: is out of range (value 2; allowed 3 to 6)" in refusal("converge", scene("few", LEVELS=2))
    assert "Measures: none is given" in refusal("calibrate", {"SCENES": [DTM], "OUTPUT": os.path.join(folder, "none")})
    try:
        run("run", scene("place", OUTPUT="/proc/nowhere/out"))
    except QgsProcessingException as error:
        assert "Folder of the result: " in str(error) and "cannot be made" in str(error), error
    else:
        raise AssertionError("not refused")
    assert "is not a number" in refusal("probability", {"RASTERS": [DTM, DTM], "THRESHOLD": "0,5", "OUTPUT": "TEMPORARY_OUTPUT"})
    good = run("run", scene("good", time_end="6", material_friction_coefficient="2e-1", output_report="false", THREADS="1"))
    with open(os.path.join(good["OUTPUT"], "scene.ini"), encoding="utf-8") as file:
        assert "friction-coefficient = 0.2" in file.read()


def test_refusals_elsewhere():
    """Studies, folders and comparisons name their fields too."""
    message = refusal("ensemble", scene("range", VARY=["material.friction-angel", "uniform(1, 2)", "Release: Volume", "unif(1)"]))
    assert message.startswith("Uncertain values: material.friction-angel: unknown key"), message
    assert "\nUncertain values: Release: Volume: 'unif' is not a distribution" in message, message
    assert refusal("ensemble", scene("range")).startswith("Uncertain values: no row is given")
    message = refusal("ensemble", scene("rare", VARY=["release.volume", "uniform(3e4, 5e4)"], SAMPLES=10,
                                        SAMPLING="importance", RARE_PLACE="house"))
    assert "are too few for the rounds of sampling = importance" in message and "rare-place" not in message, message
    first = scene("taken")
    run("run", first)
    for name, parameters, said in (
            ("run", first, "Folder of the result: contains a result already"),
            ("compare", {"RESULT": folder, "OBSERVED": SCAR}, "Folder of a result: "),
            ("compare", {"RESULT": first["OUTPUT"], "OBSERVED": polygons("POLYGON((0 0, 9 0, 9 9, 0 0))", crs="")},
             "Surveyed areas: "),
            ("render", {"RESULT": first["OUTPUT"], "MAPS": "nothing"}, "Rasters to draw: is not a raster"),
            ("render", {"RESULT": first["OUTPUT"], "SIZE": "3"}, "Size: is not a picture's size")):
        try:
            run(name, parameters)
        except QgsProcessingException as error:
            assert said in str(error), (name, str(error))
        else:
            raise AssertionError(f"{name} not refused: {said}")


def test_not_given():
    """What is not given is not in the scene: the preset keeps its values, defaults remain defaults."""
    parameters = scene("absent", material_density=None, numerics_well_balanced=None, numerics_scheme=None)
    run("run", parameters)
    with open(parameters["OUTPUT"] + "-inputs/absent.ini", encoding="utf-8") as file:
        lines = [line.split(" = ")[0] for line in file.read().splitlines() if " = " in line and line[0] != "#"]
    assert sorted(lines) == sorted(["dtm", "cell-size", "perimeter", "thickness", "preset", "end", "frame-interval", "maps",
                                    "animation", "charts", "report"]), lines


def test_folder_like_an_option():
    """A name that the program would take for an option is a folder."""
    os.chdir(folder)
    found = run("run", {**scene("unused"), "OUTPUT": "--overwrite"})
    assert found["OUTPUT"] == os.path.join(folder, "--overwrite") and os.path.isfile(found["MAX_DEPTH"]), found


def test_title():
    """Maps and groups are called as the result, or as the release layer if the result is temporary."""
    import json
    for out, name in ((scene("Valley 2")["OUTPUT"], "Valley 2"), ("TEMPORARY_OUTPUT", "drawn")):
        found = run("run", scene("x", OUTPUT=out))
        with open(found["SUMMARY"], encoding="utf-8") as file:
            assert os.path.basename(json.load(file)["scene"]) == name + ".ini"


def test_batch():
    """Rows of a batch, as QGIS runs them, each checked and run alone."""
    thickness = ["2", "4"]
    rows = [scene(f"row{text}", release_thickness=text) for text in thickness]
    volumes = []
    for row in rows:
        algorithm = provider.algorithm("run").create()
        context = processing.createContext()
        good, message = algorithm.checkParameterValues(row, context)
        assert good, message
        found, done = algorithm.run(row, context, Told())
        assert done
        volumes.append(found["VOLUME_M3"])
    assert abs(volumes[1] / volumes[0] - 2) < 1e-6, volumes


def test_scene_file():
    """A scene file with one value changed; the box that the file sets otherwise is told."""
    written = run("newscene", {**scene("kept"), "OUTPUT": os.path.join(folder, "kept", "slope.ini")})
    told = Told()
    found = run("run", {"SCENE": written["OUTPUT"], "release_thickness": "6", "OUTPUT": os.path.join(folder, "from")}, told)
    assert abs(found["VOLUME_M3"] - 90000) < 1, found["VOLUME_M3"]
    assert any("Output: Animation: off, as in the scene file" in line for line in told.infos), told.infos


def test_windows():
    """Through a stand-in for wsl.exe, which starts the program as Windows' own would; paths go there and back."""
    from frana import process, wsl
    for there, here in (("C:\\Hazard maps\\dtm.tif", "/mnt/c/Hazard maps/dtm.tif"), ("raster:d:/x/t.tif", "raster:/mnt/d/x/t.tif"),
                        ("terrain.dtm=E:\\a\\b.tif", "terrain.dtm=/mnt/e/a/b.tif"), ("--out", "--out"), ("0.5", "0.5"),
                        ("C:\\a.ini, D:\\b.ini", "/mnt/c/a.ini, /mnt/d/b.ini")):
        assert wsl.inside(there) == here, (there, wsl.inside(there))
    assert wsl.outside("/mnt/c/maps/dtm.tif: is missing") == "C:\\maps\\dtm.tif: is missing"
    assert wsl.outside("m/mnt is no drive, 3 m/s") == "m/mnt is no drive, 3 m/s"
    program, log = os.path.join(folder, "wsl.exe"), os.path.join(folder, "wsl.log")
    with open(program, "w", encoding="utf-8") as file:
        file.write(f"""#!/bin/sh
echo "$@" >> '{log}'
[ "$1" = -- ] || exit 9
shift
if [ "$1" = frana ]; then shift; exec '{FRANA}' "$@"; fi
exec "$@"
""")
    os.chmod(program, 0o755)
    terminal, process.pty = process.pty, None  # which Windows has not
    use_program(program)
    try:
        direct = run("run", scene("windows"))
        assert abs(direct["VOLUME_M3"] / 45000 - 1) < 1e-6, direct["VOLUME_M3"]
        assert "Release thickness" in refusal("run", scene("bad windows", release_thickness="-3"))
        feedback = Told()
        stopped = scene("cancelled windows", terrain_cell_size=5, time_end=6000, release_thickness="8", time_stop_change=0)
        import threading
        threading.Timer(4, feedback.cancel).start()
        try:
            run("run", stopped, feedback)
        except QgsProcessingException as error:
            assert "Stopped" in str(error), error
        else:
            raise AssertionError("the cancelled run ended as if nothing had been")
    finally:
        process.pty = terminal
        use_program(FRANA)
    with open(log, encoding="utf-8") as file:
        calls = file.read()
    assert "-- frana run " in calls and "-- pkill -INT -f -- --out" in calls, calls


def test_observed_deposit():
    """A raster where a raster or polygons may be given."""
    found = run("run", scene("deposit", observed_perimeter=SCAR, observed_deposit=scene("x")["terrain_dtm"]))
    assert "JACCARD" in found


main({name[len("test_"):]: test for name, test in list(globals().items()) if name.startswith("test_")})
