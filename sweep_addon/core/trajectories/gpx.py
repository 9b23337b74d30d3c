# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trajectories from GPX files, as GPS receivers and route planners write them.

The format is three attributes of one element, so the standard library's parser reads it; entities are refused.
"""

import numpy as np

from ..declared.documents import about, content, parsed, plain
from ..declared.parameters import LARGEST, ShapeError, require
from .table import LARGEST_FILE, number, through

EQUATOR, FLATTENING = 6_378_137.0, 1 / 298.257223563  # WGS84: metres
SQUARED = FLATTENING * (2 - FLATTENING)  # of the eccentricity


def from_gpx(text_or_path, origin=None, closed=None):
    """Make a smooth trajectory through a track of a GPX file, in metres.

    Parameters
    ----------
    text_or_path : str or Path
        The text of a document, or the path of a file of at most 50 MB. Of several tracks the one with most points is
        taken, its segments one after another; of a document without tracks, the route with most points.
    origin : (latitude, longitude, elevation), optional
        In degrees and metres, what becomes (0, 0, 0), so that several files share one map; without it the middle of the
        track, and its lowest point.
    closed : bool, optional
        Whether the last point leads back to the first; without it, where they are the same.

    Returns
    -------
    Sampled
        x to the east, y to the north, z up. Points that repeat the one before them count once. Where an elevation is
        missing, it is taken evenly between its neighbours; a track without any is level.

    Raises
    ------
    ShapeError
        For what is no GPX, for a document without a track or a route, for places that are none.

    Source
    ------
    Azimuthal equidistant projection about the origin: true to the WGS84 ellipsoid in direction and in distance from it,
    to a millionth within 50 km.

    Examples
    --------
    >>> track = from_gpx('<gpx><trk><trkseg><trkpt lat="0" lon="0"/><trkpt lat="0" lon="0.01"/></trkseg></trk></gpx>')
    >>> round(track.length(), 2)
    1113.19
    """
    if origin is not None:
        origin = required_place(origin)
    data, subject = content(text_or_path, "GPX", "<", LARGEST_FILE)
    with about(subject):
        places = track(parsed(data))
        if origin is None:
            origin = (*middle(places), places[:, 2].min())
        east_north = projected(places, origin)
        return through(np.column_stack((east_north, places[:, 2] - origin[2])), closed)


def required_place(origin):
    """A latitude, longitude and elevation as (3,) floats; what is none is refused."""
    try:
        numbers = np.asarray(origin, dtype=float)
    except (TypeError, ValueError):
        numbers = np.empty(0)
    sentence = "must be a latitude and a longitude of at most 90 and 180 degrees, and an elevation"
    require(numbers.shape == (3,) and (np.abs(numbers) <= (90, 180, LARGEST)).all(), sentence, origin, "origin")
    return numbers


def track(root):
    """Latitude, longitude and elevation of the points of the longest track, or where there is none, route: (n, 3)."""
    require(plain(root) == "gpx", "must have a gpx element at its root", plain(root))
    tracks = [element for element in root if plain(element) == "trk"]
    tracks = tracks or [element for element in root if plain(element) == "rte"]
    require(tracks, "must have a track or a route", "none")
    tracks = [[point for point in element.iter() if plain(point) in ("trkpt", "rtept")] for element in tracks]
    points = max(tracks, key=len)
    require(len(points) >= 2, "must have a track or a route of at least 2 points", len(points))
    found = np.array([place(index, element) for index, element in enumerate(points, 1)])
    known = ~np.isnan(found[:, 2])
    index = np.arange(len(found))
    found[:, 2] = np.interp(index, index[known], found[known, 2]) if known.any() else 0.0
    return found


def place(index, element):
    """Latitude, longitude and elevation of one point; an elevation that is missing is NaN."""
    read = []
    for name, most in (("lat", 90), ("lon", 180)):
        value = number(element.get(name, ""))
        if value is None or abs(value) > most:
            got = repr(element.get(name, "nothing")[:40])
            raise ShapeError(f"must have a {name} between -{most} and {most}, got {got} at point {index}")
        read.append(value)
    written = next((part.text or "" for part in element if plain(part) == "ele"), None)
    height = np.nan if written is None else number(written)
    if height is None:
        raise ShapeError(f"must have numbers as elevations, got {written[:40]!r} at point {index}")
    return *read, height


def middle(places):
    """Latitude and longitude in the middle of some places."""
    x, y, z = geocentric(places).mean(axis=0)
    return np.degrees(np.arctan2(z, np.hypot(x, y) * (1 - SQUARED))), np.degrees(np.arctan2(y, x))


def geocentric(places):
    """Where places are from the Earth's centre in metres, at sea level: (n, 3)."""
    latitude, longitude = np.radians(places[:, 0]), np.radians(places[:, 1])
    radius = EQUATOR / np.sqrt(1 - SQUARED * np.sin(latitude) ** 2)
    out = radius * np.cos(latitude)
    up = (1 - SQUARED) * radius * np.sin(latitude)
    return np.stack((out * np.cos(longitude), out * np.sin(longitude), up), axis=1)


def projected(places, origin):
    """Metres to the east and to the north of an origin: (n, 2)."""
    latitude, longitude = np.radians(origin[:2])
    away = geocentric(places) - geocentric(np.array([origin]))
    steep, level = np.sin(latitude), np.cos(latitude)
    toward = np.cos(longitude), np.sin(longitude)
    east = away @ (-toward[1], toward[0], 0.0)
    north = away @ (-steep * toward[0], -steep * toward[1], level)
    chord = np.linalg.norm(away, axis=1)
    radius = EQUATOR * np.sqrt(1 - SQUARED) / (1 - SQUARED * steep**2)  # the mean of both curvatures
    arc = 2 * radius * np.arcsin(np.clip(chord / (2 * radius), 0.0, 1.0))
    flat = np.hypot(east, north)
    return np.stack((east, north), axis=1) * (arc / np.where(flat > 0, flat, 1.0))[:, None]
