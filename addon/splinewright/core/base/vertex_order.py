"""In which order chosen vertices follow one another."""

from .failures import Refusal


def in_order(vertices, edges, history):
    """[(vertices in order, whether they close)]: the chains and loops that edges make of vertices; of vertices that they
    do not connect so, one chain in the order in which they were chosen.

    vertices: indices; edges: pairs of them; history: indices as they were chosen, which may be few of them or none.
    Raises Refusal where neither tells an order.
    """
    neighbors = {vertex: [] for vertex in vertices}
    for first, second in edges:
        neighbors[first].append(second)
        neighbors[second].append(first)
    if all(1 <= len(of_one) <= 2 for of_one in neighbors.values()):
        return _connected(neighbors)
    if neighbors.keys() <= set(history):
        return [([vertex for vertex in dict.fromkeys(history) if vertex in neighbors], False)]
    raise Refusal("the order of the vertices is not known: select them one after another, or along edges")


def _connected(neighbors):
    waiting = dict.fromkeys(sorted(neighbors, key=lambda vertex: (len(neighbors[vertex]), vertex)))   # ends come first
    found = []
    while waiting:
        vertex = next(iter(waiting))
        chain, closed = [], len(neighbors[vertex]) == 2
        while vertex is not None:
            chain.append(vertex)
            del waiting[vertex]
            vertex = next((other for other in neighbors[vertex] if other in waiting), None)
        found.append((chain, closed))
    return found
