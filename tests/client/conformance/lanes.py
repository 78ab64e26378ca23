"""Labs side by side, because most of what a check does is waiting."""

from __future__ import annotations

import queue
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor

from lab import Lab

Job = Callable[[Lab], None]


class Lanes:
    """Lanes with a lab each. There is one lane without namespaces, because all labs would share the loopback interface."""

    def __init__(self, make: Callable[[], Lab], count: int) -> None:
        self.labs: list[Lab] = []
        try:
            while len(self.labs) < count and (not self.labs or self.labs[0].has_namespaces):
                self.labs.append(make())
                self.labs[-1].start_daemons()
        except BaseException:
            self.close()
            raise

    def run(self, jobs: Sequence[Job]) -> None:
        """Runs all jobs, which begin in this order."""
        free: queue.SimpleQueue[Lab] = queue.SimpleQueue()
        for lab in self.labs:
            free.put(lab)

        def work(job: Job) -> None:
            lab = free.get()
            try:
                job(lab)
            finally:
                free.put(lab)

        with ThreadPoolExecutor(len(self.labs)) as pool:
            for done in [pool.submit(work, job) for job in jobs]:
                done.result()

    def close(self) -> None:
        """Ends all labs."""
        for lab in self.labs:
            lab.close()
