# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the operand of a tree may be, by its name in jobs."""

from functools import cache
from typing import get_args

from ..declared.parameters import spelled
from ..shapes.kinds import SHAPES
from ..solids import Solid


@cache
def known():
    """Every kind of operand by its name: shapes, solids, and the nodes of trees."""
    from . import NODES

    return {spelled(kind): kind for kind in (*SHAPES, *get_args(Solid), *NODES)}
