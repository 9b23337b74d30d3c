# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The generalized cylinder: G(u, v) = t(u) + (ox(u) + Sx(u) cx(v)) e2(u) + (oy(u) + Sy(u) cy(v)) e3(u)."""

from dataclasses import replace
from functools import lru_cache
from math import cos, radians, tau

import numpy as np

from ..contours import Circle, Contour, Fit, fitted
from ..declared.options import Texture, solid_option
from ..declared.parameters import angle, at, declared, parameter, require
from ..later import later
from ..rings.ends import End, Flat, Round, Taper
from ..stations.frames import Frame, Frames, RotationMinimizing, axes, require_several
from ..stations.sampling import Count, Sampling, Tolerance, place
from ..trajectories import Helix, Trajectory
from ..variation.laws import Law
from ..variation.morph import AS_THICK, Blend, Match, Morph
from ..variation.rail import Guided, Rail
from ..vectors import dot
from .operand import Operand

caps, closing = later("core.rings.caps"), later("core.rings.closing")
Rails = later("core.variation.rails", "Rails")
Along, tapers, tips = later("core.variation.along", "Along", "tapers", "tips")
fanned = later("core.rings.bevels", "fanned")
Body, Swept = later("core.rings.body", "Body", "Swept")
Chart, lengths_around = later("core.grids.chart", "Chart", "lengths_around")
domes_of, with_domes = later("core.rings.domes", "domes_of", "with_domes")
affine, drawn = later("core.grids.drawn", "affine", "drawn")
enclosing, halfway = later("core.rings.enclosing", "enclosing", "halfway")
Grid = later("core.grids.grid", "Grid")
Mesh, require_few = later("core.meshes.mesh", "Mesh", "require_few")
leaned = later("core.rings.mitres", "leaned")
leaps, leaping_steps = later("core.stations.leaps", "leaps", "leaping_steps")
folds_told, running_backward = later("core.self_intersection.folds", "folds_told", "running_backward")
mitred, told_backward = later("core.rings.steps", "mitred", "told_backward")
arc_length = later("core.trajectories.arc_length", "arc_length")
volume_true = later("core.rings.volume_true", "volume_true")

ATTRIBUTES = "UVs and Attributes"
ROUNDING = 1e-12  # of the trajectory's coordinates: rounding leaves nothing of a smaller contour
CREASE = cos(radians(20))  # a mitre that turns more than this has an edge all round


