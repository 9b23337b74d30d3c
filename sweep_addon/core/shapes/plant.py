# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The plant: what a turtle draws of the word that an L-system derives, as tubes or as edges."""

from enum import Enum

import numpy as np

from ..declared.coercing import coerce
from ..declared.options import Texture
from ..declared.parameters import at, count, declared, parameter, parameters, require, spelled
from ..declared.texts import Grammar, Values
from ..later import later
from .operand import Operand

growing = later("core.shapes.growing")

ATTRIBUTES = "UVs and Attributes"
TEXT = """# After Honda 1971: The Algorithmic Beauty of Plants, figure 2.6 a
#define r1 0.9       # 0.6 .. 1 how much shorter the stem goes on
#define r2 0.6       # 0.3 .. 1 how much shorter branches are
#define a0 45        # 0 .. 90 deg between stem and branch
#define a2 45        # 0 .. 90 deg between branches
#define d 137.5      # 0 .. 360 deg round the stem from branch to branch
#define wr 0.707     # 0.5 .. 1 how much thinner all goes on
#generations 10
axiom: A(0.6, 0.06)
A(l, w) -> !(w) F(l) [&(a0) B(l*r2, w*wr)] /(d) A(l*r1, w*wr)
B(l, w) -> !(w) F(l) [-(a2) $ C(l*r2, w*wr)] C(l*r1, w*wr)
C(l, w) -> !(w) F(l) [+(a2) $ B(l*r2, w*wr)] B(l*r1, w*wr)
"""
SAID = ("generations", "angle", "step", "width", "seed")  # what the text says where nobody else does


class Start(Enum):
    AUTOMATIC = "Upwards where the system has branches and turns out of the plane, else along x"
    UPWARDS = "Along z, with its left along -x, as seen from in front"
    ALONG_X = "Along x, with its left along y"

    @classmethod
    def _missing_(cls, value):
        return {None: cls.AUTOMATIC, True: cls.UPWARDS, False: cls.ALONG_X}.get(value)

    @property
    def upright(self):
        return {"AUTOMATIC": None, "UPWARDS": True, "ALONG_X": False}[self.name]


@declared
class Tubes:
    """A closed tube along each axis, mitred where it turns, as thick where a segment begins as that is wide

    >>> fork = "axiom: F(1)[+(60)F(1)]F(1)"
    >>> [Plant(fork, output=Tubes(united=united)).mesh().euler_characteristic() for united in (False, True)]
    [4, 2]
    """

    sides: int = count(8, "Points around each tube", minimum=3, maximum=256, soft_maximum=32)
    united: bool = parameter(
        False, "Make the tubes, which overlap where branches begin, one solid, as for a 3D printer; without leaves"
    )


@declared
class Edges:
    """The segments as edges, which meet where branches begin

    >>> len(Plant("axiom: F[+F]F", output=Edges()).mesh().vertices)
    4
    """

    apart = False


@declared
class Curves:
    """Each axis as a poly-line of its own, which a modifier makes a curve in Blender, as thick as its tube

    >>> len(Plant("axiom: F[+F]F", output=Curves()).mesh().vertices)
    5
    """

    apart = True


Output = Tubes | Edges | Curves


