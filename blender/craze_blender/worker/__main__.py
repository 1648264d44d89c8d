"""The engine's process: python WORKER_FOLDER FOLDER_OF_FILES [FOLDER_OF_THE_PACKAGE_CRAZE].

Reads a request a line on standard input, {"id": 1, "do": "crack", …}, and writes replies a line:
{"id": 1, "progress": [phase, fraction, cracks, load]}, then one {"id": 1, "done": {…}},
{"id": 1, "error": "one sentence"} or {"id": 1, "cancelled": true}. {"cancel": 1} stops a request.
It ends with its input, and removes the folder of files then: Blender is gone.
"""

from __future__ import annotations

import json
import os
import queue
import shutil
import sys
import threading
from typing import Any


class Stopped(Exception):
    """The request was cancelled."""


class Requests:
    """Requests as they come, on a thread of their own, so that one can be stopped."""

    def __init__(self) -> None:
        self.waiting: queue.Queue[dict[str, Any]] = queue.Queue()
        self.stopped: set[int] = set()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        for line in sys.stdin:
            request = json.loads(line)
            if "cancel" in request:
                self.stopped.add(request["cancel"])
            else:
                self.waiting.put(request)
        shutil.rmtree(sys.argv[1], ignore_errors=True)
        os._exit(0)  # nobody waits for what is being done


def serve(replies: Any) -> None:
    def reply(**fields: Any) -> None:
        replies.write(json.dumps(fields) + "\n")
        replies.flush()

    try:
        import craze
        from runs import Runs
    except (ImportError, OSError) as e:
        reply(error=f"the engine does not start: {e}")
        return
    runs, requests = Runs(), Requests()
    reply(version=craze.__version__)
    while True:
        request = requests.waiting.get()
        number, do = request.pop("id"), request.pop("do")

        def progress(*reached: Any) -> None:
            if number in requests.stopped:
                raise Stopped
            reply(id=number, progress=reached)

        try:
            progress(do, None, 0, 0.0)
            done = getattr(runs, do)(**request, progress=progress)
            reply(id=number, done=done)
        except Stopped:
            if os.path.exists(request.get("mesh", "")):
                os.remove(request["mesh"])  # it was stopped before it was read
            reply(id=number, cancelled=True)
        except craze.Error as e:
            reply(id=number, error=str(e), kind=e.kind)
        except OSError as e:
            reply(id=number, error=f"{e.filename}: {e.strerror}", kind="output")
        except MemoryError:
            reply(id=number, error="not enough memory", kind="memory")
        except Exception as e:  # noqa: BLE001 - one sentence, never a traceback
            reply(id=number, error=f"a fault of the add-on: {type(e).__name__}: {e}", kind="internal")


if __name__ == "__main__":
    if hasattr(os, "nice"):
        os.nice(5)  # it uses all cores; Blender's windows come first
    sys.path[:0] = sys.argv[2:3]
    # Replies have standard output for themselves; what else is printed goes to standard error.
    own = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    serve(own)
