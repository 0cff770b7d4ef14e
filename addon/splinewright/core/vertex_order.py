"""In which order chosen vertices follow one another."""

from .failures import Refusal


def in_order(vertices, edges, history):
    """[(vertices in order, whether they close)]: the chains and loops that edges make of vertices; of vertices that they
    do not connect so, one chain in the order in which they were chosen.

    vertices: indices; edges: pairs of them; history: indices as they were chosen, which may be few of them or none.
    Raises Refusal where neither tells an order.
    """
    neighbours = {vertex: [] for vertex in vertices}
    for first, second in edges:
        neighbours[first].append(second)
        neighbours[second].append(first)
    if all(1 <= len(of_one) <= 2 for of_one in neighbours.values()):
        return _connected(neighbours)
    if neighbours.keys() <= set(history):
        return [([vertex for vertex in dict.fromkeys(history) if vertex in neighbours], False)]
    raise Refusal("the order of the vertices is not known: select them one after another, or along edges")


def _connected(neighbours):
    waiting = dict.fromkeys(sorted(neighbours, key=lambda vertex: (len(neighbours[vertex]), vertex)))   # ends come first
    found = []
    while waiting:
        vertex = next(iter(waiting))
        chain, closed = [], len(neighbours[vertex]) == 2
        while vertex is not None:
            chain.append(vertex)
            del waiting[vertex]
            vertex = next((other for other in neighbours[vertex] if other in waiting), None)
        found.append((chain, closed))
    return found
