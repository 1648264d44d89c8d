"""Finished scenes of docs/blender.md: blender -b --python scenes.py -- SCENE FILE.blend

SCENE is mud, vase, glass, wall, floor or lines. The add-on is installed, or its folder is in PYTHONPATH.
"""

import math
import os
import sys

import bmesh
import bpy

if not hasattr(bpy.types.Scene, "craze"):
    import craze_blender

    craze_blender.register()


def plain(name, colour, roughness):
    """A material of one colour."""
    made = bpy.data.materials.new(name)
    made.diffuse_color = (*colour, 1.0)
    made.use_nodes = True
    shader = made.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*colour, 1.0)
    shader.inputs["Roughness"].default_value = roughness
    return made


def thing(name, build, material):
    """A new object, active, of what `build` puts into a bmesh."""
    mesh = bpy.data.meshes.new(name)
    shape = bmesh.new()
    build(shape)
    shape.to_mesh(mesh)
    shape.free()
    mesh.materials.append(material)
    made = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(made)
    bpy.context.view_layer.objects.active = made
    return made


def panel(preset, spacing, gap, wall=0.0, curl=0.0, seed=1):
    """The panel as a user would set it."""
    made = bpy.context.scene.craze
    made.preset = preset
    made.keys.seed, made.keys.layer_spacing = seed, spacing
    made.keys.post_gap, made.keys.post_wall, made.keys.post_curl = gap, wall, curl
    return made


def mud():
    """A dry ground: gaps, walls and curled edges, growing for 100 frames."""

    def ground(shape):
        bmesh.ops.create_grid(shape, x_segments=40, y_segments=40, size=1.0)

    thing("ground", ground, plain("mud", (0.35, 0.24, 0.15), 0.9))
    panel("mud", spacing=0.25, gap=0.08, wall=0.06, curl=1.5, seed=7)
    bpy.ops.craze.crack()
    bpy.ops.craze.grow(frames=100)
    bpy.context.scene.frame_set(200)


def vase():
    """A glazed vase, its cracks fine lines."""
    radii = [0.30, 0.42, 0.52, 0.56, 0.54, 0.46, 0.34, 0.25, 0.22, 0.24, 0.30]

    def turned(shape):
        n, rings = 48, []
        for i, radius in enumerate(radii):
            ring = [
                shape.verts.new((radius * math.cos(a), radius * math.sin(a), 0.12 * i))
                for a in (2 * math.pi * k / n for k in range(n))
            ]
            rings.append(ring)
        for low, high in zip(rings, rings[1:]):
            for k in range(n):
                shape.faces.new((low[k], low[(k + 1) % n], high[(k + 1) % n], high[k]))
        shape.faces.new(rings[0][::-1])

    made = thing("vase", turned, plain("glaze", (0.62, 0.76, 0.72), 0.15))
    made.modifiers.new("round", "SUBSURF").levels = 1
    panel("glaze", spacing=0.15, gap=0.02, wall=0.01, seed=3)
    bpy.ops.craze.crack()
    for polygon in bpy.context.active_object.data.polygons:
        polygon.use_smooth = True


def glass():
    """A pane that something hit, in pieces that fall."""

    def pane(shape):
        bmesh.ops.create_grid(shape, x_segments=30, y_segments=30, size=1.0)

    thing("pane", pane, plain("glass", (0.55, 0.75, 0.85), 0.05))
    panel("glass-impact", spacing=0.0, gap=0.02, wall=0.03).keys.impact.clear()
    bpy.context.scene.cursor.location = (0.25, 0.1, 0.0)
    bpy.ops.craze.impact()
    bpy.ops.craze.crack()
    bpy.ops.craze.pieces(thickness=0.03)


def wall():
    """A square of plaster, crazed by baked images alone."""

    def plane(shape):
        shape.loops.layers.uv.new("UVMap")
        bmesh.ops.create_grid(shape, x_segments=1, y_segments=1, size=1.0, calc_uvs=True)

    made = thing("wall", plane, plain("plaster", (0.75, 0.72, 0.66), 0.8))
    panel("concrete-crazing", spacing=0.16, gap=0.03, wall=0.01, seed=2)
    bpy.ops.craze.crack()
    bpy.ops.craze.bake(size=1024)
    cracked = bpy.context.active_object
    made.data.materials[0] = cracked.data.materials[0]
    bpy.data.objects.remove(cracked)
    made.hide_render = False
    made.hide_set(False)


def floor():
    """A square with a tileable material, a unit of its UVs a metre."""

    def plane(shape):
        uv = shape.loops.layers.uv.new("UVMap")
        bmesh.ops.create_grid(shape, x_segments=1, y_segments=1, size=1.0, calc_uvs=True)
        for face in shape.faces:
            for loop in face.loops:
                loop[uv].uv *= 2.0

    made = thing("floor", plane, plain("bare", (0.5, 0.5, 0.5), 0.8))
    before = set(bpy.data.materials)
    bpy.ops.craze.texture(preset="mud", spacing=0.16, seed=5, period=1.0, size=1024)
    [made.data.materials[0]] = set(bpy.data.materials) - before


def lines():
    """The vase's cracks as curves, beside it."""
    vase()
    cracked = bpy.context.active_object
    bpy.ops.craze.curves()
    curves = bpy.context.active_object
    curves.location.x = 1.3
    curves.data.materials.append(plain("ink", (0.05, 0.04, 0.03), 0.6))
    cracked.location.x = -0.1


SCENES = {"mud": mud, "vase": vase, "glass": glass, "wall": wall, "floor": floor, "lines": lines}


def empty():
    for made in list(bpy.data.objects):
        bpy.data.objects.remove(made)
    for made in list(bpy.data.collections):
        if made.name.endswith(" pieces"):
            bpy.data.collections.remove(made)


if __name__ == "__main__" and "--" in sys.argv:
    scene, file = sys.argv[sys.argv.index("--") + 1 :]
    if scene not in SCENES:
        sys.exit(f"no scene {scene}: there are {', '.join(SCENES)}")
    empty()
    SCENES[scene]()
    bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(file))
