# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Paths from CSV and GPX files: metres as surveyors measured them, and one sentence for what is none."""

import json
from pathlib import Path

import numpy as np
import pytest

from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.stations.sampling import Count
from sweep_addon.core.trajectories import from_csv, from_gpx

DATA = Path(__file__).parents[1] / "data"
LINES = {line["name"]: line["points"] for line in json.loads((DATA / "centrelines.json").read_text())["lines"]}
FLINDERS_PEAK = -37 - 57 / 60 - 3.72030 / 3600, 144 + 25 / 60 + 29.52440 / 3600
BUNINYONG = -37 - 39 / 60 - 10.15610 / 3600, 143 + 55 / 60 + 35.38390 / 3600


def gpx(*segments, name="trk", space=' xmlns="http://www.topografix.com/GPX/1/1"'):
    """A document with one track of segments of (latitude, longitude[, elevation])."""

    def point(lat, lon, *ele):
        return f'<trkpt lat="{lat!r}" lon="{lon!r}">{"".join(f"<ele>{e}</ele>" for e in ele)}</trkpt>'

    inside = "".join(f"<trkseg>{''.join(point(*place) for place in segment)}</trkseg>" for segment in segments)
    return f"<gpx{space}><{name}>{inside}</{name}></gpx>"


@pytest.mark.parametrize("origin", [None, (*FLINDERS_PEAK, 0), (*BUNINYONG, 0)])
def test_surveyed_hills_are_as_far_apart_as_surveyors_say(origin):
    """Geocentric Datum of Australia Technical Manual: 54,972.271 m; here within a millimetre."""
    track = from_gpx(gpx([FLINDERS_PEAK, BUNINYONG]), origin)
    assert abs(track.length() - 54_972.271) < 1e-3


def test_the_bearing_from_the_origin_is_the_surveyors():
    """Of the same manual: 306 degrees 52 minutes 5.37 seconds from Flinders Peak."""
    east, north, _ = from_gpx(gpx([FLINDERS_PEAK, BUNINYONG]), (*FLINDERS_PEAK, 0)).points.values[1]
    assert abs(np.degrees(np.arctan2(east, north)) % 360 - (306 + 52 / 60 + 5.37 / 3600)) < 1e-6


@pytest.mark.parametrize(
    ("latitude", "longitude", "degree"),
    [
        (0, 0, (110_574.3, 111_319.5)),
        (45, 10, (111_131.8, 78_846.8)),
        (60, 180, (111_412.3, 55_800.0)),
        (-60, -180, (111_412.3, 55_800.0)),
    ],
)
def test_degrees_are_as_long_as_geodesists_say(latitude, longitude, degree):
    """WGS84: the length of a degree of latitude and of longitude, in metres; also across the date line."""
    east = (longitude + 0.005 + 180) % 360 - 180
    places = [(latitude - 0.005, longitude), (latitude + 0.005, longitude), (latitude, east)]
    south, north, beside = from_gpx(gpx(places), (latitude, longitude, 0)).points.values
    assert abs(100 * (north - south)[1] - degree[0]) < 0.1
    assert abs(200 * beside[0] - degree[1]) < 0.1


def test_a_recorded_path_is_where_it_was():
    """The file was made from metres on a sphere, of which the ellipsoid differs by 3e-3 at most."""
    points = from_gpx(DATA / "mountain_path.gpx").points.values
    expected = np.array(LINES["mojstrovka_mountain_path"])
    assert len(points) == len(expected)
    assert (np.abs(np.ptp(points, axis=0) / np.ptp(expected, axis=0) - 1) < 4e-3).all()
    assert points[:, 2].min() == 0


def test_segments_follow_each_other_and_elevations_are_filled_in():
    """The longest of two tracks, what else is in the document left alone."""
    track = gpx([(0, 0, 5), (0, 0.1)], [(0, 0.2, 9), (0, 0.3)], space="")
    other = "<trk><trkseg><trkpt lat='9' lon='9'/></trkseg></trk><wpt lat='1' lon='1'/>"
    points = from_gpx(track.replace("</gpx>", other + "</gpx>")).points.values
    assert points[:, 2].tolist() == [0, 2, 4, 4]
    assert (np.abs(np.diff(points[:, 0]) - 11_131.95) < 0.1).all()


