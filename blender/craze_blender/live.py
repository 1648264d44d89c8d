"""A cracked object follows the panel's sliders: how cracks are open ([post]) at once, of the run that
the engine keeps; the rest in the background. The latest wish wins."""

from __future__ import annotations

import json
import time
from typing import Any

import bpy
from bpy.app.handlers import persistent

from . import changes, cracked, mesh_in, panel_recipe, process, progress, runs, table
from .work import Problem, Steps, Work
from .world import remove

PAUSE = 0.15  # seconds without a change before it begins
INTERVAL = 0.02
SLICE = 0.012
SHOWN = 0.2


class _Wish:
    """What the active cracked object should become; None: nothing."""

    do: str | None = None
    since = 0.0
    work: Work | None = None
    thing = ""  # the object's name: a reference would not outlive an undo
    run = ""  # that the work began with
    shown = 0.0  # when it was said how far it is


def wanted(context: Any, do: str) -> None:
    """Something changed: "open", how cracks are open; "crack", the rest."""
    scene = context.scene
    if bpy.app.background or scene is None or not scene.craze.live:
        return
    thing = context.active_object if hasattr(context, "active_object") else None
    if not cracked.is_cracked(thing):
        return
    if _Wish.do != "crack" or _Wish.thing != thing.name:
        _Wish.do = do
    _Wish.thing, _Wish.since = thing.name, time.monotonic()
    if _Wish.work is not None and _Wish.do == "crack":
        _Wish.work.cancel()
        _Wish.work = None
    if _Wish.work is None:
        progress.clear()
    if not bpy.app.timers.is_registered(_tick):
        bpy.app.timers.register(_tick, first_interval=INTERVAL)


def start(thing: Any, do: str, scene: Any) -> Work:
    """The work that brings a cracked object up to the panel; its result is runs.Made, None for an
    object that a user has changed by hand. Raises Problem."""
    cracked.check_own(thing)
    engine, order, name = process.engine(), cracked.order_of(thing), thing.data.name
    if do == "crack":
        order.stretch = mesh_in.stretch_of(thing.matrix_world)
    recipe = panel_recipe.recipe_of(scene.craze, panel_recipe.to_engine(thing.matrix_world, order.stretch))
    if do == "open":
        steps = runs.open_again(engine, order, name, _shown_post(recipe))
        return Work(engine, _for(thing, steps))
    order.recipe, order.run = recipe, runs.new_run()
    return Work(engine, _for(thing, runs.crack(engine, order, name)))


def _for(thing: Any, steps: Steps) -> Steps:
    """Steps whose result is for an object that nobody has changed by hand, neither before nor
    meanwhile; None: somebody has."""
    name, run = thing.name, thing.craze.run
    if (yield from changes.edited(thing)):
        return None
    made = yield from steps
    ready = False
    try:
        while (now := _known(name, run)) is not None and cracked.is_busy(now):
            yield "waiting until Object Mode"
        ready = now is None or not (yield from changes.edited(now))
    finally:
        if not ready:
            remove([made.mesh])
    return made if ready else None


def _known(name: str, run: str) -> Any:
    """The object that had this name and run, or another name since; None: it is gone, or has another
    run by an undo, for one."""
    thing = bpy.data.objects.get(name)
    if thing is not None and thing.craze.run == run:
        return thing
    return next((o for o in bpy.data.objects if o.craze.run == run), None)


def finish(thing: Any, work: Work) -> None:
    """Gives the object what came of it."""
    if work.result is None:
        thing.craze.edited = True
    else:
        cracked.replace_mesh(thing, work.result)


def _shown_post(recipe: dict[str, Any]) -> dict[str, Any]:
    """How the panel opens cracks. A preset's "1%" is a number of the run, and stays it, and so does
    what says the same in another way."""
    post = recipe["post"]
    rows = {row["name"]: row for row in table.single() if row["section"] == "post"}
    own = {row["key"] for name, row in rows.items()
           if row["type"] == "real" and isinstance(post[name], str)}  # fmt: skip
    return {
        name: post[name] for name, row in rows.items() if not own & {row["key"], row["instead_of"]}
    }


def _tick() -> float | None:
    work = _Wish.work
    if work is None:
        if _Wish.do is None:
            return None
        thing = bpy.data.objects.get(_Wish.thing)
        if not cracked.is_cracked(thing):
            _Wish.do = None
            return None
        if cracked.is_busy(thing):
            return INTERVAL  # as long as it is, it keeps its mesh
        pause = 0.0 if _Wish.do == "open" else PAUSE
        if time.monotonic() - _Wish.since >= pause:
            do, _Wish.do = _Wish.do, None
            _Wish.run, _Wish.shown = thing.craze.run, time.monotonic()
            try:
                _Wish.work = start(thing, do, bpy.context.scene)
            except Problem as e:
                progress.fail(str(e))
        return INTERVAL
    if work.advance(SLICE):
        thing = _known(_Wish.thing, _Wish.run)
        _Wish.work = None
        if work.state == "done" and thing is None:
            remove([work.result.mesh] if work.result is not None else [])
        elif work.state == "done":
            finish(thing, work)
            if work.result is not None:
                with bpy.context.temp_override(window=bpy.context.window_manager.windows[0]):
                    bpy.ops.ed.undo_push(message="Craze")
        if work.state == "failed":
            progress.fail(work.error)
        else:
            progress.clear()
    elif time.monotonic() - _Wish.shown > SHOWN:
        _Wish.shown = time.monotonic()
        progress.say(work)
    return INTERVAL


@persistent
def stop(*_: Any) -> None:
    """Gives up what is under way; so it is when another file is read."""
    if _Wish.work is not None:
        _Wish.work.cancel()
    _Wish.work = _Wish.do = None
    progress.clear()
    if bpy.app.timers.is_registered(_tick):
        bpy.app.timers.unregister(_tick)


def register() -> None:
    bpy.app.handlers.load_pre.append(stop)


def unregister() -> None:
    bpy.app.handlers.load_pre.remove(stop)
    stop()
