"""Deals runs out to workers of Dask and takes their answers."""
import contextlib
import logging
import uuid

from . import _worker
from ._cluster import Local

AHEAD = 200            # runs that Dask has at once, and for each of its workers' threads:
AHEAD_OF_THREAD = 20
TIMES = 5              # a run under which workers end again and again is given up


@contextlib.contextmanager
def connected(workers, scheduler, scheduler_file, tell):
    """A client of Dask: of workers on this computer, or of a scheduler that runs."""
    from distributed import Client
    local = None
    try:
        if scheduler is None and scheduler_file is None:
            local = Local(workers)
            scheduler = local.address
        try:
            client = Client(scheduler, timeout=30) if scheduler_file is None else Client(scheduler_file=scheduler_file, timeout=30)
        except (OSError, ValueError, TimeoutError) as error:
            raise ValueError("no Dask scheduler answers at %s (%s), legal: the address of one that runs, such as tcp://host:8786"
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


def deal(client, tasks, took):
    """Has all tasks done; took gets lists of (task, answer) as they come.

    Raises RuntimeError if a worker can make no run, or the scheduler has gone.
    """
    from distributed import CancelledError, as_completed
    from distributed.scheduler import KilledWorker
    name = uuid.uuid4().hex[:8]
    out = {}
    coming = as_completed()

    def give(task, tries):
        future = client.submit(_worker.run, task, key="sear-%s-%d-%d" % (name, task["row"], tries), pure=False)
        out[future.key] = task, tries
        coming.add(future)

    def more():
        threads = sum(client.nthreads().values()) if not out else more.threads
        more.threads = threads
        while len(out) < AHEAD + AHEAD_OF_THREAD * threads:
            task = next(tasks, None)
            if task is None:
                return
            give(task, 0)
    more.threads = 1

    more()
    try:
        for batch in coming.batches():
            answers = []
            good = [future for future in batch if future.status == "finished"]
            for future, answer in zip(good, client.gather(good)):
                answers.append((out.pop(future.key)[0], answer))
            for future in batch:
                if future.status == "finished":
                    continue
                task, tries = out.pop(future.key)
                error = future.exception() if future.status == "error" else CancelledError("Dask has cancelled it")
                if not isinstance(error, KilledWorker):
                    raise RuntimeError(str(error) or type(error).__name__) from None
                if tries + 1 < TIMES:
                    give(task, tries + 1)
                else:
                    answers.append((task, {"status": "died", "message": "workers of Dask ended under the run again and again", "results": {}}))
            if answers:
                took(answers)
            more()
    except (CancelledError, OSError) as error:
        raise RuntimeError("Dask's scheduler has gone (%s)" % (error or type(error).__name__)) from None
