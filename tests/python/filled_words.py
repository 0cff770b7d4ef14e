"""Which constant words may fill the patterns of messages, read from the add-on's source: through names, choices and calls within a file."""

import ast
import re

#: What fills patterns.
FILLING = {'phrase', 'Refusal', 'WrongKind', 'AboutInputs', 'fail'}
#: A single word of English: one with spaces is looked up where it is shown.
_WORD = re.compile(r"[A-Za-z][a-z]{2,}(-[a-z]+)?")
_DEEPEST = 6


def filled(path):
    """(number of a line, name of an argument, {words}) of every message of a file that words of the source may fill."""
    file = _File(path)
    for call in file.calls:
        if _called(call) not in FILLING:
            continue
        for keyword in call.keywords:
            texts = file.texts(keyword.value, file.scope_of(call)) if keyword.arg not in ('one', None) else ()
            found = {text for text in texts if _WORD.fullmatch(text)}
            if found:
                yield call.lineno, keyword.arg, found


def _called(call):
    return ast.unparse(call.func).rpartition('.')[2]


class _File:
    def __init__(self, path):
        self.tree = ast.parse(path.read_text())
        self.above = {child: node for node in ast.walk(self.tree) for child in ast.iter_child_nodes(node)}
        self.calls = [node for node in ast.walk(self.tree) if isinstance(node, ast.Call)]

    def scope_of(self, node):
        """The function around a node, or the whole file."""
        while node in self.above:
            node = self.above[node]
            if isinstance(node, ast.FunctionDef):
                return node
        return self.tree

    def texts(self, node, scope, known=()):
        """The strings that an expression may be."""
        if isinstance(node, ast.Constant):
            return {node.value} if isinstance(node.value, str) else set()
        if isinstance(node, ast.Name):
            return self._of_name(node.id, scope, known)
        if isinstance(node, ast.Attribute):
            is_own = isinstance(node.value, ast.Name) and node.value.id in ('self', 'cls')
            return self._assigned(node.attr, self.tree, known, (ast.ClassDef,)) if is_own else set()
        if isinstance(node, ast.Call):
            is_get = isinstance(node.func, ast.Attribute) and node.func.attr == 'get'
            return self._of_all([node.func.value, *node.args[1:]] if is_get else node.args if _called(node) == 'join' else (), scope, known)
        return self._of_all(_parts(node), scope, known)

    def _of_all(self, nodes, scope, known):
        return set().union(*(self.texts(node, scope, known) for node in nodes))

    def _of_name(self, name, scope, known):
        if (name, scope) in known or len(known) > _DEEPEST:
            return set()
        known = (*known, (name, scope))
        found = self._assigned(name, scope, known)
        if not isinstance(scope, ast.FunctionDef) or _is_bound(name, scope):
            return found
        names = [argument.arg for argument in scope.args.args]
        if name not in names:
            return self._of_name(name, self.scope_of(scope), known)
        place = names.index(name) - (names[0] in ('self', 'cls'))
        for call in self.calls:
            if _called(call) == scope.name:
                given = [keyword.value for keyword in call.keywords if keyword.arg == name] or call.args[place:place + 1]
                found |= self._of_all(given, self.scope_of(call), known)
        return found

    def _assigned(self, name, scope, known, within=(ast.FunctionDef, ast.Module)):
        """What is assigned to a name in a scope, and what it runs through in loops there."""
        found = set()
        for node in ast.walk(scope):
            if isinstance(node, ast.Assign) and isinstance(self.above[node] if within == (ast.ClassDef,) else scope, within):
                found |= set().union(*(self._bound(target, node.value, name, scope, known) for target in node.targets))
            elif isinstance(node, (ast.For, ast.comprehension)) and isinstance(node.iter, (ast.Tuple, ast.List)):
                found |= set().union(*(self._bound(node.target, value, name, scope, known) for value in node.iter.elts))
        return found

    def _bound(self, target, value, name, scope, known):
        if isinstance(target, ast.Name):
            return self.texts(value, scope, known) if target.id == name else set()
        if not isinstance(target, ast.Tuple):
            return set()
        if isinstance(value, ast.IfExp):
            return self._bound(target, value.body, name, scope, known) | self._bound(target, value.orelse, name, scope, known)
        if not isinstance(value, ast.Tuple) or len(value.elts) != len(target.elts):
            return set()
        return set().union(*(self._bound(one, each, name, scope, known) for one, each in zip(target.elts, value.elts)))


def _is_bound(name, scope):
    return any(isinstance(node, ast.Name) and node.id == name and isinstance(node.ctx, ast.Store) for node in ast.walk(scope))


def _parts(node):
    """Of an expression the parts of which each may be its value."""
    if isinstance(node, ast.IfExp):
        return node.body, node.orelse
    if isinstance(node, ast.BoolOp):
        return node.values
    if isinstance(node, ast.Subscript):
        return (node.value,) if isinstance(node.value, (ast.Name, ast.Dict)) else ()
    if isinstance(node, ast.Dict):
        return node.values
    if isinstance(node, (ast.Tuple, ast.List)):
        return node.elts
    return (node.elt,) if isinstance(node, (ast.GeneratorExp, ast.ListComp)) else ()
