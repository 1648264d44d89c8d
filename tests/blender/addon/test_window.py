# needs a window
"""What a user does: start, go on working, stop, undo, drag a slider."""

import time

import bpy
import meshes
import numpy as np
from window import check, press, view

from craze_blender import process
from craze_blender.operators.crack import CRAZE_OT_crack
from craze_blender.work import Work

HEAVY = """
mesh.edge = "keep"
material = { criterion = "strength", scatter = 0.15 }
layer.relative_spacing = 0.03
evolution.max_load = 1.5
"""


def undo_push():
    with bpy.context.temp_override(**view()):
        bpy.ops.ed.undo_push(message="test")


def scene(n):
    meshes.empty()
    process.stop()
    thing = meshes.link(meshes.grid(n))
    undo_push()
    return thing


def start(**said):
    with bpy.context.temp_override(**view()):
        check(bpy.ops.craze.crack("INVOKE_DEFAULT", **said) == {"RUNNING_MODAL"}, "not modal")


def names():
    return sorted(o.name for o in bpy.data.objects)


def until(holds, limit=120.0):
    end = time.monotonic() + limit
    while not holds():
        check(time.monotonic() < end, "it takes too long")
        yield 0.02


def at_work():
    """The request that the engine is busy with, once it cracks."""
    yield from until(lambda: process.engine().pending())
    [request] = process.engine().pending()
    yield from until(lambda: request.state != "running" or is_cracking(request))
    check(request.state == "running", "it ended before anyone saw it at work")
    return request


def is_cracking(request):
    return request.progress[0] == "crack" and request.progress[2] > 0


def test_cracking_is_one_undo_step():
    scene(12)
    start(preset="mud", spacing=0.5)
    yield from until(lambda: names() == ["thing", "thing cracked"])
    yield 0.2
    cracked = len(bpy.data.objects["thing cracked"].data.vertices)
    with bpy.context.temp_override(**view()):
        bpy.ops.ed.undo()
    yield 0.2
    check(names() == ["thing"], f"undo left {names()}")
    check(not bpy.data.objects["thing"].hide_get(), "undo left it hidden")
    with bpy.context.temp_override(**view()):
        bpy.ops.ed.redo()
    yield 0.2
    check(names() == ["thing", "thing cracked"], f"redo left {names()}")
    check(len(bpy.data.objects["thing cracked"].data.vertices) == cracked, "redo made another")


def test_an_undo_meanwhile_leaves_what_it_leads_to():
    scene(150)
    thing = bpy.data.objects["thing"]
    thing.location.x = 3
    undo_push()
    start(recipe=HEAVY)
    # Operators that a script calls with temp_override() read a Python dictionary without Python's
    # lock in Blender 3.4, which dies where a thread runs Python meanwhile, as the one that starts the
    # engine does. A user's Ctrl-Z reads none.
    yield from at_work()
    with bpy.context.temp_override(**view()):
        bpy.ops.ed.undo()
    yield from until(lambda: not process.engine().pending())
    yield 0.5
    check(names() == ["thing"], f"there is {names()}")
    check(bpy.data.objects["thing"].location.x == 0, "the undo is lost")
    check(len(bpy.data.meshes) == 1, f"there are {len(bpy.data.meshes)} meshes")


class Times:
    """When the add-on was told to stop, and when the engine's request ended: the test itself looks
    only as often as the window is drawn."""

    def __enter__(self):
        self.told = self.ended = None
        self.cancel, self.end = Work.cancel, process.Request.end

        def cancel(work):
            self.told = time.monotonic()
            self.cancel(work)

        def end(request, *how):
            self.end(request, *how)
            self.ended = time.monotonic()

        Work.cancel, process.Request.end = cancel, end
        return self

    def __exit__(self, *_):
        Work.cancel, process.Request.end = self.cancel, self.end


def test_escape_stops_within_a_second_and_leaves_nothing():
    scene(150)
    before = names(), len(bpy.data.meshes)
    start(recipe=HEAVY)
    request = yield from at_work()
    with Times() as times:
        press("ESC")
        yield from until(lambda: request.state != "running")
    took = times.ended - times.told
    yield 0.3
    print(f"stopped after {took:.2f} s")
    check(took < 1.0, f"it took {took:.2f} s")
    check(request.state == "cancelled", request.state)
    check((names(), len(bpy.data.meshes)) == before, "something is left")


def test_a_killed_engine_loses_nothing():
    thing = scene(150)
    start(recipe=HEAVY)
    request = yield from at_work()
    process.engine()._process.kill()
    yield from until(lambda: request.state == "failed")
    yield 0.3
    check(names() == ["thing"] and len(thing.data.polygons) == 150 * 150, "something changed")


def shape():
    thing = bpy.data.objects["thing cracked"]
    co = np.empty(3 * len(thing.data.vertices), np.float32)
    thing.data.vertices.foreach_get("co", co)
    return co.tobytes()


