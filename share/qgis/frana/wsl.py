# SPDX-License-Identifier: Apache-2.0
"""On Windows the program runs in the Windows Subsystem for Linux, which has the drive C: at /mnt/c."""
from __future__ import annotations

import os
import re


def is_wsl(path: str) -> bool:
    return re.split(r"[\\/]", path)[-1].lower() == "wsl.exe"


def command(path: str, words: list[str]) -> list[str]:
    """The words that start the program with `words`."""
    return [path, "--", "frana", *map(inside, words)] if is_wsl(path) else [path, *words]


def inside(text: str) -> str:
    """A path as the program sees it, also behind "key=" or "raster:"; other texts as they are."""
    translated = re.sub(r"(^|=|raster:|, )([A-Za-z]):[\\/]", lambda found: f"{found[1]}/mnt/{found[2].lower()}/", text)
    return translated.replace("\\", "/") if translated != text or os.sep == "\\" else text


def outside(text: str) -> str:
    """A sentence of the program with paths as Windows has them."""
    return re.sub(r"/mnt/([a-z])((?:/[^/\s:,;]+)+)", lambda found: found[1].upper() + ":" + found[2].replace("/", "\\"), text)
