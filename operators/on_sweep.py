# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What operators have in common that change the parameters of the active sweep."""

from ..sweep_addon.core.later import later

objects = later("bridge.objects")


class OnSweep:
    """An operator on a sweep whose parameters may be changed"""

    @classmethod
    def poll(cls, context):
        if objects.is_editable_sweep(context.active_object):
            return True
        cls.poll_message_set("Make a sweep the active object whose mesh is not linked from another file")
        return False
