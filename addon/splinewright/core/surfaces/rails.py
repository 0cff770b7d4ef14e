"""Sections in the frames of the rails that they move along: x along the normal, y along the binormal, z along the rail."""

import numpy as np

from ..base.failures import AboutInputs
from ..base.library import sc
from ..meets import plane_fit
from . import sections

#: Of the size of a rail: what a section may miss it by and still cross it.
_TOUCH = 1e-6
#: A section whose plane is this far from its own x and y lies in another one.
_LEVEL = 0.7


def upright(profiles, spaces):
    """Profiles of which each one's own x and y, as long as they are in the scene, become those of the rail's frame.

    spaces: (4, 4) of each, from local to where it lies. One that is drawn in another local plane is laid into x and y.
    """
    return [_laid_flat(profile.transformed(_back(space))) for profile, space in zip(profiles, spaces)]


def _back(space):
    """(4, 4): to the axes of a space without its scale."""
    x = _unit(space[:3, 0])
    z = _unit(np.cross(x, space[:3, 1]))
    axes = np.stack([x, np.cross(z, x), z])
    back = np.eye(4)
    back[:3, :3] = axes
    back[:3, 3] = -axes @ space[:3, 3]
    return back


def _unit(vector):
    return vector / np.linalg.norm(vector)


def _laid_flat(profile):
    across = np.abs(plane_fit.normal_of([profile]))
    if across[2] >= _LEVEL:
        return profile
    turn = np.eye(4)
    turn[:3, :3] = np.roll(np.eye(3), 1, axis=1) if across[0] > across[1] else [[1, 0, 0], [0, 0, 1], [0, -1, 0]]
    return profile.transformed(turn)


def order_along(rail, profiles):
    """The numbers of profiles, from 0, in the order in which they lie along a rail."""
    return [int(i) for i in np.argsort(_places_on(rail, profiles), kind='stable')]


def _places_on(rail, profiles):
    middles = np.array([sections.samples(profile).mean(axis=0) for profile in profiles])
    return rail.nearest(middles).parameters


def _require_one_place(rail, profiles, first):
    """Raises AboutInputs for a section that crosses a rail at several places: it belongs to none of them. first: the number of the
    first section among the inputs."""
    reach = _TOUCH * sections.size_of([rail])
    for i, profile in enumerate(profiles, first):
        met = rail.intersections(profile, tolerance=reach)
        places = rail.evaluate(np.concatenate([met.parameters[:, 0], met.overlaps[:, 0].ravel()]))
        if len(places) > 1 and np.linalg.norm(places - places[0], axis=1).max() > 2 * reach:
            raise AboutInputs("{} crosses the rail at {places} places: it belongs to one of them alone", i, places=len(places))


def along(rail, profiles, frame):
    """(profiles in the frame of a rail where they lie, the parameters there, their numbers from 0), in the order along it. Raises
    AboutInputs."""
    _require_one_place(rail, profiles, 1)
    at = _places_on(rail, profiles)
    order = np.argsort(at, kind='stable')
    frames = sc.build.rail_frames(rail, at, frame=frame)
    moved = [profiles[i].transformed(_into(frames[i])) for i in order]
    return moved, at[order] if len(order) > 1 else None, order.tolist()


def _into(frame):
    """(4, 4): to where x, y, z and the origin are the columns of a frame."""
    into = np.eye(4)
    into[:3, :3] = frame[:3, :3].T
    into[:3, 3] = -frame[:3, :3].T @ frame[:3, 3]
    return into


def rails_first(curves):
    """The order of curves, as numbers from 0, with the first rail, the second one, and the sections between them along the
    first: the second rail is the curve that leaves sections whose ends lie nearest to both."""
    if len(curves) < 3:
        return list(range(len(curves)))
    others = range(1, len(curves))
    second = min(others, key=lambda j: sum(_gap(curves[0], curves[j], curves[i]) for i in others if i != j))
    between_them = [i for i in others if i != second]
    along_rail = order_along(curves[0], [curves[i] for i in between_them])
    return [0, second, *(between_them[i] for i in along_rail)]


def _gap(first, second, section):
    """How far the ends of a section lie from two rails."""
    ends = sections.ends(section)
    to_first, to_second = first.nearest(ends).distances, second.nearest(ends).distances
    return min(to_first[0] + to_second[1], to_first[1] + to_second[0])


def running_with(first, second):
    """The second rail, turned where that brings its ends nearer to those of the first."""
    a, b = sections.ends(first), sections.ends(second)
    as_it_is = np.linalg.norm(a - b, axis=1).sum()
    return second.reversed() if np.linalg.norm(a - b[::-1], axis=1).sum() < as_it_is else second


def between(first, second, profiles):
    """(profiles in the frame between two rails where they lie, the parameters of the first rail there, their numbers from 0), in the
    order along it. Each is turned so that it starts at the first rail. Raises AboutInputs."""
    for rail in (first, second):
        _require_one_place(rail, profiles, 2)
    profiles = [_from_first(first, second, profile) for profile in profiles]
    at = first.nearest(np.array([sections.ends(profile)[0] for profile in profiles])).parameters
    order = np.argsort(at, kind='stable')
    frames = sc.build.two_rail_frames(first, second, at)
    moved = [profiles[i].transformed(_into(frames[i])) for i in order]
    return moved, at[order] if len(order) > 1 else None, order.tolist()


def _from_first(first, second, profile):
    start, end = sections.ends(profile)
    there = first.nearest(np.array([start, end])).distances
    back = second.nearest(np.array([start, end])).distances
    return profile.reversed() if there[1] + back[0] < there[0] + back[1] else profile
