"""Makes every public call at a degree, a size and a weight, in a process of its own: a crash is its end.

    python every_call.py DEGREE SIZE WEIGHT SPACING SECONDS [CALL …]

prints a line of JSON for each call: its name, what came of it, and what it cost. SPACING is that of knots. A call
that takes more SECONDS of the processor is stopped as Ctrl-C stops it: `late` is how many seconds it took no notice.
"""

import json
import signal
import sys
import time

import numpy as np

import finite
import public_calls
import splinecore as sc


class Stop(BaseException):
    pass


def stop(*_):
    raise Stop


def outcome(call):
    """(what came of it, its text)."""
    try:
        result = call()
    except sc.Error as error:
        return "refused", f"{type(error).__name__}: {error}"
    except Exception as error:
        return "failed", f"{type(error).__name__}: {error}"
    return " ".join(word for word, is_bad in (("nan", np.isnan), ("inf", np.isinf))
                    if not finite.is_free_of(result, is_bad)) or "finite", ""


def timed(call, seconds):
    start = time.process_time()
    try:
        signal.setitimer(signal.ITIMER_PROF, seconds)
        try:
            what, text = outcome(call)
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0)
        return {"what": what, "text": text, "seconds": time.process_time() - start}
    except Stop:
        return {"what": "stopped", "late": time.process_time() - start - seconds}


def main(degree, size, weight, spacing, seconds, *wanted):
    signal.signal(signal.SIGPROF, stop)
    at = public_calls.surroundings(int(degree), float(size), float(weight), float(spacing))
    for name, call in public_calls.all_calls(at):
        if wanted and name not in wanted:
            continue
        print(json.dumps({"name": name}), flush=True)
        print(json.dumps({"name": name, **timed(call, float(seconds))}), flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
