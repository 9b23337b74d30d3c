# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A job file is read with its references and its picture, or refused with file, line and key."""

import importlib.util
import os
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import sweep_addon as sw
from sweep_addon.batch import job as jobs
from sweep_addon.core.declared.forms import toml
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.shapes.kinds import GeneralizedCylinder

START = 'version = 1\nkind = "generalized-cylinder"\n'
SQUARE = '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H10V10H0Z"/></svg>'
GPX = '<gpx><trk><trkseg><trkpt lat="1" lon="2">{}</trkpt><trkpt lat="1" lon="2">{}</trkpt></trkseg></trk></gpx>'


def written(folder, text, name="job.toml"):
    path = folder / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


@pytest.mark.parametrize(
    "text, sentence",
    {
        START + "\nradios = 1": ":4: radios: is no parameter of GeneralizedCylinder, which has contour, ",
        START + "[contour]\nkind = 'circle'\nradius = '3 cm'": (
            ":5: contour.radius: must be a number of metres, got '3 cm'"
        ),
        START + "[contour]\nkind = 'rectangle'\nwidth = 1\nheight = 1\nrounding = 2": (
            ":7: contour.rounding: must be at most 0.5, half the shorter side, got 2"
        ),
        START + "twist = '90 degrees'": (
            ":3: twist: must be a number of radians or an expression of u, t, s: an operator is missing at "
        ),
        START + "scale_x = '9**9**9**9'": ":3: scale_x: must be finite everywhere, got inf",
        START + "[render]\nwidth = 2": ":4: render.width: must be at least 16, got 2",
        START + "[render]\nwidht = 200": ":4: render.widht: is no parameter of Render, which has engine, width, ",
        START + "render = 3": ":3: render: must be a table, [render]",
        START + "[render]\nside = [1, 0]": ":4: render.side: must be a list of 3, got [1, 0]",
        START + "contour = {file = 'no.svg'}": ":3: contour.file: must be a file that exists, got ",
        START + "contour = {file = 'job.toml'}": ":3: contour.file: must be an .svg, .dxf or .blend file, got ",
        START + "trajectory = {file = 'job.toml'}": ":3: trajectory.file: must be a .gpx, .csv or .blend file, got ",
        START + "trajectory = {text = 'abc'}": ":3: trajectory.text: stands for a contour only, got 'abc'",
        START + "contour = {text = 'abc'}": ":3: contour.font: must be a .ttf or .otf file, got ''",
        START + "contour = {file = 'a.svg', size = 2}": ":3: contour.size: is no parameter of File, which has file, ",
        START + "contour = {file = 'a.svg', scale = 0}": ":3: contour.scale: must be more than 0, got 0",
        "version = 9\nkind = 1": ":1: version: must be at most 1, the newest that this program reads, got 9",
        "\nkind = 'tube'": ":2: kind: must be one of ",
        "": ":1: kind: must be given, as one of ",
        START + "[contour]\nradius = 2": ":3: contour.kind: must be given, as one of circle, ",
        "version = 1\nknid = 'plant'": ":2: knid: is no parameter: did you mean 'kind'?",
        "kind = 'plant'\nsystem = { fiel = 'a.l' }": (
            ":2: system.fiel: is no parameter of TextFile, which has file: did you mean 'file'?"
        ),
        START + "[render]\nkind = 'png'": ":4: render.kind: is no parameter of Render, which has engine, ",
        "kind = 'plant'\n[rendr]\nwidth = 100": ":2: rendr: is no parameter of Plant, which has system, ",
        "kind = 'rotational-sweep'\naxis = 1": ":2: axis: is no parameter of RotationalSweep, which has ",
        START + "[[contour]]\nkind = 'circle'": ":3: contour: must be one of circle, ",
        START + "contour = {file = ''}": ":3: contour.file: must name a file, got ''",
        START + "contour = {file = '.'}": ":3: contour.file: must be a file, not a folder, got ",
        "a = 1\nb = ": ":2: must be TOML: after = stands a number, ",
        b"a = '\xff'": ":1: must be UTF-8, got the byte 0xff",
    }.items(),
)
def test_a_refusal_names_file_line_and_key(tmp_path, text, sentence):
    path = written(tmp_path, text)
    for read in (jobs.read, sw.load):
        with pytest.raises(jobs.JobError) as refusal:
            read(path)
        assert str(refusal.value).startswith(f"{path}{sentence}")
        assert "\n" not in str(refusal.value)


