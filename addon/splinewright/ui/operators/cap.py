"""Cap: the open ends of surfaces are closed."""

import bpy
from bpy.props import EnumProperty

from ...bridge.edit import replace_pieces
from ...bridge.net import keyed
from ...bridge.recipes import recipes
from ...core.base.failures import Refusal
from ...core.base.words import phrase
from ...core.recipes import capping
from ...core.surfaces import caps
from . import reports
from .selected import OnSelected


class SPLINEWRIGHT_OT_cap(OnSelected, bpy.types.Operator):
    bl_idname = "splinewright.cap"
    bl_label = "Cap Holes"
    bl_description = ("Close open ends of surfaces with patches that share their points; normals of a closed body point "
                      "outward")
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}
    needs, done = "Select a shape of patches", "Capped {what}"
    fits = staticmethod(replace_pieces.is_patch_shape)
    has_settings = True

    ends: EnumProperty(name="Ends", description="Which open ends are closed", items=(
        ('ALL', "All", "All open ends"), ('SHORTEST', "Shortest", "The one with the shortest rim"),
        ('LONGEST', "Longest", "The one with the longest rim")))

    def can_work(self, ob):
        return replace_pieces.can_change(ob.data)

    def work(self, context, ob):
        if recipes.follows(ob.data):
            return self._set(ob.data)
        before = replace_pieces.read(ob.data)
        found = caps.capped(before, self.ends)
        replace_pieces.put(ob.data, before, found.changed)
        return found

    def _set(self, data):
        """Caps in the panel of shapes made from other objects. Raises Refusal where there are none."""
        recipe = recipes.of(data)
        choices = next((parameter.choices for parameter in recipe.parameters if parameter.name == 'caps'), ())
        if not choices:
            raise Refusal("it follows other objects: use Apply Construction first")
        if self.ends != 'ALL':
            raise Refusal("it follows its curves: which end is closed says Caps in its panel")
        wanted = 'both' if 'both' in (choice[0] for choice in choices) else 'flat'
        if recipes.parameters(data)['caps'] == wanted:
            raise Refusal("it has caps already")
        keyed.set_parameters(data, {'caps': wanted})

    def said(self, outcomes):
        found = [outcome for outcome in outcomes.values() if outcome is not None]
        more = []
        if found:
            count = sum(one.count for one in found)
            more.append(phrase("{count} ends closed", one="{count} end closed", count=count))
            bend = max(one.bend for one in found)
            more += capping.bend_in_words(bend)
            more += ["normals turned outwards"] if any(one.is_turned for one in found) else []
        return reports.Report(": ".join(filter(None, (self.summary(outcomes), ", ".join(more)))))

    def draw(self, context):
        self.layout.use_property_split = True
        self.layout.row().prop(self, "ends", expand=True)
        self.draw_result()


CLASSES = (SPLINEWRIGHT_OT_cap,)
