"""Long work in short steps, so that Blender's main thread is never held for long.

Work is a generator: it yields None after a step of its own, a Request or, as a text, what else it
waits for, and returns what came of it.
"""

from __future__ import annotations

import time
from typing import Any, Callable, Generator, Iterator

from .process import Engine, Request

Steps = Generator[Any, None, Any]


class Problem(Exception):
    """What went wrong, in one sentence."""


class Work:
    """Runs steps: to the end, or a slice at a time. `state` is "running", "done", "failed" or
    "cancelled"."""

    def __init__(self, engine: Engine, steps: Steps) -> None:
        self._engine = engine
        self._steps = steps
        self.request: Request | None = None
        self._waits = ""
        self.state = "running"
        self.result: Any = None
        self.error = ""

    def advance(self, budget: float = 0.01) -> bool:
        """Works for about `budget` seconds, or until it has to wait; True: ended."""
        end = time.perf_counter() + budget
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
                self.state = "failed"
                self.error = "what was worked on was removed or undone meanwhile"
            except MemoryError:
                self.state, self.error = "failed", "not enough memory in Blender"
            except Exception as e:  # noqa: BLE001 - one sentence in Blender, never a traceback
                self.state = "failed"
                self.error = f"a fault of the add-on: {type(e).__name__}: {e}"
            if self._waits or time.perf_counter() >= end:
                break
        return self.state != "running"

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
            return self._waits or "Blender", None
        phase, fraction, cracks, _ = self.request.progress
        return (f"{phase}, {cracks} cracks" if cracks else phase), fraction


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
