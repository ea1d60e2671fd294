# SPDX-License-Identifier: Apache-2.0
"""As an administrator does: the plugin into a new profile, then qgis_process: plugin_headless.py FRANA SAMPLE ZIP.

Also the zip that QGIS's plugin manager takes: what is in it, and that QGIS runs it."""
import find_qgis  # noqa: F401
import configparser
import json
import os
import shutil
import subprocess
import sys
import tempfile
import zipfile

frana, sample, archive = sys.argv[1:]
# Debian's qgis_process is a script that gives the program a word which it does not know.
qgis_process = shutil.which("qgis_process.bin") or shutil.which("qgis_process")
if qgis_process is None:
    print("qgis_process (Debian: qgis) is not installed")
    sys.exit(77)
place = tempfile.mkdtemp(prefix="frana_qgis_headless_")
environment = dict(os.environ, QGIS_CUSTOM_CONFIG_PATH=place, XDG_RUNTIME_DIR=place, PATH="/usr/bin:/bin")


def ask(*words, code=0):
    done = subprocess.run(words, env=environment, capture_output=True, text=True, timeout=200)
    assert done.returncode == code, (words, done.returncode, done.stdout[-2000:], done.stderr[-2000:])
    return done


def run_headless(out, *more, code=0):
    return ask(qgis_process, "--json", "run", "frana:run", "--", f"terrain_dtm={sample}/dtm.tif", "terrain_cell_size=20",
               f"release_perimeter={sample}/perimeter.shp", "release_thickness=5", "material_preset=bindo", "time_end=4",
               "output_maps=off", "output_animation=0", "output_charts=0", "output_report=0", f"OUTPUT={place}/{out}", *more,
               code=code)


installing = ask(frana, "qgis-plugin", "--install")
installed = installing.stdout.strip()
if shutil.which("qgis_process.bin"):  # Debian 12, whose script qgis_process does not work
    assert "qgis_process.bin plugins enable frana" in installing.stderr, installing.stderr
assert installed == os.path.join(place, "profiles/default/python/plugins/frana"), installed
ask(qgis_process, "plugins", "enable", "frana")
found = json.loads(run_headless("first").stdout)["results"]
assert os.path.isfile(found["MAX_DEPTH"]) and found["VOLUME_M3"] > 0, found
refused = run_headless("second", "numerics_cfl=7", code=1)
assert "Numerical method: Courant number: is out of range (value 7" in refused.stdout + refused.stderr, refused

with zipfile.ZipFile(archive) as package:
    names = [name for name in package.namelist() if not name.endswith("/")]
    assert {name.split("/")[0] for name in names} == {"frana"}, names
    assert "frana/LICENSE" in names
    metadata = configparser.ConfigParser()
    metadata.read_string(package.read("frana/metadata.txt").decode())
    general = metadata["general"]
    for field in ("name", "qgisMinimumVersion", "description", "about", "version", "author", "email", "icon"):
        assert general[field], field
    assert not {"homepage", "tracker", "repository"} & set(general), "an address that does not exist"
    assert general["hasProcessingProvider"] == "yes" and "frana/" + general["icon"] in names
    assert ask(frana, "--version").stdout.split()[1] == general["version"], "the program has another version"
    written = {os.path.relpath(os.path.join(where, name), installed) for where, _, files in os.walk(installed)
               for name in files if "__pycache__" not in where}
    assert {name[len("frana/"):] for name in names} == (written - {"program.txt"}) | {"LICENSE"}, names
    shutil.rmtree(installed)
    package.extractall(os.path.dirname(installed))
environment["PATH"] = os.path.dirname(frana) + ":" + environment["PATH"]  # nothing else says where the program is
found = json.loads(run_headless("third").stdout)["results"]
assert os.path.isfile(found["MAX_DEPTH"])
shutil.rmtree(place, ignore_errors=True)
print("good")
