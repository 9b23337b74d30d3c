# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The solid of a canal surface: everything that its balls visit, which is what its runs enclose together."""

from dataclasses import replace
from functools import partial

import numpy as np

from ..envelopes.envelope import Envelope
from ..meshes.booleans import body_of, united
from ..meshes.polyhedron import polyhedron
from .of_shapes import once
from .resolve import resolved
from .tidying import tidied_arrays


def of_balls(shape, progress=None):
    """The solid of balls, or of discs their region, each place once.

    Parameters
    ----------
    shape : CanalSurface
    progress : callable, optional
        Is told which part is done, from 0 to 1; what it raises ends the work.
    """
    surface = replace(shape, make_solid=False)
    envelope = Envelope(surface, apart=True)
    if surface.is_plane:
        return once(envelope.region(np.float64))
    progress = progress or (lambda part: None)
    parts, solids = envelope.parts(np.float64), []
    for number, part in enumerate(parts):
        share = partial(shared, progress, number, len(parts) + 1)
        solids.append(resolved(part, share, lambda: bool(surface.self_intersections())))
    if len(solids) == 1:
        return once(solids[0])
    return once(polyhedron(*tidied_arrays(united(map(body_of, solids))), told=parts[0].told))


def shared(progress, number, parts, done):
    """Tell that of so many parts some are done and the next one in part."""
    progress((number + done) / parts)
