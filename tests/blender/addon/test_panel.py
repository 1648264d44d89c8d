# needs a window
"""What is clicked: surfaces, and presets by their pictures."""

import contextlib
import io
import types

import bpy
import meshes
from bpy_extras import view3d_utils
from mathutils import Vector
from window import check, click, drag, hover, press, view

from craze_blender import panel, pictures, table
from craze_blender.settings import GAP


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


def show_tab():
    """Opens the sidebar at the tab Craze; the sidebar."""
    area = view()["area"]
    area.spaces[0].show_region_ui = True
    yield 0.5
    sidebar = next(r for r in area.regions if r.type == "UI")
    for _ in range(2):  # the first click may only bring the mouse there
        click(sidebar.x + sidebar.width - 10, sidebar.y + sidebar.height - TAB)
        yield 0.2
    return sidebar


def only_where(self, context):
    """The panel Where in the place of the main one, without its fields: buttons where they are seen."""
    panel.CRAZE_PT_where.draw(types.SimpleNamespace(layout=self.layout, _place=no_field), context)


def no_field(*_):
    pass


def test_the_button_starts_weight_paint_and_what_is_painted_does_not_crack():
    meshes.empty()
    thing = meshes.link(meshes.grid(16, size=4.0))
    main = panel.CRAZE_PT_main.draw
    panel.CRAZE_PT_main.draw = only_where
    try:
        sidebar = yield from show_tab()
        button = sidebar.x + 50, sidebar.y + sidebar.height - PAINT
        hover(*button)
        yield 0.2
        click(*button)
        yield 0.3
    finally:
        panel.CRAZE_PT_main.draw = main
    check(thing.mode == "WEIGHT_PAINT", f"it is in {thing.mode}")
    group = thing.vertex_groups["Cracks"]
    check(all(group.weight(i) == 1 for i in range(17 * 17)), "it does not begin with 1 everywhere")
    check(bpy.context.scene.craze.keys.where_attribute == "Cracks", "the recipe does not know it")
    of = view()
    region = of["area"].spaces[0].region_3d
    region.view_perspective, region.view_distance = "ORTHO", 12.0
    region.view_rotation, region.view_location = (1, 0, 0, 0), (0, 0, 0)
    brush = bpy.context.tool_settings.unified_paint_settings
    brush.weight, brush.size = 0.0, 60
    yield 0.3
    drag(seen(of, Vector((0, -1.9, 0))), seen(of, Vector((0, 1.9, 0))))
    yield 0.3
    with bpy.context.temp_override(**of):
        bpy.ops.object.mode_set(mode="OBJECT")
        left = [v.co for v in thing.data.vertices if group.weight(v.index) > 0]
        painted = [v.co for v in thing.data.vertices
                   if all((v.co - co).length > 0.4 for co in left)]  # fmt: skip
        check(left and painted, f"painted {len(painted)}, left {len(left)}")
        keys = bpy.context.scene.craze.keys
        keys.post_gap = 0.0  # nothing moves
        bpy.ops.craze.crack()
        keys.post_gap, keys.where_attribute = GAP, ""
    cracked = bpy.context.scene.objects["thing cracked"].data
    check(len(cracked.vertices) > 17 * 17, "nothing cracked")
    distance = cracked.attributes["crack_distance"].data
    for co in painted:
        near = [v.index for v in cracked.vertices if (v.co - co).length < 1e-6]
        check(len(near) == 1 and distance[near[0]].value > 0, f"it cracked at {tuple(co)}: {near}")


def test_the_panels_are_drawn_without_an_error():
    """For an object that was cracked and for one that was not; all that are drawn are seen by name."""
    meshes.empty()
    meshes.link(meshes.grid(8))
    area = view()["area"]
    yield from show_tab()
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
PAINT = 46  # to the button Paint of the panel Where
