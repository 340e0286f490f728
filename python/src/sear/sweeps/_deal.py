# SPDX-License-Identifier: Apache-2.0
"""Distributes runs to Dask workers and collects their answers."""
import contextlib
import itertools
import logging
import uuid

from . import _worker
from ._cluster import Local

AHEAD = 10             # tasks submitted to Dask in advance, and per thread of its workers:
AHEAD_OF_THREAD = 4
TASK_SECONDS = 0.5     # target duration of a task of several runs
MOST = 100             # maximum runs per task
WEIGHT = 0.1           # weight of the last run in the mean
TIMES = 5              # number of attempts at a run during which workers die


@contextlib.contextmanager
def connected(workers, scheduler, scheduler_file, tell):
    """Returns a Dask client: for workers on this computer, or for a running scheduler."""
    from distributed import Client
    local = None
    try:
        if scheduler is None and scheduler_file is None:
            local = Local(workers)
            scheduler = local.address
        try:
            client = Client(scheduler, timeout=30) if scheduler_file is None else Client(scheduler_file=scheduler_file, timeout=30)
        except (OSError, ValueError, TimeoutError) as error:
            raise ValueError("no Dask scheduler answers at %s (%s), legal: the address of a running one, for example tcp://host:8786"
                             % (scheduler or scheduler_file, error or type(error).__name__)) from None
        logging.getLogger("distributed").setLevel(logging.CRITICAL)
        try:
            tell("%d workers at %s" % (len(client.scheduler_info(n_workers=-1)["workers"]), client.scheduler.address))
            dashboard = local.dashboard if local else client.dashboard_link
            tell("Dask's dashboard: %s%s" % (dashboard, "" if _has("bokeh") else " (needs bokeh: python3 -m pip install bokeh)"))
            yield client
        finally:
            with contextlib.suppress(Exception):
                client.run(_worker.close) if local is None else None
            with contextlib.suppress(Exception):
                client.close(timeout=5)
    finally:
        if local is not None:
            local.close()


def _has(module):
    import importlib.util
    return importlib.util.find_spec(module) is not None


class _Size:
    """Number of runs per Dask task. A task costs some milliseconds, so short runs are grouped. The number follows the
    measured durations."""

    def __init__(self):
        self._seconds = TASK_SECONDS

    def took(self, seconds):
        """Records the duration of a run."""
        self._seconds += (seconds - self._seconds) * WEIGHT

    def now(self):
        """Returns the number."""
        return max(1, min(MOST, int(TASK_SECONDS / max(self._seconds, 1e-6))))


class _Dealer:
    """Runs everything on the workers of a client."""

    def __init__(self, client, common, parts, took):
        from distributed import as_completed
        self._client = client
        self._common = common
        self._parts = parts
        self._took = took
        self._name = uuid.uuid4().hex[:8]
        self._number = itertools.count()
        self._size = _Size()
        self._out = {}
        self._coming = as_completed()

    def _give(self, parts, tries):
        future = self._client.submit(_worker.run_all, self._common, parts, key="sear-%s-%d" % (self._name, next(self._number)), pure=False)
        self._out[future.key] = parts, tries
        self._coming.add(future)

    def _more(self):
        threads = sum(self._client.nthreads().values())
        while len(self._out) < AHEAD + AHEAD_OF_THREAD * threads:
            parts = list(itertools.islice(self._parts, self._size.now()))
            if not parts:
                return
            self._give(parts, 0)

    def _failed(self, future):
        """Handles a failed task: returns answers for abandoned runs and resubmits the others."""
        from distributed.scheduler import KilledWorker
        error = future.exception() if future.status == "error" else None
        if error is not None and not isinstance(error, KilledWorker):
            raise RuntimeError(str(error) or type(error).__name__) from None
        return self._again(future)

    def _again(self, future):
        """Handles a task whose workers died during it or with its result."""
        if self._client.status != "running":
            raise RuntimeError("the connection to Dask's scheduler is lost")
        parts, tries = self._out.pop(future.key)
        if len(parts) == 1 and tries + 1 >= TIMES:
            return [(parts[0], {"status": "died", "message": "Dask workers died repeatedly during the run", "results": {}})]
        for one in parts:
            self._give([one], tries + 1)
        return []

    def _made(self, batch):
        """Returns the finished tasks of a batch with their results; none if a worker has died meanwhile with some of
        them."""
        from distributed import CancelledError
        from distributed.scheduler import KilledWorker
        good = [future for future in batch if future.status == "finished" and future.key in self._out]
        try:
            return list(zip(good, self._client.gather(good)))
        except (CancelledError, KilledWorker):
            return []

    def run(self):
        """Runs until the last answer."""
        self._more()
        for batch in self._coming.batches():
            answers = []
            for future, made in self._made(batch):
                for part, answer in zip(self._out.pop(future.key)[0], made):
                    self._size.took(answer.pop("seconds"))
                    answers.append((part, answer))
            for future in batch:
                if future.key in self._out:     # not finished
                    answers += self._failed(future)
            if answers:
                self._took(answers)
            self._more()


def deal(client, common, parts, took):
    """Performs all runs; took receives lists of (part, answer) as they arrive.

    common: data common to all tasks. parts: dictionaries with the data of each run.

    Raises RuntimeError if a worker can't run anything, or the scheduler is lost.
    """
    from distributed import CancelledError
    try:
        _Dealer(client, common, parts, took).run()
    except (CancelledError, OSError) as error:
        raise RuntimeError("the connection to Dask's scheduler is lost (%s)" % (error or type(error).__name__)) from None
