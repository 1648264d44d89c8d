"""The renders of docs/blender.md: blender -b --python render.py -- SCENE FILE.png, scenes as in
scenes.py. Cycles, a sun and a grey sky."""

import math
import sys
from pathlib import Path

import bpy
import mathutils

sys.path.insert(0, str(Path(__file__).resolve().parent))
import scenes  # noqa: E402

# From where it is looked at, and at what.
VIEWS = {
    "mud": ((1.7, -2.3, 1.9), (0, 0, -0.1)),
    "vase": ((1.6, -2.2, 1.3), (0, 0, 0.55)),
    "glass": ((1.2, -2.2, 2.0), (0, 0, -0.1)),
    "wall": ((0.0, -2.2, 1.6), (0, 0, 0)),
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


def render(path):
    scene = bpy.context.scene
    scene.render.engine, scene.cycles.samples = "CYCLES", 48
    scene.cycles.use_denoising = False
    scene.render.resolution_x, scene.render.resolution_y = 560, 420
    scene.render.resolution_percentage = 100
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True)


name, file = sys.argv[sys.argv.index("--") + 1 :]
scenes.empty()
scenes.SCENES[name]()
look(*VIEWS[name])
light()
render(file)
