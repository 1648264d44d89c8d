"""A dask cluster whose workers are killed during the run. Skipped without dask.distributed."""

import importlib.util
import os
import signal
import subprocess
import tempfile
import threading
import time
import unittest
from pathlib import Path

import craze.cluster
from small import COMMAND

PLAN = """
samples = 12
shard_samples = 2
width = 48
height = 48
[object]
mesh = "shape:plate?n=20&jitter=0.3"
[recipe]
preset = "mud"
"""


def files(folder):
    return {str(path.relative_to(folder)): path.read_bytes()
            for path in sorted(Path(folder).rglob("*"))
            if path.is_file() and path.name != "made_by.json"}


@unittest.skipUnless(COMMAND, "no command")
@unittest.skipUnless(importlib.util.find_spec("distributed"),
                     "no dask.distributed (apt: python3-distributed)")
class Dask(unittest.TestCase):
    def test_workers_that_are_killed_change_no_byte_of_a_set_that_grows(self):
        from distributed import Client, LocalCluster

        with tempfile.TemporaryDirectory() as folder:
            plan = Path(folder, "plan.toml")
            plan.write_text(PLAN, encoding="utf-8")
            subprocess.run([COMMAND, "dataset", plan, "-o", Path(folder, "one"), "--quiet"],
                           check=True)
            subprocess.run([COMMAND, "dataset", plan, "-o", Path(folder, "many"), "--quiet",
                            "--samples", "3"], check=True)
            with LocalCluster(n_workers=2, threads_per_worker=1, processes=True,
                              dashboard_address=None) as cluster, Client(cluster) as client:
                pids = list(client.run(os.getpid).values())

                def kill():
                    time.sleep(0.6)
                    os.kill(pids[0], signal.SIGKILL)

                killer = threading.Thread(target=kill)
                killer.start()
                craze.cluster.run("dataset", str(plan), str(Path(folder, "many")), client=client,
                                  shards=5, command=COMMAND,
                                  arguments=("--samples", "12"))
                killer.join()
            self.assertEqual(files(Path(folder, "one")), files(Path(folder, "many")))

    def test_what_a_shard_says_comes_out(self):
        from distributed import Client

        with Client(processes=False, n_workers=1, dashboard_address=None) as client:
            with self.assertRaisesRegex(RuntimeError, "cannot read the plan"):
                craze.cluster.run("sweep", "/none.toml", "/none", client=client, shards=2,
                                  command=COMMAND)


class Verbs(unittest.TestCase):
    def test_only_those_in_shards_are_known(self):
        with self.assertRaises(ValueError):
            craze.cluster.run("crack", "plan.toml", "out", client=None)


if __name__ == "__main__":
    unittest.main()
