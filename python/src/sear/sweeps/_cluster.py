# SPDX-License-Identifier: Apache-2.0
"""Dask workers on this computer, in their own process: python3 -m sear.sweeps._cluster NUMBER. It ends when its
standard input is closed.

Workers in the sweeping program's process would import that program again and repeat its statements outside functions.
"""
import json
import os
import signal
import subprocess
import sys

SETTINGS = {"DASK_DISTRIBUTED__WORKER__PROFILE__ENABLED": "False",       # it would sample a waiting worker a hundred times per second
            "DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES": "20"}       # number of workers that may be killed during one run


class Local:
    """The process of the workers."""

    def __init__(self, workers):
        self._process = subprocess.Popen([sys.executable, "-m", "sear.sweeps._cluster", str(workers)], stdin=subprocess.PIPE,
                                         stdout=subprocess.PIPE, env={**SETTINGS, **os.environ}, start_new_session=True)
        told = self._process.stdout.readline()
        if not told:
            self.close()
            raise RuntimeError("Dask's workers do not start; see their messages above")
        said = json.loads(told)
        self.address = said["address"]
        self.dashboard = said["dashboard"]

    def close(self):
        """Ends the process."""
        self._process.stdin.close()
        try:
            self._process.wait(20)
        except subprocess.TimeoutExpired:
            if hasattr(os, "killpg"):
                os.killpg(self._process.pid, signal.SIGKILL)
            self._process.kill()
        self._process.stdout.close()


def main(workers):
    """Prints the addresses and waits for the end."""
    import logging
    from distributed import LocalCluster
    with LocalCluster(n_workers=workers, threads_per_worker=1, memory_limit=0, host="127.0.0.1", dashboard_address="127.0.0.1:0",
                      silence_logs=logging.CRITICAL) as cluster:
        print(json.dumps({"address": cluster.scheduler_address, "dashboard": "http://127.0.0.1:%s/status" % cluster.scheduler.http_server.port}),
              flush=True)
        sys.stdin.read()


if __name__ == "__main__":
    main(int(sys.argv[1]))
