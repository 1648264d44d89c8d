# needs a window
"""What is clicked: surfaces, and presets by their pictures."""

import contextlib
import io

import bpy
import meshes
from bpy_extras import view3d_utils
from mathutils import Vector
from window import check, click, press, view

from craze_blender import panel, pictures, table


def scene():
    meshes.empty()
    thing = meshes.link(meshes.grid(4, size=2.0))
    thing.location.z = 1.0
    impacts = bpy.context.scene.craze.keys.impact
    impacts.clear()
    of = view()
    region = of["area"].spaces[0].region_3d
    region.view_perspective, region.view_distance = "PERSP", 20.0
    region.view_rotation = Vector((0.3, -0.4, 1.0)).to_track_quat("Z", "Y")
    region.view_location = (0, 0, 1)
    with bpy.context.temp_override(**of):
        check(bpy.ops.craze.impact_click("INVOKE_DEFAULT") == {"RUNNING_MODAL"}, "not modal")
    return impacts, of


def seen(of, point):
    """Where a point is seen in the window."""
    region = of["region"]
    space = of["area"].spaces[0].region_3d
    place = view3d_utils.location_3d_to_region_2d(region, space, point)
    return round(place.x) + region.x, round(place.y) + region.y


def test_a_click_is_an_impact_where_the_surface_is_seen():
    impacts, of = scene()
    yield 0.3
    place = seen(of, Vector((0.5, -0.25, 1.0)))
    click(*place)
    yield 0.3
    check(len(impacts) == 1, f"{len(impacts)} impacts")
    point = impacts[0].point
    check(abs(point[2] - 1) < 1e-5, f"it is not on the surface: {tuple(point)}")
    check(seen(of, Vector(point)) == place, f"{tuple(point)} is seen elsewhere")
    click(*place)
    yield 0.3
    check(len(impacts) == 1, "it goes on after one click")


def test_a_click_beside_the_surface_is_none_and_escape_ends_it():
    impacts, of = scene()
    yield 0.3
    beside = seen(of, Vector((3.5, 0, 1.0)))
    click(*beside)
    yield 0.3
    press("ESC")
    yield 0.3
    click(*seen(of, Vector((0, 0, 1.0))))
    yield 0.3
    check(len(impacts) == 0, f"{len(impacts)} impacts")


def test_each_preset_has_a_picture():
    yield 0.1
    icons = {name: pictures.icon(name) for name in table.PRESETS}
    check(all(icons.values()), f"without a picture: {icons}")
    check(len(set(icons.values())) == len(icons), "two have the same")
    items = bpy.types.Scene.bl_rna.properties["craze"].fixed_type.properties["preset"].enum_items
    check([i.identifier for i in items] == list(table.PRESETS), "other presets")


def test_the_search_finds_keys_by_name_and_by_help():
    yield 0.1
    everything = [row["key"] for row in table.single()]
    check([r["key"] for r in panel.found("")] == everything, "not all without words")
    for words, key in (("gap width", "post.gap_width"), ("GAP_WIDTH", "post.gap_width"),
                       (" screening length ", "layer.screening_length"), ("post.curl", "post.curl"),
                       ("tapering to their tips", "post.gap_width")):  # fmt: skip
        keys = [r["key"] for r in panel.found(words)]
        check(key in keys, f"{words!r} finds {keys}")
        check(len(keys) < len(everything) / 3, f"{words!r} finds {len(keys)}")
    check(panel.found("no such thing") == [], "it finds what is not there")


def test_the_panels_are_drawn_without_an_error():
    """For an object that was cracked and for one that was not; all that are drawn are seen by name."""
    meshes.empty()
    meshes.link(meshes.grid(8))
    area = view()["area"]
    area.spaces[0].show_region_ui = True
    yield 0.5
    sidebar = next(r for r in area.regions if r.type == "UI")
    click(sidebar.x + sidebar.width - 10, sidebar.y + sidebar.height - TAB)
    drawn, old = set(), {cls: cls.draw for cls in panel.CLASSES}

    def drawing(cls):
        def draw(self, context):
            old[cls](self, context)
            drawn.add(cls.__name__)

        return draw

    heard = io.StringIO()
    try:
        for cls in panel.CLASSES:
            cls.draw = drawing(cls)
        with contextlib.redirect_stderr(heard):
            for crack in (False, True):
                if crack:
                    with bpy.context.temp_override(**view()):
                        bpy.ops.craze.crack(preset="mud", spacing=0.7)
                area.tag_redraw()
                yield 0.5
    finally:
        for cls in panel.CLASSES:
            cls.draw = old[cls]
    check("Traceback" not in heard.getvalue(), heard.getvalue())
    # The others are closed at first.
    check({"CRAZE_PT_main", "CRAZE_PT_result"} <= drawn, f"drawn: {drawn}")


TAB = 160  # pixels from the top of the sidebar to the fourth tab
