# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A sweep primitive of two leaves: a contour, and the transformation that sweeps it."""

from functools import lru_cache
from math import tau

from ..contours import Contour, Rectangle
from ..declared.parameters import angle, declared, length, parameter
from ..later import later
from ..shapes.operand import Operand
from ..trajectories import Trajectory
from .rigid import RigidMotion

GeneralSweep = later("core.shapes.general_sweep", "GeneralSweep")
GeneralizedCylinder = later("core.shapes.generalized_cylinder", "GeneralizedCylinder")
RotationalSweep = later("core.shapes.rotational_sweep", "RotationalSweep")
TranslationalSweep = later("core.shapes.translational_sweep", "TranslationalSweep")


@declared
class Translation:
    """Out of the contour's plane, straight up or obliquely

    >>> SweptContour(Rectangle(1.0, 2.0), Translation(3.0)).mesh().volume()
    6.0
    """

    height: float = length(1.0, "How far, measured out of the plane")
    direction: tuple[float, float, float] = parameter((0.0, 0.0, 1.0), "Where to")


@declared
class Rotation:
    """About an axis in the contour's plane, rising along it where it is a screw

    >>> ring = SweptContour(Rectangle(1.0, 1.0), Rotation(axis_point=(-2.0, 0.0)))
    >>> ring.sweep().mesh().euler_characteristic()
    0
    """

    angle: float = angle(tau, "How far it turns")
    pitch: float = parameter(0.0, "How far it rises along the axis in a turn", unit="length")
    axis_point: tuple[float, float] = parameter((0.0, 0.0), "A point of the axis", unit="length")
    axis_direction: tuple[float, float] = parameter((0.0, 1.0), "Where the axis runs")


Transformation = Translation | Rotation | RigidMotion | Trajectory


@declared
class SweptContour(Operand):
    """A contour and a transformation that sweeps it: two leaves, each of which may be a leaf of other primitives too

    Along a trajectory it makes a generalized cylinder, by a `RigidMotion` a general sweep.

    Source
    ------
    Hui: Solid modelling with sweep-CSG representation, 1994: "the leaf nodes are sweeping contour or sweep
    transformation defining together a sweep primitive", as the lecture has it.

    Examples
    --------
    Two contours swept alike, and the difference of what they sweep:

    >>> from sweep_addon.core.trajectories import Line
    >>> way = Line(end=(0, 0, 2))
    >>> pipe = SweptContour(Rectangle(1.0, 1.0), way) - SweptContour(Rectangle(0.5, 0.5), way)
    >>> print(pipe)
    (Rectangle * Line) - (Rectangle * Line)
    """

    contour: Contour = parameter(Rectangle(1.0, 1.0), "What moves: a closed outline", accepts=("CURVE", "FONT"))
    transformation: Transformation = parameter(Translation(), "How it moves", accepts=("CURVE",))

    def sweep(self):
        """The same as a shape, which has all parameters of its kind."""
        return made(self.contour, self.transformation)

    def mesh(self, dtype=None):
        """The surface as a `Mesh`, in metres."""
        mesh = self.sweep().mesh()
        return mesh if dtype is None else mesh.astype(dtype)

    def solid(self, progress=None):
        """The boundary of all points that the contour visits as a `Mesh`, in metres."""
        return self.sweep().solid(progress)

    def __str__(self):
        return f"{type(self.contour).__name__} * {type(self.transformation).__name__}"


@lru_cache(maxsize=64)
def made(contour, by):
    """The shape that a contour makes by a transformation."""
    if isinstance(by, Translation):
        return TranslationalSweep(contour, by.height, direction=by.direction)
    if isinstance(by, Rotation):
        axis = {"axis_point": by.axis_point, "axis_direction": by.axis_direction}
        return RotationalSweep(contour, by.angle, by.pitch, **axis)
    if isinstance(by, RigidMotion):
        turns = {f"turn_{axis}": getattr(by, f"turn_{axis}") for axis in "xyz"}
        return GeneralSweep(contour, by.trajectory, frame=by.frame, **turns)
    return GeneralizedCylinder(contour, by)
