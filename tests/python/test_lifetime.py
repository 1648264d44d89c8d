"""What comes out outlives what it came from; what is let go of is freed."""

import gc
import threading
import unittest

import numpy as np

import craze
from small import KEEP, Case, cracked, plate


def resident():
    """Bytes of memory in use."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * 4096


class Lifetime(Case):
    def test_views_outlive_meshes_lines_and_results(self):
        result = cracked(**{"post.gap": 0.1})
        kept = [result.mesh.vertices, result.mesh.vertex_attributes["crack_time"][::2],
                result.lines.points, result.lines.time, result.opened().faces,
                result.fragments()[0].vertices, plate().uv]
        before = [np.array(array) for array in kept]
        del result
        gc.collect()
        for _ in range(3):
            cracked()  # would write over what was freed
        for array, copied in zip(kept, before):
            self.assertTrue(np.array_equal(array, copied))

    def test_a_result_outlives_its_mesh(self):
        mesh = plate()
        result = craze.crack(mesh, "mud", 7, max_cracks=12, **KEEP)
        del mesh
        gc.collect()
        self.assert_same(result.mesh, cracked().mesh)

    def test_products_are_not_copied(self):
        result = cracked()
        self.assertIs(result.mesh, result.mesh)
        self.assertIs(result.lines, result.lines)
        a, b = result.opened(gap=0.1), result.opened(gap=0.1)
        self.assertTrue(np.shares_memory(a.vertices, b.vertices))
        self.assertIsNone(a.vertices.base.base if isinstance(a.vertices.base, np.ndarray) else None)
        self.assertIs(a._as_handle(), a._handle)  # what craze made goes back as it is

    def test_a_mesh_is_freed_with_its_last_view(self):
        freed = []
        mesh = plate()
        handle, view = mesh._handle, mesh.vertices[::2]
        free = handle._free
        handle._free = lambda pointer: (freed.append(pointer), free(pointer))
        del mesh, handle
        gc.collect()
        self.assertEqual(freed, [])
        del view
        gc.collect()
        self.assertEqual(len(freed), 1)

    def test_nothing_waits_for_the_collector(self):
        gc.collect()
        gc.disable()
        self.addCleanup(gc.enable)
        freed = []
        result = cracked()
        result.mesh, result.lines, result.opened(gap=0.1), result.report
        free = result._job._free
        result._job._free = lambda pointer: (freed.append(pointer), free(pointer))
        del result
        self.assertEqual(len(freed), 1)

    def test_jobs_one_after_the_other_leave_nothing_behind(self):
        def job():
            mesh = craze.Mesh(*(np.array(a) for a in (shape.vertices, shape.faces)))
            result = craze.crack(mesh, "mud", max_cracks=3, **KEEP)
            result.opened(gap=0.1).fragments()
            result.positions_at(0.5), result.lines, result.report
            with self.assertRaises(craze.Error):
                craze.crack(mesh, "mudd")

        shape = plate(60)
        for _ in range(4):
            job()
        before, threads = resident(), threading.active_count()
        for _ in range(10):
            job()
        gc.collect()
        one = 4 * (shape.vertices.nbytes + shape.faces.nbytes + shape.uv.nbytes)
        self.assertLess(resident() - before, 10 * one)  # ten jobs that leak hold ten times as much
        self.assertEqual(threading.active_count(), threads)


if __name__ == "__main__":
    unittest.main()
