"""The screenshots of docs/blender.md, in a window: blender --python pictures.py -- FOLDER"""

import os
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))
import scenes  # noqa: E402

FOLDER = Path(sys.argv[sys.argv.index("--") + 1])
bpy.context.preferences.view.show_splash = False


def view():
    window = bpy.context.window_manager.windows[0]
    area = next(a for a in window.screen.areas if a.type == "VIEW_3D")
    region = next(r for r in area.regions if r.type == "WINDOW")
    return {"window": window, "area": area, "region": region}


def open_panel():
    """The sidebar, and in it the tab "Craze", by a click on it."""
    of = view()
    area = of["area"]
    area.spaces[0].show_region_ui = True
    sidebar = next(r for r in area.regions if r.type == "UI")
    x, y = sidebar.x + sidebar.width - 10, sidebar.y + sidebar.height - TAB
    for value in ("PRESS", "RELEASE"):
        of["window"].event_simulate(type="LEFTMOUSE", value=value, x=x, y=y)


def widen(by):
    """Drags the sidebar's edge, pixels."""
    of = view()
    sidebar = next(r for r in of["area"].regions if r.type == "UI")
    x, y = sidebar.x + EDGE, sidebar.y + sidebar.height // 4
    simulate = of["window"].event_simulate
    simulate(type="MOUSEMOVE", value="NOTHING", x=x, y=y)
    yield 0.3
    simulate(type="LEFTMOUSE", value="PRESS", x=x, y=y)
    yield 0.3
    for part in (0.5, 1.0):
        simulate(type="MOUSEMOVE", value="NOTHING", x=x - round(part * by), y=y)
        yield 0.3
    simulate(type="LEFTMOUSE", value="RELEASE", x=x - by, y=y)
    yield 0.5


def panel_shot(name):
    """The sidebar alone."""
    import numpy as np

    sidebar = next(r for r in view()["area"].regions if r.type == "UI")
    shot(name)
    path = str(FOLDER / f"{name}.png")
    whole = bpy.data.images.load(path)
    width, height = whole.size
    pixels = np.empty(width * height * whole.channels, np.float32)
    whole.pixels.foreach_get(pixels)
    pixels = pixels.reshape(height, width, -1)
    part = pixels[sidebar.y : sidebar.y + sidebar.height, sidebar.x : sidebar.x + sidebar.width]
    cut = bpy.data.images.new(name, part.shape[1], part.shape[0])
    cut.pixels.foreach_set(np.ascontiguousarray(part).reshape(-1))
    cut.filepath_raw, cut.file_format = path, "PNG"
    cut.save()


TAB = 160  # pixels from the top of the sidebar to the fourth tab
EDGE = 6  # pixels from the sidebar's left to where it is dragged


def look(yaw, pitch, distance, target=(0, 0, 0)):
    import mathutils

    of = view()
    space = of["area"].spaces[0].region_3d
    space.view_perspective = "PERSP"
    space.view_rotation = mathutils.Euler((pitch, 0, yaw)).to_quaternion()
    space.view_distance, space.view_location = distance, target
    shading = of["area"].spaces[0].shading
    shading.type, shading.color_type = "SOLID", "MATERIAL"
    shading.show_cavity = True
    of["area"].spaces[0].overlay.show_floor = False
    of["area"].spaces[0].overlay.show_axis_x = of["area"].spaces[0].overlay.show_axis_y = False


def shot(name):
    with bpy.context.temp_override(**view()):
        bpy.ops.screen.screenshot(filepath=str(FOLDER / f"{name}.png"))


def steps():
    yield 1.0
    open_panel()
    yield 1.0
    for name, (yaw, pitch, distance, target) in {
        "mud": (0.5, 0.9, 3.2, (0, 0, 0)),
        "vase": (0.5, 1.2, 2.6, (0, 0, 0.55)),
        "glass": (0.3, 0.8, 3.0, (0, 0, 0)),
    }.items():
        scenes.empty()
        with bpy.context.temp_override(**view()):
            scenes.SCENES[name]()
            bpy.ops.object.select_all(action="DESELECT")
        look(yaw, pitch, distance, target)
        yield 4.0  # until pictures of presets are there
        view()["area"].tag_redraw()
        yield 2.0
        shot(name)
        yield 0.5
        if name == "vase":
            for width, by in (("wide", 160), ("narrow", -220)):
                yield from widen(by)
                panel_shot(f"panel_{width}")
            yield from widen(60)


running = steps()


def step():
    try:
        return next(running)
    except StopIteration:
        os._exit(0)
    except BaseException:
        import traceback

        traceback.print_exc()
        os._exit(3)


bpy.app.timers.register(step, first_interval=1.0)
