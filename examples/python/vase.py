"""A vase by five circles: lofted, closed by a bottom, measured, and written as a mesh.

    python vase.py vase.stl
"""

import sys

import splinecore as sc

PROFILE = ((0.0, 3.0), (3.0, 5.0), (7.0, 4.0), (10.0, 2.0), (12.0, 3.0))      # height and radius in centimeters


def vase() -> sc.NurbsPatch:
    surface, _ = sc.build.loft([sc.conics.circle((0.0, 0.0, height), radius) for height, radius in PROFILE])
    return surface


def closed(surface: sc.NurbsPatch) -> sc.PatchSet:
    """The surface with flat caps at both ends, normals outwards."""
    patches, error = sc.build.cap([surface])
    print(f"{len(patches)} patches, rims are plane within {error:.1e} cm")
    return sc.PatchSet.from_patches(patches)


def main() -> None:
    body = closed(vase())
    print(f"{body.volume(tolerance=1e-9):.2f} cm³, {body.area(tolerance=1e-9):.2f} cm² with both caps")
    if len(sys.argv) > 1:
        sc.meshes.save(sys.argv[1], body, tolerance=0.01)


if __name__ == "__main__":
    main()