def test_a_track_that_comes_back_to_its_first_point_is_closed():
    around = [(0, 0, 1), (0, 0.01, 1), (0.01, 0.01, 1)]
    assert from_gpx(gpx([*around, around[0]])).closed
    assert not from_gpx(gpx([*around, around[0]]), closed=False).closed
    assert not from_gpx(gpx(around)).closed


@pytest.mark.parametrize(
    ("text", "columns"),
    [
        ("1,2,3\n4,5,6\n", None),
        ("# made by hand\n\n 1 2   3\n4 5 6\n", None),
        ("1;2;3,0\r\n4;5;6\r\n", None),
        ('\ufefftime,z,y,x\nnoon,3,2,"1"\none,6,5,4\n', ("x", "y", "z")),
        ("t\tX\tY\tZ\n0\t1\t2\t3\n0\t4\t5\t6\n", None),
        ("0,1,2,3\n0,4,5,6\n", (2, 3, 4)),
        ("1,2,3\n,,\n4,5,6\n", None),
    ],
)
def test_tables_are_read_as_programs_write_them(text, columns, tmp_path):
    path = tmp_path / "path.csv"
    path.write_text(text, encoding="utf-8")
    for source in (text, path, str(path)):
        assert from_csv(source, columns).points.values.tolist() == [[1, 2, 3], [4, 5, 6]]


def test_two_columns_lie_on_the_ground():
    assert from_csv("x,y\n1,2\n3,4\n").points.values.tolist() == [[1, 2, 0], [3, 4, 0]]


@pytest.mark.parametrize(
    ("text", "arguments"),
    [
        ("x,y,z,radius\n1,2,3,0.5\n4,5,6,0.25\n", {}),
        ("Radius;x;y;z\n0,5;1;2;3\n0,25;4;5;6\n", {}),
        ("radius a b c\n0.5 1 2 3\n0.25 4 5 6\n", {}),
        ("x,y,z,thick\n1,2,3,0.5\n4,5,6,0.25\n", {"radius": "thick"}),
        ("0.5,1,2,3\n0.25,4,5,6\n", {"radius": 1}),
        ("x,y,z,radius\n1000,2000,3000,0.5\n4000,5000,6000,0.25\n", {"scale": 0.001}),
    ],
)
def test_a_column_of_radii_scales_the_contour(text, arguments):
    path = from_csv(text, **arguments)
    assert path.points.values == pytest.approx(np.array([[1, 2, 3], [4, 5, 6]]))
    assert path.radii.values.tolist() == [0.5, 0.25]


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ({"radius": "r"}, "radius: must be names of the first line, x, y, radius, or numbers from 1 to 3, got 'r'"),
        ({"scale": 0}, "scale: must be more than 0, got 0"),
        ({}, "radii: must all be at least 0, got -1"),
    ],
)
def test_what_is_no_radius_is_refused(arguments, sentence):
    with pytest.raises(ShapeError) as refusal:
        from_csv("x,y,radius\n0,0,1\n1,1,-1\n", **arguments)
    assert str(refusal.value) == sentence


def test_a_backbone_of_a_protein_becomes_a_tube():
    path = from_csv(DATA / "backbone.csv")
    assert path.points.values.tolist() == LINES["1A8O_A_CA"]
    assert len(GeneralizedCylinder(trajectory=path, samples=Count(500)).mesh().boundary_edges()) == 0


