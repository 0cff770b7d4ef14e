"""The least that one core can need for an item: what must be computed or moved, at the rates measured beside it.

An operation is one on a vector of four doubles (a multiplication with addition counts once). Divisions and memory run
beside the operations, so the bound is the largest of the three, never their sum.
"""

from dataclasses import dataclass


@dataclass
class Bound:
    operations: float
    divisions: float
    bytes: int
    formula: str

    def nanoseconds(self, machine):
        return max(self.operations * machine["operation_ns"], self.divisions * machine["division_ns"],
                   self.bytes * machine["byte_ns"])


def bezier(degree):
    return Bound(3.5 * degree / 4, 0, 32, f"Horner after Volk and Schumaker, {degree} · (3 FMA + half a power), "
                 "in lanes of 4 parameters; 32 bytes")


BOUNDS = {
    "W1 sorted": Bound(4, 0.25, 32, "12 FMA, 1 subtraction, 3 products in lanes of 4 parameters; 32 bytes"),
    "W1 random": Bound(28, 1, 32, "look-up of the span 8, 4 loads, 1 subtraction, 3 FMA, reciprocal 4, stores and "
                       "shuffles 8, x y z w in the lanes; 32 bytes"),
    "W2": Bound(11, 0.25, 80, "24 FMA for the sums, 20 for the quotients, in lanes of 4 parameters; 80 bytes"),
    "W3 points": Bound(4.6, 0.25, 24, "as W1, and 2.4 FMA a point for rows and spans; 24 bytes"),
    "W3 normals": Bound(14, 0.75, 48, "32 FMA for S, Su, Sv, 24 for quotients, cross product, length, in lanes of 4; "
                        "48 bytes"),
    "W4": Bound(72, 1, 88, "72 operations with x y z w in the lanes; 88 bytes"),
    "W5 degree 11": bezier(11),
    "W5 degree 25": bezier(25),
    "W6 refine": Bound(24, 3, 48, "2 new points a knot: 6 steps of de Boor of 2 operations and 6 divisions each; "
                       "48 bytes"),
    "W6 elevate": Bound(30, 3, 72, "3 new points a span, each a sum of 4 points and its 4 coefficients, 10 operations; "
                        "72 bytes"),
    "W6 Beziers": Bound(12, 3, 96, "3 new points a span, each 2 steps of de Boor of 2 operations; 96 bytes"),
    **{f"W7 curve {count}": Bound(31, 2.5, 104, "chord 8; twice a row of functions in lanes of 4, 4; elimination 7, "
                                  "substitution 2, distance 6; 10 divisions and roots in lanes of 4; "
                                  "points read, parameters, knots, factors, points written: 104 bytes")
       for count in ("1e3", "1e4", "1e5")},
    "W7 surface": Bound(15, 0, 136, "2 × (2 + 2 columns and a product) in lanes of 4, distance 4; grid, two nets and the "
                        "points: 136 bytes"),
    "W7 least squares": Bound(26, 0, 96, "7 sums of products 6, and twice: functions 3, distance 4, 12 sums, in lanes of 4; "
                              "points and parameters read three times: 96 bytes"),
    "W8 curve": Bound(100 + 3 * 30, 5, 40, "5 groups of 8 boxes of 20 operations each, 3 Newton steps of 30; "
                      "40 bytes"),
    "W8 patch": Bound(400 + 3 * 90 + 160, 5, 48, "20 groups of 8 boxes of 20 operations each, 3 Newton steps of 90, "
                      "and 160 for the coefficients of the squared distance; 48 bytes"),
    "W9 curves": Bound(63 * 4 * 40 + 61 * 8 * 10, 63 * 4, 0, "63 crossings of 4 Newton steps of 40 operations each, "
                       "and 8 looks at pairs of 10 a span"),
    "W9 surfaces": Bound(270 / 2 * 25 * 200, 270 / 2 * 25, 0, "135 places of 25 evaluations of both surfaces each, of "
                         "200 operations"),
    "W10": Bound(11, 0.5, 48, "24 FMA for S, Su, Sv, 18 for cross product and length, in lanes of 4, 0.5 for rows; "
                 "48 bytes"),
    **{f"W13 {hits}": Bound(20 + count * (40 + 3 * 120), count * 3, 48 + 72 * count, f"a group of 8 boxes of 20 operations, and for "
                            f"each of {count} hits 2 groups, 3 Newton steps of 120 operations; 48 bytes and 72 a hit")
       for hits, count in (("first", 1), ("all", 2))},
    "W11": Bound(61 * 31 * 5, 61 * 31 / 2, 0, "61 spans, 31 nodes of Kronrod's rule each: 15 FMA for the speed, its "
                 "length, a root and a division, in lanes of 4"),
}
