"""Pictures of cracks that our renderer had no part in, as a stand-in for a real set: Blender Cycles,
other meshes, other presets and other materials than the plans of recipes/datasets/. The cracks are
gaps with walls; their mask is a pass of its own in which the walls alone shine.

    blender -b --python render_proxy.py -- proxy/test --craze craze --count 90 --clean 30 --seed 1
"""

import argparse
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

import bpy
import mathutils

SIZE = 256
LEAST_PIXELS = 100
OBJECTS = ["terrain", "pillar", "torus", "panel"]
PRESETS = ["concrete-crazing", "mud-mature", "crackle-glass", "glaze"]


def terrain(rng):
    """An uneven ground, two units wide."""
    waves = [(rng.uniform(1, 4), rng.uniform(1, 4), rng.uniform(0, 6), 0.05) for _ in range(4)]
    return grid(lambda u, v: (2 * u, 2 * v, wave_height(waves, 2 * u, 2 * v)))


def panel(rng):
    """A sheet that is bent a little both ways."""
    a, b = rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3)
    return grid(lambda u, v: (2 * u - 1, 2 * v - 1, a * (2 * u - 1) ** 2 + b * (2 * v - 1) ** 2))


def pillar(rng):
    """The front of a round column that swells."""
    swell = rng.uniform(0.0, 0.15)

    def place(u, v):
        r = 0.8 + swell * math.sin(math.pi * v)
        return (r * math.sin(2.6 * (u - 0.5)), 2.2 * v - 1.1, r * math.cos(2.6 * (u - 0.5)))

    return grid(place)


def torus(rng):
    """The upper half of a ring."""
    thick = rng.uniform(0.35, 0.5)

    def place(u, v):
        a, b = 3.0 * (u - 0.5), math.pi * (0.9 * (1 - v) + 0.05)
        r = 1 + thick * math.cos(b)
        return (r * math.sin(a), -r * math.cos(a), thick * math.sin(b))

    return grid(place)


def wave_height(waves, x, y):
    return sum(h * math.sin(p * x + q * y + s) for p, q, s, h in waves)


def grid(place, n=70):
    """Vertices and triangles of a map of the unit square; its upper side is seen."""
    rng = random.Random(7)
    points = []
    for j in range(n + 1):
        for i in range(n + 1):
            inside = 0 < i < n and 0 < j < n
            du, dv = (rng.uniform(-0.3, 0.3) if inside else 0 for _ in "uv")
            points.append(place((i + du) / n, (j + dv) / n))
    faces = []
    for j in range(n):
        for i in range(n):
            a = j * (n + 1) + i
            b, c, d = a + 1, a + n + 2, a + n + 1
            faces += [(a, b, c), (a, c, d)] if (i + j) % 2 else [(a, b, d), (b, c, d)]
    return points, faces


def write_obj(path, points, faces):
    lines = ["v %.6f %.6f %.6f" % p for p in points]
    lines += ["f %d %d %d" % tuple(k + 1 for k in f) for f in faces]
    path.write_text("\n".join(lines) + "\n")


def read_obj(path):
    """Vertices, faces, and per face whether it is a crack's wall."""
    points, faces, walls, wall = [], [], [], False
    for line in path.read_text().splitlines():
        word, *rest = line.split() or [""]
        if word == "v":
            points.append(tuple(map(float, rest[:3])))
        elif word == "usemtl":
            wall = rest[0].startswith("crack_wall")
        elif word == "f":
            faces.append(tuple(int(k.split("/")[0]) - 1 for k in rest))
            walls.append(wall)
    return points, faces, walls


class Shader:
    """A material's nodes, linked as they are made."""

    def __init__(self, name):
        self.material = bpy.data.materials.new(name)
        self.material.use_nodes = True
        self.tree = self.material.node_tree
        self.shader = self.tree.nodes["Principled BSDF"]
        self.place = self.tree.nodes.new("ShaderNodeTexCoord").outputs["Object"]

    def texture(self, kind, scale, output="Fac", **inputs):
        node = self.tree.nodes.new(kind)
        self.tree.links.new(self.place, node.inputs["Vector"])
        node.inputs["Scale"].default_value = scale
        for name, value in inputs.items():
            node.inputs[name].default_value = value
        return node.outputs[output]

    def ramp(self, factor, stops):
        """Colours between stops (place, colour)."""
        node = self.tree.nodes.new("ShaderNodeValToRGB")
        self.tree.links.new(factor, node.inputs["Fac"])
        elements = node.color_ramp.elements
        while len(elements) < len(stops):
            elements.new(0.5)
        for element, (place, colour) in zip(elements, stops):
            element.position, element.color = place, (*colour, 1)
        return node.outputs["Color"]

    def mix(self, factor, a, b, blend="MIX"):
        node = self.tree.nodes.new("ShaderNodeMixRGB")
        node.blend_type, node.inputs["Fac"].default_value = blend, factor
        self.tree.links.new(a, node.inputs["Color1"])
        self.tree.links.new(b, node.inputs["Color2"])
        return node.outputs["Color"]

    def finish(self, colour, height, bump, roughness):
        node = self.tree.nodes.new("ShaderNodeBump")
        node.inputs["Strength"].default_value = bump[0]
        node.inputs["Distance"].default_value = bump[1]
        self.tree.links.new(height, node.inputs["Height"])
        self.tree.links.new(node.outputs["Normal"], self.shader.inputs["Normal"])
        self.tree.links.new(colour, self.shader.inputs["Base Color"])
        self.shader.inputs["Roughness"].default_value = roughness
        return self.material


