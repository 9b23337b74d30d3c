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
    from OCP.BRepGProp import BRepGProp
    from OCP.BRepOffsetAPI import BRepOffsetAPI_MakePipeShell
    from OCP.gp import gp_Ax2, gp_Circ, gp_Dir, gp_Pnt
    from OCP.GProp import GProp_GProps
except ImportError:
    BRepOffsetAPI_MakePipeShell = None

ABSENT = "not installed"


def corner(path):
    """The volume of a 1 x 1 square's pipe along legs (n, 3) that begin on +x, with right corners."""
    if not BRepOffsetAPI_MakePipeShell:
        return ABSENT
    square = [(0, 0.5, 0.5), (0, -0.5, 0.5), (0, -0.5, -0.5), (0, 0.5, -0.5)]
    mode = BRepBuilderAPI_TransitionMode.BRepBuilderAPI_RightCorner
    return volume(polygon(path), polygon(square, closed=True), mode)


def ring(major, minor):
    """The volume of a circle's pipe round a circle."""
    if not BRepOffsetAPI_MakePipeShell:
        return ABSENT
    spine = wire(gp_Circ(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), major))
    return volume(spine, wire(gp_Circ(gp_Ax2(gp_Pnt(major, 0, 0), gp_Dir(0, 1, 0)), minor)))


def straight(length, outer, inner):
    """The volume of a pipe along z: that of its outer circle's solid less that of its inner one's."""
    if not BRepOffsetAPI_MakePipeShell:
        return ABSENT
    upright = gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1))
    spine = polygon([(0, 0, 0), (0, 0, length)])
    return volume(spine, wire(gp_Circ(upright, outer))) - volume(spine, wire(gp_Circ(upright, inner)))


def wire(circle):
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle).Edge()).Wire()


def polygon(points, closed=False):
    made = BRepBuilderAPI_MakePolygon()
    for point in points:
        made.Add(gp_Pnt(*map(float, point)))
    if closed:
        made.Close()
    return made.Wire()


def volume(spine, profile, mode=None):
    """The volume of a swept solid."""
    pipe = BRepOffsetAPI_MakePipeShell(spine)
    if mode is not None:
        pipe.SetTransitionMode(mode)
    pipe.Add(profile)
    pipe.Build()
    pipe.MakeSolid()
    found = GProp_GProps()
    BRepGProp.VolumeProperties_s(pipe.Shape(), found)
    return abs(found.Mass())
