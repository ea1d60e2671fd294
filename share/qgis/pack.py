# SPDX-License-Identifier: Apache-2.0
"""Usage: pack.py ZIP FOLDER. Packs a folder with the same bytes every time: names sorted, one time, one mode."""
import pathlib
import sys
import zipfile

target, folder = sys.argv[1], pathlib.Path(sys.argv[2])
with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
    for file in sorted(folder.rglob("*"), key=lambda path: path.as_posix()):
        if file.is_file():
            entry = zipfile.ZipInfo(file.relative_to(folder).as_posix(), (2000, 1, 1, 0, 0, 0))
            entry.create_system, entry.external_attr, entry.compress_type = 3, 0o100644 << 16, zipfile.ZIP_DEFLATED
            archive.writestr(entry, file.read_bytes())