def shade(colour, factor):
    return tuple(min(1.0, factor * c) for c in colour)


def grounds(rng):
    """A colour that stone, clay, plaster or paint may have."""
    return rng.choice(
        [(0.35, 0.34, 0.32), (0.6, 0.57, 0.5), (0.32, 0.2, 0.12), (0.16, 0.16, 0.17),
         (0.7, 0.68, 0.64), (0.45, 0.25, 0.18), (0.2, 0.3, 0.36), (0.55, 0.42, 0.25)]
    )  # fmt: skip


def material(rng, view):
    """One of six surfaces; `view` is the height of what is seen, model units."""
    kind = rng.choice(["concrete", "granite", "marble", "earth", "flaking", "tiles"])
    colour, made = grounds(rng), Shader(kind)
    fine = made.texture("ShaderNodeTexNoise", rng.uniform(40, 120) / view, Detail=6.0)
    broad = made.texture("ShaderNodeTexNoise", rng.uniform(2, 6) / view, Detail=4.0)
    tint = made.ramp(broad, [(0.3, shade(colour, 0.75)), (0.7, shade(colour, 1.2))])
    grain = made.ramp(fine, [(0.3, (0.7,) * 3), (0.7, (1.0,) * 3)])
    looks, roughness = made.mix(0.8, tint, grain, "MULTIPLY"), rng.uniform(0.5, 1.0)
    strength = rng.uniform(0.15, 0.7)
    height = fine
    if kind == "granite":
        cells = made.texture("ShaderNodeTexVoronoi", rng.uniform(30, 80) / view, "Color")
        looks = made.mix(rng.uniform(0.2, 0.5), tint, cells, "SOFT_LIGHT")
    elif kind == "marble":
        scale = rng.uniform(1, 3) / view
        veins = made.texture("ShaderNodeTexWave", scale, Distortion=12.0, Detail=4.0)
        stops = [(0.0, 0.55), (0.25, 1.3), (1.0, 1.4)]
        looks = made.ramp(veins, [(at, shade(colour, factor)) for at, factor in stops])
        roughness, strength = rng.uniform(0.1, 0.4), 0.05
    elif kind == "flaking":
        patch = made.texture("ShaderNodeTexNoise", rng.uniform(3, 8) / view, Detail=8.0)
        edge = rng.uniform(0.5, 0.6)
        other = grounds(rng)
        looks = made.ramp(patch, [(edge, colour), (edge + 0.02, other)])
        looks = made.mix(0.7, looks, grain, "MULTIPLY")
    elif kind == "tiles":
        node = made.tree.nodes.new("ShaderNodeTexBrick")
        made.tree.links.new(made.place, node.inputs["Vector"])
        node.inputs["Scale"].default_value = rng.uniform(1.2, 2.5) / view
        node.inputs["Mortar Size"].default_value = rng.uniform(0.006, 0.02)
        for name, factor in (("Color1", 1), ("Color2", 0.85), ("Mortar", rng.choice([0.4, 1.6]))):
            node.inputs[name].default_value = (*shade(colour, factor), 1)
        looks = made.mix(0.8, node.outputs["Color"], grain, "MULTIPLY")
    return made.finish(looks, height, (strength, 0.02 * view), roughness), colour


def plain(name, colour, emission=None):
    made = Shader(name)
    made.shader.inputs["Base Color"].default_value = (*colour, 1)
    made.shader.inputs["Roughness"].default_value = 0.9
    if emission is not None:
        shine = made.tree.nodes.new("ShaderNodeEmission")
        shine.inputs["Color"].default_value = (emission,) * 3 + (1,)
        made.tree.links.new(shine.outputs[0], made.tree.nodes["Material Output"].inputs["Surface"])
    return made.material


def link(name, mesh):
    made = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(made)
    return made


