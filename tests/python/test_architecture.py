"""The rooms, and the arrows allowed between them. Reads every include and import."""

import ast
import re
from pathlib import Path

import pytest

PROJECT = Path(__file__).resolve().parents[2]
NATIVE = PROJECT / "native"
ADDON = PROJECT / "addon" / "splinewright"

# A native room may use itself and these.
NATIVE_ARROWS = {
    'kernels': set(),
    'numeric': set(),
    'base': {'kernels'},
    'basis': {'base', 'kernels'},
    'curve': {'base', 'numeric', 'basis', 'kernels'},
    'patch': {'base', 'basis', 'curve', 'kernels'},
    'convert': {'base', 'basis', 'curve', 'patch'},
    'conic': {'base', 'basis', 'curve', 'convert'},
    'tessellate': {'base', 'basis', 'curve', 'patch', 'convert'},
    'formula': {'base'},
    'measure': {'base', 'basis', 'curve', 'patch', 'kernels'},
    'meet': {'base', 'basis', 'curve', 'patch', 'conic', 'kernels'},
    'build': {'base', 'basis', 'curve', 'patch', 'convert', 'conic', 'formula', 'kernels', 'measure', 'meet'},
    'region': {'base', 'conic', 'curve', 'measure', 'meet', 'build'},
    'fit': {'base', 'kernels', 'basis', 'curve', 'patch', 'build', 'meet'},
    'surface': {'base', 'numeric', 'basis', 'conic', 'curve', 'patch', 'measure', 'meet', 'build', 'fit', 'kernels'},
    'exchange': {'base', 'basis', 'curve', 'patch', 'region', 'tessellate'},
}
# A room of the add-on may import itself and these.
ADDON_ARROWS = {'core': set(), 'bridge': {'core'}, 'ui': {'core', 'bridge'}}
# Of core and bridge a room within may use itself and these.
ROOMS_WITHIN = {
    'core': {
        'base': set(),
        'native': {'base'},
        'drawing': {'base'},
        'shape': {'base'},
        'verbs': {'base', 'shape'},
        'formulas': {'base', 'shape', 'verbs'},
        'deform': {'base', 'shape', 'verbs'},
        'meets': {'base', 'shape', 'verbs'},
        'joints': {'base', 'shape', 'verbs'},
        'net': {'base', 'native', 'shape', 'verbs'},
        'analysis': {'base', 'formulas', 'net', 'shape', 'verbs'},
        'figures': {'analysis', 'base', 'shape', 'verbs'},
        'rounding': {'base', 'joints', 'verbs'},
        'surfaces': {'base', 'joints', 'meets', 'shape', 'verbs'},
        'recipes': {'base', 'deform', 'drawing', 'formulas', 'joints', 'meets', 'rounding', 'shape', 'surfaces', 'verbs'},
        'lessons': {'base', 'formulas', 'joints', 'recipes', 'shape'},
    },
    'bridge': {
        'data': set(),
        'mesh': {'data'},
        'curve': {'data'},
        'recipes': {'data'},
        'cage': {'curve', 'data', 'mesh'},
        'keys': {'cage', 'data', 'recipes'},
        'shape': {'cage', 'curve', 'data', 'keys', 'mesh', 'recipes'},
        'analysis': {'data', 'recipes', 'shape'},
        'native': {'curve', 'data', 'keys', 'mesh', 'recipes', 'shape'},
        'figures': {'analysis', 'cage', 'curve', 'data', 'native', 'shape'},
        'follow': {'curve', 'data', 'keys', 'native', 'recipes', 'shape'},
        'lessons': {'data', 'follow', 'recipes', 'shape'},
        'net': {'cage', 'curve', 'data', 'follow', 'keys', 'mesh', 'recipes', 'shape'},
        'edit': {'curve', 'data', 'follow', 'keys', 'mesh', 'native', 'recipes', 'shape'},
    },
}


def native_files():
    for folder in (NATIVE / "include" / "splinecore", NATIVE / "src"):
        for path in sorted(folder.rglob("*.?pp")):
            yield path.relative_to(folder).parts[0], path


def addon_files():
    for room in ADDON_ARROWS:
        for path in sorted((ADDON / room).rglob("*.py")):
            yield room, path


