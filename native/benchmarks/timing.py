"""What the programs in Python have in common: they time calls, and keep what these give."""

import json
import statistics
import time
from pathlib import Path

import numpy as np

import workloads

SECONDS = 0.4
FEWEST, MOST = 3, 200
#: Shorter calls are timed several together, for to read the clock takes time, too.
SHORTEST = 5e-4


class Run:
    def __init__(self, who, data, kept, workload):
        self.who, self.data, self.kept, self.workload = who, Path(data), Path(kept), workload

    def input(self, name, *shape):
        return np.fromfile(self.data / f"{name}.f64").reshape(shape or (-1,))

    def time(self, call, items, work, note="", clock=time.process_time):
        def several(count):
            start = clock()
            for _ in range(count - 1):
                work()
            result = work()
            spent = clock() - start
            del result
            return spent / count

        several(1)
        together = max(1, round(SHORTEST / max(several(1), 1e-7)))
        times = []
        while len(times) < FEWEST or (len(times) < MOST and together * sum(times) < SECONDS):
            times.append(several(together))
        print(json.dumps({"workload": self.workload, "who": self.who, "call": call,
                          "seconds": statistics.median(times), "items": items, "note": note}))

    def keep(self, call, rows, step=workloads.SAMPLE_STEP):
        rows = np.asarray(rows, float)[::step]
        rows.tofile(self.kept / f"{self.workload}.{self.who}.{call}.f64")
