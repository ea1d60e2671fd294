# SPDX-License-Identifier: Apache-2.0
"""The module frana: arrays without copies, frames, other threads, Ctrl-C, errors, texts."""
import ast
import gc
import inspect
import os
import pathlib
import pydoc
import signal
import sys
import threading
import time
import unittest
import weakref

try:
    import numpy as np
except ImportError:
    print("numpy (Debian: python3-numpy) is not installed")
    sys.exit(77)

import frana
import frana._frana

CELL = 4.0
SQUARE = [(20, 40), (60, 40), (60, 80), (20, 80)]


def slope(rows=30, columns=60):
    x = CELL * np.arange(columns, dtype=np.float64)
    return np.ascontiguousarray(np.broadcast_to(100 + np.maximum(0, 0.5 * (120 - x)), (rows, columns)))


def small_scene(elevations, end=8):
    scene = frana.Scene(elevations, north=120, cell_size=CELL)
    scene["material.friction-coefficient"] = 0.3
    scene.set("time.end", end)
    scene["time.frame-interval"] = 2
    scene.add_release(2.0, outline=SQUARE, name="upper")
    return scene


class Watched(np.ndarray):
    """An array that can be watched."""


class Arrays(unittest.TestCase):
    def test_a_scene_reads_elevations_where_they_are_and_keeps_them(self):
        elevations = slope().view(Watched)
        watch = weakref.ref(elevations)
        scene = small_scene(elevations)
        elevations[0, 0] = 777
        del elevations
        gc.collect()
        self.assertIsNotNone(watch())
        run = frana.Run(scene)
        del scene
        result = run.result()
        del run
        self.assertEqual(result["bed"][0, 0], 777)
        del result
        gc.collect()
        self.assertIsNone(watch())

    def test_a_result_is_not_copied_and_outlives_its_object(self):
        result = frana.run(small_scene(slope()))
        depth, again = result["max_depth"], result["max_depth"]
        self.assertEqual(depth.shape, (30, 60))
        self.assertEqual(depth.dtype, np.float64)
        self.assertTrue(np.shares_memory(depth, again))
        before = depth.copy()
        del result, again
        gc.collect()
        np.testing.assert_array_equal(depth, before)
        with self.assertRaises(ValueError):
            depth[0, 0] = 1
        self.assertGreater(np.nanmax(depth), 1.5)

    def test_arrays_that_would_have_to_be_copied_are_refused(self):
        z = slope()
        for wrong, word in ((z.astype(np.float32), "float64"), (z[:, ::2], "C-contiguous"), (z.T, "C-contiguous"),
                            (np.ma.masked_less(z, 101), "masked"), (z[0], "1 dimensions"), (z.tolist(), "numpy array")):
            with self.assertRaisesRegex(TypeError, word):
                frana.Scene(wrong, cell_size=CELL)
        scene = small_scene(z)
        with self.assertRaisesRegex(ValueError, "30 x 59.*30 x 60"):
            scene.add_release(np.ascontiguousarray(z[:, 1:]))
        with self.assertRaisesRegex(TypeError, "float64"):
            scene.set_values("zones.friction-angle", z.astype(int))

    def test_thickness_friction_and_walls_by_cell(self):
        thickness = np.full((30, 60), np.nan)
        thickness[10:20, 5:15] = 2
        scene = frana.Scene(slope(), north=120, cell_size=CELL)
        scene["material.friction-coefficient"] = 0.3
        scene["time.end"] = 8
        scene.add_release(thickness)
        free = frana.run(scene)
        self.assertAlmostEqual(free.summary["volume"]["initial_m3"], 2 * 100 * CELL**2, places=6)
        wall = np.zeros((30, 60))
        wall[:, 18] = 1
        scene.set_walls(wall)
        self.assertTrue(np.isnan(frana.run(scene)["max_depth"][:, 19:]).all())
        self.assertFalse(np.isnan(free["max_depth"][:, 19:]).all())
        rough = np.full((30, 60), 45.0)
        scene.set_values("zones.friction-angle", rough)
        self.assertLess(frana.run(scene).summary["max_velocity_ms"], free.summary["max_velocity_ms"] - 1)