@pytest.mark.parametrize(("slip", "meant"), [("[rendr]", "render"), ("vesion = 1", "version"), ("sed = 1", "seed")])
def test_a_slip_in_any_key_of_a_job_is_told_what_was_meant(tmp_path, slip, meant):
    with pytest.raises(jobs.JobError, match=rf": did you mean '{meant}'\?$"):
        jobs.read(written(tmp_path, f"kind = 'plant'\n{slip}\n"))


def test_all_mistakes_of_a_job_are_told_each_at_its_line(tmp_path):
    text = (
        START
        + """twist = [1, 2]
[render]
widht = 9
engine = "cyles"
[contour]
kind = "circle"
raduis = 2
points = 1
[trajectory]
file = "none.csv"
[[morph]]
t = "a"
contour = "cirle"
[[morph]]
t = 0.5
contour = { text = "A", font = "none.ttf" }
"""
    )
    path = written(tmp_path, text)
    with pytest.raises(jobs.JobError) as refusal:
        jobs.read(path)
    lines = [line.removeprefix(f"{path}:") for line in str(refusal.value).split("\n")]
    beginnings = [
        "3: twist: must be a number of radians, a formula in text or a list of points [t, value], got [1, 2]",
        "5: render.widht: is no parameter of Render, ",
        "6: render.engine: must be one of cycles, workbench, eevee, got 'cyles': did you mean 'cycles'?",
        "9: contour.raduis: is no parameter of Circle, which has radius, points: did you mean 'radius'?",
        "10: contour.points: must be at least 3, got 1",
        "12: trajectory.file: must be a file that exists, got ",
        "14: morph.1.t: must be a number, got 'a'",
        "15: morph.1.contour: must be one of circle, ",
        "18: morph.2.contour.font: must be a file that exists, got ",
    ]
    assert len(lines) == len(beginnings)
    assert all(map(str.startswith, lines, beginnings)), lines
    assert refusal.value.line == 3 and refusal.value.key == "twist"


def test_the_page_shows_what_is_told_of_a_job(tmp_path):
    text = (
        START.removeprefix("version = 1\n") + "twist = [1, 2]\n\n[contour]\nkind = 'circle'\nraduis = 0.2\n\n[render]\n"
    )
    with pytest.raises(jobs.JobError) as refusal:
        jobs.read(written(tmp_path, text + "width = 'wide'\n", "broken.toml"))
    told = str(refusal.value).replace(str(tmp_path / "broken.toml"), "    broken.toml")
    assert told in (Path(__file__).parents[2] / "docs" / "jobs.md").read_text()


@pytest.mark.parametrize("count, more", [(21, "1 more mistake"), (1000, "980 more mistakes")])
def test_of_very_many_mistakes_some_are_told(tmp_path, count, more):
    path = written(tmp_path, "kind = 'plant'\n[constants]\n" + "".join(f"c{n} = 'a'\n" for n in range(count)))
    with pytest.raises(jobs.JobError) as refusal:
        jobs.read(path)
    *told, last = str(refusal.value).split("\n")
    assert told[0] == f"{path}:3: constants.c0: must be a number, got 'a'"
    assert len(told) == 20 and last == f"{path}: and {more}"


@pytest.mark.parametrize("make", [lambda path: path, lambda path: path.mkdir() or path])
def test_what_is_no_file_is_refused(tmp_path, make):
    with pytest.raises(ShapeError, match="must be a job file"):
        jobs.read(make(tmp_path / "nothing.toml"))


