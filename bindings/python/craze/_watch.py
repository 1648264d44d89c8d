"""Long calls of the C interface: on a thread of their own, so that Ctrl-C and what a progress
function raises come out at once, whatever the engine is busy with."""

from __future__ import annotations

import threading
from collections import deque
from typing import Any, Callable, Deque, Optional, Tuple

from ._library import PROGRESS, Error, Handle, call, shown

ProgressCallback = Callable[[str, Optional[float], int, float], object]
"""progress(phase, fraction, cracks, load): fraction is 0 … 1, or None where no end is known."""

_INTERVAL = 0.05  # seconds between looks at what has been reached
_PATIENCE = 0.1  # seconds that a call has to stop before it is left to stop by itself


def check_progress(progress: Any) -> None:
    """Raises Error unless it is None or can be called: before any work."""
    if progress is not None and not callable(progress):
        raise Error(f"wrong progress ({shown(progress)}): must be a function")


class _Waiting(threading.local):
    """Locks of the calls that this thread waits for: while it runs a progress function it is still
    waiting, and would wait for itself."""

    def __init__(self) -> None:
        self.locks: list[threading.Lock] = []


_waiting = _Waiting()


class _Call:
    """What the caller's thread and that of the call tell each other."""

    def __init__(self) -> None:
        self.reached: Deque[Tuple[str, Optional[float], int, float]] = deque()
        self.reaching = threading.Lock()
        self.stop = False
        self.done = threading.Event()
        self.result: Any = None
        self.error: BaseException | None = None

    def report(self, _: Any, phase: bytes, fraction: float, cracks: int, load: float) -> int:
        entry = (phase.decode(), None if fraction < 0 else fraction, cracks, load)
        with self.reaching:
            if self.reached and self.reached[-1][0] == entry[0]:
                self.reached.pop()  # the caller is slower than the engine
            self.reached.append(entry)
        return 1 if self.stop else 0

    def tell(self, progress: ProgressCallback | None) -> None:
        if progress is None:
            return
        with self.reaching:
            entries = list(self.reached)
            self.reached.clear()
        for entry in entries:
            progress(*entry)


def watched(
    body: Callable[[Any], Any],
    progress: ProgressCallback | None = None,
    lock: threading.Lock | None = None,
    finish: bool = False,
) -> Any:
    """Returns or raises what body(callback) does, the callback being one for craze.h.

    The thread that calls this waits, hears Ctrl-C and runs `progress`. What either raises stops the
    body and comes out at once; a body that has not stopped by then goes on unseen until it asks its
    callback, unless `finish` is wanted. `lock` is held as long as the body runs. Raises Error where
    `progress` asks for what waits for it.
    """
    if lock is not None and any(held is lock for held in _waiting.locks):
        raise Error("busy (progress): it cannot ask the run that it is told about")
    taken = lock or threading.Lock()
    watch = _Call()
    callback = PROGRESS(watch.report)

    def work() -> None:
        try:
            with taken:
                if not watch.stop:
                    watch.result = body(callback)
        except BaseException as e:  # noqa: BLE001 - raised again in the caller's thread
            watch.error = e
        finally:
            watch.done.set()

    # No daemon: the interpreter must not end under a callback.
    thread = threading.Thread(target=work, name="craze", daemon=False)
    thread.start()
    _waiting.locks.append(taken)
    try:
        while not watch.done.wait(_INTERVAL):
            watch.tell(progress)
        watch.tell(progress)
    except BaseException:
        watch.stop = True
        watch.done.wait(None if finish else _PATIENCE)
        raise
    finally:
        _waiting.locks.pop()
    if watch.error is not None:
        try:
            raise watch.error
        finally:
            watch.error = None  # no cycle through the traceback
    return watch.result


def run(
    job: Handle,
    progress: ProgressCallback | None,
    name: str,
    *arguments: Any,
    take: Callable[[Any], Any] = lambda result: result,
) -> Any:
    """A long function of craze.h on a job; `take` makes something of what it returns that frees
    itself, even where nobody waits for it any more."""

    def body(callback: Any) -> Any:
        call("craze_job_set_progress", job.pointer, callback, None)
        try:
            return take(call(name, job.pointer, *arguments))
        finally:
            call("craze_job_set_progress", job.pointer, PROGRESS(0), None)

    return watched(body, progress, job.lock)