class InflowAndRecords(unittest.TestCase):
    def test_what_flows_in_is_recorded(self):
        scene = frana.Scene(slope(), north=120, cell_size=CELL)
        scene["material.friction-coefficient"] = 0.1
        scene["time.end"] = 30
        scene["time.stop-when-still"] = False
        scene["output.sample-interval"] = 0.5
        scene.add_inflow([(20, 40), (20, 80)], np.array([[0.0, 40.0], [5.0, 40.0]]))
        scene.add_gauge(60, 60, name="bridge")
        scene.add_gauge(62, 60)
        scene.add_section([(60, 120), (60, 0)], name="road")
        result = frana.run(scene)
        self.assertAlmostEqual(result.summary["volume"]["inflow_m3"], 200, places=9)
        self.assertEqual(list(result.gauges), ["bridge", "2"])
        gauge, road = result.gauges["bridge"], result.sections["road"]
        self.assertEqual(set(gauge), {"time", "depth", "speed"})
        self.assertGreater(gauge["depth"].max(), 0.1)
        self.assertEqual(gauge["depth"][0], 0)
        # The flow goes east, to the left of a line that points south.
        self.assertLess(road["discharge"].min(), -5)
        self.assertTrue(-205 < road["volume"][-1] < -150, road["volume"][-1])
        self.assertAlmostEqual(np.diff(gauge["time"])[:5].mean(), 0.5, delta=0.2)
        with_velocity = frana.Scene(slope(), north=120, cell_size=CELL)
        with_velocity.add_inflow([(20, 40), (20, 80)], [(0, 40, 8.0), (5, 40, 8.0)], direction=90)
        with_velocity["material.friction-coefficient"] = 0.1
        with_velocity["time.end"] = 1
        self.assertGreater(frana.run(with_velocity).summary["max_velocity_ms"], 8)
        with self.assertRaisesRegex(frana.Error, "is not a row of two or three numbers"):
            scene.add_inflow([(20, 40), (20, 80)], [[1.0]])
        scene.add_gauge(1e6, 0, name="far")
        with self.assertRaisesRegex(frana.Error, "lies outside the working grid .*gauge far"):
            scene.check()