@declared
class GeneralizedCylinder(Operand):
    """A contour that moves along a trajectory, scaled, turned and moved aside on the way

    The contour's own x and y axes lie along e2 and e3 of the trajectory's frame. Its origin, the reference point, is on
    the trajectory, or beside it by the offsets: they are measured along e2 and e3 as twist has turned them, and no
    scale stretches them. So a constant offset and an even twist carry the contour round the trajectory on a helix.

    Source
    ------
    The lecture's G(u, n) = t(u) + Sx(u) cx(n) e2(u) + Sy(u) cy(n) e3(u), where the offset is 0.

    Examples
    --------
    A tube's volume is the area of its contour times the length of its trajectory (Weyl's tube formula).

    >>> from sweep_addon.core.trajectories import Line
    >>> mesh = GeneralizedCylinder(Circle(0.5, points=64), Line(end=(0, 0, 2))).mesh()
    >>> round(mesh.volume() / (Circle(0.5, points=64).section().area * 2), 12)
    1.0
    >>> len(mesh.boundary_edges()), mesh.euler_characteristic()
    (0, 2)
    """

    contour: Contour = parameter(
        Circle(0.1), "What moves: a closed outline", others=AS_THICK, accepts=("CURVE", "FONT")
    )
    trajectory: Trajectory = parameter(Helix(), "The path along which it moves", accepts=("CURVE",))
    samples: Sampling = parameter(Tolerance(), "How many contours stand along the trajectory")
    frame: Frame = parameter(RotationMinimizing(), "The axes that carry the contour", group="Frame")
    scale_x: Law = parameter(1.0, "Scale along e2", group="Along the Path")
    scale_y: Law = parameter(1.0, "Scale along e3", group="Along the Path")
    twist: Law = angle(0.0, "Turn about the tangent", group="Along the Path")
    offset_x: Law = parameter(0.0, "Offset from the path along e2", unit="length", group="Along the Path")
    offset_y: Law = parameter(0.0, "Offset from the path along e3", unit="length", group="Along the Path")
    start: End = parameter(Flat(), "What closes the start", group="Ends")
    end: End = parameter(Flat(), "What closes the end", group="Ends")
    morph: tuple[Morph, ...] = parameter((), "What the contour becomes on the way", most=100, group="Morph")
    match: Match = parameter(Match.BY_ARC_LENGTH, "Which points of the contours belong together", group="Morph")
    blend: Blend = parameter(Blend.LINEAR, "How one contour becomes the next", group="Morph")
    rails: tuple[Rail, ...] = parameter((), "One turns the contour, two also set its width", most=2, group="Rails")
    guided: Guided = parameter(Guided.EVENLY, "How two rails scale the contour", group="Rails")
    texture: Texture = parameter(Texture.LENGTHS, "How texture coordinates are measured", group=ATTRIBUTES)
    attributes: bool = parameter(True, "Keep u, v and arc_length of each vertex for materials", group=ATTRIBUTES)
    fit: Fit = parameter(Fit.INSCRIBED, "How the mesh stands to the true shape")
    make_solid: bool = solid_option()

    def mesh(self, dtype=np.float64):
        """The surface as a mesh: closed, manifold and outward unless an end is open.

        Parameters
        ----------
        dtype : numpy dtype
            Of the vertices, which are in metres; single precision is what Blender keeps and takes half the time.

        Returns
        -------
        Mesh

        Raises
        ------
        ShapeError
            Where a law is not finite or leaves no area, or where there would be too many vertices.

        Examples
        --------
        >>> mesh = GeneralizedCylinder(Circle(0.1, points=16), samples=Count(10)).mesh()
        >>> mesh.vertices.shape, mesh.vertices.dtype.name, len(mesh.boundary_edges())
        ((160, 3), 'float64', 0)
        """
        if self.make_solid:
            return self.solid().astype(dtype)
        return self.surface(dtype)

    def surface(self, dtype=np.float64, empty=np.empty):
        """The surface that the contour leaves, also where it meets itself: a `Mesh`.

        Its vertices are drawn, when nothing can be refused any more, into what ``empty`` gives for a number of
        coordinates and a dtype.
        """
        swept = self.swept()
        grid = swept.chart.grid
        topology = grid.topology()
        vertices = drawn(grid, affine(swept.shape), swept.rings, dtype, empty)
        return Mesh(vertices, topology, swept.chart, swept.told)

    def self_intersections(self):
        """Where the sweep meets itself, and up to which size it does not.

        Returns
        -------
        Places
            A sequence of places, empty when the sweep is clean or made a solid, with ``largest_safe_size``.

        Source
        ------
        A round tube along a smooth trajectory is clean up to its reach (`sweep_addon.reach`), and what its ends leave
        of that: decided of the true shape, however coarse the mesh. Of other shapes the local test is that of the true
        shape, and the global one is decided on the faces of the mesh.

        Examples
        --------
        A pipe round a bend that is tighter than the pipe is thick:

        >>> from sweep_addon.core.trajectories import Arc
        >>> found = GeneralizedCylinder(Circle(0.5), Arc(radius=0.3)).self_intersections()
        >>> [place.kind for place in found], round(found.largest_safe_size, 9)
        (['local'], 0.3)
        """
        from ..self_intersection.cylinders import of_cylinder
        from ..self_intersection.places import Places

        return Places(()) if self.make_solid else of_cylinder(self)

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
        A disc turned about an axis inside it visits a spindle, and what both its sides visit once:

        >>> from math import pi
        >>> from sweep_addon.core.trajectories import Arc
        >>> spindle = GeneralizedCylinder(Circle(0.5, points=32), Arc(0.3, 2 * pi), Count(64))
        >>> round(spindle.solid().volume(), 3), spindle.solid().euler_characteristic()
        (1.525, 2)
        """
        from ..resolving.of_shapes import along_a_trajectory  # asks manifold3d

        return along_a_trajectory(self, progress)

    def swept(self, stations=None):
        """All that the mesh is drawn from: a `Swept`, with contours at its own stations or at others."""
        (section, change), closed = self.moving(), self.trajectory.closed
        ends = (Flat(), Flat()) if closed else (self.start, self.end)
        along, symmetry, reach, told = self.laid_out(section, change, ends)
        stations = stations or stand(self.samples, along.unchanging(), 0.0 if along.is_constant else reach)
        sectors = closing.sectors(along.rails or self.frame, along, symmetry) if closed else 0
        body = self.carried(section, along, stations, symmetry, tau * sectors / symmetry)
        true = body.ends if self.fit is Fit.INSCRIBED else (section_of(self.contour, Fit.INSCRIBED),) * 2
        domes = domes_of(ends, body, true, self.samples, self.fit)
        vertices = (len(stations.s) + sum(map(len, domes))) * len(section.points)
        require_few(vertices, "samples")
        rings, shape = body.rings, body.section.points
        if self.fit is Fit.CIRCUMSCRIBED:
            true = halfway(stations, along.rails or self.frame, along, symmetry)
            least = np.where(body.tips, 0.0, np.abs(body.scales).min(axis=1))
            leaping = leaping_steps(along.frame, stations)
            rings, shape = enclosing(stations, rings, true, body.section, least, tau * sectors / symmetry, leaping)
        rings, points, u, s = with_domes(domes, stations, rings, body)
        change, scale = body.change, np.abs(body.scales[~body.tips] if body.tips.any() else body.scales).mean(axis=0)
        if change:
            rings, shape = change.carried(rings, s / stations.total), change.shape
        grid = Grid(
            rings=len(s),
            tips=tuple(np.flatnonzero(points).tolist()),
            closed=closed,
            creases=creases(stations, along, len(domes[0])),
            offsets=tuple(body.section.offsets.tolist()),
            sharp=tuple(np.flatnonzero(change.sharp if change else body.section.sharp).tolist()),
            caps=caps.at_ends(body.ends, ends, (closed or points[0], closed or points[-1])),
            seam=closing.seam(body.section, sectors, symmetry) if closed else (),
            domes=tuple(map(len, domes)),
            gaps=tuple(body.section.gaps.tolist()),
            smooth=change.smooth(s / stations.total) if change else (),
        )
        around = change.around(scale, stations.t) if change else lengths_around(body.section, scale)
        flat = tuple(body.ends[station].points * body.scales[station] for station in (0, -1))
        chart = Chart(grid, u, s, stations.total, around, flat, self.texture, self.attributes)
        return Swept(
            stations, along, symmetry, body, rings, shape, points, chart, told + told_backward(stations) + body.told
        )

    def moving(self):
        """The section that starts the sweep, and how it changes: a `Changing`, or None."""
        if not self.morph:
            return section_of(self.contour, self.fit), None
        from ..variation.changing import changing, require_inscribed  # most contours stay as they are

        require_inscribed(self.fit)
        change = changing(self.contour, self.morph, self.match, self.blend, bool(self.trajectory.closed))
        return change.sections[0], change

    def laid_out(self, section, change, ends):
        """The laws of the sweep, in how many turns they leave the section as it is, its reach, and what is to be told.

        The reach is that of the section's farthest point from the reference point, in metres, before any scale.
        """
        told, reach = change.told if change else (), farthest(section, change)
        if self.rails and self.frame != RotationMinimizing():
            told += ("Frame: the rails turn the contour, and no frame.",)
        if self.trajectory.closed and any(isinstance(end, (Taper, Round)) for end in (self.start, self.end)):
            told += ("Ends: a closed trajectory has none, so nothing tapers and nothing is round.",)
        along, symmetry = self.along(section, change, ends)
        along, limit = bevelled(along, reach)
        return along, symmetry, reach, told + limit

    def carried(self, section, along, stations, symmetry, turn):
        """The section carried by the frame to every station: a `Body`; it meets itself turned by that angle."""
        scale_x, scale_y, twist, *offset = along.at(stations.s, stations.u)
        points, mirrored = tips(scale_x, scale_y, along.largest, stations.closed, along.scaled_by)
        e2, e3, told = axes(along.rails or self.frame, stations, twist, symmetry)
        rings = across(offset, e2, e3), e2 * scale_x[:, None], e3 * scale_y[:, None]
        change, centroid = along.change, section.centroid
        if change:
            centroid = change.centroids(stations.t)
            weighted = (change.weighted(axis, stations.t) for axis in rings[1:])
            told += folds_told(stations, rings[0], *weighted, change.support)
        else:
            longest = np.abs((scale_x, scale_y)).max()
            told += folds_told(stations, *rings, getattr(self.contour, "support", section.support), longest)
        if self.fit is Fit.AREA_TRUE:
            rings = volume_true(stations, rings, along, section.centroid, turn, farthest(section, change))
        else:
            # enclosing what a law changes over a lean would make the mesh bulge there
            still = along.is_constant and not any(along.tapers)
            leaning = farthest(section, change) if still or self.fit is Fit.INSCRIBED else 0.0
            rings = placed(stations, leaning, *rings)
        reach = farthest(section, change) * along.largest
        least = ROUNDING * np.abs(rings[0]).max()
        require(reach >= least, f"must reach {least:.3g} m or more on this trajectory", reach, "contour")
        backward = running_backward(stations, rings, centroid, any(map(np.any, offset)))
        if mirrored != backward:
            scale_x, rings[1] = -scale_x, -rings[1]
            change = change and change.mirrored
            section = change.sections[0] if change else section.mirrored
        return Body(section, change, rings, np.stack((scale_x, scale_y)).T, points, backward, told)

    def frames(self, most=100):
        """The frames and contours at places spread evenly along the trajectory.

        Parameters
        ----------
        most : int
            Of places; where the trajectory is short they are no closer than the contour is large.

        Returns
        -------
        Frames

        Examples
        --------
        >>> from sweep_addon.core.trajectories import Line
        >>> frames = GeneralizedCylinder(Circle(0.5), Line(end=(0, 0, 2))).frames()
        >>> frames.points[:, 2].tolist(), frames.e1[0].tolist(), frames.contours[0].shape
        ([0.0, 0.5, 1.0, 1.5, 2.0], [0.0, 0.0, 1.0], (5, 64, 3))
        """
        (section, change), closed = replace(self, fit=Fit.INSCRIBED).moving(), self.trajectory.closed
        require_several(most)
        along, symmetry, reach, _ = self.laid_out(
            section, change, (Flat(), Flat()) if closed else (self.start, self.end)
        )
        steps = arc_length(along.trajectory).total / max(reach * along.largest, ROUNDING)
        stations = place(along.trajectory, Count(int(np.clip(steps + (not closed), 2, most))))
        scale_x, scale_y, twist, *offset = along.at(stations.s, stations.u)
        e2, e3, _ = axes(along.rails or self.frame, stations, twist, symmetry)
        rings = placed(stations, reach, across(offset, e2, e3), e2 * scale_x[:, None], e3 * scale_y[:, None])
        shown = np.unique(np.linspace(0, len(stations.s) - 1, min(most, len(stations.s))).round().astype(int))
        rings, shape = rings[:, shown], section.points
        if change:
            rings, shape = change.carried(rings, stations.t[shown]), change.shape
        points = np.einsum("mk,kni->nmi", affine(shape), rings)
        loops = tuple(np.split(points, section.offsets[1:-1], axis=1))
        held = (stations.u, stations.s, stations.points, stations.tangent, e2, e3)
        return Frames(*(values[shown] for values in held), loops)

    def along(self, section, change, ends):
        """The laws of the sweep, and in how many turns the section is mapped to itself as they leave it."""
        with at("trajectory"):
            arc_length(self.trajectory)
        laws = (self.scale_x, self.scale_y, self.twist, self.offset_x, self.offset_y)
        along = Along(self.trajectory, *laws, tapers(*ends))
        if self.rails:
            rails = Rails(tuple(rail.path for rail in self.rails), self.guided, section, change)
            return replace(along, frame=rails, change=change, rails=rails), 1
        turns = change is None and (self.trajectory.closed or self.frame.extra_sectors)
        symmetry = along.symmetry(section) if turns else 1
        placed = None if isinstance(self.frame, RotationMinimizing) else self.frame
        return replace(along, spin=self.frame.extra(symmetry), frame=placed, change=change), symmetry


@lru_cache(maxsize=16)
def section_of(contour, fit):
    """The section of a contour, made once for equal ones, and with it what is known of it."""
    return fitted(contour, fit)


def bevelled(along, reach):
    """The laws along a path whose mitres beyond their limit are bevelled, and a sentence that says so."""
    if not len(along.trajectory.too_sharp):
        return along, ()
    path, limit = along.trajectory.limited(along.farthest(reach))
    return replace(along, trajectory=path), (limit,)


@lru_cache(maxsize=16)
def stand(samples, along, reach):
    """The stations of a sweep, the same for all contours of one reach."""
    return place(along.trajectory, samples, *along.asks(reach))


@lru_cache(maxsize=16)
def farthest(section, change):
    """How far a section, or any that it becomes, reaches from its reference point, in metres."""
    return float(np.linalg.norm(change.points if change else section.points, axis=-1).max())


def creases(stations, along, before):
    """The rings where a mitre, morph or frame turns so much that it is an edge; some stand before the first station."""
    turn = dot(stations.arrive[stations.corners], stations.leave[stations.corners])
    edges = stations.corners[turn < CREASE]
    leaping = leaps(along.frame, along.trajectory)
    if len(leaping):
        edges = np.union1d(edges, np.abs(stations.s - leaping.reshape(-1, 1)).argmin(axis=1))
    if along.change:
        met = along.change.creases(stations.total, along.largest)
        edges = np.union1d(edges, np.abs(stations.t - met[:, None]).argmin(axis=1))
    return tuple((before + edges).tolist())


def placed(stations, reach, aside, x, y):
    """The middle of each contour and its axes as they are drawn, mitred at the corners: (3, n, 3).

    A contour that reaches so far leans where it stands close to a mitre; 0 leaves it perpendicular.
    """
    rings = np.stack((aside, x, y))
    corners = stations.corners
    if len(corners):
        bevels, fans = fanned(stations, rings)
        rings = leaned(stations, rings, reach) if reach else rings
        rings[:, corners] = mitred(rings[:, corners], stations.arrive[corners], stations.leave[corners])
        rings[:, bevels] = fans
    rings[0] += stations.points
    return rings


def across(offset, e2, e3):
    """The way of each contour off the trajectory: (n, 3)."""
    x, y = offset
    return e2 * x[:, None] + e3 * y[:, None] if x.any() or y.any() else np.zeros_like(e2)
