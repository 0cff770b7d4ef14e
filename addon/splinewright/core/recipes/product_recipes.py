"""Surfaces of lectures: products of basis functions over the parameters of a patch, or over typed knots."""

from dataclasses import replace

from ..base.words import phrase
from ..formulas import functions, products, teaching
from . import wanted
from .curve_recipes import numbers_of
from .recipe import Parameter, Recipe
from .teaching_recipes import DEGREE, FAMILY, KNOTS, PIECE, family_of, of_surfaces

_SHOW = Parameter("show", "Show", "Which products are drawn", "all", choices=(
    ("all", "All", "Each product of a function along u and one along v"), ("chosen", "Chosen", "One of them"),
    ("sum", "Sum", "The sum of those that weigh points: it is 1 where all functions are there")))
_INDEX = Parameter("index", "Function Along U", "Its number, counted from 0", 1, 0, functions.MOST - 1, where=("show", ("chosen",)))
_INDEX_V = Parameter("index_v", "Function Along V", "Its number, counted from 0", 1, 0, functions.MOST - 1, where=("show", ("chosen",)))
_WIDTH = Parameter("width", "Width", "From the first to the last knot along u", 1.0, 1e-3, unit='LENGTH')
_DEPTH = Parameter("depth", "Depth", "From the first to the last knot along v", 1.0, 1e-3, unit='LENGTH')
_HEIGHT = Parameter("height", "Height", "Of the value 1", 1.0, unit='LENGTH')
_DRAWN = (_SHOW, _INDEX, _INDEX_V, _WIDTH, _DEPTH, _HEIGHT)


def _products(points, family, degree, knot_values, degree_v, knot_values_v, **drawn):
    return _picture((family_of(family, degree, numbers_of(knot_values)), family_of(family, degree_v, numbers_of(knot_values_v))), **drawn)


def _basis_products(inputs, piece, **drawn):
    return _picture(products.of_patch(teaching.patch_of(inputs[0], piece)), **drawn)


def _picture(families, show, index, index_v, width, depth, height):
    parts = products.picture(families, show, (index, index_v), (width, depth), height)
    zero = [name for family in families for name in functions.zero_functions(family)]
    return of_surfaces(parts, phrase("zero everywhere: {zero}", zero=', '.join(dict.fromkeys(zero))) if zero else "")


PRODUCTS = Recipe(
    "products", "Products of Functions on Knots", "The products of functions along u and v over their square, exact",
    (FAMILY, DEGREE, replace(KNOTS, label="Knots Along U"), replace(DEGREE, name="degree_v", label="Degree Along V"),
     replace(KNOTS, name="knot_values_v", label="Knots Along V"), *_DRAWN), _products, resolution=8, is_surface=True)
RECIPES = (
    PRODUCTS,
    Recipe("basis_products", "Products of Functions", "The products of the basis functions of a patch over its parameters, exact; they follow its knots",
           (*_DRAWN, PIECE), _basis_products, resolution=8, inputs=(wanted.ONE_SURFACE,), is_beside=True, is_surface=True),
)
