"""The renders of docs/blender.md: blender -b --python render.py -- SCENE FILE.jpg, scenes as in
scenes.py. Cycles, a sun, a grey sky and ground."""

import math
import os
import sys
from pathlib import Path

import bpy
import mathutils

sys.path.insert(0, str(Path(__file__).resolve().parent))
import scenes  # noqa: E402

# From where it is looked at, at what, and how high the ground is; None: there is none.
VIEWS = {
    "mud": ((2.1, -2.9, 2.2), (0.1, -0.05, -0.1), -0.07),
    "vase": ((1.7, -2.6, 1.5), (0, 0, 0.58), 0.0),
    "glass": ((1.7, -2.9, 2.4), (0.1, -0.05, -0.1), -0.04),
    "wall": ((0.0, -2.9, 2.2), (0, -0.05, 0), None),
    "floor": ((1.1, -2.7, 1.8), (0.05, -0.1, 0), None),
    "lines": ((2.0, -3.5, 2.0), (0.68, 0, 0.52), 0.0),
}


def look(place, target):
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location = place
    away = mathutils.Vector(place) - mathutils.Vector(target)
    camera.rotation_euler = away.to_track_quat("Z", "Y").to_euler()
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.scene.camera = camera


def light():
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy, sun.data.angle = 3.0, 0.05
    sun.rotation_euler = (math.radians(50), 0, math.radians(-40))
    bpy.context.scene.collection.objects.link(sun)
    world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.35, 0.35, 0.35, 1)
    bpy.context.scene.world = world


def ground(height):
    bpy.ops.mesh.primitive_plane_add(size=40, location=(0, 0, height))
    bpy.context.active_object.data.materials.append(scenes.plain("ground", (0.3, 0.3, 0.3), 0.9))


def render(path):
    scene = bpy.context.scene
    scene.render.engine, scene.cycles.samples = "CYCLES", 24
    scene.cycles.use_denoising = False
    scene.render.resolution_x, scene.render.resolution_y = 560, 420
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "JPEG"
    scene.render.image_settings.quality = 88
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True)


name, file = sys.argv[sys.argv.index("--") + 1 :]
file = os.path.abspath(file)
scenes.empty()
scenes.SCENES[name]()
place, target, height = VIEWS[name]
look(place, target)
light()
if height is not None:
    ground(height)
render(file)
