"""Which verbs can do nothing with a definition, whatever their settings: buttons that would be refused are gray."""

from ..shape import describe
from .creases import creases_of


def refused(definition):
    """Names of operators that have nothing to do."""
    pieces = definition.pieces
    kinds, is_one = {piece.kind for piece in pieces}, len(pieces) == 1
    has_knots = any(_inner_knots(piece) for piece in pieces)
    types = {describe.knot_type(*axis) for piece in pieces if piece.kind == 'nurbs'
             for axis in zip(piece.knots, piece.degree, piece.periodic)}
    no_work = {
        'remove_knot': not has_knots, 'remove_knots': not has_knots,
        'lower_degree': all(max(describe.degrees(piece)) < 2 for piece in pieces),
        'fair': all(max(describe.degrees(piece)) < 2 for piece in pieces),
        'clamp': types <= {'clamped'}, 'make_periodic': types == {'periodic'} and kinds == {'nurbs'},
        'unclamp': types == {'unclamped'} and kinds == {'nurbs'},
        'to_nurbs': kinds == {'nurbs'}, 'to_hermite': kinds == {'hermite'} or describe.is_rational(definition),
        'to_bezier': kinds == {'bezier'},
        'join_pieces': is_one, 'join_ends': is_one, 'join_patches': is_one,
        'standard_form': definition.has_curves and all(_has_unit_ends(definition.pool, piece) for piece in pieces)}
    names = {name for name, is_so in no_work.items() if is_so}
    if definition.has_curves:
        return frozenset(names - {'to_hermite'})            # of conics, within a tolerance
    has_edges = not is_one or bool(creases_of(definition)[0])
    return frozenset(names if has_edges else names | {'add_rounded_edge'})


def _inner_knots(piece):
    """Whether knots could be taken away: a Hermite piece has its parameters."""
    if piece.kind == 'hermite':
        return any(len(knots) > 2 for knots in piece.knots)
    for knots, degree, periodic in zip(piece.knots, piece.degree, piece.periodic):
        domain = (knots[0], knots[-1]) if periodic else (knots[degree], knots[-degree - 1])
        if periodic or ((knots > domain[0]) & (knots < domain[1])).any():
            return True
    return False


def _has_unit_ends(pool, piece):
    return piece.kind == 'hermite' or not any(piece.periodic) and bool((pool[piece.indices[[0, -1]], 3] == 1.0).all())
