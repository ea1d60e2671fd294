# SPDX-License-Identifier: Apache-2.0
"""frana: run-out of landslides, debris flows and avalanches, from numpy arrays to numpy arrays.

    import frana
    scene = frana.Scene(elevations, cell_size=5)       # rows x columns of float64 [m], the northernmost row first
    scene["material.friction-coefficient"] = 0.2       # any key of scene files that needs no file
    scene.add_release(3.0, outline=[(100, 400), (150, 400), (150, 460), (100, 460)])
    result = frana.run(scene, threads=2)
    result["max_depth"]                                # rows x columns [m]
    result.summary["runout"]["horizontal_m"]

    for frame in frana.run_frames(scene):              # the flow as it moves, or at every time.frame-interval
        print(frame.time, frame["depth"])

Arrays are not copied: a scene reads yours where they are, and those of a result are its own memory, read-only. Results
have the same bits as those of the program `frana run`, for any number of threads. share/doc/python.md has examples,
share/doc/parameters.md every key, share/doc/results.md every raster and number.
"""
from __future__ import annotations

from typing import Generator

from ._frana import (Error, Frame, Problem, RasterInfo, Result, Run, RunFailed, Scene, __version__)

__all__ = ["Error", "Frame", "Problem", "RasterInfo", "Result", "Run", "RunFailed", "Scene", "run", "run_frames",
           "__version__"]


def run(scene: Scene, threads: int = 1) -> Result:
    """Runs a scene to its end.

    threads: the result does not depend on it; 0 means all there are.
    Raises Error with every problem of the scene, RunFailed, and KeyboardInterrupt for Ctrl-C.
    """
    return Run(scene, threads).result()


def run_frames(scene: Scene, threads: int = 1) -> Generator[Frame, None, Result]:
    """Yields the flow at the start, at every frame and at the end, as it is computed; returns the
    result. Leaving the loop ends the run.
    """
    steps = Run(scene, threads)
    yield from steps
    return steps.result()
