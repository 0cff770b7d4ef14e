"""Tessellates many patches on several processes with Dask: the same bits as one process, whatever happens to a worker.

    python3 examples/dask_tessellate.py                    100,000 patches on two workers, compared with one process
    python3 examples/dask_tessellate.py --kill             the same, and a worker is killed on the way
    python3 examples/dask_tessellate.py --scaling          how much faster two workers are than one

Values of splinecore cross processes as they are: tasks get patches and give meshes or, as here, what is left to say of
them. On machines of your own start `dask scheduler` and `dask worker`, and give --scheduler tcp://HOST:8786.
"""

import argparse
import hashlib
import os
import signal
import sys
import time

import numpy as np
from distributed import Client, LocalCluster, as_completed

import splinecore as sc

DEGREE = 3
COUNT = 6          # control points along u and v
RESOLUTION = 4


def patches_of(chunk, size):
    """The patches of a chunk, the same whoever makes them: waves on a rational bicubic net."""
    random = np.random.default_rng(chunk)
    places = np.stack(np.meshgrid(np.arange(COUNT), np.arange(COUNT), indexing="ij"), axis=-1)
    inner = np.arange(1, COUNT - DEGREE) / (COUNT - DEGREE)
    knots = np.concatenate([np.zeros(DEGREE + 1), inner, np.ones(DEGREE + 1)])
    made = []
    for _ in range(size):
        points = np.concatenate([places, random.uniform(-1, 1, (COUNT, COUNT, 1))], axis=-1)
        made.append(sc.NurbsPatch((DEGREE, DEGREE), (knots, knots), points, random.uniform(0.5, 2, (COUNT, COUNT))))
    return made


def tessellate(patches):
    """A task: how many vertices the meshes of these patches have, and the digest of all their bits."""
    digest, vertices = hashlib.sha256(), 0
    for patch in patches:
        patch_set = sc.PatchSet.from_patches([patch])
        mesh = sc.Tessellation(patch_set, RESOLUTION)
        for array in (*mesh.evaluate(patch_set), mesh.corner_vertices):
            digest.update(array.tobytes())
        vertices += mesh.vertex_count
    return vertices, digest.hexdigest()


def chunks_of(args):
    """The sizes of chunks."""
    whole, rest = divmod(args.patches, args.chunk)
    return [args.chunk] * whole + [rest] * (rest > 0)


def alone(args):
    """The results of all chunks in this process."""
    return [tessellate(patches_of(number, size)) for number, size in enumerate(chunks_of(args))]


def together(client, args, kill=False):
    """The same by the workers of a client; progress on the error output."""
    sizes = chunks_of(args)
    found = [None] * len(sizes)
    numbers = {client.submit(tessellate, patches_of(number, size), pure=False): number for number, size in enumerate(sizes)}
    for done, future in enumerate(as_completed(numbers), 1):
        found[numbers[future]] = future.result()
        print(f"\r{done} of {len(sizes)} chunks", end="", file=sys.stderr, flush=True)
        if kill and done == len(sizes) // 4:
            kill_one(client)
    print(file=sys.stderr)
    return found


def kill_one(client):
    """End a worker's process without a word."""
    process = next(iter(client.run(os.getpid).values()))
    print(f"\nkilling the worker in process {process}", file=sys.stderr)
    os.kill(process, signal.SIGKILL)


def cluster(workers):
    """Processes on this machine, one thread each."""
    return LocalCluster(n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None)


def timed(call):
    """What a call gives, and its seconds."""
    began = time.perf_counter()
    return call(), time.perf_counter() - began


def scaling(args):
    """Seconds of one worker and of more, printed."""
    seconds = {}
    for workers in (1, args.workers):
        with cluster(workers) as machines, Client(machines) as client:
            _, seconds[workers] = timed(lambda: together(client, args))
        print(f"{args.patches} patches, {workers} {'worker' if workers == 1 else 'workers'}: {seconds[workers]:.2f} s, "
              f"{seconds[1] / seconds[workers]:.2f}x")


def compared(args):
    """Whether workers give the bits of one process, said."""
    if args.scheduler:
        with Client(args.scheduler) as client:
            found, seconds = timed(lambda: together(client, args, args.kill))
    else:
        with cluster(args.workers) as machines, Client(machines) as client:
            found, seconds = timed(lambda: together(client, args, args.kill))
    expected, by_one = timed(lambda: alone(args))
    vertices = sum(count for count, _ in found)
    print(f"{args.patches} patches, {vertices} vertices: {seconds:.1f} s on workers, {by_one:.1f} s in one process")
    same = found == expected
    print("the same bits" if same else "DIFFERENT bits")
    return 0 if same else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--patches", type=int, default=100_000)
    parser.add_argument("--chunk", type=int, default=1000, help="patches of a task")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--scheduler", help="the address of a scheduler that runs already")
    parser.add_argument("--kill", action="store_true", help="end a worker on the way")
    parser.add_argument("--scaling", action="store_true", help="only measure one worker and more")
    args = parser.parse_args()
    if min(args.patches, args.chunk, args.workers) < 1:
        parser.error("patches, chunk and workers are 1 or more")
    if args.scaling:
        scaling(args)
        return 0
    return compared(args)


if __name__ == "__main__":
    sys.exit(main())