@pytest.mark.parametrize(
    ("text", "columns", "sentence"),
    [
        ("x,y,z\n0,0,0\n1,abc,3\n", None, "the CSV text must have numbers only, got 'abc' in line 3"),
        ("0,0,0\n1,,3\n", None, "the CSV text must have numbers only, got '' in line 2"),
        ("0,0,0\n1,nan,3\n", None, "the CSV text must have numbers only, got 'nan' in line 2"),
        ("0,0,0\n1,2\n", None, "the CSV text must have 3 numbers in line 2, got 2"),
        ("1\n2\n", None, "the CSV text must have two or three columns of numbers, got 1"),
        ("x,y,z\n", None, "the CSV text must have lines of numbers after the first, got 'none'"),
        ("\n\n", None, "the CSV text must have lines of numbers, got 'none'"),
        ("0,0,0\n", None, "the CSV text must have at least 2 different points, got 1"),
        ("0,0,0\n0,0,0\n", None, "the CSV text must have at least 2 different points, got 1"),
        ("0,0,0\n0,0,1e13\n", None, "the CSV text must have finite numbers up to 1e+12 in size, got 1e+13 in row 2"),
        ("a,b\n0,0\n", ("a", "c"), "columns: must be names of the first line, a, b, or numbers from 1 to 2, got 'c'"),
        ("0,0,0\n1,1,1\n", (1, 2, 4), "columns: must be numbers from 1 to 3, got 4"),
        ("0,0,0\n1,1,1\n", (True, 2, 3), "columns: must be numbers from 1 to 3, got True"),
        ("0,0,0\n1,1,1\n", 5, "columns: must be the two or three columns that are x, y and z, got 5"),
        ("0,0,0\n1,1,1\n", "xyz", "columns: must be the two or three columns that are x, y and z, got 'xyz'"),
        ("0,0,0\n1_0,1,1\n", None, "the CSV text must have numbers only, got '1_0' in line 2"),
        ("", None, "csv: must be CSV text or a path, got ''"),
        ("no/such.csv", None, "the CSV file no/such.csv cannot be read: No such file or directory"),
    ],
)
def test_what_is_no_table_of_points_is_refused(text, columns, sentence):
    with pytest.raises(ShapeError) as refusal:
        from_csv(text, columns)
    assert str(refusal.value) == sentence


BOMB = '<!DOCTYPE gpx [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;&a;">]><gpx><trk>&b;</trk></gpx>'


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("<gpx></gpx>", "the GPX text must have a track or a route, got 'none'"),
        (gpx([]), "the GPX text must have a track or a route of at least 2 points, got 0"),
        (gpx([(0, 0)]), "the GPX text must have a track or a route of at least 2 points, got 1"),
        (gpx([(0, 0), (0, 0)]), "the GPX text must have at least 2 different points, got 1"),
        (gpx([(0, 0), (91, 0)]), "the GPX text must have a lat between -90 and 90, got '91' at point 2"),
        (gpx([(0, 0), (1, "x")]), "the GPX text must have a lon between -180 and 180, got \"'x'\" at point 2"),
        (gpx([(0, 0, "high"), (1, 1)]), "the GPX text must have numbers as elevations, got 'high' at point 1"),
        (gpx([(0, 0, "nan"), (1, 1)]), "the GPX text must have numbers as elevations, got 'nan' at point 1"),
        ("<svg/>", "the GPX text must have a gpx element at its root, got 'svg'"),
        ("<gpx><trk></gpx>", "the GPX text must be XML, got an error: mismatched tag: line 1, column 12"),
        (BOMB, "the GPX text must have no entity declarations, got one of 'a'"),
        ("<gpx>" + "<a>" * 200, "the GPX text must have elements nested at most 100 deep, got 101"),
        ("", "gpx: must be GPX text or a path, got ''"),
        (None, "gpx: must be GPX text or a path, got None"),
        ("no/such.gpx", "the GPX file no/such.gpx cannot be read: No such file or directory"),
    ],
)
def test_what_is_no_track_is_refused(text, sentence):
    with pytest.raises(ShapeError) as refusal:
        from_gpx(text)
    assert str(refusal.value) == sentence


@pytest.mark.parametrize(
    "origin", ["x", 5, (1, 2), (1, 2, 3, 4), ("a", "b", "c"), (91, 0, 0), (0, 181, 0), (0, 0, np.nan), (None, 0, 0), {}]
)
def test_what_is_no_place_is_refused(origin):
    with pytest.raises(ShapeError) as refusal:
        from_gpx(gpx([(0, 0), (1, 1)]), origin=origin)
    assert refusal.value.key == "origin" and "must be a latitude and a longitude" in str(refusal.value)


def test_a_planned_route_counts_where_there_is_no_track():
    points = '<rtept lat="0" lon="0"/><rtept lat="0" lon="0.01"/>'
    assert from_gpx(f"<gpx><rte>{points}</rte></gpx>").length() == pytest.approx(1113.19, abs=0.01)
    both = gpx([(0, 0), (0, 0.001)]).replace("</gpx>", f"<rte>{points}</rte></gpx>")
    assert from_gpx(both).length() == pytest.approx(111.319, abs=0.001)
