# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The general sweep: any generator in any motion, turned, scaled and deformed on the way."""

from dataclasses import replace

import numpy as np

from ..contours import Contour
from ..contours.region import Region
from ..declared.options import Texture
from ..declared.parameters import angle, at, count, declared, parameter
from ..later import later
from ..rings.ends import Cap, Flat
from ..solids import Bracket, Solid
from ..stations.frames import FixedUp, Frames, Frenet, Parallel, RotationMinimizing, require_several
from ..stations.sampling import Sampling, Tolerance
from ..trajectories import Arc, Trajectory
from ..variation.laws import Law
from ..variation.morph import AS_THICK
from ..vectors import unit
from .generalized_cylinder import ATTRIBUTES
from .operand import Operand

arc_length = later("core.trajectories.arc_length", "arc_length")
compile = later("core.formulas.expressions", "compile")
Motion = later("core.variation.motion", "Motion")
swept = later("core.swept", "swept")

PLACES = ("x", "y", "z", "t", "u", "s")  # what a formula of a deformation may use
Generator = Contour | Region | Solid
Carried = Parallel | RotationMinimizing | Frenet | FixedUp
COARSE = 20  # cells of a solid that is made while somebody drags a slider
MOTION, DEFORMATION = "Along the Path", "Deformation"


