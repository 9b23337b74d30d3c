# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The rotational sweep: a contour turned about an axis in its plane, all round or in part, or along a screw."""

from dataclasses import replace
from enum import Enum
from functools import lru_cache
from math import ceil, copysign, pi, sin, sqrt, tau

import numpy as np

from ..contours import Fit, Mixed, Outline, PlanarSet, all_fitted
from ..declared.options import PREFIX, Texture, solid_option
from ..declared.parameters import ShapeError, angle, at, declared, parameter, proven, require, spelled
from ..later import later
from ..rings.ends import Cap, Flat
from ..stations.frames import Frames, require_several
from ..stations.sampling import MOST_STATIONS, Count, Sampling, Tolerance
from .operand import Operand

caps, cells = later("core.rings.caps"), later("core.stations.cells")
in_plane, parting = later("core.grids.in_plane"), later("core.rings.parting")
Chart, lengths_around = later("core.grids.chart", "Chart", "lengths_around")
affine, drawn = later("core.grids.drawn", "affine", "drawn")
Grid = later("core.grids.grid", "Grid")
joined = later("core.meshes.joining", "joined")
Mesh, require_few = later("core.meshes.mesh", "Mesh", "require_few")
finished, welded = later("core.meshes.welding", "finished", "welded")

ATTRIBUTES = "UVs and Attributes"
WHOLE = 1e-6  # of a turn: an angle so close to one closes
MOST_TURNS = 10_000
WIDEST = tau / 3  # of a step: two are no turn
LESS = f"must be less than half a turn, {pi:.6g}, where crossing is meet and the sides then sweep the same places"
OVERLAP = f"{PREFIX}beyond half a turn both sides of the contour sweep the same places, and their bodies overlap."
PULLEY = ((0.25, -0.4), (1.0, -0.4), (0.7, 0.0), (1.0, 0.4), (0.25, 0.4))


class Crossing(Enum):
    REFUSE = "A contour on both sides of the axis is refused"
    KEEP = "It is swept as it is: the sweep passes through itself on the axis"
    SPLIT = "It is cut along the axis: each side makes a body of its own"
    MEET = "It is cut along the axis, and the two sides meet there: in singular points and non-manifold edges"


