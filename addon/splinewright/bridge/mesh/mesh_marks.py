"""What users put on the edges of a mesh, carried over to other faces of the same patches.

An edge of the new faces takes what lay on the line that it lies on, in the parameters of a patch: borders and lines along
u or v that both meshes have. What no edge lies on is remembered for faces that have one, so that a slider that goes
through all resolutions takes nothing away.
"""

from typing import NamedTuple

import numpy as np

from . import mesh_layers, mesh_lines
from .mesh_layers import Layer
from .mesh_lines import Lines

#: On the Mesh: what lies on lines, whether or not edges show it.
KEY = "splinewright_marks"
_CERTAIN = "certain"


class Marks(NamedTuple):
    """A Layer of edges, not of its edges but of the lines that they lie on."""

    layer: Layer                        # of which the values are left out
    lines: Lines
    values: np.ndarray                  # (lines, width)

    def on(self, sides):
        """(edges, width): what a mesh with these mesh_lines.Sides has of it."""
        nothing = self.values.dtype.type() if self.values.dtype != object else _blank(self.values)
        found = np.full((sides.edge_count, self.values.shape[1]), nothing, self.values.dtype)
        under = mesh_lines.under(sides.lines, self.lines)
        is_on = under >= 0
        found[sides.edges[is_on]] = self.values[under[is_on]]
        return found


def _blank(texts):
    return type(texts[0, 0])() if len(texts) else ""


def keep(mesh, corners, layers):
    """The Marks of each Layer of the edges of a mesh whose corners have these parameters, and of those remembered."""
    known = _remembered(mesh)
    if not layers and not known:
        return []
    sides = mesh_lines.sides_of(mesh, corners)
    if _is_certain(mesh):
        names = {_name(marks.layer) for marks in known}
        return known + [_of_edges(layer, sides, None) for layer in layers if _name(layer) not in names]
    by_name = {_name(marks.layer): marks for marks in known}
    found = [_of_edges(layer, sides, by_name.pop(_name(layer), None)) for layer in layers]
    return found + [_of_edges(_all_cleared(marks, sides), sides, marks) for marks in by_name.values()
                    if mesh_layers.is_dropped_where_empty(marks.layer)]


def _all_cleared(marks, sides):
    values = np.zeros((sides.edge_count, marks.values.shape[1]), marks.values.dtype)
    return marks.layer._replace(values=values)


def _of_edges(layer, sides, known):
    """The Marks of a Layer: the known ones where the edges have just those, else what they have."""
    values, nothing = layer.values, np.zeros((0, layer.values.shape[1]), layer.values.dtype)
    if known is not None and np.array_equal(known.on(sides), values):
        return known
    is_marked = values.astype(bool).any(axis=1)[sides.edges]
    marks = Marks(layer._replace(values=nothing), sides.lines.of(is_marked), values[sides.edges[is_marked]])
    if known is None or not is_marked.any():
        return marks
    is_hidden = mesh_lines.under(known.lines, sides.lines) < 0
    return marks._replace(lines=mesh_lines.together([marks.lines, known.lines.of(is_hidden)]),
                          values=np.concatenate([marks.values, known.values[is_hidden]]))


def restore(mesh, corners, all_marks):
    """Put Marks on the edges that the mesh has now."""
    if not all_marks:
        return
    sides = mesh_lines.sides_of(mesh, corners)
    for marks in all_marks:
        mesh_layers.write(mesh, marks.layer, marks.on(sides))
    remember(mesh, all_marks)


def moved(all_marks, parents, places):
    """The Marks on patches that came of others, as mesh_attributes.moved() says it."""
    found = []
    for marks in all_marks:
        lines, of = mesh_lines.moved(marks.lines, parents, places)
        found.append(marks._replace(lines=lines, values=marks.values[of]))
    return found


def together(here, others, first):
    """The Marks of a mesh and those of another, whose patches are those from number `first` on."""
    by_name = {_name(marks.layer): marks for marks in here}
    for marks in others:
        rows = marks.lines.rows + np.array([first, 0, 0, 0, 0])
        name, lines, values = _name(marks.layer), Lines(rows), marks.values
        if name in by_name:
            lines = mesh_lines.together([by_name[name].lines, lines])
            values = np.concatenate([by_name[name].values, values])
        by_name[name] = marks._replace(lines=lines, values=values)
    return list(by_name.values())


def _name(layer):
    return layer.name, layer.data_type


def remember(mesh, all_marks, is_certain=False):
    """Note Marks on the mesh. is_certain: whatever its edges have, until they are others."""
    groups = {str(i): {'name': marks.layer.name, 'type': marks.layer.data_type, 'kind': marks.values.dtype.str,
                       'numbers': marks.values.shape[1], 'lines': marks.lines.rows.ravel(),
                       'values': marks.values.astype(np.float64).ravel()}
              for i, marks in enumerate(all_marks) if marks.values.dtype != object and len(marks.values)}
    forget(mesh)
    if groups:
        mesh[KEY] = {**groups, _CERTAIN: is_certain}


def forget(mesh):
    if KEY in mesh.keys():
        del mesh[KEY]


def be_uncertain(mesh):
    """From now on what the edges have counts again."""
    if _is_certain(mesh):
        mesh[KEY][_CERTAIN] = False


def _is_certain(mesh):
    group = mesh.get(KEY)
    return hasattr(group, 'get') and bool(group.get(_CERTAIN))


def _remembered(mesh):
    """The Marks that remember() noted; those that are damaged are passed over."""
    group = mesh.get(KEY)
    if not hasattr(group, 'values'):
        return []
    found = []
    for entry in group.values():
        try:
            values = np.array(entry['values'], np.float64).reshape(-1, entry['numbers']).astype(np.dtype(entry['kind']))
            lines = Lines(np.array(entry['lines'], np.float64).reshape(-1, 5))
            layer = Layer(str(entry['name']), str(entry['type']), 'EDGE', values[:0])
            if len(values) == len(lines.rows) > 0 and mesh_layers.is_possible(layer):
                found.append(Marks(layer, lines, values))
        except (KeyError, TypeError, ValueError, IndexError, AttributeError):
            continue
    return found
