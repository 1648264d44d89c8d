"""Long work in short steps, so that Blender's main thread is never held for long.

Work is a generator: it yields None after a step of its own, a Request or, as a text, what else it
waits for, and returns what came of it.
"""

from __future__ import annotations

import time
from contextlib import contextmanager
from typing import Any, Callable, Generator, Iterator

import bpy
from bpy.app.handlers import persistent

from .process import Engine, Request

Steps = Generator[Any, None, Any]
GONE = "what was worked on was removed or undone meanwhile"


class Problem(Exception):
    """What went wrong, in one sentence."""


class Work:
    """Runs steps: to the end, or a slice at a time. `state` is "running", "done", "failed" or
    "cancelled"."""

    current: Work | None = None  # whose steps run now
    undone = 0  # how often something was undone or done again

    def __init__(self, engine: Engine, steps: Steps) -> None:
        self._engine = engine
        self._steps = steps
        self.request: Request | None = None
        self._waits = ""
        self.state = "running"
        self.result: Any = None
        self.error = ""
        self.held: list[Any] = []
        self._undone = Work.undone

    def advance(self, budget: float = 0.01) -> bool:
        """Works for about `budget` seconds, or until it has to wait; True: ended."""
        end = time.perf_counter() + budget
        if self._is_gone():
            self._steps.close()
            self.state, self.error = "failed", GONE
        Work.current = self
        while self.state == "running":
            if self.request is not None and self.request.state == "running":
                return False
            try:
                reached = next(self._steps)
                self._waits = reached if isinstance(reached, str) else ""
                self.request = None if self._waits else reached
            except StopIteration as e:
                self.state, self.result = "done", e.value
            except Problem as e:
                self.state, self.error = "failed", str(e)
            except ReferenceError:
                self.state, self.error = "failed", GONE
            except MemoryError:
                self.state, self.error = "failed", "not enough memory in Blender"
            except Exception as e:  # noqa: BLE001 - one sentence in Blender, never a traceback
                self.state = "failed"
                self.error = f"a fault of the add-on: {type(e).__name__}: {e}"
            if self._waits or time.perf_counter() >= end:
                break
        return self.state != "running"

    def _is_gone(self) -> bool:
        """Whether it cannot go on after what happened since the last step: a data-block that it has
        parts of at hand is gone, or went back to what it was at an undo's time, half made."""
        undone, self._undone = self._undone != Work.undone, Work.undone
        if self.state != "running" or self.request is not None or self._waits:
            return False
        return undone or not all(map(is_there, self.held))

    def finish(self, seen: Callable[[], None] = lambda: None) -> None:
        """Works to the end; `seen` is called about every 10 ms."""
        while not self.advance(1.0):
            seen()
            time.sleep(0.005)

    def cancel(self) -> None:
        """Stops at once; what was made so far is removed."""
        if self.state == "running":
            if self.request is not None:
                self._engine.cancel(self.request)
            self._steps.close()
            self.state = "cancelled"

    def says(self) -> tuple[str, float | None]:
        """What it is at, and how far, 0 … 1 or None."""
        if self.request is None:
            return self._waits or "working in Blender", None
        phase, fraction, cracks, _ = self.request.progress
        return (f"{phase}, {cracks} cracks" if cracks else phase), fraction


def is_there(thing: Any) -> bool:
    """Whether a data-block was not removed, by an undo, another file or a user."""
    try:
        return bool(thing.name)
    except ReferenceError:
        return False


@contextmanager
def holding(*things: Any) -> Iterator[None]:
    """For steps that have parts of data-blocks at hand, which Blender does not watch over: where one
    of those is removed in between, the work fails before it is touched."""
    held = Work.current.held if Work.current is not None else []
    held += things
    try:
        yield
    finally:
        for thing in things:
            held.remove(thing)


@persistent
def _undo(*_: Any) -> None:
    Work.undone += 1


def register() -> None:
    bpy.app.handlers.undo_post.append(_undo)
    bpy.app.handlers.redo_post.append(_undo)


def unregister() -> None:
    bpy.app.handlers.undo_post.remove(_undo)
    bpy.app.handlers.redo_post.remove(_undo)


def asked(request: Request) -> Steps:
    """Waits for a request and returns its reply."""
    yield request
    if request.state != "done":
        raise Problem(request.error or "cancelled")
    return request.reply


def last(steps: Iterator[Any]) -> Steps:
    """Goes through steps and returns what the last one yields; the others yield None."""
    found = None
    for found in steps:
        if found is None:
            yield
    return found