def imports(path):
    """(module, level) of every import in a file."""
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            yield from ((alias.name, 0) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            if node.module:
                yield node.module, node.level
            else:
                yield from ((alias.name, node.level) for alias in node.names)


def parts_of_import(path, module, level):
    """Where in the add-on a relative import leads to."""
    folder = path.parent
    for _ in range(level - 1):
        folder = folder.parent
    return (folder / module.replace('.', '/')).relative_to(ADDON).parts


def room_of_import(path, module, level):
    """The room of the add-on that a relative import leads to, or None."""
    parts = parts_of_import(path, module, level)
    return parts[0] if parts and parts[0] in ADDON_ARROWS else None


def test_every_native_room_is_known():
    assert {room for room, _ in native_files()} == set(NATIVE_ARROWS)


@pytest.mark.parametrize('room', NATIVE_ARROWS)
def test_a_native_room_includes_only_rooms_above_it(room):
    files = [path for name, path in native_files() if name == room]
    assert files
    for path in files:
        for included in re.findall(r'#include "(?:splinecore/)?(\w+)/', path.read_text()):
            assert included == room or included in NATIVE_ARROWS[room], f"{path} includes {included}"


def includes(*folders):
    """The quoted includes of all files below, each with the file."""
    for folder in folders:
        for path in sorted(folder.rglob("*.?pp")):
            yield from ((path, included) for included in re.findall(r'#include "([^"]+)"', path.read_text()))


def test_the_public_interface_and_the_bindings_include_public_headers_only():
    for path, included in includes(NATIVE / "include", NATIVE / "bindings"):
        is_public = (NATIVE / "include" / included).is_file()
        assert is_public or (path.parent / included).is_file(), f"{path} includes {included}"


def test_a_header_that_the_library_alone_includes_is_not_public():
    wanted = {included for path, included in includes(NATIVE / "include", NATIVE / "bindings", PROJECT / "tests")
              if path.parent.name != "inside"}
    for path in sorted((NATIVE / "include").rglob("*.hpp")):
        assert str(path.relative_to(NATIVE / "include")) in wanted, f"{path} belongs in native/src"


def test_internal_headers_hide_what_they_declare():
    for room, path in native_files():
        if (NATIVE / "src") in path.parents and path.suffix == ".hpp" and "namespace splinecore" in path.read_text():
            assert "#pragma GCC visibility push(hidden)" in path.read_text(), path


def types_of(path):
    """Of every type that a file declares outside of others, its name and what it is: an alias what it stands for."""
    text = re.sub(r'//.*', '', path.read_text())
    of_its_own = r'^(?:template <.*>\s*)?(?:struct|class|enum class|enum|union) (\w+)\b(?!::|<)[^;{]*\{'
    yield from ((name, path) for name in re.findall(of_its_own, text, re.M))
    yield from re.findall(r'^(?:template <.*>\s*)?using (\w+) = ([^;]+);', text, re.M)


def test_a_name_of_a_type_means_one_thing_in_the_library():
    known = {}
    for room, path in native_files():
        for name, meaning in types_of(path) if room != 'kernels' else ():
            other, where = known.setdefault(name, (meaning, path))
            assert other == meaning, f"{name} is declared in {where} and in {path}"


def parts_of(text, start):
    """The parts between the parenthesis before `start` and its partner, and where that is; commas within brackets part nothing."""
    parts, depth, at = [""], 0, start
    while at < len(text) and (depth or text[at] != ')'):
        depth += (text[at] in '<({[') - (text[at] in '>)}]')
        parts = [*parts, ""] if text[at] == ',' and not depth else [*parts[:-1], parts[-1] + text[at]]
        at += 1
    return [re.sub(r'\s+', ' ', part.partition('=')[0]).strip() for part in parts], at


def functions_of(text):
    """(name, types of its parameters) of each function that a header declares or defines outside of classes."""
    text = re.sub(r'//.*', '', text)
    for found in re.finditer(r'^(?!namespace|template|using|struct|class|enum)\w[\w:<>,&* ]*[ &*](\w+)\(', text, re.M):
        parts, end = parts_of(text, found.end())
        if re.match(r'\)(?: const)?(?: noexcept)?\s*[;{]', text[end:end + 40]):
            yield found[1], tuple(re.sub(r'(?<=[\w>&*]) ?\b(?<!:)\w+$', '', part) if ' ' in part or '&' in part else part for part in parts)


def test_no_two_headers_have_a_function_of_one_name_and_parameters():
    """Linkers take either of two, and say nothing."""
    known = {}
    for room, path in native_files():
        for function in functions_of(path.read_text()) if path.suffix == '.hpp' and room != 'kernels' else ():
            other = known.setdefault(function, path)
            assert other == path, f"{function[0]}{function[1]} is in {other} and in {path}"
    assert len(known) > 500


def test_functions_of_a_header_are_read():
    text = """
inline double at(const Interval& domain, double t) noexcept {
  if (t == 0.0) return 1.0;
double at(const Interval& interval, double place) noexcept;
std::vector<glm::dvec3> all(std::span<const double> s, std::array<int, 2> by = {0, 0}, const char* name = "a");
int none();
class Thing {
  double member(int k) const;
};
"""
    assert list(functions_of(text)) == [('at', ('const Interval&', 'double')), ('at', ('const Interval&', 'double')),
                                        ('all', ('std::span<const double>', 'std::array<int, 2>', 'const char*')), ('none', ('',))]


def test_the_library_knows_neither_python_nor_blender():
    for _, path in native_files():
        assert not re.search(r'pybind11|Python\.h|numpy', path.read_text()), path


def test_bindings_hold_no_geometry():
    for path in (NATIVE / "bindings").glob("*.?pp"):
        assert not re.search(r'glm::(cross|dot|normalize|length)', path.read_text()), path


@pytest.mark.parametrize('room', ADDON_ARROWS)
def test_a_room_of_the_addon_imports_only_rooms_below_it(room):
    files = [path for name, path in addon_files() if name == room]
    assert files
    for path in files:
        for module, level in imports(path):
            if level:
                target = room_of_import(path, module, level)
                assert target in (None, room) or target in ADDON_ARROWS[room], f"{path} imports {target}"


@pytest.mark.parametrize('outer', ROOMS_WITHIN)
def test_rooms_within_core_and_bridge_use_those_above_them_only(outer):
    arrows = ROOMS_WITHIN[outer]
    seen = set()
    for room in arrows:
        assert arrows[room] <= seen, f"{room} uses a room below it"
        seen.add(room)
    assert seen == {path.name for path in (ADDON / outer).iterdir() if path.is_dir() and path.name != '__pycache__'}
    assert [path.name for path in (ADDON / outer).glob("*.py")] == ['__init__.py']
    for path in sorted((ADDON / outer).rglob("*/*.py")):
        room = path.relative_to(ADDON / outer).parts[0]
        used = {parts[1] for parts in (parts_of_import(path, module, level) for module, level in imports(path) if level)
                if len(parts) > 1 and parts[0] == outer}
        assert used <= arrows[room] | {room}, f"{path} imports {used - arrows[room] - {room}}"


def test_the_interface_for_scripts_calls_what_is_below_the_user_interface():
    path = ADDON / "api.py"
    assert {room_of_import(path, module, level) for module, level in imports(path) if level} <= {None, 'core', 'bridge'}
    for _, other in addon_files():
        assert not any(module.split('.')[-1] == 'api' for module, level in imports(other) if level), f"{other} imports it"


def test_core_knows_no_blender():
    for room, path in addon_files():
        if room == 'core':
            assert not {'bpy', 'mathutils', 'bmesh'} & {module.split('.')[0] for module, _ in imports(path)}, path


def test_the_addon_reaches_the_library_through_one_file_only():
    for _, path in addon_files():
        text = path.read_text()
        if path.name != "library.py":
            assert 'import splinecore' not in text and '.splinecore' not in text, path


def test_the_addon_imports_itself_relatively_and_touches_no_search_path():
    for _, path in addon_files():
        text = path.read_text()
        assert 'sys.path' not in text and 'sys.modules' not in text, path
        assert not any(module.split('.')[0] == 'splinewright' for module, level in imports(path) if not level), path
        assert not re.search(r'\b(eval|exec)\(', text), path


def test_one_file_of_the_addon_knows_versions_of_blender():
    """Others ask it for a fact by its name."""
    for _, path in addon_files():
        if path != ADDON / "bridge" / "data" / "versions.py":
            assert not re.search(r'\bapp\.version|hasattr\(bpy\.', path.read_text()), path


def test_what_blender_gives_as_a_matrix_becomes_float64():
    """NumPy makes float32 of it from Blender 5.2 on."""
    for _, path in addon_files():
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Call) and ast.unparse(node.func) in ('np.array', 'np.asarray'):
                given = ast.unparse(node.args[0])
                is_matrix = re.search(r'matrix_(world|local|layer)|calc_matrix|to_3x3|to_camera', given)
                assert not is_matrix or any(keyword.arg == 'dtype' for keyword in node.keywords), (path, given)


