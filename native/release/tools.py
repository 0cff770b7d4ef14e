"""The tools of a release, kept in a folder: Zig and others from PyPI, headers of Debian's packages, Python's names."""

import shutil
import stat
import subprocess
import sys
from pathlib import Path

import import_library
from targets import PYTHONS

HERE = Path(__file__).parent
PROJECT = HERE.parents[1]
# The release of Debian whose packages have the headers.
PACKAGES = {
    "bookworm": ("libpython3.11-dev",),
    "trixie": ("libpython3.13-dev", "pybind11-dev", "libglm-dev", "libeigen3-dev", "nlohmann-json3-dev"),
}
# Programs that CMake takes for a compiler and its tools. Zig writes the names of processors with underscores.
COMMANDS = {
    "zig-clang++": """for word; do
  shift
  case $word in -march=*) word=-march=$(echo "${word#*=}" | tr - _) ;; esac
  set -- "$@" "$word"
done
exec ZIG c++ "$@\"""",
    "zig-ar": 'exec ZIG ar "$@"',
    "zig-ranlib": 'exec ZIG ranlib "$@"',
}


def run(*command, **options):
    """@raises CalledProcessError after the command has said why."""
    return subprocess.run([str(word) for word in command], check=True, **options)


def complete(folder, wanted, make):
    """Make what the folder lacks, once for what is wanted of it."""
    mark = folder / ".complete"
    if mark.exists() and mark.read_text() == wanted:
        return folder
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    make(folder)
    mark.write_text(wanted)
    return folder


class Tools:
    """Paths of the tools below one folder."""

    def __init__(self, cache):
        self.folder = cache / "release"
        requirements = (HERE / "requirements.txt").read_text()
        self.environment = complete(self.folder / "environment", requirements, self._make_environment)
        self.python = self.environment / "bin/python"
        self.commands = complete(self.folder / "commands", f"{COMMANDS}", self._make_commands)
        self.headers = complete(self.folder / "headers", f"{PACKAGES}", self._make_headers)
        for python in PYTHONS:
            shutil.copy(HERE / "pyconfig.h", self.include(python))
        self.libraries = complete(self.folder / "libraries", f"{PYTHONS}", self._make_libraries)

    @property
    def zig(self):
        return next(self.environment.glob("lib/python*/site-packages/ziglang/zig"))

    def include(self, python):
        """The folder of a Python's public headers."""
        return self.headers / f"usr/include/python{python}"

    def library(self, python):
        """What modules for Windows link of a Python."""
        return self.libraries / f"python{python.replace('.', '')}.lib"

    def _make_environment(self, folder):
        print("Installing", *[line for line in (HERE / "requirements.txt").read_text().split() if "==" in line])
        run(sys.executable, "-m", "venv", folder)
        run(folder / "bin/pip", "install", "-q", "--disable-pip-version-check", "-r", HERE / "requirements.txt")

    def _make_commands(self, folder):
        for name, text in COMMANDS.items():
            path = folder / name
            path.write_text("#!/bin/sh\n" + text.replace("ZIG", str(self.zig)) + "\n")
            path.chmod(path.stat().st_mode | stat.S_IXUSR)

    def _make_headers(self, folder):
        print("Unpacking headers of Debian", ", ".join(PACKAGES))
        lists = folder / "lists"
        (lists / "partial").mkdir(parents=True)
        sources = folder / "sources.list"
        mirror = run(PROJECT / "tests/matrix/root.sh", "mirror", capture_output=True, text=True).stdout.strip()
        key = "signed-by=/usr/share/keyrings/debian-archive-keyring.gpg"
        sources.write_text("".join(f"deb [{key}] {mirror} {suite} main\n" for suite in PACKAGES))
        options = [f"-oDir::Etc::sourcelist={sources}", "-oDir::Etc::sourceparts=-", f"-oDir::State::lists={lists}",
                   "-oAPT::Sandbox::User=root", f"-oDir::Cache={folder / 'cache'}"]
        (folder / "cache/archives/partial").mkdir(parents=True)
        run("apt-get", "-qq", *options, "update")
        wanted = [f"{package}/{suite}" for suite, packages in PACKAGES.items() for package in packages]
        run("apt-get", "-qq", *options, "download", *wanted, cwd=folder)
        for archive in folder.glob("*.deb"):
            run("dpkg", "-x", archive, folder)
            archive.unlink()

    def _make_libraries(self, folder):
        for python in PYTHONS:
            name = f"python{python.replace('.', '')}"
            definition, library = folder / f"{name}.def", folder / f"{name}.lib"
            definition.write_text(import_library.definition(self.include(python), f"{name}.dll"))
            run(self.zig, "dlltool", "-d", definition, "-D", f"{name}.dll", "-m", "i386:x86-64", "-l", library)
