"""The screenshots of docs/blender.md, in a window:

    blender --enable-event-simulate --python pictures.py -- FOLDER SCENE…, or panels, or assets

panels wants a window that is 2100 pixels high, scenes one of 800; as those of xvfb-run.
"""

import os
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))
import scenes  # noqa: E402

FOLDER, *WANTED = sys.argv[sys.argv.index("--") + 1 :]
FOLDER = Path(FOLDER).resolve()
bpy.context.preferences.view.show_splash = False


def view():
    window = bpy.context.window_manager.windows[0]
    area = next(a for a in window.screen.areas if a.type == "VIEW_3D")
    region = next(r for r in area.regions if r.type == "WINDOW")
    return {"window": window, "area": area, "region": region}


def unfold():
    """All panels are open from the start."""
    from craze_blender import panel

    for cls in reversed(panel.CLASSES):
        bpy.utils.unregister_class(cls)
    for cls in panel.CLASSES:
        cls.bl_options = set()
        bpy.utils.register_class(cls)


def open_panel():
    """The sidebar, and in it the tab "Craze", by a click on it."""
    of = view()
    of["area"].spaces[0].show_region_ui = True
    yield 1.0
    sidebar = next(r for r in of["area"].regions if r.type == "UI")
    x, y = sidebar.x + sidebar.width - 10, sidebar.y + sidebar.height - TAB
    simulate = of["window"].event_simulate
    simulate(type="MOUSEMOVE", value="NOTHING", x=x, y=y)
    yield 0.3
    for value in ("PRESS", "RELEASE"):
        simulate(type="LEFTMOUSE", value=value, x=x, y=y)


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


def part_of(path, box, name, kind):
    """Saves a part, (x, y, width, height) from below, of a picture as another."""
    import numpy as np

    whole = bpy.data.images.load(path)
    width, height = whole.size
    pixels = np.empty(width * height * whole.channels, np.float32)
    whole.pixels.foreach_get(pixels)
    x, y, w, h = box or (0, 0, width, height)
    part = pixels.reshape(height, width, -1)[y : y + h, x : x + w]
    cut = bpy.data.images.new(name, w, h)
    cut.pixels.foreach_set(np.ascontiguousarray(part).reshape(-1))
    cut.filepath_raw, cut.file_format = str(FOLDER / name), kind
    cut.save()


def panel_shot(name):
    """The sidebar alone."""
    sidebar = next(r for r in view()["area"].regions if r.type == "UI")
    path = str(FOLDER / f"{name}.png")
    capture(path)
    box = sidebar.x, sidebar.y, sidebar.width, sidebar.height
    part_of(path, box, f"{name}.png", "PNG")


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


def capture(path, area=None):
    window = bpy.context.window_manager.windows[0]
    with bpy.context.temp_override(window=window, area=area or view()["area"]):
        bpy.ops.screen.screenshot(filepath=path)


def shot(name, area=None):
    """The window, as a JPEG."""
    path = FOLDER / f"{name}.png"
    capture(str(path), area)
    part_of(str(path), None, f"{name}.jpg", "JPEG")
    path.unlink()


VIEWS = {
    "mud": (0.5, 0.9, 3.2, (0, 0, 0)),
    "vase": (0.5, 1.2, 2.6, (0, 0, 0.55)),
    "glass": (0.3, 0.8, 3.0, (0, 0, 0)),
    "wall": (0.0, 0.7, 3.0, (0, 0, 0)),
    "floor": (0.4, 0.8, 2.6, (0, 0, 0)),
    "lines": (0.4, 1.2, 4.0, (0.6, 0, 0.6)),
}


def scene_shot(name):
    scenes.empty()
    with bpy.context.temp_override(**view()):
        scenes.SCENES[name]()
        bpy.ops.object.select_all(action="DESELECT")
    look(*VIEWS[name])
    if name in {"wall", "floor"}:  # what images show
        view()["area"].spaces[0].shading.type = "MATERIAL"
    yield 4.0  # until pictures of presets are there, and shaders
    view()["area"].tag_redraw()
    yield 2.0 if name in {"mud", "vase", "glass", "lines"} else 20.0
    shot(name)
    yield 0.5


def panel_shots():
    bpy.context.scene.craze.search = "gap"
    scenes.empty()
    with bpy.context.temp_override(**view()):
        scenes.SCENES["vase"]()
        bpy.ops.craze.impact()
    yield 4.0
    for width, by in (("wide", 160), ("middle", -110), ("narrow", -110)):
        yield from widen(by)
        view()["area"].tag_redraw()
        yield 1.0
        panel_shot(f"panel_{width}")


def asset_shot():
    """The Asset Browser with three tiles, in place of the 3D View."""
    scenes.empty()
    for preset, spacing in (("mud", 0.16), ("glaze", 0.12), ("paint", 0.1)):
        bpy.ops.craze.texture(preset=preset, spacing=spacing, size=512)
    area = view()["area"]
    yield 1.0
    area.ui_type = "ASSETS"
    yield 3.0
    if hasattr(area.spaces[0].params, "asset_library_ref"):  # before 4.0
        area.spaces[0].params.asset_library_ref = "LOCAL"
    else:
        area.spaces[0].params.asset_library_reference = "LOCAL"
    yield 5.0
    shot("assets", area)
    area.ui_type = "VIEW_3D"
    yield 1.0


def steps():
    yield 1.0
    if WANTED != ["assets"]:
        yield from open_panel()
    yield 1.0
    for name in WANTED:
        others = {"panels": panel_shots, "assets": asset_shot}
        yield from others[name]() if name in others else scene_shot(name)


if "panels" in WANTED:
    unfold()  # before the window is drawn
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
