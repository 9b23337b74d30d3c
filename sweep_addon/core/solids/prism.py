# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The prism: a contour that has moved along z, as much below its plane as above; what several solids are."""


def prism(contour, height):
    """A prism about the origin as the shape that it is.

    Parameters
    ----------
    contour : Contour
    height : float
        Its size along z in metres.

    Returns
    -------
    TranslationalSweep
    """
    from ..shapes.translational_sweep import TranslationalSweep  # shapes have solids as parameters

    return TranslationalSweep(contour, height=height, directions="symmetric", texture="none", attributes=False)