@declared
class Plant(Operand):
    """What a turtle draws of the word that an L-system derives

    A grammar replaces all modules of a word at once, step after step. The last word tells a turtle where to go: its
    segments become tubes or edges, its polygons faces, and each of its organs a point.

    Source
    ------
    Prusinkiewicz, Lindenmayer: The Algorithmic Beauty of Plants, 1990, whose notation the text has.

    Examples
    --------
    >>> koch = Plant("#angle 60\\naxiom: F--F--F\\nF -> F+F--F+F", generations=3, output="edges")
    >>> len(koch.mesh().edges)
    192
    >>> tree = Plant('''
    ... #define r 0.7   # 0.5 .. 0.9 how much shorter a branch is
    ... #angle 30
    ... axiom: F(1)
    ... F(l) : l > 0.2 -> F(l) [+ F(l*r)] [- F(l*r)]
    ... ''', generations=3, constants={"r": 0.6})
    >>> len(tree.mesh().vertices), tree.mesh().euler_characteristic()
    (432, 54)
    """

    TITLE = "L-System"

    system: Grammar = parameter(Grammar(TEXT), "The grammar, in the notation of The Algorithmic Beauty of Plants")
    generations: int = parameter(None, "Steps of the derivation; else as many as the text says", shown=10,
                                 minimum=0, maximum=1_000_000, soft_maximum=12)  # fmt: skip
    angle: float = parameter(None, "Degrees by which + - & ^ \\ / turn where they say nothing; else as the text says",
                             shown=90.0, minimum=-1e6, maximum=1e6)  # fmt: skip
    step: float = parameter(None, "How far F f G go where they say nothing; else as the text says", shown=1.0,
                            unit="length")  # fmt: skip
    width: float = parameter(None, "Diameter where no ! says another; else as the text says", shown=0.1,
                             unit="length", minimum=0.0)  # fmt: skip
    seed: int = parameter(None, "Of all random numbers; else that of the text", shown=0, minimum=0, maximum=2**31 - 1)
    constants: Values = parameter(Values(), "Values for constants of the text instead of those that it gives")
    upright: Start = parameter(Start.AUTOMATIC, "Where the turtle looks at first")
    output: Output = parameter(Tubes(), "What segments become")
    texture: Texture = parameter(Texture.LENGTHS, "How texture coordinates of tubes are measured", group=ATTRIBUTES)
    attributes: bool = parameter(
        True, "Keep radius, colour, birth, axis, order and places along and round of each vertex", group=ATTRIBUTES
    )
    budget: int = count(2_000_000, "Most modules of a word", maximum=100_000_000, soft_maximum=20_000_000)

    def check(self):
        """Refuse a text that is no grammar, and a constant that it does not have."""
        with at("system"):
            growing.read(self.system)
        system = growing.read(self.system, self.constants)
        said = {p.name: p for p in parameters(type(self))}
        followed = growing.followed(self.system)
        for name in SAID:
            if getattr(self, name) is None or name in followed:
                with at(name):
                    self.__dict__[name] = coerce(said[name], getattr(system, name))
        self.__dict__["constants"] = growing.other(self.system, self.constants)

    def mesh(self, dtype=np.float64):
        """The figure as a mesh: tubes are closed, manifold and look outwards, and those of branches begin in others.

        Parameters
        ----------
        dtype : numpy dtype
            Of the vertices, which are in metres.

        Returns
        -------
        Mesh
            With the attributes radius, colour, birth, axis, order, u, v and arc_length.

        Raises
        ------
        ShapeError
            Where the word would have more modules than the budget allows, a parameter is not finite, or where there
            would be too many vertices.

        Examples
        --------
        >>> mesh = Plant(output={"kind": "tubes", "sides": 6}).mesh()
        >>> len(mesh.boundary_edges()), int(mesh.attributes["order"].max())
        (0, 9)
        """
        return growing.mesh(self, dtype)

    def require_solid(self):
        """Refuse segments that are to be edges or curves."""
        require(isinstance(self.output, Tubes), "must be tubes for a solid", spelled(type(self.output)), "output")

    def united(self):
        """The solid of all tubes, which overlap where branches begin: as such a plant is an operand of a tree.

        Returns
        -------
        Triangles
            Closed and manifold. Leaves and other polygons, which are open, are left out.

        Raises
        ------
        ShapeError
            Where there is no tube, or manifold3d is missing.

        Examples
        --------
        >>> fork = Plant("axiom: F(1)[+(60)F(1)]F(1)").united().mesh()
        >>> len(fork.boundary_edges()), fork.euler_characteristic()
        (0, 2)
        """
        return growing.united(self)

    def axes(self):
        """The poly-lines of the figure, as curves are made of.

        Returns
        -------
        points : (r, 3) float array
            In metres, of one axis behind the other.
        radii : (r,) float array
        offsets : (a + 1,) int array
            Axis ``i`` has ``points[offsets[i]:offsets[i + 1]]``.

        Examples
        --------
        >>> points, radii, offsets = Plant("axiom: F[+F]F").axes()
        >>> points.shape, radii.tolist(), offsets.tolist()
        ((5, 3), [0.05, 0.05, 0.05, 0.05, 0.05], [0, 3, 5])
        """
        return growing.axes(self)

    @property
    def make_solid(self):
        """Whether the mesh takes so long that in a window the last one stays until it is made."""
        return growing.takes_long(self)

    def surface(self, dtype=np.float64):
        """Nothing: a figure of fewer steps would be another one."""

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
        >>> mesh = Plant().solid(parts.append)
        >>> len(mesh.vertices) > 0, parts == sorted(parts), parts[-1]
        (True, True, 1.0)
        """
        return growing.made(self, progress or (lambda part: None))
