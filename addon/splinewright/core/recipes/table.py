"""All recipes, by kind."""

from . import (conic_recipes, curve_recipes, homogeneous_recipes, input_recipes, meeting_recipes, mirror_recipes, picture_recipes, product_recipes,
               skin_recipes, surface_recipes, surface_verb_recipes, teaching_recipes)

RECIPES = {recipe.kind: recipe
           for recipe in (*conic_recipes.RECIPES, *curve_recipes.RECIPES, *surface_recipes.PRIMITIVES,
                          *surface_recipes.FROM_CURVES, *skin_recipes.RECIPES, *surface_verb_recipes.RECIPES, *mirror_recipes.RECIPES,
                          *meeting_recipes.RECIPES, *input_recipes.RECIPES, *teaching_recipes.RECIPES, *picture_recipes.RECIPES,
                          *homogeneous_recipes.RECIPES, *product_recipes.RECIPES)}
#: Those that start from nothing, and those that are made from other objects.
STARTING = tuple(recipe for recipe in RECIPES.values() if not (recipe.inputs or recipe.has_places))
DERIVED = tuple(recipe for recipe in RECIPES.values() if recipe.inputs)
FOLLOW = RECIPES['follow']
#: What is made of surfaces, and what of curves and surfaces.
FROM_SURFACES = surface_verb_recipes.RECIPES
FROM_BOTH = (*skin_recipes.FROM_BOTH, *mirror_recipes.RECIPES)
THROUGH_OBJECTS = curve_recipes.THROUGH_OBJECTS
#: Surfaces that one curve or two make by moving, and those that curves span.
FROM_CURVES = (*surface_recipes.FROM_CURVES, *skin_recipes.FROM_CURVES)
#: Curves beside curves, and where surfaces meet.
MEETING = tuple(recipe for recipe in meeting_recipes.RECIPES if recipe.inputs)
