"""Compares the results of systems, bit for bit: compare.py FIRST OTHER...

The sections named "libm …" rest on functions that each system has in a library of its own; they may differ by LIBM_ULP
units in the last place of a function, and shapes made of them by LIBM_SHAPE of their size.
"""

import struct
import sys

LIBM_ULP = 4
LIBM_SHAPE = 4e-16


def read(path):
    """{section: [bits]} of a file that splinecore_results printed."""
    found, section = {}, None
    with open(path) as lines:
        for line in lines:
            line = line.rstrip("\n")
            if len(line) == 16 and all(letter in "0123456789abcdef" for letter in line):
                section.append(int(line, 16))
            else:
                section = found.setdefault(line, [])
    return found


def number(bits):
    return struct.unpack("<d", struct.pack("<Q", bits))[0]


def place(bits):
    """The number of a float among all floats in order."""
    return bits if bits < 1 << 63 else (1 << 63) - bits


def difference(name, a, b):
    """A sentence on what differs beyond what may, or ""; and one on what differs within it, or ""."""
    if a == b:
        return "", ""
    if len(a) != len(b):
        return f"{name}: {len(a)} numbers and {len(b)}", ""
    ulp = max(abs(place(x) - place(y)) for x, y in zip(a, b))
    size = max(abs(number(x)) for x in a)
    relative = max(abs(number(x) - number(y)) for x, y in zip(a, b)) / size
    count = sum(x != y for x, y in zip(a, b))
    said = f"{name}: {count} of {len(a)} differ, by {ulp} ulp, {relative:.1e} of the largest"
    is_function = name.startswith("libm ") and "(" in name
    may = name.startswith("libm ") and (ulp <= LIBM_ULP if is_function else relative <= LIBM_SHAPE)
    return ("", said) if may else (said, "")


def main(paths):
    first = read(paths[0])
    print(f"{paths[0]}: {sum(map(len, first.values()))} numbers in {len(first)} sections")
    failed = False
    for path in paths[1:]:
        other = read(path)
        wrong = [f"{name} is missing" for name in first.keys() ^ other.keys()]
        allowed = []
        for name in first.keys() & other.keys():
            bad, fine = difference(name, first[name], other[name])
            wrong += [bad] if bad else []
            allowed += [fine] if fine else []
        same = sum(first[name] == other[name] for name in first.keys() & other.keys())
        print(f"{path}: {same} of {len(first)} sections the same bits, {len(allowed)} within what libm may differ by")
        print("".join(f"  {line}\n" for line in sorted(allowed) + [f"WRONG {line}" for line in sorted(wrong)]), end="")
        failed |= bool(wrong)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
