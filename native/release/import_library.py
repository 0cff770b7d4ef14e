"""What an extension for Windows may import from Python's DLL, by the public headers."""

import re

DECLARED = re.compile(r"PyAPI_(FUNC|DATA)\s*\([^;{]*?\)\s*(?:\w+\s+)*\**\s*(\w+)\s*[;(\[]")


def definition(headers, dll):
    """The text of a module definition file: every function and value that the headers declare."""
    files = [*sorted(headers.glob("*.h")), *sorted(headers.glob("cpython/*.h"))]
    kinds = {name: kind for file in files for kind, name in DECLARED.findall(file.read_text())}
    lines = [f"    {name}{' DATA' if kind == 'DATA' else ''}" for name, kind in sorted(kinds.items())]
    return "\n".join([f"LIBRARY {dll}", "EXPORTS", *lines, ""])
