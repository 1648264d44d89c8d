# needs a window
"""What a user reads while the engine is at work, and what a second wish does."""

import bpy
from test_window import HEAVY, OPEN, at_work, names, scene, start, undo_push, until
from window import check, press, view

import craze_blender
from craze_blender import process, progress

# A few seconds on that grid: long enough to be seen, and its end is waited for.
LONGER, LARGE = HEAVY.replace("0.03", "0.1"), 150


def idle():
    yield from until(lambda: not process.engine().pending())
    yield 0.5


def test_the_panel_says_how_far_it_is_until_it_ends():
    scene(LARGE)
    start(recipe=LONGER)
    yield from at_work()
    yield from until(lambda: progress.shown()[0].startswith("craze: crack, "))
    check(not progress.shown()[1], "it is an error")
    press("ESC")
    yield from idle()
    check(progress.shown() == ("", False), f"it says {progress.shown()}")
    check(names() == ["thing"], f"there is {names()}")


def test_a_second_press_does_not_crack_twice_and_a_later_one_does():
    scene(LARGE)
    start(recipe=LONGER)
    with bpy.context.temp_override(**view()):
        check(bpy.ops.craze.crack("INVOKE_DEFAULT", recipe=LONGER) == {"CANCELLED"}, "it began")
    yield from until(lambda: len(names()) == 2)
    yield from idle()
    check(names() == ["thing", "thing cracked"], f"there is {names()}")
    start(recipe=LONGER)
    yield from at_work()
    press("ESC")
    yield from idle()
    run = bpy.data.objects["thing cracked"].craze.run
    start(recipe=OPEN)
    yield from until(lambda: bpy.data.objects["thing cracked"].craze.run != run)
    check(len(names()) == 2, f"there is {names()}")


def test_what_the_sliders_cannot_do_is_said_until_they_can():
    scene(12)
    panel = bpy.context.scene.craze
    panel.preset, panel.keys.layer_spacing = "mud", 0.6
    start()
    yield from until(lambda: len(names()) == 2)
    yield 0.3
    thing = bpy.data.objects["thing cracked"]
    run = thing.craze.run
    with bpy.context.temp_override(**view()):
        panel.keys.layer_spacing = 90.0
    yield from until(lambda: progress.shown()[1])
    check("spacing larger than the object" in progress.shown()[0], progress.shown()[0])
    check(thing.craze.run == run, "it was cracked")
    with bpy.context.temp_override(**view()):
        panel.keys.layer_spacing = 0.7
    yield from until(lambda: thing.craze.run != run)
    yield 0.3
    check(progress.shown() == ("", False), f"it says {progress.shown()}")
    panel.keys.layer_spacing = 0.0


def test_edits_in_edit_mode_while_it_cracks_in_place_stay():
    thing = scene(LARGE)
    start(recipe=LONGER, in_place=True)
    yield from at_work()
    with bpy.context.temp_override(**view()):
        bpy.ops.object.mode_set(mode="EDIT")
    yield from until(lambda: "waiting until Edit Mode" in progress.shown()[0])
    with bpy.context.temp_override(**view()):
        bpy.ops.mesh.select_all(action="SELECT")
        bpy.ops.transform.translate(value=(0, 0, 2))
        bpy.ops.object.mode_set(mode="OBJECT")
    yield from until(lambda: len(names()) == 2)
    yield 0.3
    check(len(thing.data.vertices) == (LARGE + 1) ** 2, "it is another mesh")
    check(all(abs(v.co.z - 2) < 1e-6 for v in thing.data.vertices), "the edit is lost")
    check(not thing.hide_get(), "it is hidden")
    check(bpy.context.view_layer.objects.active == thing, "another object is active")


def test_who_has_gone_on_to_another_object_stays_there():
    thing = scene(LARGE)
    other = bpy.data.objects.new("other", thing.data.copy())
    bpy.context.scene.collection.objects.link(other)
    undo_push()
    start(recipe=LONGER)
    yield from at_work()
    with bpy.context.temp_override(**view()):
        thing.select_set(False)
        other.select_set(True)
        bpy.context.view_layer.objects.active = other
        bpy.ops.object.mode_set(mode="EDIT")
    yield from until(lambda: "thing cracked" in names())
    yield 0.3
    check(bpy.context.view_layer.objects.active == other, "another object is active")
    check(other.mode == "EDIT", f"it is in {other.mode}")
    chosen = [o.name for o in bpy.context.view_layer.objects if o.select_get()]
    check(chosen == ["other"], f"selected is {chosen}")
    with bpy.context.temp_override(**view()):
        bpy.ops.object.mode_set(mode="OBJECT")


def test_another_file_meanwhile_ends_it():
    for in_place in (False, True):
        scene(LARGE)
        start(recipe=LONGER, in_place=in_place)
        yield from at_work()
        with bpy.context.temp_override(**view()):
            bpy.ops.wm.read_homefile(use_factory_startup=True)
        yield from idle()
        yield 1.0
        check(names() == ["Camera", "Cube", "Light"], f"there is {names()}")
        check(len(bpy.data.meshes) == 1, "a mesh is left")
        check(progress.shown() == ("", False), f"it says {progress.shown()}")


def test_an_addon_that_is_disabled_meanwhile_leaves_nothing_and_comes_back():
    scene(LARGE)
    start(recipe=LONGER)
    yield from at_work()
    craze_blender.unregister()
    yield 0.5
    check(names() == ["thing"] and len(bpy.data.meshes) == 1, "something is left")
    craze_blender.register()
    yield 0.5
    check(progress.shown() == ("", False), f"it says {progress.shown()}")
    scene(12)
    start(recipe=OPEN)
    yield from until(lambda: names() == ["thing", "thing cracked"])
    yield 0.3


def test_cracking_in_place_is_undone_with_modifiers_and_done_again():
    thing = scene(12)
    thing.modifiers.new("finer", "SUBSURF")
    undo_push()
    start(recipe=OPEN, in_place=True)
    yield from until(lambda: len(bpy.data.objects["thing"].data.vertices) > 200)
    yield 0.3
    for _ in range(2):
        with bpy.context.temp_override(**view()):
            bpy.ops.ed.undo()
        yield 0.3
        thing = bpy.data.objects["thing"]
        check(len(thing.data.vertices) == 13 * 13, "undo left another mesh")
        check([m.name for m in thing.modifiers] == ["finer"], "undo left no modifier")
        with bpy.context.temp_override(**view()):
            bpy.ops.ed.redo()
        yield 0.3
        thing = bpy.data.objects["thing"]
        check(len(thing.data.vertices) > 200 and not thing.modifiers, "redo made another")