def test_operators_report_through_one_function_only():
    for room, path in addon_files():
        calls = [node for node in ast.walk(ast.parse(path.read_text()))
                 if isinstance(node, ast.Attribute) and node.attr == 'report']
        assert len(calls) == (path.name == "reports.py"), path


def test_modal_operators_have_one_base():
    for _, path in addon_files():
        is_base = path.name == "gesture.py"
        assert ("modal_handler_add" in path.read_text()) == is_base, path
        defined = [node.name for node in ast.walk(ast.parse(path.read_text())) if isinstance(node, ast.FunctionDef)]
        assert ('modal' in defined) == is_base, path


#: Where the words of an error are taken apart: the library has no other way to say which item it means, a module that does not load why;
#: Blender's begin with "Error: ".
READERS = {("library.py", '_load'), ("failures.py", 'about_items'), ("failures.py", 'blenders_refusals')}


def readers(source):
    """Names of functions that take the words of an exception apart, or compare them."""
    for function in ast.walk(ast.parse(source)):
        if not isinstance(function, ast.FunctionDef):
            continue
        caught = {node.name for node in ast.walk(function) if isinstance(node, ast.ExceptHandler) and node.name}
        for node in ast.walk(function):
            is_compared = isinstance(node, ast.Compare) and [node.left, *node.comparators]
            is_taken = isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and [node.func.value]
            is_searched = isinstance(node, ast.Call) and ast.unparse(node.func).startswith("re.") and node.args
            for part in (*(is_compared or ()), *(is_taken or ()), *(is_searched or ())):
                if any(ast.unparse(inner) in {f"{way}" for name in caught for way in (f"str({name})", f"{name}.args[0]", f"sentence({name})")}
                       for inner in ast.walk(part)):
                    yield function.name


