"""Self-Test: whether everything works on this machine, said so that it can be sent to others."""

import bpy

from ...bridge.edit import self_test
from ...core.base.words import phrase, say
from .. import progress
from . import reports


class SPLINEWRIGHT_OT_self_test(bpy.types.Operator):
    bl_idname = "splinewright.self_test"
    bl_label = "Self-Test"
    bl_description = "Test the native library on this machine; the results are printed and copied to the clipboard"
    bl_options = {'REGISTER'}

    def execute(self, context):
        lines, failed = self_test.machine(), []
        with progress.shown(context, self_test.COUNT) as done:
            for number, check in enumerate(self_test.checks(context), 1):
                lines.append(f"{'passed' if check.passed else 'FAILED'}  {check.name}: {check.found}")
                failed += [] if check.passed else [check.name]
                done(number)
        said = "\n".join(lines)
        print(said)
        context.window_manager.clipboard = said
        if failed:
            return reports.cancelled(self, phrase("Failed: {names}. All of it is in the clipboard", names=', '.join(failed)))
        if not bpy.app.background:
            _show(context, lines)
        return reports.finished(self, reports.Report("Everything works: what was tried is in the clipboard"))


def _show(context, lines):
    def draw(popup, _context):
        for line in lines:
            popup.layout.label(text=say(line))
    context.window_manager.popup_menu(draw, title=say("Self-Test"), icon='CHECKMARK')


CLASSES = (SPLINEWRIGHT_OT_self_test,)
