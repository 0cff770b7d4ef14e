"""All recipes, by kind."""

from . import conic_recipes, curve_recipes

RECIPES = {recipe.kind: recipe for recipe in conic_recipes.RECIPES + curve_recipes.RECIPES}
