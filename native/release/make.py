"""Builds the library for every system from this machine, checks what came out and packs it; `./run release` calls it.

    make.py BUILD CACHE [PLATFORM...]       the modules, wheels and results of these systems, or of all
    make.py BUILD CACHE PLATFORM --modules  the modules alone
    make.py BUILD CACHE PLATFORM --syntax   only whether the compiler takes every file
"""

import argparse
import json
import os
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import check_module
import packages
import wheels
from targets import PYTHONS, TARGETS
from tools import HERE, PROJECT, Tools, run

#: Results are compared for the instructions that add up in one order on all systems; ARM has no others.
ONE_SET = ("env", "SPLINECORE_KERNELS=x86-64-v3")


class Release:
    """One run: where it builds, and its tools."""

    def __init__(self, build, cache):
        self.build, self.cache = build / "release", cache
        self.tools = Tools(cache)
        self.dist = self.build / "dist"
        self.dist.mkdir(parents=True, exist_ok=True)

    def configure(self, source, folder, target, *definitions):
        """CMake for a target, quietly."""
        run("/usr/bin/cmake", "-S", source, "-B", folder, "-G", "Ninja",
            f"-DCMAKE_TOOLCHAIN_FILE={HERE / 'toolchain.cmake'}", "-DCMAKE_BUILD_TYPE=Release",
            f"-DRELEASE_TOOLS={self.tools.commands}", f"-DRELEASE_HEADERS={self.tools.headers}",
            f"-DRELEASE_TRIPLE={target.triple}", f"-DRELEASE_SYSTEM={target.system}",
            "-DCMAKE_CXX_COMPILER_LAUNCHER=ccache", "--log-level=WARNING", *definitions)

    def configured_module(self, target, python):
        """The folder in which the module can be built."""
        folder = self.build / f"{target.platform}-{python}"
        library = [f"-DPython_LIBRARY={self.tools.library(python)}"] if target.system == "Windows" else []
        self.configure(PROJECT / "native", folder, target, f"-DPython_INCLUDE_DIR={self.tools.include(python)}",
                       f"-DPYTHON_MODULE_EXTENSION={target.suffix.format(python.replace('.', ''))}",
                       "-DPYBIND11_USE_CROSSCOMPILING=ON", "-DPYTHON_IS_DEBUG=OFF", "-DPYTHON_MODULE_DEBUG_POSTFIX=",
                       "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", *library)
        return folder

    def syntax(self, target, python):
        """How many files the compiler takes. @raises CalledProcessError after it has said why it does not take one."""
        folder = self.configured_module(target, python)
        commands = [entry["command"] for entry in json.loads((folder / "compile_commands.json").read_text())]
        with ThreadPoolExecutor(os.cpu_count()) as workers:
            for _ in workers.map(lambda command: run("sh", "-c", f"{command} -O0 -fno-sanitize=undefined -w", cwd=folder), commands):
                pass
        return len(commands)

    def module(self, target, python):
        """The compiled module, built."""
        folder = self.configured_module(target, python)
        run("/usr/bin/cmake", "--build", folder, "--target", "_splinecore")
        return self.module_file(target, python)

    def module_file(self, target, python):
        """Where the compiled module lies once it is built."""
        return self.build / f"{target.platform}-{python}/bindings" / target.module(python)

    def test(self, target):
        """The GoogleTests and the results of a system whose programs can be run here."""
        folder = self.build / f"{target.platform}-tests"
        self.configure(PROJECT, folder, target, "-DSPLINECORE_PYTHON=OFF", f"-DPython_EXECUTABLE={sys.executable}")
        programs = ("splinecore_inside_tests", "splinecore_tests", "splinecore_results")
        run("/usr/bin/cmake", "--build", folder, "--target", *programs)
        suffix = ".exe" if target.system == "Windows" else ""
        for program in programs[:2]:
            heading(f"{program} for {target.platform}, by {target.runner[0]}")
            run(*target.runner, folder / f"tests/native/{program}{suffix}", "--gtest_brief=1")
        results = self.build / f"results-{target.platform}.txt"
        with results.open("w") as out:
            run(*ONE_SET, *target.runner, folder / f"tests/native/splinecore_results{suffix}", stdout=out)
        return results


def heading(text):
    print(f"\n== {text}", flush=True)


def native_results(build):
    """[the results of this machine's own compiler], where `./run build` has built what prints them."""
    program, results = build.resolve() / "tests/native/splinecore_results", build.resolve() / "release/results-native.txt"
    if not program.exists():
        return []
    results.parent.mkdir(exist_ok=True)
    with results.open("w") as out:
        run(*ONE_SET, program, stdout=out)
    return [results]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path)
    parser.add_argument("cache", type=Path)
    parser.add_argument("platforms", nargs="*", metavar="PLATFORM", help=", ".join(TARGETS))
    parser.add_argument("--modules", action="store_true", help="build and check the modules, no tests")
    parser.add_argument("--syntax", action="store_true", help="compile without making anything")
    args = parser.parse_args()
    unknown = [name for name in args.platforms if name not in TARGETS]
    if unknown:
        parser.error(f"{unknown[0]} is not one of {', '.join(TARGETS)}")
    release = Release(args.build.resolve(), args.cache.resolve())
    chosen = [TARGETS[name] for name in args.platforms or TARGETS]
    if args.syntax:
        for target in chosen:
            heading(f"Zig's compiler for {target.platform}")
            print(f"It takes all {release.syntax(target, PYTHONS[-1])} files")
        return
    results = native_results(args.build)
    for target in chosen:
        for python in PYTHONS:
            heading(f"{target.platform}, Python {python}")
            began = time.monotonic()
            module = release.module(target, python)
            print(f"{module.name}: {check_module.check(release.tools, target, python, module)}; "
                  f"{time.monotonic() - began:.0f} s", flush=True)
            print(wheels.write(release.tools, target, python, module, release.dist).name)
        if target.runner and not args.modules:
            results.append(release.test(target))
    if results:
        heading("The same bits")
        run(sys.executable, HERE / "compare.py", *results)
    heading("Packages")
    packages.pack(release)
    if any(target.platform == "linux-x64" for target in chosen):
        run(HERE / "in_blender.sh", release.dist, args.build, args.cache)


if __name__ == "__main__":
    main()