def test_nothing_that_does_not_end_is_read():
    if not Path("/dev/zero").exists():
        pytest.skip("needs /dev/zero, which this system has not")
    with pytest.raises(ShapeError, match="must be a job file"):
        jobs.read("/dev/zero")


def test_a_job_is_a_path_or_text(tmp_path):
    path = written(tmp_path, START + "twist = 'pi*t'")
    expected = GeneralizedCylinder(twist="pi*t")
    assert sw.load(path) == sw.load(str(path)) == sw.load(path.read_text()) == sw.load(path.read_bytes()) == expected
    assert sw.load(sw.dump(expected)) == expected


@pytest.mark.parametrize("job", [None, 3, ["job.toml"], GeneralizedCylinder()])
def test_what_can_be_no_job_is_refused(job):
    with pytest.raises(ShapeError, match="^job: must be a path, or the text of a job, got "):
        sw.load(job)


def test_the_digest_says_what_the_job_says(tmp_path):
    first = jobs.read(written(tmp_path, START + "twist = 1"))
    same = jobs.read(written(tmp_path, "# a comment\n" + START + "\ntwist   = 1", "same.toml"))
    other = jobs.read(written(tmp_path, START + "twist = 1\n[render]\nwidth = 100", "other.toml"))
    assert first.digest == same.digest != other.digest
    assert other.render == jobs.Render(width=100)


needs_svg = pytest.mark.skipif(importlib.util.find_spec("svgelements") is None, reason="needs the library svgelements")


@needs_svg
def test_a_drawing_beside_the_job_is_its_contour(tmp_path):
    written(tmp_path, SQUARE, "square.svg")
    path = written(tmp_path, START + "[contour]\nfile = 'square.svg'\nscale = 0.001")
    here = os.getcwd()
    job = jobs.read(path)
    assert job.shape.contour.section().area == pytest.approx(1e-4)
    assert os.getcwd() == here
    written(tmp_path, SQUARE.replace("V10", "V20"), "square.svg")
    assert jobs.read(path).digest != job.digest


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.csv", "x,y,z\n0,0,0\n0,0,3\n"),
        ("a.gpx", GPX.format("<ele>0</ele>", "<ele>3</ele>")),
        ("A.GPX", GPX.format("<ele>0</ele>", "<ele>3</ele>")),
    ],
)
def test_a_measured_path_beside_the_job_is_its_trajectory(tmp_path, name, text):
    written(tmp_path, text, name)
    path = written(tmp_path, START + f"[trajectory]\nfile = '{name}'\nscale = 0.5")
    job = jobs.read(path)
    assert job.shape.trajectory.length() == pytest.approx(1.5)
    written(tmp_path, text.replace("3", "4"), name)
    assert jobs.read(path).digest != job.digest


def test_radii_in_a_table_scale_the_contour_of_its_job(tmp_path):
    """They are no lengths: the scale of the file, of its points, leaves them as they are."""
    written(tmp_path, "x,y,z,radius\n0,0,0,2\n0,0,3,1.5\n", "a.csv")
    path = written(tmp_path, START + "[trajectory]\nfile = 'a.csv'\nscale = 0.001")
    assert jobs.read(path).shape.trajectory.radii.values.tolist() == [2, 1.5]


def test_a_measured_path_that_is_none_is_refused_with_its_line(tmp_path):
    written(tmp_path, "0,0,0\n0,0,high\n", "a.csv")
    written(tmp_path, "<gpx/>", "a.gpx")
    for name, told in (("a.csv", "must have numbers only, got 'high' in line 2"), ("a.gpx", "must have a track")):
        with pytest.raises(jobs.JobError) as refusal:
            jobs.read(written(tmp_path, START + f"trajectory = {{file = '{name}'}}"))
        assert str(refusal.value).startswith(
            f"{tmp_path / 'job.toml'}:3: trajectory.file: the {name[2:].upper()} file "
        )
        assert told in str(refusal.value)


