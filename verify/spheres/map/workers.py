"""Who decides the chunks of a map: this process, others, or a Dask cluster; results in order."""

from __future__ import annotations

import logging
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import BrokenExecutor, CancelledError, Executor, Future
from typing import Any

from verify.wire.inputs import InputError

#: How often lost workers are replaced before the map gives up.
MAX_LOSSES = 20
#: So many chunks are given to each worker ahead of their turn.
AHEAD = 3
#: As many workers may a Dask cluster have before some of them wait.
MAX_JOBS = 64

Work = Callable[[Any], Any]
#: Tasks with their futures, the next one first.
Waiting = deque[tuple[Any, Future[Any]]]


class HereExecutor(Executor):
    """Does the work at once, in this process."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """A future that has its result."""
        future: Future[Any] = Future()
        future.set_result(fn(*args, **kwargs))
        return future


class DaskExecutor(Executor):
    """The workers of a Dask cluster, until it is shut down."""

    def __init__(self, client: Any) -> None:
        self._client, self._executor = client, client.get_executor(pure=False)

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Give work to some worker."""
        future: Future[Any] = self._executor.submit(fn, *args, **kwargs)
        return future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:  # noqa: ARG002
        """Leave the cluster."""
        self._executor.shutdown(wait=wait)
        self._client.close()


class Workers:
    """An executor that is made anew when its workers are lost; what they finished is kept."""

    def __init__(
        self,
        make: Callable[[], Executor],
        ahead: int,
        lost: tuple[type[BaseException], ...] = (),
        unfit: tuple[type[BaseException], ...] = (),
    ) -> None:
        self._make, self._executor, self._unfit = make, make(), unfit
        self.ahead, self._losses = ahead, 0
        self._lost: tuple[type[BaseException], ...] = (BrokenExecutor, CancelledError, *lost)

    def __enter__(self) -> Workers:
        return self

    def __exit__(self, *_: object) -> None:
        self._executor.shutdown(wait=True)

    def in_order(self, work: Work, tasks: Iterable[Any]) -> Iterator[Any]:
        """The results in the order of the tasks, some of which are done ahead.

        A task None says that the next one depends on results that are not known yet.
        After Ctrl-C nothing new is begun, and what is finished still comes.
        """
        waiting: Waiting = deque()
        try:
            for task in tasks:
                if task is not None:
                    waiting.append((task, self._submit(work, task)))
                if task is None or len(waiting) >= self.ahead:
                    yield self._first(work, waiting)
            while waiting:
                yield self._first(work, waiting)
        except KeyboardInterrupt:
            _cancel(waiting)
            while waiting and not waiting[0][1].cancelled():
                yield waiting.popleft()[1].result()
            raise
        finally:
            _cancel(waiting)

    def _submit(self, work: Work, task: Any) -> Future[Any]:
        try:
            return self._executor.submit(work, task)
        except self._lost as error:  # a worker was lost before anybody asked for a result
            future: Future[Any] = Future()
            future.set_exception(error)
            return future

    def _first(self, work: Work, waiting: Waiting) -> Any:
        while True:
            try:
                result = waiting[0][1].result()
            except self._lost as error:
                self._renew(work, waiting, error)
                continue
            except self._unfit as error:
                raise InputError(
                    "--dask: the cluster cannot do this work; install the same version of this "
                    f"program there ({str(error).partition('.')[0]})"
                ) from error
            waiting.popleft()
            return result

    def _renew(self, work: Work, waiting: Waiting, error: BaseException) -> None:
        self._losses += 1
        if self._losses > MAX_LOSSES:
            raise InputError(f"--jobs: workers were lost {MAX_LOSSES} times ({error})") from error
        self._executor.shutdown(wait=False)
        self._executor = self._make()
        for place, (task, future) in enumerate(waiting):
            if not future.done() or future.cancelled() or future.exception() is not None:
                waiting[place] = task, self._submit(work, task)


def _cancel(waiting: Waiting) -> None:
    for _, future in waiting:
        future.cancel()


def workers(jobs: int, dask: str | None) -> Workers:
    """So many processes, or the workers of a Dask scheduler.

    Raises:
        InputError: if there is no Dask, or no scheduler at the address.
    """
    if dask is not None:
        return _dask(dask)
    if jobs == 1:
        return Workers(HereExecutor, 1)
    return Workers(lambda: _processes(jobs), AHEAD * jobs)


def _processes(jobs: int) -> Executor:
    """So many processes, which Ctrl-C does not reach: it is for the one that prints and writes."""
    import signal
    from concurrent.futures import ProcessPoolExecutor  # loaded only where it is used

    pool = ProcessPoolExecutor(jobs, initializer=_attend)
    # All processes start with the first task; until they ignore Ctrl-C it waits.
    signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        pool.submit(int)
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
    except KeyboardInterrupt:
        pool.shutdown()
        raise
    return pool


def _attend() -> None:
    """In a worker: Ctrl-C is not for it, and it ends with the process that started it."""
    import os
    import signal
    from multiprocessing import parent_process
    from threading import Thread

    def end() -> None:
        if parent is not None:
            parent.join()
            os._exit(1)

    parent = parent_process()
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    Thread(target=end, daemon=True).start()


def _dask(address: str) -> Workers:
    try:
        from distributed import Client, KilledWorker
    except ImportError as error:
        raise InputError("--dask: needs Dask; install it with: pip install -e '.[dask]'") from error

    # It writes pages about each lost connection; one line is written here.
    for name in (*logging.root.manager.loggerDict,):
        if name.partition(".")[0] in ("distributed", "tornado", "asyncio"):
            logging.getLogger(name).setLevel(logging.CRITICAL + 1)
    answered = False

    def make() -> Executor:
        nonlocal answered
        try:
            client = Client(address, timeout=10)
        except (OSError, ValueError) as error:
            advice = (
                "the log has what was proved, so start it and run this again"
                if answered
                else "write tcp://HOST:PORT"
            )
            raise InputError(f"--dask: no scheduler answers at {address!r}; {advice}") from error
        answered = True
        return DaskExecutor(client)

    return Workers(make, AHEAD * MAX_JOBS, (KilledWorker,), (RuntimeError,))
