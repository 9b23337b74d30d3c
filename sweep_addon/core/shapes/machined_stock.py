# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Machined stock: what a program of a milling machine leaves of a block, and whether that is the part."""

import numpy as np

from ..declared.parameters import declared, parameter
from ..declared.texts import Program
from ..later import later
from ..machining.stock import Around, Stock
from ..machining.tools import BallNose, Numbered, Tool
from ..solids import Triangles
from .operand import Operand

milling = later("core.shapes.milling")

TEXT = """(A rosette: circles through the middle, each a little deeper)
G21 G90 F600
G0 X0 Y0 Z5
G1 Z0
#1 = 0
o1 repeat [24]
  G3 X0 Y0 Z[-#1 / 12] I[12 * cos[#1 * 15]] J[12 * sin[#1 * 15]]
  #1 = [#1 + 1]
o1 endrepeat
G0 Z5
M2
"""


@declared
class Unknown:
    """No part: what is left is compared with nothing

    >>> Unknown().mesh() is None
    True
    """

    def mesh(self):
        return None


Part = Unknown | Triangles


@declared
class MachinedStock(Operand):
    """What a program of a milling machine leaves of a block of material

    The tool sweeps along the program's moves, and all that it visits is removed. Lengths are in metres, as those of
    every shape; a program says itself whether its numbers are millimetres (G21) or inches (G20), and of one that does
    not they are millimetres. Its zero is that of the shape. Heights are exact at places in rows and columns, a cell
    apart.

    Source
    ------
    The lecture's "numerically controlled machining": the set-theoretic difference between a sample and a swept solid.

    Examples
    --------
    >>> program = "G21 F300\\nG0 X0 Y0 Z5\\nG1 Z-2\\nX20\\nG0 Z5"
    >>> slot = MachinedStock(program, tool={"kind": "flat-end", "diameter": 0.006}, cell=0.0002)
    >>> mesh = slot.mesh()
    >>> mesh.euler_characteristic(), len(mesh.boundary_edges())
    (2, 0)
    """

    program: Program = parameter(Program(TEXT), "The program: RS-274, or G-code, in the dialect of LinuxCNC")
    tool: Tool = parameter(BallNose(), "The tool")
    tools: tuple[Numbered, ...] = parameter((), "Tools that the program calls by T, of which others are the one above",
                                            most=100, group="Tools")  # fmt: skip
    stock: Stock = parameter(Around(), "The block before it is cut")
    cell: float = parameter(0.0, "Distance of the places where heights are known; 0 is a 256th of the longer side",
                            unit="length", minimum=0.0)  # fmt: skip
    tolerance: float = parameter(1e-5, "How far chords may be from arcs", unit="length", above=0.0)
    part: Part = parameter(Unknown(), "The desired part, with which what is left is compared", accepts=("MESH",),
                           group="Part")  # fmt: skip
    # arcs by chords and rounded numbers cut less away than this
    allowance: float = parameter(2e-5, "How much may be cut away of the part before that is told", unit="length",
                                 minimum=0.0, group="Part")  # fmt: skip
    attributes: bool = parameter(True, "Keep depth, line and deviation from the part of each vertex",
                                 group="UVs and Attributes")  # fmt: skip

    def check(self):
        """Refuse a text that is no program, and two tools of one number."""
        milling.check(self)

    def mesh(self, dtype=np.float64):
        """What is left, as a closed mesh that looks outwards; where the stock is cut through it has a hole.

        Parameters
        ----------
        dtype : numpy dtype
            Of the vertices, which are in metres.

        Returns
        -------
        Mesh
            With the attributes depth, below the top of the stock in metres; line, which cut there last, 0 where none
            did; and deviation, how high it stands above the part, in metres. ``told`` says what is wrong.

        Raises
        ------
        ShapeError
            Where the program is refused, nothing is left, or there would be too many places.

        Examples
        --------
        >>> mesh = MachinedStock(cell=0.001).mesh()
        >>> round(float(mesh.attributes["depth"].max()), 6), int(mesh.attributes["line"].max())
        (0.001914, 7)
        """
        return milling.mesh(self, dtype)

    def verify(self, part=None):
        """Whether the program makes the part: see `sweep_addon.machining.verify`.

        Parameters
        ----------
        part : Mesh, shape, solid or tree, optional
            Instead of that of the stock.

        Returns
        -------
        Verification

        Examples
        --------
        >>> found = MachinedStock(cell=0.001).verify()
        >>> found.correct, found.sentences()
        (True, ('There was no part to compare with.',))
        """
        return milling.verify(self, part)

    @property
    def make_solid(self):
        """Whether the mesh takes so long that in a window the last one stays until it is made."""
        return milling.takes_long(self)

    def surface(self, dtype=np.float64):
        """Nothing: stock that is cut by some of the moves would be another."""

    def solid(self, progress=None):
        """The mesh, and how far it is.

        Parameters
        ----------
        progress : callable, optional
            Is told which part is done, from 0 to 1; what it raises ends the work.

        Returns
        -------
        Mesh

        Examples
        --------
        >>> parts = []
        >>> mesh = MachinedStock(cell=0.001).solid(parts.append)
        >>> len(mesh.boundary_edges()), parts == sorted(parts)
        (0, True)
        """
        return milling.made(self, progress)
