# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""OpenCASCADE's pipes, where its Python wrapper is installed: solids of exact curves, not meshes."""

try:
    from OCP.BRepBuilderAPI import (
        BRepBuilderAPI_MakeEdge,
        BRepBuilderAPI_MakePolygon,
        BRepBuilderAPI_MakeWire,
        BRepBuilderAPI_TransitionMode,
    )
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.BRepGProp import BRepGProp
    from OCP.BRepOffsetAPI import BRepOffsetAPI_MakePipeShell
    from OCP.collections import HArray1_gp_Pnt
    from OCP.GCPnts import GCPnts_TangentialDeflection
    from OCP.Geom import Geom_Ellipse
    from OCP.GeomAdaptor import GeomAdaptor_Curve
    from OCP.GeomAPI import GeomAPI_Interpolate
    from OCP.gp import gp_Ax2, gp_Circ, gp_Dir, gp_Elips, gp_Pnt, gp_Vec
    from OCP.GProp import GProp_GProps
    from OCP.Law import Law_Linear
    from OCP.Standard import Standard_ConstructionError
except ImportError:
    BRepOffsetAPI_MakePipeShell = None

ABSENT = "not installed"


def where_installed(ask):
    """The answer of a function, or that OpenCASCADE is not there."""
    return ask if BRepOffsetAPI_MakePipeShell else lambda *given: ABSENT


@where_installed
def corner(path):
    """The volume of a 1 x 1 square's pipe along legs (n, 3) that begin on +x, with right corners."""
    square = [(0, 0.5, 0.5), (0, -0.5, 0.5), (0, -0.5, -0.5), (0, 0.5, -0.5)]
    mode = BRepBuilderAPI_TransitionMode.BRepBuilderAPI_RightCorner
    return volume(polygon(path), polygon(square, closed=True), mode)


@where_installed
def ring(major, minor):
    """The volume of a circle's pipe round a circle."""
    spine = wire(gp_Circ(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), major))
    return volume(spine, wire(gp_Circ(gp_Ax2(gp_Pnt(major, 0, 0), gp_Dir(0, 1, 0)), minor)))


@where_installed
def straight(length, outer, inner):
    """The volume of a pipe along z: that of its outer circle's solid less that of its inner one's."""
    upright = gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1))
    spine = polygon([(0, 0, 0), (0, 0, length)])
    return volume(spine, wire(gp_Circ(upright, outer))) - volume(spine, wire(gp_Circ(upright, inner)))


@where_installed
def knot(points, radius, closed=True):
    """The volume of a circle's pipe along a smooth curve through points (n, 3), and whether the solid is valid."""
    places = HArray1_gp_Pnt(1, len(points))
    for index, point in enumerate(points):
        places.SetValue(index + 1, gp_Pnt(*map(float, point)))
    through = GeomAPI_Interpolate(places, closed, 1e-9)
    through.Perform()
    start, tangent = gp_Pnt(), gp_Vec()
    through.Curve().D1(through.Curve().FirstParameter(), start, tangent)
    solid = pipe(wire(through.Curve()), wire(gp_Circ(gp_Ax2(start, gp_Dir(tangent)), radius)))
    return measured(solid), BRepCheck_Analyzer(solid).IsValid()


@where_installed
def cone():
    """Whether a circle's pipe that shrinks to a point is refused."""
    shrinking = Law_Linear()
    shrinking.Set(0, 1, 1, 0)
    profile = wire(gp_Circ(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 0.1))
    try:
        pipe(polygon([(0, 0, 0), (0, 0, 10)]), profile, law=shrinking)
    except Standard_ConstructionError:
        return "refused"
    return "made"


@where_installed
def samples(long, short, tolerance):
    """The points that it takes to follow an ellipse within a distance, as its mesher takes them."""
    ellipse = GeomAdaptor_Curve(Geom_Ellipse(gp_Elips(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), long, short)))
    return GCPnts_TangentialDeflection(ellipse, 1.0, tolerance).NbPoints() - 1  # the first is also the last


def wire(line):
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(line).Edge()).Wire()


def polygon(points, closed=False):
    made = BRepBuilderAPI_MakePolygon()
    for point in points:
        made.Add(gp_Pnt(*map(float, point)))
    if closed:
        made.Close()
    return made.Wire()


def volume(spine, profile, mode=None):
    """The volume of a swept solid."""
    return measured(pipe(spine, profile, mode))


def pipe(spine, profile, mode=None, law=None):
    """A swept solid, with a way to make corners or a law of its scale."""
    made = BRepOffsetAPI_MakePipeShell(spine)
    if mode is not None:
        made.SetTransitionMode(mode)
    if law is None:
        made.Add(profile)
    else:
        made.SetLaw(profile, law, False, False)
    made.Build()
    made.MakeSolid()
    return made.Shape()


def measured(solid):
    found = GProp_GProps()
    BRepGProp.VolumeProperties_s(solid, found)
    return abs(found.Mass())
