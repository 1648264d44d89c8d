"""Tests that crack objects by the operator, in an empty scene each."""

import unittest

import bpy
import meshes
import numpy as np


def recipe_of(spacing, post="gap = 0.1, wall = 0.05"):
    """One that cracks an object's own triangles; `spacing` as TOML says it."""
    return f"""
mesh.edge = "keep"
material = {{ criterion = "strength", scatter = 0.15 }}
layer.{spacing}
evolution.max_load = 2.0
post = {{ {post} }}
"""


def get(collection, name, columns=1, dtype=np.float32):
    """(n, columns) of a property of a collection."""
    values = np.empty(len(collection) * columns, dtype)
    collection.foreach_get(name, values)
    return values.reshape(-1, columns)


def places(mesh):
    """(n, 3) of its vertices."""
    return get(mesh.vertices, "co", 3)


class Cracking(unittest.TestCase):
    recipe = ""  # of a file's tests

    def setUp(self):
        meshes.empty()

    def crack(self, thing, **said):
        """The cracked object of one."""
        meshes.activate(thing)
        self.assertEqual(bpy.ops.craze.crack(**{"recipe": self.recipe, **said}), {"FINISHED"})
        return bpy.context.active_object
