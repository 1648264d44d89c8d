"""Runs are heard and can be stopped, whatever they are at, and go on beside each other."""

import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np

import craze
from craze import _watch
from small import KEEP, Case, cracked, plate


class Stop(Exception):
    pass


def interrupted_after(seconds, call, *arguments, **settings):
    """How long a call goes on after Ctrl-C; None where it was done by then."""
    struck = []

    def strike():
        struck.append(time.perf_counter())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(seconds, strike)
    timer.start()
    try:
        call(*arguments, **settings)
    except KeyboardInterrupt:
        return time.perf_counter() - struck[0]
    finally:
        try:
            timer.cancel()
            timer.join()
        except KeyboardInterrupt:
            pass
    return None


class Progress(Case):
    def test_it_is_told_of_phases_in_the_callers_thread(self):
        calls = []

        def progress(*told):
            self.assertIs(threading.current_thread(), threading.main_thread())
            calls.append(told)

        craze.crack(plate(), "mud", max_cracks=5, progress=progress, **KEEP)
        self.assertGreater(len(calls), 0)
        for phase, fraction, cracks, load in calls:
            self.assertIsInstance(phase, str)
            self.assertTrue(fraction is None or 0 <= fraction <= 1)
            self.assertGreaterEqual(cracks, 0)
            self.assertGreaterEqual(load, 0)
        self.assertEqual(calls[0][0], "repair")

    def test_fractions_end_at_one_in_every_phase(self):
        calls = []
        result = craze.crack(craze.shape("cube?n=4"), "mud", max_cracks=20, **KEEP,
                             progress=lambda *told: calls.append(told))
        result.opened(gap=0.05, wall=0.05)
        result.bake(64, maps=["height"])
        known = {phase: fraction for phase, fraction, _, _ in calls if fraction is not None}
        self.assertLessEqual({"repair", "prepare", "open", "maps"}, set(known))
        self.assertEqual(set(known.values()), {1})

    def test_what_it_raises_comes_out(self):
        for raised in (Stop, SystemExit, KeyboardInterrupt):
            def progress(*_, raised=raised):
                raise raised

            with self.assertRaises(raised):
                craze.crack(plate(), "mud", progress=progress, **KEEP)

    def test_it_may_crack_another_mesh(self):
        inner = []

        def progress(*_):
            if not inner:
                inner.append(cracked().mesh)

        outer = craze.crack(plate(), "mud", 7, max_cracks=12, progress=progress, **KEEP)
        self.assert_same(outer.mesh, inner[0])

    def test_it_cannot_ask_the_run_that_it_is_told_about(self):
        """Which would wait for itself; it may ask another."""
        other, asked = cracked(), []

        def ask(*_):
            if asked:
                asked[0].opened(gap=0.2)

        result = craze.crack(plate(), "mud", max_cracks=12, progress=ask, **KEEP)
        asked.append(other)
        result.opened(gap=0.1)
        asked[:] = [result]
        self.assert_error("busy", "usage", result.opened, gap=0.3)
        asked.clear()
        self.assertGreater(len(result.opened(gap=0.3).vertices), 0)

    def test_a_product_that_was_stopped_can_be_asked_for_again(self):
        stop = []

        def progress(*_):
            if stop:
                raise Stop

        result = craze.crack(plate(), "mud", 7, max_cracks=12, progress=progress, **KEEP)
        stop.append(True)
        for product in (lambda: result.mesh, lambda: result.opened(gap=0.3)):
            try:
                product()
            except Stop:
                pass
        stop.clear()
        self.assert_same(result.mesh, cracked().mesh)


class Interrupt(Case):
    """The bound is on a quiet machine; where the processor is wanted by others, waking up takes
    what it takes: as long as a thread that does nothing else than wake up."""

    def wake_up_takes(self):
        longest = 0.0
        for _ in range(5):
            start = time.perf_counter()
            threading.Event().wait(0.02)
            longest = max(longest, time.perf_counter() - start - 0.02)
        return longest

    def check(self, call, *arguments, **settings):
        heard = 0
        for after in (0.02, 0.1, 0.3, 0.8):
            took = interrupted_after(after, call, *arguments, **settings)
            if took is None:
                continue
            heard += 1
            self.assertLess(took, 0.2 + 2 * self.wake_up_takes(), f"after {after} s")
        self.assertGreater(heard, 0, "it was over before it could be interrupted")

    def test_ctrl_c_is_heard_while_it_remeshes_measures_curvature_and_cracks(self):
        sphere = craze.shape("sphere?n=120")
        self.check(craze.crack, sphere, "glaze", **{"stress.curvature": 1.0})

    def test_ctrl_c_is_heard_while_a_shape_is_made(self):
        self.check(craze.shape, "plate?n=1500&jitter=0.3")

    def test_ctrl_c_is_heard_while_lines_are_measured(self):
        n = 250
        at = np.stack(np.meshgrid(np.arange(n), np.arange(n)), -1).reshape(-1, 2)
        i = np.arange(n * n).reshape(n, n)
        edges = np.concatenate([np.stack([i[:, :-1], i[:, 1:]], -1).reshape(-1, 2),
                                np.stack([i[:-1], i[1:]], -1).reshape(-1, 2)])
        self.check(craze.stats, at, edges)

    def test_ctrl_c_is_heard_in_every_product(self):
        done = threading.Event()

        def deaf(_):  # as a step of the engine that asks nobody
            done.wait(5)

        took = interrupted_after(0.1, _watch.watched, deaf)
        done.set()
        self.assertIsNotNone(took)
        self.assertLess(took, 0.2 + 2 * self.wake_up_takes())

    def test_a_program_ends_once_it_was_interrupted(self):
        program = ("import craze, os, signal, threading\n"
                   "threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT)).start()\n"
                   "craze.crack(craze.shape('sphere?n=120'), 'glaze')\n")
        run = subprocess.run([sys.executable, "-c", program], stderr=subprocess.PIPE, text=True,
                             timeout=60)
        self.assertIn("KeyboardInterrupt", run.stderr)
        self.assertNotIn("Exception ignored", run.stderr)


class Threads(Case):
    def test_python_goes_on_while_a_mesh_cracks(self):
        ticks, over = [], threading.Event()

        def tick():
            while not over.wait(0.001):
                ticks.append(1)

        beside = threading.Thread(target=tick)
        beside.start()
        try:
            cracked(n=60)  # a tenth of a second
        finally:
            over.set()
            beside.join()
        self.assertGreater(len(ticks), 5)

    def test_runs_beside_each_other_give_what_they_give_alone(self):
        wanted = [craze.crack(plate(), "mud", seed, max_cracks=12, **KEEP).mesh
                  for seed in range(3)]
        found = [None] * 6

        def work(i):
            found[i] = craze.crack(plate(), "mud", i % 3, max_cracks=12, **KEEP).mesh

        threads = [threading.Thread(target=work, args=(i,)) for i in range(6)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for i, mesh in enumerate(found):
            self.assert_same(mesh, wanted[i % 3])

    def test_threads_may_share_a_mesh_and_a_result(self):
        result, mesh, found = cracked(), plate(), []

        def work(i):
            found.append(result.opened(gap=0.1 * (i % 2 + 1)).vertices.tobytes())
            found.append(craze.crack(mesh, "mud", max_cracks=2, **KEEP).mesh.vertices.tobytes())

        threads = [threading.Thread(target=work, args=(i,)) for i in range(6)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(found), 12)
        self.assertEqual(len(set(found)), 3)


if __name__ == "__main__":
    unittest.main()
