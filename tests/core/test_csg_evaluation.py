# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A tree of extrusions as one extrusion again: the outline that was converted comes back."""

import numpy as np
import pytest

import sweep_addon as sw
from sweep_addon.core.conversion.evaluation import csg_to_sweep

pytest.importorskip("manifold3d", reason="trees are evaluated by it")

OUTLINES = {
    "notched": ([(-2, -1), (2, -1), (2, 1), (1, 1), (1, 2), (0, 1), (-2, 1)], [0, 0.4, 0, 0, -0.3, 0.2, 0]),
    "slot": ([(-1, -0.5), (1, -0.5), (1, 0.5), (-1, 0.5)], [0, 1, 0, 1]),
    "comb": ([(0, 0), (3, 0), (3, 2), (2, 2), (2, 1), (1, 1), (1, 2), (0, 2)], [0] * 8),
}

WAYS = [{}, {"direction": (0.5, 0.25, 1.0)}, {"directions": "symmetric"}, {"reference": "centroid"}]


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", OUTLINES)
def test_the_outline_comes_back_with_its_arcs(name, way):
    corners, bulges = OUTLINES[name]
    shape = sw.TranslationalSweep(sw.contours.Outline([corners], [bulges], tolerance=1e-4), height=0.5, **way)
    back = csg_to_sweep(sw.sweep_to_csg(shape))
    (loop,), (turns,) = back.contour.loops, back.contour.bulges or [np.zeros(len(corners))]
    assert len(loop) == len(corners)
    assert np.allclose(np.sort(np.array(turns)), np.sort(bulges), atol=1e-3)
    low, high = (f(shape.mesh().vertices, axis=0) for f in (np.min, np.max))
    assert np.allclose([back.mesh().vertices.min(axis=0), back.mesh().vertices.max(axis=0)], [low, high], atol=1e-3)


def test_a_tree_of_other_leaves_is_refused():
    plate = sw.TranslationalSweep(sw.contours.Rectangle(1.0, 1.0), height=0.5)
    with pytest.raises(sw.ShapeError, match="leaves: must be extruded alike"):
        csg_to_sweep(plate | sw.TranslationalSweep(sw.contours.Rectangle(2.0, 0.5), height=0.4))
    with pytest.raises(sw.ShapeError, match="leaves: must be translational sweeps, got 'Block'"):
        csg_to_sweep(plate | sw.solids.Block())
