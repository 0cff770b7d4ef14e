"""Curves and patches from points, curves and formulas (lecture rows S1, S3, S5, S7, S8, S20, S21)."""

from ._splinecore import build as _build

blend = _build.blend
blend_patches = _build.blend_patches
c2_pair = _build.c2_pair
catmull_clark = _build.catmull_clark
catmull_rom = _build.catmull_rom
chain_from_polygon = _build.chain_from_polygon
chamfered = _build.chamfered
cone = _build.cone
contour = _build.contour
coons = _build.coons
curve_from_formulas = _build.curve_from_formulas
curve_on_patch = _build.curve_on_patch
cylinder = _build.cylinder
disc = _build.disc
extend_patch = _build.extend_patch
extrude = _build.extrude
fill = _build.fill
fill_rim = _build.fill_rim
fillet_chain = _build.fillet_chain
fillet_patches = _build.fillet_patches
filleted = _build.filleted
fillets = _build.fillets
helix = _build.helix
join_beziers = _build.join_beziers
join_curves = _build.join_curves
join_patches = _build.join_patches
joint_equations = _build.joint_equations
joint_points = _build.joint_points
kochanek_bartels = _build.kochanek_bartels
lagrange_evaluate = _build.lagrange_evaluate
least_motion = _build.least_motion
cap = _build.cap
corner_counts = _build.corner_counts
loft = _build.loft
match_patch = _build.match_patch
network = _build.network
open_ends = _build.open_ends
offset_patch = _build.offset_patch
osculating_polynomial = _build.osculating_polynomial
patch_from_formulas = _build.patch_from_formulas
pipe = _build.pipe
plane = _build.plane
polygon_of_chain = _build.polygon_of_chain
polynomial_through = _build.polynomial_through
rail_frames = _build.rail_frames
revolve = _build.revolve
ruled = _build.ruled
sphere = _build.sphere
sweep = _build.sweep
sweep_two_rails = _build.sweep_two_rails
thicken = _build.thicken
torus = _build.torus
touching_circle = _build.touching_circle
two_rail_frames = _build.two_rail_frames

__all__ = [
    "blend",
    "blend_patches",
    "c2_pair",
    "cap",
    "catmull_clark",
    "catmull_rom",
    "chain_from_polygon",
    "chamfered",
    "cone",
    "contour",
    "coons",
    "corner_counts",
    "curve_from_formulas",
    "curve_on_patch",
    "cylinder",
    "disc",
    "extend_patch",
    "extrude",
    "fill",
    "fill_rim",
    "fillet_chain",
    "fillet_patches",
    "filleted",
    "fillets",
    "helix",
    "join_beziers",
    "join_curves",
    "join_patches",
    "joint_equations",
    "joint_points",
    "kochanek_bartels",
    "lagrange_evaluate",
    "least_motion",
    "loft",
    "match_patch",
    "network",
    "offset_patch",
    "open_ends",
    "osculating_polynomial",
    "patch_from_formulas",
    "pipe",
    "plane",
    "polygon_of_chain",
    "polynomial_through",
    "rail_frames",
    "revolve",
    "ruled",
    "sphere",
    "sweep",
    "sweep_two_rails",
    "thicken",
    "torus",
    "touching_circle",
    "two_rail_frames",
]