def test_no_logic_reads_the_words_of_an_error():
    found = {(path.name, name) for _, path in addon_files() for name in readers(path.read_text())}
    assert found == READERS
    taken = "def f():\n try:\n  g()\n except E as error:\n  "
    for line in ("return 'curve' in str(error)", "return str(error).replace('at', 'u')", "return re.sub('a', 'b', str(error))",
                 "return error.args[0] == 'no'"):
        assert list(readers(taken + line)), line
    assert not list(readers(taken + "return name(str(error))"))


def test_windows_wait_until_it_is_so_and_never_a_fixed_time():
    for path in (PROJECT / "tests" / "gui").glob("*.py"):
        assert not re.search(r'\byield +[\d.]|\bsleep\(', path.read_text()), path


def test_no_file_is_longer_than_500_lines():
    for pattern in ("native/**/*.?pp", "addon/**/*.py", "tests/**/*.py", "tests/**/*.?pp", "blend_samples/**/*.py"):
        for path in PROJECT.glob(pattern):
            assert len(path.read_text().splitlines()) <= 500, path


def test_settings_are_reached_through_one_file():
    for room, path in addon_files():
        if room == 'bridge' and path.name != "settings.py":
            assert not re.search(r'\.splinewright\b', path.read_text()), path


def test_what_is_remembered_of_the_open_file_has_one_room():
    """A dictionary, list or set at the top of a module outlives the file that is open; keymaps do, too."""
    for room, path in addon_files():
        if path.name != "keymaps.py":
            assert not re.search(r'^[a-z_]+ = (set\(\)|dict\(\)|\{\}|\[\])', path.read_text(), re.M), path


def test_refusals_are_told_from_mistakes():
    """What a modeler is told of is a Refusal; a ValueError that nobody raised for him is a mistake of ours."""
    allowed = {"failures.py", "store.py", "recipes.py"}
    for _, path in addon_files():
        if path.name not in allowed:
            assert not re.search(r'raise (ValueError|TypeError|RuntimeError|ArithmeticError)\(', path.read_text()), path


def test_new_arrays_of_one_axis_come_from_new_numbers():
    """The constructors of py::array_t that take a count, which one number in braces is, too, make arrays of stride 0 of some pybind11 and
    NumPy."""
    named = re.compile(r"array_t<[\w:]+>(?: \w+)?\((?:count|overlaps|size|static_cast<)")
    in_braces = re.compile(r"array_t<[\w:]+>(?: \w+)?[({]\{(?:[^{},<]|<[^<>]*>)*\}(?!,\s*\{)")
    assert in_braces.search("py::array_t<double> array({static_cast<py::ssize_t>(numbers.size())},")
    for path in sorted((NATIVE / "bindings").glob("*.[ch]pp")):
        text = path.read_text()
        assert not named.search(text) and not in_braces.search(text), path
