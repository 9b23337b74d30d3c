# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a generator leaves behind in general motion, by its kind: of a planar figure, of a surface, of a solid."""

from ..contours.region import Region


def swept(shape):
    """The sweep of a `GeneralSweep`: what has its ``mesh``, its ``self_intersections`` and its ``outlines``."""
    if isinstance(shape.generator, Region):
        from .region import Changing

        return Changing(shape)
    if not hasattr(shape.generator, "mesh"):
        from .planar import Planar

        return Planar(shape)
    body = shape.generator.mesh()
    if len(body.boundary_edges()):
        from .surface import Surface

        return Surface(shape, body)
    from .solid import Solid

    return Solid(shape, body)
