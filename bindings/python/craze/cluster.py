"""Datasets and sweeps on a dask cluster.

    from dask.distributed import Client
    import craze.cluster
    craze.cluster.run("dataset", "wall.toml", "/shared/wall", client=Client("tcp://host:8786"))

The workers run the `craze` command, one shard a task, into one folder that all of them see. A task
whose worker dies is done again by another, and goes on where it was: what is whole is kept.
"""

from __future__ import annotations

import subprocess
from typing import Any

__all__ = ["run"]


def run(
    verb: str,
    plan: str,
    folder: str,
    *,
    client: Any,
    shards: int = 64,
    threads: int = 1,
    command: str = "craze",
    arguments: tuple[str, ...] = (),
    retries: int = 100,
) -> None:
    """Runs `craze VERB PLAN -o FOLDER` ("dataset" or "sweep") in `shards` tasks on a
    dask.distributed client and waits for them. Paths are the workers'; `arguments` are added to
    each call. RuntimeError with the command's own words where a shard fails."""
    if verb not in ("dataset", "sweep"):
        raise ValueError(f"no verb for many machines: {verb}")
    call = [command, verb, str(plan), "-o", str(folder), "--threads", str(threads), "--quiet"]
    tasks = client.map(
        _run_shard,
        [[*call, *arguments, "--shard", f"{i}/{shards}"] for i in range(shards)],
        pure=False,
        retries=retries,
    )
    failures = [text for text in client.gather(tasks) if text]
    if failures:
        raise RuntimeError(failures[0])


def _run_shard(call: list[str]) -> str:
    """What went wrong, in the command's words; "": nothing. A command that was killed is an
    exception, so that dask runs it again."""
    done = subprocess.run(call, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode < 0 or done.returncode > 2:
        raise RuntimeError(f"{call[0]} was stopped ({done.returncode})")
    return done.stderr.strip() if done.returncode else ""
