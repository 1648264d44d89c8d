"""A scene before and after it cracked, as Blender sees both.

blender -b -P kept_scene.py -- BEFORE.glb AFTER.glb FOLDER. Names are the same but for those of cracks;
pictures at rest and amid the animations differ within two pixels of a crack alone.
"""

import pathlib
import sys

import bpy
import numpy
from bpy_extras.object_utils import world_to_camera_view

numpy.bool = bool  # Debian's Blender 3.4 asks for a name that Debian's NumPy no longer has
before, after, folder = map(pathlib.Path, sys.argv[sys.argv.index("--") + 1 :])
WIDTH, HEIGHT, NEAR = 240, 160, 2
FRAMES = (1, 13)


def load(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=str(path))
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
    scene.render.resolution_percentage = 100
    cycles = scene.cycles
    cycles.device, cycles.samples, cycles.seed = "CPU", 16, 1
    cycles.use_denoising = cycles.use_adaptive_sampling = False
    cycles.max_bounces, cycles.transparent_max_bounces = 0, 8
    scene.view_settings.view_transform = "Raw"
    for light in bpy.data.lights:
        light.energy = 3
    for material in bpy.data.materials:
        if material.name.startswith("crack_line"):
            # Unlit bands count as lamps, and another number of lamps has the same light with other noise.
            material.cycles.sample_as_light = False
    [scene.camera] = [o for o in bpy.data.objects if o.type == "CAMERA"]


def play(frame):
    """All animations at once."""
    for holder in [*bpy.data.objects, *bpy.data.shape_keys]:
        tracks = holder.animation_data.nla_tracks if holder.animation_data else []
        if holder.animation_data:
            holder.animation_data.action = None
        for track in tracks:
            track.mute = False
    bpy.context.scene.frame_set(frame)


def picture(name, frame):
    play(frame)
    path = folder / f"{name}_{frame}.png"
    bpy.context.scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(str(path))
    pixels = numpy.array(image.pixels[:]).reshape(HEIGHT, WIDTH, 4)[:, :, :3]
    bpy.data.images.remove(image)
    return pixels


def cracks(frame):
    """Pixels within NEAR of a crack, seen or hidden."""
    play(frame)
    scene = bpy.context.scene
    near = numpy.zeros((HEIGHT, WIDTH), bool)
    for thing in bpy.data.objects:
        if thing.type != "MESH" or not thing.name.startswith("crack_lines"):
            continue
        mesh = thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
        for edge in mesh.edges:
            a, b = (thing.matrix_world @ mesh.vertices[v].co for v in edge.vertices)
            steps = 2 + int(60 * (b - a).length)
            for k in range(steps + 1):
                p = world_to_camera_view(scene, scene.camera, a.lerp(b, k / steps))
                x, y = int(p.x * WIDTH), int(p.y * HEIGHT)
                near[max(y - NEAR, 0) : y + NEAR + 1, max(x - NEAR, 0) : x + NEAR + 1] = True
    return near


def names():
    kinds = ("objects", "meshes", "materials", "images", "actions", "cameras", "lights", "armatures")
    listed = {kind: sorted(item.name for item in getattr(bpy.data, kind)) for kind in kinds}
    return {kind: [n for n in all if "crack_line" not in n] for kind, all in listed.items()}


load(before)
wanted = names()
shots = {frame: picture("before", frame) for frame in FRAMES}
assert numpy.abs(shots[FRAMES[0]] - shots[FRAMES[1]]).max() > 0.2, "nothing moves"
load(after)
assert names() == wanted, (names(), wanted)
for frame in FRAMES:
    near = cracks(frame)
    assert 0.01 < near.mean() < 0.6, f"cracks cover {near.mean():.2f} of the picture"
    apart = numpy.abs(picture("after", frame) - shots[frame]).max(axis=2)
    print(f"frame {frame}: cracks near {near.mean():.3f}, differs by {apart[~near].max():.4f} away from "
          f"them, by {apart.max():.4f} at them")
    assert apart[~near].max() < 0.02, f"frame {frame}: {(apart[~near] >= 0.02).sum()} pixels differ"
print("blender: all is well")
