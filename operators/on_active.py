# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What operators have in common that change the active sweep, the active tree or one of its steps."""

import bpy
from bpy.props import StringProperty

from ..sweep_addon.core.later import later

objects, trees = later("bridge.objects"), later("bridge.trees")


class OnSweep:
    """An operator on a sweep whose parameters may be changed"""

    @classmethod
    def poll(cls, context):
        if objects.is_editable_sweep(context.active_object):
            return True
        cls.poll_message_set("Make a sweep the active object whose mesh is not linked from another file")
        return False


def can_change(operator, context):
    """Whether the active object may be changed in Object Mode; if not, the operator says why."""
    if context.mode != "OBJECT":
        operator.poll_message_set("Go back to Object Mode first")
    elif context.active_object is None or not context.active_object.is_editable:
        operator.poll_message_set("Select a mesh that is not linked from another file")
    else:
        return True
    return False


class OnTree:
    """An operator on the active tree"""

    @classmethod
    def poll(cls, context):
        if not can_change(cls, context):
            return False
        if trees.is_tree(context.active_object):
            return True
        cls.poll_message_set("Make an object with Boolean modifiers the active one")
        return False


class OnStep(OnTree):
    """An operator on a step of the active tree: the one that is named, or the one that is picked"""

    owner: StringProperty(name="Object", description="The object that has the step; without, that of the picked one")
    step: StringProperty(name="Step", description="The name of the step's modifier")

    def found(self, context):
        """The object and the modifier of the step, or None after a report."""
        if not self.step:
            found = trees.picked(context.active_object)
        else:
            owner = bpy.data.objects.get(self.owner) if self.owner else context.active_object
            modifier = owner.modifiers.get(self.step) if owner else None
            found = (owner, modifier) if modifier and modifier.type == "BOOLEAN" else None
        if not found:
            self.report({"ERROR"}, f"{context.active_object.name!r} has no such step: pick one in the sidebar")
        return found