@declared
class RotationalSweep(Operand):
    """A contour that turns about an axis in its plane: a solid of revolution, or a screw

    It turns as a right hand does whose thumb shows along the axis. A point of the contour on the axis is one vertex, a
    pole; an edge along the axis leaves nothing. With a pitch the contour rises along the axis as it turns.

    Examples
    --------
    The volume is the area of the contour times the way of its centroid (Pappus), but for the chords of the turn.

    >>> from math import pi, sin, tau
    >>> from sweep_addon.core.stations.sampling import Count
    >>> ring = RotationalSweep(Outline([[(1, 0), (2, 0), (2, 1), (1, 1)]]), samples=Count(12)).mesh()
    >>> round(ring.volume() / (1.5 * tau * sin(tau / 12) / (tau / 12)), 12), ring.euler_characteristic()
    (1.0, 0)
    """

    contour: PlanarSet = parameter(proven(Outline, loops=[PULLEY]), "What turns", accepts=("CURVE", "FONT"))
    angle: float = angle(tau, "How far it turns; a whole turn closes", minimum=-MOST_TURNS * tau,
                         maximum=MOST_TURNS * tau)  # fmt: skip
    pitch: float = parameter(0.0, "How far it rises along the axis in a turn", unit="length")
    samples: Sampling = parameter(Tolerance(), "How many contours stand round the axis")
    axis_point: tuple[float, float] = parameter(
        (0.0, 0.0), "A point of the axis, in the contour's plane", unit="length", group="Axis"
    )
    axis_direction: tuple[float, float] = parameter((0.0, 1.0), "Where the axis runs", group="Axis")
    upright: bool = parameter(False, "Stand the contour's plane upright, its y axis along z", group="Axis")
    crossing: Crossing = parameter(Crossing.REFUSE, "What becomes of a contour that crosses the axis", group="Axis")
    start: Cap = parameter(Flat(), "What closes the start", group="Ends")
    end: Cap = parameter(Flat(), "What closes the end", group="Ends")
    texture: Texture = parameter(Texture.LENGTHS, "How texture coordinates are measured", group=ATTRIBUTES)
    attributes: bool = parameter(True, "Keep u, v and arc_length of each vertex for materials", group=ATTRIBUTES)
    fit: Fit = parameter(Fit.INSCRIBED, "How the mesh stands to the true shape: inscribed, or of the true volume")
    regularize: bool = parameter(False, "Keep only the parts that are solid, closed and manifold")
    make_solid: bool = solid_option()

    def check(self):
        """Refuse no angle or more than a turn without a pitch, and an axis without a direction."""
        require(self.angle, "must not be 0", self.angle, "angle")
        once = self.pitch or abs(self.angle) <= tau * (1 + WHOLE)
        require(once, f"must be at most a turn, {tau:.6g}, without a pitch", self.angle, "angle")
        require(any(self.axis_direction), "must have a length", list(self.axis_direction), "axis_direction")
        boxed = self.fit is Fit.CIRCUMSCRIBED
        require(not boxed, "must be inscribed or area-true for a rotational sweep", "circumscribed", "fit")

    @classmethod
    def beside(cls, contour):
        """The sweep of a contour about the y axis or, where that would cross it, about a line along its left side.

        >>> from sweep_addon.core.contours import Circle
        >>> RotationalSweep.beside(Circle(0.5)).axis_point
        (-0.5, 0.0)
        """
        x = np.concatenate([section.points[:, 0] for section in all_fitted(contour, Fit.INSCRIBED)])
        crosses = x.min() < 0 < x.max()
        return cls(contour, axis_point=(float(x.min()), 0.0)) if crosses else cls(contour)

    @property
    def closed(self):
        """Whether the end is the start."""
        return not self.pitch and abs(self.angle) >= tau * (1 - WHOLE)

    @property
    def turn(self):
        """The angle, exactly a turn where it closes."""
        return copysign(tau, self.angle) if self.closed else self.angle

    def mesh(self, dtype=np.float64):
        """The surface as a mesh: closed, manifold and outward unless an end is open.

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
            Where the contour crosses the axis and that is refused, where it runs along the axis and there is a pitch,
            where its sides are to meet there but sweep the same places, or where there would be too many vertices.

        Examples
        --------
        A ball is a half disc turned round: two poles, and rings of eight between them.

        >>> half = Outline([[(0, -1), (0, 1)]], bulges=[(1, 0)], tolerance=0.1)
        >>> len(half.section().points), RotationalSweep(half, samples=Count(8)).mesh().vertices.shape
        (7, (42, 3))
        """
        if self.make_solid:
            return self.solid().astype(dtype)
        return self.surface(dtype)

    def surface(self, dtype=np.float64):
        """The surface that the contour leaves, also where it meets itself: a `Mesh`."""
        mesh, mixed = self.whole(dtype)
        turned = ceil(abs(self.turn) / cells.WIDEST_BEND)
        return finished(
            mesh, mixed, self.regularize, lambda few: replace(self, samples=Count(turned + few)).whole()[0], turned
        )

    def whole(self, dtype=np.float64):
        """The mesh, solid or not, and whether it may be of mixed dimension."""
        sections, bodies = self.sections(), self.bodies(dtype)
        mixed = isinstance(self.contour, Mixed) or self.crossing is Crossing.MEET and len(sections) > 1
        drawn_as = (self.outward(section) for section in sections)
        mesh = welded(bodies, [section.points * (side, 1) for section, side in drawn_as]) if mixed else joined(bodies)
        if self.crossing is Crossing.SPLIT and abs(self.angle) > pi * (1 + WHOLE) and self.sides_overlap(sections):
            mesh = replace(mesh, told=(*mesh.told, OVERLAP))
        return mesh, mixed

    def bodies(self, dtype=np.float64):
        """The meshes of the sections that turn, each on its own."""
        sections = self.sections()
        turns = self.turns(sections)
        require_few(len(turns) * sum(len(section.points) for section in sections), "samples")
        return [self.body(section, turns, dtype) for section in sections]

    def self_intersections(self):
        """Where the sweep meets itself, and up to which size it does not.

        Returns
        -------
        Places
            A sequence of places, empty when the sweep is clean or made a solid, with ``largest_safe_size``.

        Examples
        --------
        A screw whose thread is higher than its pitch, and one whose thread is as high as it is 0.8 times as large:

        >>> thread = Outline([[(1, 0), (2, 0), (2, 0.5), (1, 0.5)]])
        >>> screw = RotationalSweep(thread, angle=4 * tau, pitch=0.4)
        >>> places = screw.self_intersections()
        >>> {place.kind for place in places} <= {"global", "ends"}, round(places.largest_safe_size, 4)
        (True, 0.8)
        """
        from ..self_intersection.places import Places
        from ..self_intersection.screws import of_rotation

        return Places(()) if self.make_solid else of_rotation(self)

    def solid(self, progress=None):
        """The boundary of all points that the contour visits, as one valid solid: each place counts once.

        Parameters
        ----------
        progress : callable, optional
            Is told which part is done, from 0 to 1; what it raises ends the work.

        Returns
        -------
        Mesh
            Closed, manifold and outward, in metres; faces that nothing has cut are as they were. Where the sweep does
            not meet itself it is the surface.

        Raises
        ------
        ShapeError
            For an open surface, a contour that turns too much from sample to sample, or where manifold3d is missing.

        Examples
        --------
        >>> thread = Outline([[(1, 0), (2, 0), (2, 0.5), (1, 0.5)]])
        >>> screw = RotationalSweep(thread, angle=2 * tau, pitch=0.4)
        >>> screw.solid().volume() < screw.surface().volume()
        True
        """
        from ..resolving.of_shapes import about_an_axis  # asks manifold3d

        return about_an_axis(self, progress)

    def sections(self):
        """The sections that turn, x across the axis and y along it: one unless the contour is mixed or is split."""
        across = (self.axis_point, self.axis_direction)
        sections = about_axis(self.contour, self.fit, *across, self.crossing, bool(self.pitch))
        for section in sections:
            solid = section.closed or isinstance(self.contour, Mixed)  # an open outline may run along the axis
            along = solid and self.pitch and len(between_poles(section))
            cut = self.crossing in (Crossing.SPLIT, Crossing.MEET) and across_axis(sections)
            kept = "must be keep where there is a pitch, by which the cut along the axis would slide in itself"
            require(not (along and cut), kept, spelled(self.crossing), "crossing")
            require(not along, "must be 0 for a contour with an edge along the axis", self.pitch, "pitch")
        apart = self.crossing is not Crossing.MEET or abs(self.angle) < pi * (1 - WHOLE)
        require(apart or not self.sides_overlap(sections), LESS, self.angle, "angle")
        return sections

    def sides_overlap(self, sections):
        """Whether what is on both sides of the axis sweeps the same places, from half a turn on."""
        with at("contour"):
            return not self.pitch and parting.overlapping(sections)

    def body(self, section, turns, dtype):
        """The mesh of one section that turns so far."""
        (section, side), rings, told = self.outward(section), self.rings(turns), ()
        if not (self.pitch or section.points[:, 0].any()):
            return in_plane.flat(section, rings[:, 0], self.texture, self.attributes, dtype)
        if all(parting.sides(section)):
            told = (f"{PREFIX}the contour crosses the axis, and the sweep passes through itself there.",)
        rings[1] *= side * self.wider(len(turns) - (not self.closed))
        poles = () if self.pitch else np.flatnonzero(section.points[:, 0] == 0).tolist()
        grid = Grid(
            rings=len(turns),
            tips=(),
            closed=self.closed,
            creases=(),
            offsets=tuple(section.offsets.tolist()),
            sharp=tuple(np.flatnonzero(section.sharp).tolist()),
            caps=caps.at_ends((section, section), (self.start, self.end), (self.closed, self.closed), tuple(poles)),
            gaps=tuple(np.union1d(between_poles(section), section.gaps).tolist()),
            poles=tuple(poles),
        )
        middles = (section.points + section.points[section.following])[:, 0] / 2
        weights = section.edge_lengths if section.edge_lengths.any() else np.ones(len(middles))  # of single points
        radius = weights @ np.abs(middles) / weights.sum()
        way = sqrt(radius**2 + (self.pitch / tau) ** 2)  # in a radian, of the contour's mean
        around = lengths_around(section, np.ones(2))
        flat = (section.points, section.points)
        s, total = np.abs(turns) * way, abs(self.turn) * way
        chart = Chart(grid, turns, s, total, around, flat, self.texture, self.attributes)
        return Mesh(drawn(grid, affine(section.points), rings, dtype), grid.topology(), chart, told)

    def outward(self, section):
        """The section as it is drawn, and 1, or -1 where it is mirrored as it turns to the back of its plane."""
        back = (section.centroid[0] > 0) == (self.angle > 0)
        return (section.mirrored, -1) if back else (section, 1)

    def turns(self, sections):
        """The angles at which contours stand: (n,) float array; a whole turn is not among them where it closes."""
        size = abs(self.turn)
        if isinstance(self.samples, Count):
            steps = self.samples.contours - (not self.closed)
            least = ceil(size / WIDEST - WHOLE)
            sentence = f"must be at least {least + (not self.closed)} for this angle"
            require(steps >= least, sentence, self.samples.contours, "samples.contours")
        else:
            radius = max(float(np.abs(section.points[:, 0]).max()) for section in sections)
            wanted = size / min(cells.chord_angle(self.samples.chord, radius), cells.WIDEST_BEND)
            most = f"must be larger: this turn takes {wanted:,.0f} contours of {MOST_STATIONS:,} at most"
            require(wanted <= MOST_STATIONS, most, self.samples.chord, "samples.chord")
            steps = max(ceil(wanted - WHOLE), 1)
        return np.linspace(0, self.turn, steps + 1)[: steps if self.closed else None]

    def rings(self, turns):
        """The place of the axis' point at each turn, and the axes across and along it: (3, n, 3) float array."""
        along = np.append(self.axis_direction, 0.0) / np.hypot(*self.axis_direction)
        across, down = np.array((along[1], -along[0], 0.0)), np.array((0.0, 0.0, -1.0))
        radial = np.cos(turns)[:, None] * across + np.sin(turns)[:, None] * down
        place = np.append(self.axis_point, 0.0) + (self.pitch / tau * turns)[:, None] * along
        rings = np.stack((place, radial, np.broadcast_to(along, place.shape)))
        return rings[..., [0, 2, 1]] * (1, -1, 1) if self.upright else rings

    def wider(self, steps):
        """By what the contour's distance from the axis grows so that sectors are as large as those of a circle."""
        step = abs(self.turn) / steps
        return sqrt(step / sin(step)) if self.fit is Fit.AREA_TRUE else 1.0

    def frames(self, most=100):
        """The frames and contours at the stations, or at places spread evenly among them.

        Parameters
        ----------
        most : int
            Of places.

        Returns
        -------
        Frames
            The trajectory is that of the contour's centroid.

        Examples
        --------
        >>> frames = RotationalSweep(samples=Count(4)).frames()
        >>> frames.e1[0].tolist(), frames.contours[0].shape
        ([0.0, 0.0, -1.0], (4, 5, 3))
        """
        require_several(most)
        sections = self.sections()
        turns = self.turns(sections)
        turns = turns[np.unique(np.linspace(0, len(turns) - 1, min(most, len(turns))).round().astype(int))]
        rings = self.rings(turns)
        contours = (np.einsum("mk,kni->nmi", affine(each.points), rings) for each in sections)
        loops = (np.split(c, each.offsets[1:-1], axis=1) for c, each in zip(contours, sections, strict=True))
        x, y = sections[0].centroid
        sense = copysign(1.0, self.angle)
        onward = np.cross(rings[2], rings[1]) * x + self.pitch / tau * rings[2]
        length = float(np.linalg.norm(onward[0]))
        points = rings[0] + x * rings[1] + y * rings[2]
        tangents = sense * (onward / length if length else np.cross(rings[2], rings[1]))
        return Frames(turns, np.abs(turns) * length, points, tangents, rings[1], rings[2], tuple(sum(loops, [])))