class Runs(unittest.TestCase):
    def test_frames_come_at_their_times(self):
        frames = list(frana.run_frames(small_scene(slope())))
        self.assertEqual([frame.index for frame in frames], [0, 1, 2, 3, 4])
        self.assertEqual((frames[0].time, frames[-1].time), (0, 8))
        self.assertEqual(set(frames[0].rasters), {"depth", "velocity"})
        self.assertEqual(frames[0].rasters["velocity"].unit, "m/s")

        def returned():
            return (yield from frana.run_frames(small_scene(slope()), threads=2))
        steps = returned()
        with self.assertRaises(StopIteration) as end:
            while True:
                next(steps)
        result = end.exception.value
        np.testing.assert_array_equal(frames[-1]["depth"], result["final_depth"])
        np.testing.assert_array_equal(result["max_depth"], frana.run(small_scene(slope()))["max_depth"])

    def test_summary_series_and_rasters(self):
        result = frana.run(small_scene(slope()))
        self.assertEqual(result.summary["release_areas"][0]["name"], "upper")
        self.assertEqual(result.stop_reason, result.summary["stop_reason"])
        self.assertEqual(len(result.series["time"]), result.summary["steps"])
        self.assertEqual(result.rasters["arrival_time"].unit, "s")
        with self.assertRaisesRegex(frana.Error, "max_depth"):
            result["depth"]

    def test_other_threads_run_meanwhile(self):
        counted, done = [0], threading.Event()

        def count():
            while not done.is_set():
                counted[0] += 1
                time.sleep(0.001)
        scene = small_scene(slope(200, 60), end=20)
        scene["material.friction-coefficient"] = 0.1
        scene["time.stop-when-still"] = False
        thread = threading.Thread(target=count)
        thread.start()
        before = counted[0]
        frana.run(scene)
        during = counted[0] - before
        done.set()
        thread.join()
        self.assertGreater(during, 10)

    def test_one_thread_at_a_time_computes_a_run(self):
        scene = small_scene(slope(200, 60), end=20)
        scene["time.stop-when-still"] = False
        run = frana.Run(scene)
        refused, frames = [], []

        def iterate():
            try:
                for frame in run:
                    frames.append(frame.time)
            except ValueError as error:
                refused.append(str(error))
        threads = [threading.Thread(target=iterate) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        # Frames go to whoever asks; a thread that asks while another computes is told so.
        self.assertEqual((len(frames), len(set(frames)), max(frames)), (11, 11, 20))
        self.assertTrue(all("another thread computes this run" in text for text in refused), refused)
        self.assertEqual(run.time, 20)

    def test_ctrl_c_ends_a_run(self):
        scene = small_scene(slope(400, 200), end=36000)
        scene["material.friction-coefficient"] = 0.05
        scene["time.stop-when-still"] = False
        scene["time.stop-change"] = 0
        scene["time.frame-interval"] = 3600
        scene["numerics.boundary"] = "wall"  # nothing leaves: the run ends with its time alone
        # Whoever started this in the background may have made it deaf to the signal.
        signal.signal(signal.SIGINT, signal.default_int_handler)
        for work in (lambda: frana.run(scene), lambda: list(frana.run_frames(scene))):
            timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                work()
            timer.join()


class Errors(unittest.TestCase):
    def test_a_wrong_key_is_refused_where_it_is_set(self):
        scene = small_scene(slope())
        with self.assertRaisesRegex(frana.Error, "Did you mean material.friction-coefficient") as caught:
            scene["material.friction-coeficient"] = 0.2
        self.assertEqual(caught.exception.problems[0].where, "material.friction-coeficient")
        with self.assertRaisesRegex(frana.Error, "is out of range .value 32; allowed"):
            scene["material.friction-coefficient"] = 32
        with self.assertRaisesRegex(frana.Error, "reads and writes files"):
            scene["output.maps"] = "off"
        scene["material.bed-friction"] = ["coulomb", "turbulence"]
        scene["material.turbulence"] = np.float64(400)

    def test_wrong_outlines_and_rows_are_errors_of_frana(self):
        scene = frana.Scene(slope(), cell_size=CELL)
        for outline in ([(1, 2), (3,)], [(1, 2, 3)], [("a", "b")], [1, 2, 3]):
            with self.assertRaisesRegex(frana.Error, "is not a point") as caught:
                scene.add_release(2.0, outline=outline)
            self.assertEqual(len(caught.exception.problems), 1)
        with self.assertRaisesRegex(frana.Error, "is not a row"):
            scene.add_inflow([(1, 2), (3, 4)], [(0,), (1, 2)])
        with self.assertRaises(TypeError):
            scene.add_release(2.0, outline=5)

    def test_an_object_that_was_not_constructed_is_refused(self):
        for kind in (frana.Scene, frana.Result, frana.Frame, frana.RasterInfo, frana.Problem, frana.Run):
            empty = kind.__new__(kind)
            names = [name for name in dir(kind) if isinstance(getattr(kind, name), property)]
            for name in names:
                with self.assertRaises(TypeError, msg=f"{kind.__name__}.{name}"):
                    getattr(empty, name)
        with self.assertRaises(TypeError):
            frana.Scene.__new__(frana.Scene).check()

    def test_numbers_are_read_by_the_rule_of_files(self):
        for arguments in ({"volume": 1e300}, {"volume": float("nan")}, {"thickness": float("nan")}, {"thickness": 1e300}):
            scene = frana.Scene(slope(), cell_size=CELL)
            scene["material.friction-angle"] = 10
            scene.add_release(**{"thickness": 2.0, "outline": [(20, -20), (60, -20), (60, -60), (20, -60)], **arguments})
            with self.assertRaises(frana.Error) as caught:
                scene.check()
            self.assertIn("release 1", caught.exception.problems[0].where)

    def test_all_problems_of_a_scene_at_once(self):
        scene = frana.Scene(slope(), cell_size=CELL)
        scene["material.bed-friction"] = "chezy"
        with self.assertRaises(frana.Error) as caught:
            frana.run(scene)
        self.assertEqual(len(caught.exception.problems), 2)
        self.assertEqual(small_scene(slope()).check(), [])

    def test_a_run_that_fails_says_so(self):
        z = slope()
        z[:, 20:24] = np.nan
        with self.assertRaises(frana.RunFailed) as caught:
            frana.run(small_scene(z))
        self.assertEqual(caught.exception.result.stop_reason, "reached-no-data")
        self.assertTrue(caught.exception.problems)
        self.assertIsInstance(caught.exception, frana.Error)


class Texts(unittest.TestCase):
    def test_help_describes_every_name(self):
        text = pydoc.plaintext.document(frana)
        for name in frana.__all__:
            if not name.startswith("__"):
                self.assertTrue(inspect.getdoc(getattr(frana, name)), name)
                self.assertIn(name, text)
        self.assertIn("rows x columns", frana.Scene.__doc__)
        self.assertRegex(frana.Result.series.__doc__, r"\[s\]")

    def test_stubs_have_the_names_of_the_module(self):
        package = pathlib.Path(frana.__file__).parent
        self.assertTrue((package / "py.typed").exists())
        stubs = {node.name: node for node in ast.parse((package / "_frana.pyi").read_text()).body
                 if isinstance(node, ast.ClassDef)}
        for name, item in vars(frana._frana).items():
            if not inspect.isclass(item):
                continue
            own = {m for m in vars(item) if not m.startswith("_")} | (set(vars(item)) & {"__getitem__", "__setitem__",
                                                                                        "__iter__", "__next__"})
            stub = {m.name for m in stubs[name].body if isinstance(m, ast.FunctionDef)} - {"__init__"}
            self.assertEqual(stub, own, name)
        self.assertEqual(set(stubs), {n for n, item in vars(frana._frana).items() if inspect.isclass(item)})


if __name__ == "__main__":
    unittest.main(verbosity=2)