def cracked(rng, craze, folder, view, clean):
    """The surface, cut by craze, as an object of two materials: surface, wall."""
    write_obj(folder / "in.obj", *globals()[rng.choice(OBJECTS)](rng))
    width = math.exp(rng.uniform(math.log(1.4), math.log(6.5))) * view / SIZE
    keys = {
        "layer.spacing": view * rng.uniform(0.2, 1.0),
        "post.gap_width": width,
        "post.wall": width * rng.uniform(0.7, 2.0),
        "seed": rng.randrange(1, 10**6),
    }
    command = [craze, "crack", folder / "in.obj", "-o", folder / "out.obj", "--quiet"]
    command += ["--no-warnings", "--preset", rng.choice(PRESETS)]
    most = round(math.exp(rng.uniform(math.log(20), math.log(900))))
    command += ["--max-cracks", str(0 if clean else most)]
    for key, value in keys.items():
        command += ["--set", f"{key}={value}"]
    subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
    points, faces, walls = read_obj(folder / "out.obj")
    mesh = bpy.data.meshes.new("surface")
    mesh.from_pydata(points, [], faces)
    mesh.polygons.foreach_set("material_index", [int(w) for w in walls])
    return link("surface", mesh), points, faces, walls


def strewn(rng, target, view, frame):
    """Hairs, rods and pebbles that lie on the surface or throw a shadow on it, and are no cracks."""
    made = []
    for _ in range(rng.choice([0, 0, 1, 2, 4])):
        kind = rng.choice(["hair", "pebble", "rod"])
        place = target + frame @ mathutils.Vector(
            (rng.uniform(-0.5, 0.5) * view, rng.uniform(-0.5, 0.5) * view, 0.02 * view)
        )
        if kind == "pebble":
            bpy.ops.mesh.primitive_ico_sphere_add(
                subdivisions=2, radius=view * rng.uniform(0.01, 0.05), location=place
            )
            made.append(bpy.context.active_object)
        else:
            curve = bpy.data.curves.new(kind, "CURVE")
            curve.dimensions, curve.bevel_depth = "3D", view * rng.uniform(0.002, 0.006)
            line = curve.splines.new("NURBS")
            line.points.add(4)
            away = rng.uniform(0, 2 * math.pi)
            lift = view * (0.03 if kind == "hair" else rng.uniform(0.1, 0.5))
            for k, point in enumerate(line.points):
                way = view * (0.3 if kind == "hair" else 1.0) * (k - 2) / 2
                bend = view * 0.08 * rng.uniform(-1, 1) * (kind == "hair")
                c, s = math.cos(away), math.sin(away)
                at = place + frame @ mathutils.Vector((way * c - bend * s, way * s + bend * c, lift))
                point.co = (*at, 1)
            line.use_endpoint_u = True
            made.append(link(kind, curve))
        made[-1].data.materials.append(plain(kind, shade(grounds(rng), rng.uniform(0.3, 1.2))))
    return made


def lamps(rng, frame):
    sun = link("sun", bpy.data.lights.new("sun", "SUN"))
    height, way = rng.uniform(0.3, 1.4), rng.uniform(0, 2 * math.pi)
    toward = frame @ mathutils.Vector(
        (math.cos(height) * math.cos(way), math.cos(height) * math.sin(way), math.sin(height))
    )
    sun.rotation_euler = toward.to_track_quat("Z", "Y").to_euler()
    sun.data.energy, sun.data.angle = rng.uniform(1.5, 4.5), rng.choice([0.01, 0.05, 0.3])
    world = bpy.context.scene.world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    sky = rng.uniform(0.2, 0.7)
    colour = (0.95 * sky, sky, 1.05 * sky, 1)
    world.node_tree.nodes["Background"].inputs["Color"].default_value = colour


