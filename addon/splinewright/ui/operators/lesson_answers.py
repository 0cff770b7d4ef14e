"""Answers of lessons, out of many files into one table."""

from pathlib import Path

import bpy
from bpy.props import BoolProperty, CollectionProperty, StringProperty
from bpy_extras.io_utils import ImportHelper

from ...bridge.lessons import collecting, shelf
from ...core.base import whole_files
from ...core.base.failures import FAILURES, sentence
from ...core.base.words import phrase
from ...core.lessons import answers
from .. import progress
from . import polls, reports


class SPLINEWRIGHT_OT_collect_answers(ImportHelper, bpy.types.Operator):
    bl_idname = "splinewright.collect_answers"
    bl_label = "Collect Answers"
    bl_description = "Write the answers to lessons that .blend files keep into a table (.csv), without opening the files"
    bl_options = {'REGISTER'}

    filename_ext = ".blend"
    filter_glob: StringProperty(default="*.blend", options={'HIDDEN'})
    filepath: StringProperty(name="File Path", subtype='FILE_PATH', options={'HIDDEN', 'SKIP_SAVE'})
    directory: StringProperty(subtype='DIR_PATH', options={'HIDDEN', 'SKIP_SAVE'})
    files: CollectionProperty(type=bpy.types.OperatorFileListElement, options={'HIDDEN', 'SKIP_SAVE'})
    table: StringProperty(name="Table", description="The file that is written, beside the first of those that are read", default="answers.csv",
                          options={'SKIP_SAVE'})
    overwrite: BoolProperty(name="Overwrite", description="Replace a table that is there", options={'SKIP_SAVE'})

    @classmethod
    def poll(cls, context):
        return polls.in_object_mode(cls, context)

    def execute(self, context):
        paths = self._paths()
        if not paths:
            return reports.cancelled(self, "Choose .blend files with answers")
        table = paths[0].parent / (self.table or "answers.csv")
        if table.suffix.lower() != ".csv":
            table = table.with_name(f"{table.name}.csv")
        if table.exists() and not self.overwrite:
            return reports.cancelled(self, phrase("{name} is there already: Overwrite replaces it", name=table.name))
        rows, refused, empty = self._collected(context, paths)
        if not rows:
            return reports.cancelled(self, *(refused or ["These files keep no answers"]))
        try:
            whole_files.write(table, answers.table(rows), 'utf-8-sig')      # spreadsheets tell UTF-8 by its mark
        except OSError as error:
            return reports.failed(self, error, table.name)
        said = phrase("{count} answers are in {table}; files with answers: {files}", one="{count} answer is in {table}; files with answers: {files}",
                      count=len(rows), files=len(paths) - len(refused) - len(empty), table=table)
        return reports.finished(self, reports.Report(said, warnings=(*refused, *empty)))

    def _paths(self):
        """The files that were chosen, or the one that a script names."""
        folder = Path(bpy.path.abspath(self.directory))
        found = [folder / element.name for element in self.files if element.name]
        return found or ([Path(bpy.path.abspath(self.filepath))] if self.filepath else [])

    def _collected(self, context, paths):
        """(Rows, why files cannot be read, which keep no answers)"""
        rows, refused, empty = [], [], []
        try:
            lessons = shelf.all_lessons()
        except FAILURES:
            lessons = {}                # answers are written as they are kept
        with progress.shown(context, len(paths)) as step:
            for number, path in enumerate(paths, 1):
                try:
                    found = collecting.rows_of(path, lessons)
                    rows += found
                    empty += [] if found else [phrase("{name} keeps no answers", name=path.name)]
                except FAILURES as error:
                    refused.append(sentence(error))
                step(number)
        return rows, refused, empty


CLASSES = (SPLINEWRIGHT_OT_collect_answers,)