def between_poles(section):
    """The points of a section from which an edge runs along the axis."""
    here = section.points[:, 0] == 0
    along = here & here[section.following]
    along[section.gaps] = False
    return np.flatnonzero(along)


@lru_cache(maxsize=16)
def about_axis(contour, fit, point, direction, crossing, screw):
    """The sections of a contour as an axis sees it, x across it to its right and y along it, made once for equal ones.

    Raises
    ------
    ShapeError
        Where the contour is on both sides of the axis and that is refused, or where nothing of it is off the axis.
    """
    x, y = np.array(direction) / np.hypot(*direction)
    sections = [turned(section, np.array(point), x, y) for section in all_fitted(contour, fit)]
    sections = parting.on_axis(sections, isinstance(contour, Mixed), screw)
    across = np.concatenate([section.points[:, 0] for section in sections])
    if not across.any():
        raise ShapeError("must not lie on the axis, got only points on it", "contour")
    if crossing is Crossing.KEEP or not across_axis(sections):
        return tuple(sections if screw else map(parting.with_crossings, sections))
    if crossing is Crossing.REFUSE:
        if fit is not Fit.INSCRIBED:
            drawn = about_axis(contour, Fit.INSCRIBED, point, direction, Crossing.KEEP, screw)
            beside = "must be inscribed for a contour that touches the axis with a curve, whose edges else cross it"
            require(across_axis(drawn), beside, spelled(fit), "fit")
        low, high = float(across.min()), float(across.max())
        one_side = "must be on one side of the axis, or crossing be keep, split or meet"
        raise ShapeError(f"{one_side}, got one from {low:.6g} to {high:.6g} m across it", "contour")
    return tuple(part for section in sections for part in parting.parted(section))


def across_axis(sections):
    """Whether sections that an axis sees are on both sides of it."""
    across = [section.points[:, 0] for section in sections]
    return min(side.min() for side in across) < 0 < max(side.max() for side in across)


def turned(section, origin, x, y):
    """A section as an axis through a point sees it that runs along (x, y); equal points stay equal, to the bit."""
    right, up = (section.points - origin).T
    return replace(section, points=np.stack((right * y - up * x, right * x + up * y), axis=1))
