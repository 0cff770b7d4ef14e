"""The edges that Blender makes of the sides of faces."""

_SELECTION = '.select_edge'


def calculate(mesh):
    """Make the edges of a mesh that was given faces."""
    mesh.update(calc_edges=True)
    mend(mesh)


def mend(mesh):
    """Drop the selection of calculated edges where it has the wrong type, as in 5.0.0 and 5.0.1: whoever
    selects or deselects such an edge, crashes. Without it no edge is selected."""
    selection = mesh.attributes.get(_SELECTION)
    if selection is not None and selection.data_type != 'BOOLEAN':
        mesh.attributes.remove(selection)