def test_a_cracked_object_follows_the_sliders_and_the_latest_wish_wins():
    scene(12)
    panel = bpy.context.scene.craze
    panel.preset = "mud"
    panel.keys.layer_spacing = 0.6
    start()
    yield from until(lambda: len(names()) == 2)
    yield 0.2
    first, run = shape(), bpy.data.objects["thing cracked"].craze.run
    with bpy.context.temp_override(**view()):
        panel.keys.post_gap = 0.3
    yield from until(lambda: shape() != first)
    thing = bpy.data.objects["thing cracked"]
    check(thing.craze.run == run, "it was cracked anew for a gap")
    opened = shape()
    with bpy.context.temp_override(**view()):
        for spacing in (0.9, 0.8, 0.7):
            panel.keys.layer_spacing = spacing
    yield from until(lambda: shape() != opened)
    thing = bpy.data.objects["thing cracked"]
    check(thing.craze.run != run, "it was not cracked anew")
    check('"spacing": 0.7,' in thing.craze.recipe, "an older wish won")
    check(len(bpy.data.meshes) == 3, f"meshes are left: {len(bpy.data.meshes)}")
    yield 0.2
    with bpy.context.temp_override(**view()):
        bpy.ops.ed.undo()
    yield 0.3
    check(shape() == opened, "undo does not lead back to what was before the slider")


def test_what_is_made_of_a_cracked_object_is_one_undo_step_each():
    scene(12)
    start(recipe=OPEN)
    yield from until(lambda: len(names()) == 2)
    yield 0.2
    for operator, said in (
        (bpy.ops.craze.bake, {"size": 16}),
        (bpy.ops.craze.texture, {"preset": "mud", "spacing": 0.2, "size": 16}),
        (bpy.ops.craze.grow, {"frames": 4, "method": "KEYS"}),
        (bpy.ops.craze.grow, {"frames": 4, "method": "NODES"}),
        (bpy.ops.craze.curves, {}),
        (bpy.ops.craze.stats, {}),
        (bpy.ops.craze.pieces, {"thickness": 0.1}),
    ):
        before = state()
        with bpy.context.temp_override(**view()):
            operator("INVOKE_DEFAULT", True, **said)  # with an undo step, as from a button
        yield from until(lambda: state() != before)
        yield from until(lambda: not process.engine().pending())
        yield 0.3
        after = state()
        with bpy.context.temp_override(**view()):
            bpy.ops.ed.undo()
        yield 0.3
        check(state() == before, f"undo of {operator.idname_py()} left {state()}, not {before}")
        with bpy.context.temp_override(**view()):
            bpy.ops.ed.redo()
        yield 0.3
        check(state() == after, f"redo of {operator.idname_py()} made {state()}, not {after}")
        with bpy.context.temp_override(**view()):
            bpy.ops.ed.undo()
        yield 0.3


def state():
    """What there is in the scene, and what the cracked object has."""
    thing = bpy.data.objects.get("thing cracked")
    if thing is None:
        return (names(),)
    keys = thing.data.shape_keys
    return (
        names(),
        sorted(t.name for t in bpy.data.texts),
        sorted(m.name for m in bpy.data.materials if m.asset_data is not None),
        [m.name for m in thing.data.materials if m is not None],
        [m.name for m in thing.modifiers],
        len(keys.key_blocks) if keys else 0,
        sorted(a.name for a in thing.data.attributes),
        thing.hide_get(),
    )


OPEN = HEAVY.replace("0.03", "0.3") + "post = { gap = 0.1, wall = 0.05 }\n"


class Held:
    """How long each call of an operator's modal() takes: of this thread, and by the wall."""

    def __enter__(self):
        self.own, self.wall, self.modal = [], [], CRAZE_OT_crack.modal

        def modal(operator, context, event):
            own, begin = time.thread_time(), time.perf_counter()
            try:
                return self.modal(operator, context, event)
            finally:
                self.own.append(time.thread_time() - own)
                self.wall.append(time.perf_counter() - begin)

        CRAZE_OT_crack.modal = modal
        return self

    def __exit__(self, *_):
        CRAZE_OT_crack.modal = self.modal


def test_the_window_goes_on_while_200000_triangles_crack():
    scene(317)
    with Held() as held:
        start(recipe=HEAVY)
        request = yield from at_work()
        end, turns = time.monotonic() + 5, 0
        while time.monotonic() < end and request.state == "running":
            turns += 1
            yield 0.01
        press("ESC")
        yield from until(lambda: request.state != "running")
        yield 0.3
    print(f"{len(held.own)} calls held {max(held.own) * 1e3:.0f} ms, by the wall "
          f"{max(held.wall) * 1e3:.0f} ms; {turns} turns of a timer in 5 s")  # fmt: skip
    check(len(held.own) > 50, f"{len(held.own)} calls")
    check(max(held.own) < 0.05, f"held for {max(held.own):.3f} s")
