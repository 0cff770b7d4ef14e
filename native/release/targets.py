"""What a release is made for: systems by the names Blender gives them, and the Pythons of its official builds."""

from dataclasses import dataclass

PYTHONS = ("3.11", "3.13")


@dataclass(frozen=True)
class Target:
    """A system, as Zig, CMake, Python's file names and Blender's manifest call it."""

    platform: str        # of Blender's manifest
    triple: str          # of Zig, with the oldest version that is served
    system: str          # of CMake
    suffix: str          # of a compiled module, after "cp311" or "311"
    wheel: str           # the tag of wheels
    runner: tuple = ()   # what runs its programs on this machine

    def module(self, python):
        """The file name of the compiled module for a Python, as "3.11"."""
        return "_splinecore" + self.suffix.format(python.replace(".", ""))


TARGETS = {
    target.platform: target
    for target in (
        Target("linux-x64", "x86_64-linux-gnu.2.28", "Linux", ".cpython-{}-x86_64-linux-gnu.so",
               "manylinux_2_28_x86_64", ("env",)),
        Target("linux-arm64", "aarch64-linux-gnu.2.28", "Linux", ".cpython-{}-aarch64-linux-gnu.so",
               "manylinux_2_28_aarch64", ("qemu-aarch64-static", "-L", "/usr/aarch64-linux-gnu")),
        Target("windows-x64", "x86_64-windows-gnu", "Windows", ".cp{}-win_amd64.pyd", "win_amd64", ("wine",)),
        Target("macos-arm64", "aarch64-macos.11.0", "Darwin", ".cpython-{}-darwin.so", "macosx_11_0_arm64"),
        Target("macos-x64", "x86_64-macos.11.0", "Darwin", ".cpython-{}-darwin.so", "macosx_11_0_x86_64"),
    )
}
