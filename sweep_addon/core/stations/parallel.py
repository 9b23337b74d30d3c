# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The frame of a generator that stays parallel to itself."""

from ..declared.parameters import declared


@declared
class Parallel:
    """The generator's axes stay those of space

    >>> from sweep_addon.core.shapes.general_sweep import GeneralSweep
    >>> from sweep_addon.core.contours import Rectangle
    >>> mesh = GeneralSweep(Rectangle(1.0, 1.0), frame="parallel").mesh()
    >>> bool(abs(mesh.vertices[:, 2]).max() < 1e-12)  # along an arc in its own plane
    True
    """

    extra_sectors = 0
