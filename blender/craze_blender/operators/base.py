"""An operator whose work takes a while: modal when a user starts it, blocking when a script does."""

from __future__ import annotations

import time
from typing import Any

import bpy

from .. import process, progress
from ..work import Steps, Work

INTERVAL = 0.02  # seconds between looks
SHOWN = 0.2  # seconds from one state that is shown to the next
SLICE = 0.012  # seconds of work in Blender at a look
# Of operators that run: which, and the object it is about; its work and timer.
_AT_WORK: list[tuple[tuple[str, str], Work, Any]] = []


class EngineOperator:
    """Mixed into bpy.types.Operator. No redo panel: what it changes would run in the main thread."""

    bl_options = {"UNDO"}
    of_object = True  # it is about the active one
    _work: Work
    _timer: Any = None
    _shown = 0.0

    def steps(self, context: Any) -> Steps:
        """The work. The last step changes the scene and returns a sentence about it."""
        raise NotImplementedError

    def execute(self, context: Any) -> set[str]:
        work = Work(process.engine(), self.steps(context))
        work.finish()
        return self._end(work)

    def invoke(self, context: Any, _: Any) -> set[str]:
        if bpy.app.background:
            return self.execute(context)
        name = context.active_object.name if self.of_object else ""
        what = (self.bl_idname, name)  # type: ignore[attr-defined]
        if self.of_object and any(what == known for known, *_ in _AT_WORK):
            self.report(  # type: ignore[attr-defined]
                {"WARNING"}, f"craze: {name} is being worked on already; Esc stops it"
            )
            return {"CANCELLED"}
        self._work = Work(process.engine(), self.steps(context))
        self._work.advance(0.0)  # of the object that is active now
        manager = context.window_manager
        self._timer = manager.event_timer_add(INTERVAL, window=context.window)
        _AT_WORK.append((what, self._work, self._timer))
        manager.progress_begin(0, 100)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: Any, event: Any) -> set[str]:
        if event.type == "ESC" and event.value == "PRESS":
            self._work.cancel()
        elif event.type == "TIMER":
            self._work.advance(SLICE)
            self._show(context)
        if self._work.state == "running":
            return {"RUNNING_MODAL"} if event.type == "ESC" else {"PASS_THROUGH"}
        self._hide(context)
        return self._end(self._work)

    def cancel(self, context: Any) -> None:
        """Blender closes or reads another file."""
        self._work.cancel()
        self._hide(context)

    def _end(self, work: Work) -> set[str]:
        if work.state == "done":
            if work.result:
                self.report({"INFO"}, work.result)  # type: ignore[attr-defined]
            return {"FINISHED"}
        if work.state == "failed":
            self.report({"ERROR"}, f"craze: {work.error}")  # type: ignore[attr-defined]
        return {"CANCELLED"}

    def _show(self, context: Any) -> None:
        """Says how far it is, now and then."""
        if time.monotonic() - self._shown < SHOWN:
            return
        self._shown = time.monotonic()
        progress.say(self._work, "Esc: stop")
        context.window_manager.progress_update(100 * (self._work.says()[1] or 0.0))

    def _hide(self, context: Any) -> None:
        for known in list(_AT_WORK):
            if known[1] is self._work:
                _forget(*known)


def _forget(what: tuple[str, str], work: Work, timer: Any) -> None:
    _AT_WORK.remove((what, work, timer))
    progress.clear()
    bpy.context.window_manager.progress_end()
    bpy.context.window_manager.event_timer_remove(timer)


def stop() -> None:
    """Cancels what runs: the add-on is disabled, and nobody would call modal() again."""
    for what, work, timer in list(_AT_WORK):
        work.cancel()
        _forget(what, work, timer)


class OfCracked(EngineOperator):
    """One that needs a cracked object."""

    @classmethod
    def poll(cls, context: Any) -> bool:
        from ..cracked import is_cracked

        if is_cracked(context.active_object) and context.mode == "OBJECT":
            return True
        cls.poll_message_set("craze: select an object that Crack has made, in Object Mode")
        return False
