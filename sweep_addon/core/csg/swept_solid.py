# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sweep of a solid as a node of a tree: all points that a shape or a tree visits as it moves."""

from ..declared.parameters import count, declared, parameter
from ..later import later
from ..shapes.operand import Operand
from ..solids import Block
from ..trajectories import Trajectory
from .rigid import RigidMotion

bent_facets = later("core.meshes.facets", "bent_facets")
closed_mesh = later("core.csg.meshes", "closed_mesh")
GeneralSweep = later("core.shapes.general_sweep", "GeneralSweep")
Triangles = later("core.solids", "Triangles")
line, shared_hash, shared_equal = (later("core.csg.shared", name) for name in ("line", "hashed", "equal"))

Moving = Trajectory | RigidMotion


@declared
class SweptSolid(Operand):
    """All points that a shape, a solid or a tree visits as it moves

    Along a trajectory it stays parallel to itself; a `RigidMotion` turns it too.

    Source
    ------
    Hui: Solid modelling with sweep-CSG representation, 1994: the internal node "sweep". Its mesh is that of
    `GeneralSweep`.

    Examples
    --------
    >>> from sweep_addon.core.solids import Cylinder
    >>> from sweep_addon.core.trajectories import Line
    >>> slot = SweptSolid(Block() - Cylinder(0.1, 1.0), Line(end=(2, 0, 0)))
    >>> print(slot)
    sweep(Block - Cylinder)
    """

    solid: Operand = parameter(Block(), "What moves")
    motion: Moving = parameter(RigidMotion(), "How it moves")
    cells: int = count(48, "Cells across the mesh", minimum=8, maximum=512, soft_maximum=128)

    def mesh(self, dtype=None, progress=None):
        """The boundary of the set that it visits as a `Mesh` of triangles, in metres."""
        mesh = self.sweep().solid(progress)
        return mesh if dtype is None else mesh.astype(dtype)

    def sweep(self, generator=None):
        """The same as a `GeneralSweep` of the solid's mesh, or of a generator that stands for that."""
        rigid = self.rigid
        turns = {f"turn_{axis}": getattr(rigid, f"turn_{axis}") for axis in "xyz"}
        generator = generator or Triangles(*bent_facets(closed_mesh(self.solid)))
        return GeneralSweep(generator, rigid.trajectory, cells=self.cells, frame=rigid.frame, **turns)

    @property
    def rigid(self):
        """The motion, that along a trajectory alone as one that does not turn."""
        return self.motion if isinstance(self.motion, RigidMotion) else RigidMotion(self.motion)

    def __hash__(self):
        return shared_hash(self)

    def __eq__(self, other):
        return shared_equal(self, other)

    def __str__(self):
        return line(self)