@declared
class GeneralSweep(Operand):
    """Any generator, planar figure, surface or solid, in any motion, turned, scaled and deformed on the way

    A planar generator or a surface sweeps its surface: it stands at the start and at the end, and its boundary leaves
    the sides. A solid sweeps the set of all points that it visits, made of a distance function.

    A point of the generator is first deformed, then scaled along the generator's own axes, then turned about its x, its
    y and its z axis, and then carried by the frame: parallel to itself, or with x and y along e2 and e3.

    Source
    ------
    The lecture's "general sweeping": "arbitrary and variable shape of the generator, including set-theoretic and
    nonrigid objects", "general type motion of the generator with self-intersections allowed".

    Examples
    --------
    A square that stays parallel to itself on its way along an arc out of its plane sweeps its area times the height:

    >>> from sweep_addon.core.contours import Rectangle
    >>> from sweep_addon.core.trajectories import Formula
    >>> mesh = GeneralSweep(Rectangle(1.0, 1.0), Formula("cos(u)", "0", "sin(u)", 0.0, 1.5)).mesh()
    >>> round(mesh.volume() / float(np.sin(1.5)), 9), mesh.euler_characteristic()
    (1.0, 2)
    """

    generator: Generator = parameter(
        Bracket(),
        "What moves: a planar figure, a surface or a solid",
        others=AS_THICK,
        accepts=("MESH", "CURVE", "FONT"),
    )
    trajectory: Trajectory = parameter(Arc(), "The path along which it moves", accepts=("CURVE",))
    samples: Sampling = parameter(
        Tolerance(), "How many times a planar figure or a surface stands along the trajectory"
    )
    cells: int = count(48, "Cells across the sweep of a solid or of a region", minimum=8, maximum=512, soft_maximum=128)
    frame: Carried = parameter(Parallel(), "The axes that carry the generator", group="Frame")
    turn_x: Law = angle(0.0, "Turn about the generator's x axis", group=MOTION)
    turn_y: Law = angle(0.0, "Turn about the generator's y axis", group=MOTION)
    turn_z: Law = angle(0.0, "Turn about the generator's z axis", group=MOTION)
    scale_x: Law = parameter(1.0, "Scale along the generator's x axis", group=MOTION)
    scale_y: Law = parameter(1.0, "Scale along the generator's y axis", group=MOTION)
    scale_z: Law = parameter(1.0, "Scale along the generator's z axis", group=MOTION)
    deform_x: str = parameter("x", "Expression of x, y, z and t: where a point goes along x", group=DEFORMATION)
    deform_y: str = parameter("y", "Expression of x, y, z and t: where a point goes along y", group=DEFORMATION)
    deform_z: str = parameter("z", "Expression of x, y, z and t: where a point goes along z", group=DEFORMATION)
    start: Cap = parameter(Flat(), "What closes the start of a planar figure's or a surface's sweep", group="Ends")
    end: Cap = parameter(Flat(), "What closes the end of a planar figure's or a surface's sweep", group="Ends")
    texture: Texture = parameter(Texture.LENGTHS, "How texture coordinates are measured", group=ATTRIBUTES)
    attributes: bool = parameter(True, "Keep u, v and arc_length of each vertex for materials", group=ATTRIBUTES)

    def check(self):
        """Refuse a deformation that is no expression."""
        for name in "xyz":
            with at(f"deform_{name}"):
                compile(getattr(self, f"deform_{name}"), PLACES)

    def mesh(self, dtype=np.float64):
        """The surface as a mesh; of a solid the boundary of the set that it visits.

        Parameters
        ----------
        dtype : numpy dtype
            Of the vertices, which are in metres.

        Returns
        -------
        Mesh

        Raises
        ------
        ShapeError
            Where a law or a deformation is not finite, or where there would be too many vertices.

        Examples
        --------
        >>> from sweep_addon.core.contours import Circle
        >>> mesh = GeneralSweep(Circle(0.1, points=16), frame="rotation-minimizing").mesh()
        >>> len(mesh.boundary_edges()), mesh.euler_characteristic()
        (0, 2)
        """
        return self.swept().mesh(dtype)

    @property
    def make_solid(self):
        """Whether the mesh takes so long that in a window a coarser one stands until it is made."""
        return self.cells > COARSE and getattr(self.swept(), "is_solid", False)

    def surface(self, dtype=np.float64):
        """The mesh with so few cells that it is made at once."""
        return replace(self, cells=min(self.cells, COARSE)).mesh(dtype)

    def solid(self, progress=None):
        """The boundary of all that the generator visits; of a surface the mesh, though it may cross itself.

        Parameters
        ----------
        progress : callable, optional
            Is told which part is done, from 0 to 1; what it raises ends the work.

        Returns
        -------
        Mesh

        Examples
        --------
        >>> from sweep_addon.core.solids import Block
        >>> from sweep_addon.core.trajectories import Line
        >>> parts = []
        >>> bar = GeneralSweep(Block(0.5, 0.5, 0.5), Line(), cells=24).solid(parts.append)
        >>> bar.euler_characteristic(), parts == sorted(parts), 0 < parts[-1] <= 1
        (2, True, True)
        """
        return self.swept().solid(progress)

    def self_intersections(self):
        """Where the sweep of a planar figure or of a surface meets itself; that of a solid never does.

        Returns
        -------
        Places
            A sequence of places, empty when the sweep is clean; the largest safe size is not known.

        Examples
        --------
        >>> from sweep_addon.core.contours import Rectangle
        >>> from sweep_addon.core.trajectories import Line
        >>> len(GeneralSweep(Rectangle(1.0, 1.0), Line()).self_intersections())
        0
        """
        return self.swept().self_intersections()

    def frames(self, most=100):
        """The axes of the generator, and its outlines, at places spread evenly along the trajectory.

        Parameters
        ----------
        most : int
            Of places.

        Returns
        -------
        Frames
            With the generator's z axis as e1, its x axis as e2 and its y axis as e3; a solid is shown as its box.

        Examples
        --------
        >>> from sweep_addon.core.contours import Rectangle
        >>> frames = GeneralSweep(Rectangle(1.0, 1.0), turn_z="pi*t").frames(5)
        >>> frames.e2.round(9)[[0, -1]].tolist(), frames.contours[0].shape
        ([[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]], (5, 4, 3))
        """
        require_several(most)
        poses = self.motion.at(np.linspace(0.0, arc_length(self.trajectory).total, most))
        e2, e3, e1 = (unit(poses.matrix[..., axis]) for axis in range(3))
        return Frames(poses.u, poses.s, poses.origin, e1, e2, e3, self.swept().outlines(poses))

    def swept(self):
        """The generator's sweep by its kind: of a planar figure, of a surface or of a solid."""
        return swept(self)

    @property
    def motion(self):
        """The `Motion` of the generator."""
        turns, scales = (tuple(getattr(self, f"{what}_{axis}") for axis in "xyz") for what in ("turn", "scale"))
        formulas = tuple(getattr(self, f"deform_{axis}") for axis in "xyz")
        return Motion(self.trajectory, self.frame, turns, scales, formulas)