def camera(rng, points, faces, walls, view):
    """A camera that sees nothing but the surface, away from its border, and a frame where it looks."""
    tops = [f for f, wall in zip(faces, walls) if not wall]
    middle = sum((mathutils.Vector(p) for p in points), mathutils.Vector()) / len(points)
    tops.sort(key=lambda f: (mathutils.Vector(points[f[0]]) - middle).length)
    eye = link("camera", bpy.data.cameras.new("camera"))
    bpy.context.scene.camera = eye
    for _ in range(200):
        a, b, c = (mathutils.Vector(points[k]) for k in rng.choice(tops[: len(tops) // 4])[:3])
        frame = (b - a).cross(c - a).normalized().to_track_quat("Z", "Y").to_matrix()
        lean, way = math.radians(rng.uniform(0, 40)), rng.uniform(0, 2 * math.pi)
        away = frame @ mathutils.Vector(
            (math.sin(lean) * math.cos(way), math.sin(lean) * math.sin(way), math.cos(lean))
        )
        eye.data.angle, eye.data.clip_start = math.radians(rng.uniform(20, 50)), 0.001
        eye.location = a + view / 2 / math.tan(eye.data.angle / 2) * away
        turn = mathutils.Quaternion((0, 0, 1), rng.uniform(0, 2 * math.pi))
        eye.rotation_euler = (away.to_track_quat("Z", "Y") @ turn).to_euler()
        if sees_surface_alone(eye):
            return a, frame
    raise RuntimeError("no place for the camera")


def sees_surface_alone(eye):
    """By rays a little beyond the picture's border, so that no wall of the sheet's rim is seen."""
    bpy.context.view_layer.update()
    half, graph = 1.15 * math.tan(eye.data.angle / 2), bpy.context.evaluated_depsgraph_get()
    rim = [k / 8 for k in range(-8, 9)]
    for x, y in [(u, v) for u in rim for v in rim if max(abs(u), abs(v)) == 1]:
        toward = eye.matrix_world.to_3x3() @ mathutils.Vector((half * x, half * y, -1))
        if not bpy.context.scene.ray_cast(graph, eye.location, toward)[0]:
            return False
    return True


def render(path, samples, look):
    scene = bpy.context.scene
    scene.render.engine, scene.cycles.samples = "CYCLES", samples
    scene.cycles.use_denoising, scene.cycles.use_adaptive_sampling = False, False
    scene.cycles.max_bounces = 3
    scene.cycles.pixel_filter_type = "BOX" if look == "Raw" else "BLACKMAN_HARRIS"
    scene.view_settings.view_transform = look
    scene.render.resolution_x = scene.render.resolution_y = SIZE
    scene.render.resolution_percentage = 100
    scene.render.image_settings.color_mode = "BW" if look == "Raw" else "RGB"
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)


def empty():
    for made in list(bpy.data.objects):
        bpy.data.objects.remove(made)
    held = bpy.data
    for kind in (held.images, held.meshes, held.curves, held.materials, held.worlds, held.lights):
        for made in list(kind):
            kind.remove(made)


def sample(name, out, craze, seed, clean):
    """One picture and its mask's coverage, 0 … 255. Returns how many pixels the mask has."""
    rng = random.Random(seed)
    empty()
    view = rng.uniform(0.3, 0.55)
    with tempfile.TemporaryDirectory() as folder:
        surface, points, faces, walls = cracked(rng, craze, Path(folder), view, clean)
    target, frame = camera(rng, points, faces, walls, view)
    look, colour = material(rng, view)
    dark = plain("wall", shade(colour, rng.uniform(0.1, 0.6)))
    surface.data.materials.append(look)
    surface.data.materials.append(dark)
    things = strewn(rng, target, view, frame)
    lamps(rng, frame)
    picture = rng.choice(["Standard", "Filmic"])
    off, on = plain("off", (0,) * 3, 0), plain("on", (0,) * 3, 1)
    surface.data.materials[0], surface.data.materials[1] = off, on
    own = [thing.data.materials[0] for thing in things]
    for thing in things:
        thing.data.materials[0] = off
    sky = bpy.context.scene.world.node_tree.nodes["Background"].inputs["Strength"]
    sky.default_value = 0
    coverage = out / "coverage" / f"{name}.png"
    render(coverage, 32, "Raw")
    seen = sum(v >= 0.5 for v in bpy.data.images.load(str(coverage)).pixels[:][::4])
    if not clean and seen < LEAST_PIXELS:
        return seen
    surface.data.materials[0], surface.data.materials[1] = look, dark
    for thing, looks in zip(things, own):
        thing.data.materials[0] = looks
    sky.default_value = 1
    render(out / "images" / f"{name}.png", 32, picture)
    return seen


def main():
    parse = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parse.add_argument("folder", type=Path)
    parse.add_argument("--craze", required=True, help="the command")
    parse.add_argument("--count", type=int, default=90, help="of pictures with cracks")
    parse.add_argument("--clean", type=int, default=30, help="of pictures without")
    parse.add_argument("--seed", type=int, default=1)
    given = parse.parse_args(sys.argv[sys.argv.index("--") + 1 :])
    total = given.count + given.clean
    for k in range(total):
        clean = (k + 1) * given.clean // total > k * given.clean // total
        name = f"{k:04}_{'clean' if clean else 'crack'}"
        if (given.folder / "images" / f"{name}.png").exists():
            continue
        for again in range(20):  # until a crack is seen
            seed = 10**6 * given.seed + 100 * k + again
            if sample(name, given.folder, given.craze, seed, clean) >= LEAST_PIXELS or clean:
                break


main()
