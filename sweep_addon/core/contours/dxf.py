# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours from DXF drawings, their arcs kept as arcs."""

from io import BytesIO
from itertools import islice

import numpy as np

from ..declared.documents import about, content
from ..declared.parameters import ShapeError
from .joining_edges import closed_loops
from .outline import Outline
from .reading import argument, library

LARGEST = 50_000_000  # bytes
MARK = "SECTION"  # in every such text
METRES = {1: 0.0254, 2: 0.3048, 3: 1609.344, 4: 0.001, 5: 0.01, 6: 1.0, 7: 1000.0, 8: 2.54e-8, 9: 2.54e-5, 10: 0.9144}
METRES |= {11: 1e-10, 12: 1e-9, 13: 1e-6, 14: 0.1, 15: 10.0, 16: 100.0, 17: 1e9}  # of the units of $INSUNITS
METRES |= {21: 1200 / 3937, 22: 100 / 3937, 23: 3600 / 3937, 24: 6336000 / 3937}  # as the survey of the USA has them
MOST = 20_000  # entities, those of blocks in blocks each time they are drawn
FLATTENED = 1e-3  # of a curve's size: its distance from chords, of one that is no arc
DRAWN = {"LINE", "ARC", "CIRCLE", "LWPOLYLINE", "POLYLINE", "SPLINE", "ELLIPSE"}


def from_dxf(text_or_path, scale=0.0, layer="", centred=True):
    """Make an outline of the closed loops of a DXF drawing.

    Parameters
    ----------
    text_or_path : str or Path
        The text of a drawing, or the path of a file of at most 50 MB.
    scale : float
        Metres for one unit of the drawing; 0 is the unit that it names, metres where it names none.
    layer : str
        The only layer that counts; by default all do that are neither off nor frozen.
    centred : bool
        Whether the centroid of the area becomes the reference point; otherwise the drawing's origin is.

    Returns
    -------
    Outline
        Lines and arcs as they are drawn; splines and ellipses as chords. What an odd number of loops lies around is
        inside.

    Raises
    ------
    ShapeError
        For what is no DXF, a drawing without a closed loop, and where the library ezdxf is missing.

    Lines, arcs, circles, polylines, splines and ellipses count, those in blocks too, as seen from above. Ends that meet
    are joined; what is left open is no outline. Texts, dimensions and hatches are left out.

    Examples
    --------
    >>> from_dxf("0\\nSECTION\\n")  # doctest: +IGNORE_EXCEPTION_DETAIL
    Traceback (most recent call last):
    sweep_addon.core.declared.parameters.ShapeError: the DXF text must have a closed loop, got none
    """
    scale, centred = argument("scale", scale, minimum=0.0), argument("centred", centred, bool)
    layer = argument("layer", layer, str)
    data, subject = content(text_or_path, "DXF", MARK, LARGEST)
    with about(subject):
        drawing, chains, layers = read(data, layer)
        if layer and layer not in layers:
            there = ", ".join(map(repr, sorted(layers))) or "none with lines, arcs or polylines"
            raise ShapeError(f"must be one of the layers that have something drawn, {there}, got {layer!r}", "layer")
        scale = scale or METRES.get(drawing.header.get("$INSUNITS", 0), 1.0)
        loops = closed_loops(chains)
        if not loops:
            raise ShapeError("must have a closed loop, got none")
        points, bulges = ([scale * corners for corners, _ in loops], [bulge for _, bulge in loops])
        outline = Outline(points, bulges)
        if not centred:
            return outline
        centre = outline.section().centroid
        return Outline([loop - centre for loop in points], bulges)


def read(data, layer):
    """The drawing in some bytes, the chains of edges that its entities draw, and the layers on which any is drawn."""
    library("ezdxf", "ezdxf")
    from ezdxf import recover
    from ezdxf.disassemble import recursive_decompose

    try:
        drawing, _ = recover.read(BytesIO(data))
        entities = list(islice(recursive_decompose(drawing.modelspace()), MOST + 1))
        hidden = {each.dxf.name for each in drawing.layers if each.is_off() or each.is_frozen()}
        drawn = [entity for entity in entities if entity.dxftype() in DRAWN and is_seen(entity, hidden - {layer})]
        wanted = [entity for entity in drawn if layer in ("", entity.dxf.layer)]
        chains = [chain for entity in wanted[:MOST] for chain in edges_of(entity)]
    except Exception as error:  # the parser meets what is no DXF in ways of its own
        raise ShapeError(f"must be DXF, got an error: {' '.join(str(error).split())}") from error
    if len(entities) > MOST:
        raise ShapeError(f"must have at most {MOST:,} entities, those of blocks each time they are drawn, got more")
    return drawing, chains, {entity.dxf.layer for entity in drawn}


def is_seen(entity, hidden):
    """Whether an entity is visible, and its layer, of which those that are not are given."""
    return not entity.dxf.get("invisible", 0) and entity.dxf.layer not in hidden


def edges_of(entity):
    """The chains of edges that an entity draws: each start and end (2,), and bulge, of a row (n, 5)."""
    kind, dxf = entity.dxftype(), entity.dxf
    if kind == "LINE":
        yield np.array([[*flat(dxf.start), *flat(dxf.end), 0.0]])
    elif kind == "CIRCLE" or kind == "ARC" and (dxf.end_angle - dxf.start_angle) % 360.0 == 0:
        (x, y), r = flat(entity.ocs().to_wcs(dxf.center)), dxf.radius
        yield np.array([[x - r, y, x + r, y, 1.0], [x + r, y, x - r, y, 1.0]])
    elif kind == "ARC":
        turn = np.radians((dxf.end_angle - dxf.start_angle) % 360.0)
        bulge = np.tan(turn / 4) * (1 if dxf.extrusion.z >= 0 else -1)
        yield np.array([[*flat(entity.start_point), *flat(entity.end_point), bulge]])
    elif kind == "LWPOLYLINE" or kind == "POLYLINE" and entity.is_2d_polyline:
        yield from polyline(entity)
    elif kind != "POLYLINE" or entity.is_3d_polyline:  # no mesh of faces
        yield from curve(entity)


def flat(point):
    """A point as seen from above: (x, y)."""
    return point[0], point[1]


def polyline(entity):
    """The chain of a polyline, with the bulges of its edges; seen from below these are the other way."""
    light = entity.dxftype() == "LWPOLYLINE"
    rows = entity.get_points("xyb") if light else [(*flat(v.dxf.location), v.dxf.bulge) for v in entity.vertices]
    rows = np.array(rows, dtype=float).reshape(-1, 3)
    ocs = entity.ocs()
    places = np.array([flat(ocs.to_wcs((x, y, 0.0))) for x, y, _ in rows]).reshape(-1, 2)
    bulges = rows[:, 2] * (1 if entity.dxf.extrusion.z >= 0 else -1)
    ends = np.roll(places, -1, axis=0)
    made = np.column_stack((places, ends, bulges))
    yield made if (entity.closed if light else entity.is_closed) else made[:-1]


def curve(entity):
    """The chain of chords of a spline or an ellipse."""
    from ezdxf.path import make_path

    path = make_path(entity)
    places = np.array([flat(point) for point in path.control_vertices()])
    size = float(np.hypot(*np.ptp(places, axis=0)))
    places = np.array([flat(point) for point in path.flattening(FLATTENED * max(size, 1e-9))])
    yield np.column_stack((places[:-1], places[1:], np.zeros(len(places) - 1)))