@pytest.mark.skipif(importlib.util.find_spec("fontTools") is None, reason="needs the library fonttools")
def test_a_text_that_cannot_be_drawn_is_refused(tmp_path):
    written(tmp_path, b"no font", "a.ttf")
    for text, key in ((" ", "text"), ("B", "font: the font "), ("B', size = 0, note = '", "note")):
        with pytest.raises(jobs.JobError) as refusal:
            jobs.read(written(tmp_path, START + f"contour = {{text = '{text}', font = 'a.ttf'}}"))
        assert str(refusal.value).startswith(f"{tmp_path / 'job.toml'}:3: contour.{key}")


@needs_svg
@pytest.mark.parametrize("svg", ["", "<svg/>", "<svg xmlns='http://www.w3.org/2000/svg'></svg>", "\x00"])
def test_a_drawing_without_an_outline_is_refused(tmp_path, svg):
    written(tmp_path, svg, "a.svg")
    with pytest.raises(jobs.JobError, match=r"job\.toml:3: contour\.file"):
        jobs.read(written(tmp_path, START + "contour = {file = 'a.svg'}"))


def test_the_schema_accepts_references_and_the_picture():
    jsonschema = pytest.importorskip("jsonschema")
    validator = jsonschema.Draft202012Validator(jobs.schema())
    table = {"version": 1, "kind": "generalized-cylinder", "render": {"width": 100}}
    validator.validate(table | {"contour": {"file": "a.svg", "scale": 0.001}})
    validator.validate(table | {"contour": {"text": "B", "font": "a.ttf"}, "trajectory": {"file": "a", "object": "b"}})
    assert list(validator.iter_errors(table | {"contour": {"file": "a.svg", "size": 1}}))
    assert list(validator.iter_errors(table | {"render": {"width": 1}}))


@given(st.text(max_size=40))
def test_any_name_of_a_file_is_refused_in_one_sentence(name):
    with pytest.raises(ShapeError) as refusal:
        jobs.parse(toml({"kind": "generalized-cylinder", "contour": {"file": f"{name}.nothing"}}), Path("nowhere"))
    assert refusal.value.key == "contour.file" and "\n" not in str(refusal.value)


def test_the_text_of_a_grammar_may_be_a_file_beside_the_job(tmp_path):
    (tmp_path / "koch.l").write_text("axiom: F\nF -> F+F--F+F\n")
    (tmp_path / "koch.toml").write_text('kind = "plant"\nsystem = { file = "koch.l" }\ngenerations = 2\n')
    shape = jobs.read(tmp_path / "koch.toml").shape
    assert shape.system == "axiom: F\nF -> F+F--F+F\n" and len(shape.mesh().edges) > 0
    (tmp_path / "koch.toml").write_text('kind = "plant"\n\nsystem = { file = "none.l" }\n')
    with pytest.raises(ShapeError, match=r"koch.toml:3: system.file: must be a file that exists, got "):
        jobs.read(tmp_path / "koch.toml")


def test_a_mistake_in_a_grammar_is_told_with_the_line_of_the_job_and_its_own(tmp_path):
    (tmp_path / "koch.toml").write_text("kind = \"plant\"\nsystem = '''\naxiom: F[\n'''\n")
    with pytest.raises(ShapeError, match=r"koch.toml:2: system: line 1, column 9: expected '\]' after it"):
        jobs.read(tmp_path / "koch.toml")


def test_each_mistake_in_a_grammar_is_told_with_the_line_of_the_job(tmp_path):
    (tmp_path / "two.toml").write_text("kind = \"plant\"\nsystem = '''\naxiom: F[\nF -> F(x*r)\n'''\n")
    with pytest.raises(jobs.JobError) as refusal:
        jobs.read(tmp_path / "two.toml")
    beginnings = [line for line in str(refusal.value).split("\n") if "expected" in line]
    places = ["line 1, column 9", "line 2, column 8"]
    assert [line.partition(": expected")[0] for line in beginnings] == [
        f"{tmp_path / 'two.toml'}:2: system: {place}" for place in places
    ]


