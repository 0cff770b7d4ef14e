"""What a compiled module must be, read off its file: what it imports, exports and asks of a system."""

import hashlib
import json
import re
import subprocess
import sys

NEWEST_GLIBC = (2, 28)
OLDEST_MACOS = (11, 0)
# Of glibc and of Windows (whose C runtime is part of the system since Windows 10).
LINUX_LIBRARIES = re.compile(r"(lib(c|m|dl|rt|pthread)\.so\.\d|ld-linux-(x86-64|aarch64)\.so\.\d)")
WINDOWS_LIBRARIES = re.compile(r"(KERNEL32\.dll|ADVAPI32\.dll|ntdll\.dll|api-ms-win-crt-[\w-]+\.dll)", re.I)
MACOS_LIBRARIES = re.compile(r"/usr/lib/libSystem\.B\.dylib")


def check(tools, target, python, module):
    """One line that says what the file is.

    @raises SystemExit with every reason why it cannot be given away.
    """
    read = subprocess.run([tools.python, __file__, target.system, module], capture_output=True, text=True, check=True)
    facts = json.loads(read.stdout)
    wrong = list(faults(target, python, facts))
    if wrong:
        sys.exit(f"{module}: " + "; ".join(wrong))
    return f"{module.stat().st_size / 1e6:.2f} MB, {facts['asks']}, imports {', '.join(facts['libraries'])}"


def faults(target, python, facts):
    """What is not as it must be."""
    allowed = {"Linux": LINUX_LIBRARIES, "Windows": WINDOWS_LIBRARIES, "Darwin": MACOS_LIBRARIES}[target.system]
    own = f"python{python.replace('.', '')}.dll"
    yield from (f"imports {name}" for name in facts["libraries"]
                if not allowed.fullmatch(name) and not (target.system == "Windows" and name == own))
    entry = "_PyInit__splinecore" if target.system == "Darwin" else "PyInit__splinecore"
    if facts["exports"] != [entry]:
        yield f"exports {facts['exports'][:5]} of {len(facts['exports'])}, not {entry} alone"
    if facts["machine"] != target.triple.split("-")[0]:
        yield f"is for {facts['machine']}"
    if target.system == "Linux" and tuple(facts["version"]) > NEWEST_GLIBC:
        yield f"{facts['asks']}, newer than 2.28"
    if target.system == "Darwin" and tuple(facts["version"]) != OLDEST_MACOS:
        yield f"{facts['asks']}, not 11.0"
    if target.platform == "macos-arm64" and facts["signature"] != "valid":
        yield f"the signature is {facts['signature']}"


def linux(lief, path):
    binary = lief.ELF.parse(path)
    versions = [found for symbol in binary.imported_symbols if symbol.has_version and symbol.symbol_version.has_auxiliary_version
                for found in re.findall(r"GLIBC_([\d.]+)", symbol.symbol_version.symbol_version_auxiliary.name)]
    newest = max(tuple(map(int, version.split("."))) for version in versions)
    machine = {"X86_64": "x86_64", "AARCH64": "aarch64"}[binary.header.machine_type.name]
    return {"libraries": list(binary.libraries), "machine": machine, "version": newest,
            "exports": sorted(symbol.name for symbol in binary.exported_symbols),
            "asks": f"glibc {'.'.join(map(str, newest))}"}


def windows(lief, path):
    binary = lief.PE.parse(path)
    exports = sorted(entry.name for entry in binary.get_export().entries)
    machine = {"AMD64": "x86_64"}[binary.header.machine.name]
    return {"libraries": sorted(entry.name for entry in binary.imports), "machine": machine, "exports": exports,
            "asks": "Windows 10"}


# Names that the linker gives to the file itself.
OF_THE_LINKER = {"__mh_dylib_header", "___dso_handle"}


def macos(lief, path):
    binary = lief.MachO.parse(path).at(0)
    oldest = tuple(binary.build_version.minos[:2])
    machine = {"X86_64": "x86_64", "ARM64": "aarch64"}[binary.header.cpu_type.name]
    return {"libraries": [library.name for library in binary.libraries if library.command.name != "ID_DYLIB"],
            "machine": machine, "version": oldest, "asks": f"macOS {'.'.join(map(str, oldest))}",
            "exports": sorted({symbol.name for symbol in binary.exported_symbols} - OF_THE_LINKER),
            "signature": signature(binary, open(path, "rb").read())}


def signature(binary, data):
    """"valid", "absent", or what is wrong with the hashes of the ad-hoc signature (Apple's cs_blobs.h)."""
    if not binary.has_code_signature:
        return "absent"
    blob = data[binary.code_signature.data_offset:]
    number = lambda at: int.from_bytes(blob[at:at + 4], "big")
    places = [number(16 + 8 * i) for i in range(number(8)) if number(12 + 8 * i) == 0]
    if number(0) != 0xFADE0CC0 or not places:
        return "not one"
    start = places[0]
    hashes, count, limit = start + number(start + 16), number(start + 28), number(start + 32)
    length, kind, page = blob[start + 36], blob[start + 37], 1 << blob[start + 39]
    if number(start) != 0xFADE0C02 or kind != 2 or limit != binary.code_signature.data_offset:
        return "of another kind"
    for i in range(count):
        wanted = blob[hashes + i * length:hashes + (i + 1) * length]
        if hashlib.sha256(data[i * page:min((i + 1) * page, limit)]).digest() != wanted:
            return f"wrong for page {i} of {count}"
    return "valid" if count == -(-limit // page) else "of too few pages"


if __name__ == "__main__":
    import lief
    print(json.dumps({"Linux": linux, "Windows": windows, "Darwin": macos}[sys.argv[1]](lief, sys.argv[2])))
