"""Lengths in words, in units as Blender's scenes have them."""

#: By Blender's systems of units and names of units, the largest first: the symbol, and how many meters it has.
UNITS = {
    'METRIC': {'KILOMETERS': ("km", 1e3), 'METERS': ("m", 1.0), 'CENTIMETERS': ("cm", 1e-2), 'MILLIMETERS': ("mm", 1e-3),
               'MICROMETERS': ("µm", 1e-6)},
    'IMPERIAL': {'MILES': ("mi", 1609.344), 'FEET': ("ft", 0.3048), 'INCHES': ("in", 0.0254), 'THOU': ("thou", 2.54e-5)},
    'NONE': {},
}


def unit_for(length, system, wanted, scale):
    """(symbol, how long it is in units of the scene) of the unit for lengths up to one; wanted: a name, or 'ADAPTIVE'."""
    units = UNITS[system]
    if not units:
        return "", 1.0
    if wanted in units:
        symbol, meters = units[wanted]
    else:
        symbol, meters = next((unit for unit in units.values() if length * scale >= unit[1]), list(units.values())[-1])
    return symbol, meters / scale


def text(length, unit):
    """A length in a unit_for() it."""
    symbol, size = unit
    number = f"{length / size:.3g}" if length else "0"
    return f"{number} {symbol}".rstrip()
