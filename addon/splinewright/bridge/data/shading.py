"""How a patch or a spline looks beside its geometry."""

from typing import NamedTuple


class Look(NamedTuple):
    """Material and shading, of all faces of a patch or of one spline."""

    material_index: int = 0
    use_smooth: bool = True
