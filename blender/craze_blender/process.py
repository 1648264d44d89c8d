"""The engine's process as Blender sees it: started at the first request, asked without waiting.

A crash, or lack of memory, ends that process alone; the next request starts another.
"""

from __future__ import annotations

import atexit
import contextlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path
from typing import Any, Iterator

import numpy as np

HERE = Path(__file__).resolve().parent
PATIENCE = 0.7  # seconds that a request has to stop before the process is ended


def interpreter() -> str:
    """The Python of this Blender as a program."""
    name = f"python{sys.version_info[0]}.{sys.version_info[1]}"
    beside = Path(sys.prefix) / "bin" / name
    return str(beside) if beside.exists() else sys.executable


class Request:
    """A request on its way. `state` is "running", "done", "failed" or "cancelled"; `progress` is
    (phase, fraction or None, cracks, load)."""

    def __init__(self, number: int) -> None:
        self.number = number
        self.state = "running"
        self.progress: tuple[str, float | None, int, float] = ("start", None, 0, 0.0)
        self.reply: dict[str, Any] = {}
        self.error = ""
        self.message: dict[str, Any] = {}
        self.process: Any = None  # that was asked
        self.unwanted = False  # nobody will read the reply

    def end(self, state: str, error: str = "") -> None:
        if self.state == "running":
            self.error = error
            self.state = state


def arrays_in(reply: dict[str, Any]) -> Iterator[dict[str, np.ndarray] | None]:
    """Yields None after each array, then all that the file of a reply holds; the file is gone then."""
    path, arrays = reply["file"], {}
    try:
        with np.load(path) as file:
            for name in file.files:
                arrays[name] = file[name]
                yield None
    finally:
        os.remove(path)
    yield arrays


class Engine:
    """One process and its folder of files that go to and fro. All methods return at once."""

    def __init__(self, package: str = "") -> None:
        """`package`: the folder that holds the package craze; "": an installed one, or that in the
        folder `engine` beside this file."""
        self._package = package or (str(HERE / "engine") if (HERE / "engine").is_dir() else "")
        self._process: subprocess.Popen[str] | None = None
        self._requests: dict[int, Request] = {}
        self._count = 0
        self._lock = threading.Lock()
        self._ended: Any = None  # the process that was ended by cancel()
        self.folder = tempfile.mkdtemp(prefix="craze-")
        self.version = ""

    def pending(self) -> list[Request]:
        """Requests that have not ended."""
        return [r for r in list(self._requests.values()) if r.state == "running"]

    def send(self, do: str, arrays: dict[str, np.ndarray] | None = None, **fields: Any) -> Request:
        """A request of worker/runs.py; `arrays` go along as the file `mesh`, written on a thread."""
        with self._lock:
            self._count += 1
            request = Request(self._count)
            self._requests[request.number] = request
        if do != "hello":
            fields["out"] = os.path.join(self.folder, f"out-{request.number}.npz")
        threading.Thread(
            target=self._send, args=(request, do, arrays, fields), daemon=True
        ).start()
        return request

    def _send(
        self, request: Request, do: str, arrays: dict[str, np.ndarray] | None, fields: Any
    ) -> None:
        try:
            if arrays is not None:
                fields["mesh"] = os.path.join(self.folder, f"in-{request.number}.npz")
                np.savez(fields["mesh"], **arrays)
            request.message = {"id": request.number, "do": do, **fields}
            self._ask(request)
        except OSError as e:
            request.end("failed", f"the engine cannot be asked: {e.strerror or e}")

    def _ask(self, request: Request) -> None:
        with self._lock:
            process = self._process
            if process is None or process is self._ended or process.poll() is not None:
                self._start()
            request.process = self._process
            _write(request.process, request.message)

    def _start(self) -> None:
        # Where NumPy is, the Python that starts finds it too.
        paths = [str(Path(np.__file__).parents[1]), os.environ.get("PYTHONPATH", "")]
        self._process = subprocess.Popen(
            [interpreter(), "-B", str(HERE / "worker"), self.folder, self._package],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            encoding="utf-8",
            env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, paths))},
        )
        threading.Thread(target=self._listen, args=(self._process,), daemon=True).start()

    def _listen(self, process: subprocess.Popen[str]) -> None:
        assert process.stdout is not None
        error = ""
        for line in process.stdout:
            message = json.loads(line)
            self.version = message.get("version", self.version)
            request = self._requests.get(message.get("id", -1))
            if request is None:
                error = message.get("error", "")
            elif "progress" in message:
                request.progress = tuple(message["progress"])
            elif "done" in message:
                request.reply = message["done"]
                request.end("done")
                if request.unwanted and "file" in request.reply:
                    os.remove(request.reply["file"])
            elif "cancelled" in message:
                request.end("cancelled")
            else:
                request.end("failed", message["error"])
            if request is not None and request.state != "running":
                del self._requests[request.number]
        code = process.wait()
        error = error or f"the engine stopped ({_cause(code)}); nothing in Blender was lost"
        for request in self.pending():
            if request.process is not process:
                continue
            if process is self._ended:
                self._ask(request)  # it waited behind one that did not stop
            else:
                request.end("failed", error)
        with self._lock:  # send() adds one on another thread
            self._requests = {r.number: r for r in self.pending()}

    def cancel(self, request: Request) -> None:
        """Stops a request. A process that has not heard it by then is ended; what waits for its
        turn is asked of the next one."""
        request.unwanted = True
        if request.state == "running":
            threading.Thread(target=self._cancel, args=(request,), daemon=True).start()

    def _cancel(self, request: Request) -> None:
        end = time.monotonic() + PATIENCE
        told = False
        while request.state == "running" and time.monotonic() < end:
            if request.process is not None and not told:
                told = True
                try:
                    with self._lock:
                        _write(request.process, {"cancel": request.number})
                except OSError:
                    pass  # it is gone: whoever listens to it says so
            time.sleep(0.01)
        if request.state != "running":
            return
        waits = any(
            r.number < request.number and r.process is request.process for r in self.pending()
        )
        request.end("cancelled")
        if waits or request.process is None:
            return  # it never begins
        self._ended = request.process
        request.process.kill()
        for name in ("mesh", "out"):
            with contextlib.suppress(OSError):  # it came so far, or not
                os.remove(request.message.get(name, ""))

    def stop(self) -> None:
        """Ends the process and removes its files."""
        process, self._process = self._process, None
        if process is not None and process.poll() is None:
            process.kill()
            process.wait()
        shutil.rmtree(self.folder, ignore_errors=True)


def _write(process: Any, message: dict[str, Any]) -> None:
    process.stdin.write(json.dumps(message) + "\n")
    process.stdin.flush()


def _cause(code: int) -> str:
    if code == -9:
        return "ended from outside, often for lack of memory"
    return f"signal {-code}" if code < 0 else f"exit code {code}"


class _Current:
    """The engine that the operators share."""

    engine: Engine | None = None


def engine() -> Engine:
    """The shared one, made when first asked for."""
    if _Current.engine is None:
        from .preferences import package_folder

        _Current.engine = Engine(package_folder())
        atexit.register(stop)
    return _Current.engine


def stop() -> None:
    """Ends the shared engine, if there is one."""
    if _Current.engine is not None:
        _Current.engine.stop()
        _Current.engine = None
        atexit.unregister(stop)