def test_a_misspelt_kind_hides_no_other_mistake(tmp_path):
    (tmp_path / "job.toml").write_text(
        "kind = 'generalised-cylinder'\ntwsit = 1\n"
        "contour = { kind = 'circel', raduis = 0.1 }\ntrajectory = { kind = 'helix', turns = '3' }\n"
    )
    with pytest.raises(jobs.JobError) as refusal:
        jobs.read(tmp_path / "job.toml")
    keys = ["kind", "twsit", "contour.kind", "contour.raduis", "trajectory.turns"]
    assert [each.key for each in refusal.value.each()] == keys


def test_files_are_read_beside_a_misspelt_kind(tmp_path):
    (tmp_path / "square.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0h1v1h-1z"/></svg>')
    square = "contour = { file = 'square.svg' }\n"
    (tmp_path / "sweep.toml").write_text(f"kind = 'translational-swep'\n{square}")
    (tmp_path / "tree.toml").write_text(f"kind = 'tre'\n[base]\nkind = 'translational-swep'\n{square}")
    for name, keys in {"sweep": ["kind"], "tree": ["kind", "base.kind"]}.items():
        with pytest.raises(jobs.JobError) as refusal:
            jobs.read(tmp_path / f"{name}.toml")
        assert [each.key for each in refusal.value.each()] == keys


@pytest.mark.parametrize("kind", ["spline", "tube", "x" * 100])
def test_a_kind_that_may_be_any_is_told_of_alone(tmp_path, kind):
    (tmp_path / "job.toml").write_text(
        f"kind = 'generalized-cylinder'\ntrajectory = {{ kind = '{kind}', points = 'many' }}\n"
    )
    with pytest.raises(jobs.JobError) as refusal:
        jobs.read(tmp_path / "job.toml")
    assert [each.key for each in refusal.value.each()] == ["trajectory.kind"]


def test_mistakes_beside_that_of_a_grammar_are_told_too(tmp_path):
    (tmp_path / "job.toml").write_text("kind = 'plant'\nsystem = 'axiom: F['\nstep = 'a'\nagle = 3\n")
    with pytest.raises(jobs.JobError) as refusal:
        jobs.read(tmp_path / "job.toml")
    assert [each.key for each in refusal.value.each()] == ["system", "step", "agle"]


def test_mistakes_beside_that_of_a_grammar_in_a_tree_are_told_too(tmp_path):
    (tmp_path / "job.toml").write_text("kind = 'tree'\n[base]\nkind = 'plant'\nsystem = 'axiom: F['\nstep = 'a'\n")
    with pytest.raises(jobs.JobError) as refusal:
        jobs.read(tmp_path / "job.toml")
    assert [each.key for each in refusal.value.each()] == ["base.system", "base.step"]


def test_each_mistake_in_the_file_of_a_grammar_is_told_with_its_place_there(tmp_path):
    bad, job = tmp_path / "bad.l", tmp_path / "koch.toml"
    bad.write_text("axiom: F\nF -> [\nG -> F(\n")
    job.write_text('kind = "plant"\nsystem = { file = "bad.l" }\n')
    with pytest.raises(ShapeError) as refusal:
        jobs.read(job)
    first, second = [line for line in str(refusal.value).split("\n") if "expected" in line]
    assert first.startswith(f"{job}:2: system.file: {bad}:2:6: expected ']' after it")
    assert second.startswith(f"{bad}:3:7: expected ')' after it")


def test_a_grammar_in_the_place_of_a_job_is_told_who_reads_it(tmp_path):
    (tmp_path / "honda.l").write_text("axiom: F\nF -> FF\n")
    with pytest.raises(ShapeError, match="honda.l:1: must be TOML: .*; of a grammar tell `derive` and `describe`"):
        jobs.read(tmp_path / "honda.l")
