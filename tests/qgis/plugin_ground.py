# SPDX-License-Identifier: Apache-2.0
"""QGIS with the plugin's provider, on a profile of its own, and a small scene: the sample on coarse cells."""
import find_qgis  # noqa: F401 (first: it sets the environment)
import os
import shutil
import sys
import tempfile
import traceback

sys.dont_write_bytecode = True
os.environ["LC_ALL"] = "C.UTF-8"  # maps and projects in English
FRANA, SAMPLE, PLUGINS = sys.argv[2:5]
sys.path[:0] = [PLUGINS, "/usr/share/qgis/python/plugins"]

from qgis.core import (QgsApplication, QgsFeature, QgsField, QgsGeometry, QgsProcessingContext,  # noqa: E402
                       QgsProcessingFeedback, QgsProject, QgsSettings, QgsVectorLayer)
from qgis.PyQt.QtCore import QVariant  # noqa: E402

application = QgsApplication([], True)
application.initQgis()
from processing.core.Processing import Processing  # noqa: E402
import processing  # noqa: E402

Processing.initialize()
PROGRAM_SETTING = "Processing/Configuration/FRANA_PROGRAM"
QgsSettings().setValue(PROGRAM_SETTING, FRANA)
from frana.provider import FranaProvider  # noqa: E402

provider = FranaProvider()
QgsApplication.processingRegistry().addProvider(provider)
folder = tempfile.mkdtemp(prefix="frana_qgis_test_")


def use_program(program):
    """Sets the program; the provider asks another one for its keys and commands."""
    if QgsSettings().value(PROGRAM_SETTING) != program:
        QgsSettings().setValue(PROGRAM_SETTING, program)
        provider.refreshAlgorithms()


DTM, SCAR = os.path.join(SAMPLE, "dtm.tif"), os.path.join(SAMPLE, "scar.shp")
# In EPSG:32632, on the sample's slope.
UPPER = "POLYGON((529330 5094500, 529480 5094500, 529480 5094600, 529330 5094600, 529330 5094500))"
LOWER = ("MULTIPOLYGON(((529400 5094250, 529450 5094250, 529450 5094300, 529400 5094300, 529400 5094250)), "
         "((529460 5094250, 529510 5094250, 529510 5094300, 529460 5094300, 529460 5094250)))")


def polygons(*texts, crs="EPSG:32632", **columns):
    """A layer in memory, as a user draws one. `columns`: of each a value for every polygon, texts or numbers."""
    layer = QgsVectorLayer("Polygon?crs=" + crs, "drawn", "memory")
    layer.dataProvider().addAttributes(
        [QgsField("fid", QVariant.Int), QgsField("thick", QVariant.Double)] +
        [QgsField(name, QVariant.String if isinstance(values[0], str) else QVariant.Double)
         for name, values in columns.items()])
    layer.updateFields()
    for number, text in enumerate(texts):
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromWkt(text))
        # The same fid twice: a column, not a key.
        feature.setAttributes([7, 2.0 + number, *(values[number] for values in columns.values())])
        layer.dataProvider().addFeature(feature)
    layer.updateExtents()
    QgsProject.instance().addMapLayer(layer)
    return layer


def drawn(kind, text):
    """A layer in memory with one feature."""
    layer = QgsVectorLayer(kind + "?crs=EPSG:32632", "drawn", "memory")
    feature = QgsFeature(layer.fields())
    feature.setGeometry(QgsGeometry.fromWkt(text))
    layer.dataProvider().addFeature(feature)
    QgsProject.instance().addMapLayer(layer)
    return layer


def scene(name, **more):
    """Parameters of a run that takes a second."""
    return {"terrain_dtm": DTM, "terrain_cell_size": 20, "release_perimeter": polygons(UPPER), "release_thickness": "3",
            "material_preset": "debris-flow", "time_end": 6, "time_frame_interval": 2, "output_maps": ["off"],
            "output_animation": False, "output_charts": False, "output_report": False,
            "OUTPUT": os.path.join(folder, name), **more}


class Told(QgsProcessingFeedback):
    """Keeps what was said."""

    def __init__(self):
        super().__init__(False)
        self.errors, self.infos, self.warnings, self.seen = [], [], [], []
        self.progressChanged.connect(self.seen.append)

    def reportError(self, error, fatalError=False):
        self.errors.append(error)

    def pushInfo(self, info):
        self.infos.append(info)

    def pushWarning(self, warning):
        self.warnings.append(warning)


def run(name, parameters, feedback=None, context=None):
    """As a script runs it: the check first, then the algorithm."""
    return processing.run("frana:" + name, parameters, feedback=feedback or Told(), context=context,
                          is_child_algorithm=False)


def context():
    """That of the project."""
    made = QgsProcessingContext()
    made.setProject(QgsProject.instance())
    return made


def refusal(name, parameters):
    """What the dialogue says before anything runs."""
    good, message = provider.algorithm(name).create().checkParameterValues(parameters, context())
    assert not good, "not refused"
    return message


def main(tests):
    """Runs the tests that the first argument names, separated by commas, or all of them, each with an empty project, and
    goes on after one that fails. QGIS may crash while it leaves: the verdict is given before."""
    names = list(tests) if sys.argv[1] == "all" else sys.argv[1].split(",")
    failed = []
    for name in names:
        QgsProject.instance().clear()
        use_program(FRANA)
        os.chdir("/")
        try:
            tests[name]()
            print("good:", name, flush=True)
        except Exception:
            traceback.print_exc()
            print("FAILED:", name, flush=True)
            failed.append(name)
    print(len(names) - len(failed), "of", len(names), "good; failed:", ", ".join(failed) or "none")
    sys.stdout.flush()
    sys.stderr.flush()
    shutil.rmtree(folder, ignore_errors=True)
    shutil.rmtree(os.environ["QGIS_CUSTOM_CONFIG_PATH"], ignore_errors=True)
    os._exit(1 if failed or not names else 0)
