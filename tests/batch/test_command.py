# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line: results on standard output, one sentence on standard error, and the right exit code."""

import importlib.util
import json
import os
import re
import struct
import subprocess
import sys
import tomllib
from collections import Counter
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import sweep_addon as sw
from sweep_addon import presets
from sweep_addon.batch import describing, verbs
from sweep_addon.batch.command import main
from sweep_addon.core.declared.parameters import spelled

CHECKOUT = Path(__file__).parents[2]
TUBE = sw.GeneralizedCylinder(
    contour=sw.contours.Rectangle(width=0.5, height=0.25),
    trajectory=sw.trajectories.Line(end=(0, 0, 2)),
    scale_x="1 - t/2",
)
SMALL = "\n[render]\nwidth = 160\nheight = 120\nsamples = 1\ntransparent = true\nmargin = 0.1\n"


@pytest.fixture
def job(tmp_path):
    path = tmp_path / "tube.toml"
    path.write_text(sw.dump(TUBE) + SMALL)
    return path


def test_check_answers_for_each_job(tmp_path, job, capsys):
    wrong = tmp_path / "wrong.toml"
    wrong.write_text(sw.dump(TUBE).replace("width = 0.5", "width = -0.5"))
    bad_law = tmp_path / "law.toml"
    bad_law.write_text(sw.dump(TUBE).replace('"1 - t/2"', '"1/t"'))
    assert main(["check", str(job)]) == 0
    vertices = len(TUBE.mesh().vertices)
    assert capsys.readouterr().out.startswith(f"{job}: {vertices:,} vertices and ")
    assert main(["check", str(wrong), str(job), str(bad_law)]) == 2
    told = capsys.readouterr()
    line = wrong.read_text().split("\n").index("width = -0.5") + 1
    first, second = told.err.splitlines()
    assert first == f"{wrong}:{line}: contour.width: must be more than 0, got -0.5"
    assert second.startswith(f"{bad_law}:3: scale_x: must be finite everywhere, got inf at ")
    assert told.out.startswith(str(job))


@pytest.mark.parametrize(
    ("width", "height", "along", "said"),
    [
        (0.4, 0.3, 0.12, "0.4 x 0.3 x 0.12 m"),
        (400, 300, 120.04, "400 x 300 x 120 m"),  # millimetres that were taken for metres
        (1234.56, 0.0123456, 1, "1235 x 0.0123 x 1 m"),
    ],
)
def test_check_says_how_large_a_shape_is(tmp_path, capsys, width, height, along, said):
    path = tmp_path / "block.toml"
    outline = f'{{ kind = "rectangle", width = {width}, height = {height} }}'
    path.write_text(f'kind = "translational-sweep"\ncontour = {outline}\nheight = {along}\n')
    assert main(["check", str(path)]) == 0
    assert capsys.readouterr().out == f"{path}: 8 vertices and 6 faces, {said}\n"


def test_check_tells_every_mistake_of_a_job_in_a_line(tmp_path, job, capsys):
    job.write_text(
        job.read_text().replace("rounding = 0.0", "rounding = -1").replace("width = 0.5", "widht = 0.5") + "wdith = 3\n"
    )
    lines = job.read_text().split("\n")
    assert main(["check", str(job)]) == 2
    told = [line.split(": ")[:2] for line in capsys.readouterr().err.splitlines()]
    keys = {"contour.widht": "widht = 0.5", "contour.rounding": "rounding = -1", "render.wdith": "wdith = 3"}
    assert told == [[f"{job}:{lines.index(line) + 1}", key] for key, line in keys.items()]


def test_check_tells_of_a_tree_of_which_nothing_is_left(tmp_path, capsys):
    pytest.importorskip("manifold3d", reason="meshes of trees are asked of manifold3d")
    path = tmp_path / "nothing.toml"
    path.write_text(sw.dump(sw.solids.Block() - sw.solids.Block(9.0, 9.0, 9.0)))
    assert main(["check", str(path)]) == 0
    told = capsys.readouterr()
    assert told.out == f"{path}: 0 vertices and 0 faces\n"
    assert told.err == f"{path}: Tree: nothing is left: the steps take all of it away.\n"


def test_a_key_of_two_lines_is_told_in_one(tmp_path, capsys):
    job = tmp_path / "job.toml"
    job.write_text('kind = "generalized-cylinder"\n"con\\ntour" = 1\n')
    assert main(["check", str(job)]) == 2
    told = capsys.readouterr().err
    assert r"'con\ntour': is no parameter of GeneralizedCylinder" in told and told.count("\n") == 1


def test_check_says_what_people_should_know(tmp_path, capsys):
    told = tmp_path / "told.toml"
    told.write_text(sw.dump(sw.GeneralizedCylinder(trajectory=sw.trajectories.Line(), frame=sw.frames.Frenet())))
    assert main(["check", str(told)]) == 0
    assert capsys.readouterr().err.startswith(f"{told}: Frame: the trajectory is straight and has no Frenet frame")


def test_build_says_what_people_should_know(scene, tmp_path, capsys):
    job = tmp_path / "nothing.toml"
    job.write_text("kind = 'plant'\nsystem = 'axiom: A'\n")
    assert main(["check", str(job)]) == 0
    checked = capsys.readouterr().err
    assert checked.startswith(f"{job}: The word draws nothing: ")
    assert main(["build", str(job), "--output", str(job.with_suffix(".stl"))]) == 0
    assert capsys.readouterr().err == checked


def test_check_says_where_a_sweep_meets_itself(tmp_path, capsys):
    crossing = tmp_path / "crossing.toml"
    bend = sw.trajectories.Arc(radius=0.3)
    crossing.write_text(sw.dump(sw.GeneralizedCylinder(sw.contours.Circle(0.5), bend)))
    assert main(["check", str(crossing)]) == 0
    assert capsys.readouterr().err.splitlines() == [
        f"{crossing}: Self-intersection: from u = 0 to 3.142 the contour reaches the centre of curvature, "
        "and the sweep folds.",
        f"{crossing}: A radius up to 0.3 m is clear of it.",
    ]


def test_describe_tells_units_limits_and_defaults(capsys):
    assert main(["describe", "generalized-cylinder"]) == 0
    told = capsys.readouterr().out
    assert "contour(circle).radius = 0.1\n" in told and "number; m, more than 0\n" in told
    assert main(["describe"]) == main(["describe", "circle"]) == main(["describe", "render"]) == 0
    capsys.readouterr()
    assert main(["describe", "--schema"]) == 0
    assert json.loads(capsys.readouterr().out)["title"] == "Sweep job"


def test_describe_alone_names_all_that_it_can_tell_of(capsys):
    assert main(["describe"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines.index("Planar Generator") < lines.index("Solid Generator") and max(map(len, lines)) < 140
    lines = lines[: next(number for number, line in enumerate(lines) if line.startswith("Presets"))]
    groups = (line.strip().split(": ", 1) for line in lines if line.startswith("  "))
    first, second = zip(*groups, strict=True)
    at = first.index("contour")
    names = [*first[:at], *(name for kinds in second[at:] for name in kinds.split(", "))]
    assert {"circle", "helix", "generalized-cylinder", "tree", "ball", "formula", "render"} <= set(names)
    assert all(main(["describe", name]) == 0 for name in names)


def test_describe_alone_names_each_preset(capsys):
    assert main(["describe"]) == 0
    listed = re.search(r"^Presets.*\n((?:  .*\n)+)", capsys.readouterr().out, re.MULTILINE)[1]
    assert re.findall(r"\w+", listed) == sorted(presets.BY_NAME, key=lambda name: name.startswith("l_system_"))


@pytest.mark.parametrize("name", ["hose", "pipe", "screw_thread_m8", "l_system_koch_curve_a"])
def test_describe_prints_the_job_of_a_preset_whatever_folder_has_its_name(name, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    Path(name).mkdir()
    assert main(["describe", name]) == 0
    told = capsys.readouterr().out
    assert sw.load(told) == presets.shape(name)
    Path("job.toml").write_text(told)
    assert main(["check", "job.toml"]) == 0


def test_no_preset_is_called_as_a_kind_is():
    assert not set(presets.BY_NAME) & {spelled(kind) for kind in describing.kinds()}


def test_describe_tells_the_name_that_was_meant(capsys):
    assert main(["describe", "helx"]) == main(["describe", "generalised-cylinder"]) == 2
    told = capsys.readouterr().err.splitlines()
    assert [line.rpartition(": ")[2] for line in told] == [
        "did you mean 'helix'?",
        "did you mean 'generalized-cylinder'?",
    ]


@pytest.mark.parametrize(
    ("shape", "kind", "key"),
    [("generalized-cylinder", "circle", "radius"), ("pd-curve-sweep", "rectangle", "width"),
     ("translational-sweep", "rectangle", "height")],
)  # fmt: skip
def test_describe_of_a_kind_tells_the_default_that_a_job_of_a_shape_has(shape, kind, key, capsys):
    default = getattr(sw.load(f'kind = "{shape}"\n[contour]\nkind = "{kind}"\n').contour, key)
    assert main(["describe", kind]) == 0
    told = re.search(rf"^{key} = .*\n((?:    .*\n)+)", capsys.readouterr().out, re.MULTILINE)[1]
    places = re.split(r"([\d.]+) in (?=[\w-]+ \()", " ".join(told.split()))  # a default, and where, by turns
    [found] = [value for value, where in zip(places[1::2], places[2::2], strict=True) if f"{shape} (contour)" in where]
    assert float(found) == default


def test_describe_tells_no_default_that_is_the_same_everywhere(capsys):
    assert main(["describe", "helix"]) == main(["describe", "generalized-cylinder"]) == 0
    assert " in generalized-cylinder (" not in capsys.readouterr().out


def test_describe_tells_of_all_kinds_of_a_name(capsys):
    assert main(["describe", "formula"]) == main(["describe", "round"]) == 0
    told = capsys.readouterr().out
    for kind in (sw.trajectories.Formula, sw.laws.Formula, sw.ends.Round, sw.corners.Round):
        assert kind.__doc__.partition("\n")[0] in told
    assert main(["describe", "formula", "--markdown"]) == 0
    told = capsys.readouterr().out
    assert told.count("| parameter |") == 2 and "| `text` |" in told and "| `closed` |" in told


@pytest.mark.parametrize(
    "arguments, sentence",
    {
        (): "sweep: the following arguments are required: VERB",
        ("squeeze",): "sweep: argument VERB: invalid choice: 'squeeze'",
        ("build", "a.toml"): "sweep build: one of the arguments -o/--output -d/--output-dir is required",
        ("chekc", "a.toml"): "sweep: argument VERB: invalid choice: 'chekc' (choose from ",
        ("derive", "a.l", "-n", "x"): "sweep derive: argument -n/--generations: must be a whole number, got 'x'; see ",
        ("derive", "docs/demo.toml"): "docs/demo.toml: must be a grammar, got a job, which `check`, ",
        ("check",): "sweep check: the following arguments are required: JOB",
        ("check", "no.toml"): "no.toml: must be a job file that exists",
        ("describe", "nothing"): "SHAPE: must be a name that `describe` alone lists, or the file of a grammar, got 'no",
        ("describe", "."): ".: must be a file, got a folder",
        ("derive", "."): ".: must be a file, got a folder",
        ("check", "."): ".: must be a job file, got a folder",
    }.items(),
)
def test_bad_input_is_one_sentence_and_exit_code_2(arguments, sentence, capsys, monkeypatch):
    monkeypatch.chdir(CHECKOUT)
    assert main(list(arguments)) == 2
    told = capsys.readouterr()
    assert told.err.startswith(sentence) and told.err.count("\n") == 1 and not told.out


def test_a_verb_with_a_slip_is_told_the_one_that_was_meant(capsys):
    assert main(["chekc", "a.toml"]) == 2
    assert capsys.readouterr().err.endswith(": did you mean 'check'?; see sweep --help\n")


@pytest.mark.skipif(importlib.util.find_spec("bpy") is not None, reason="this host has Blender")
@pytest.mark.parametrize("verb", ["build", "render"])
def test_without_blender_the_way_to_it_is_told(verb, job, capsys):
    assert main([verb, str(job), "--output", "a.glb"]) == 1
    told = capsys.readouterr().err
    assert told.startswith("This needs Blender: ") and "pip install" in told and told.count("\n") == 1


@pytest.mark.skipif(importlib.util.find_spec("bpy") is not None, reason="this host has Blender")
def test_a_job_that_only_blender_can_read_is_not_called_wrong(job, capsys):
    job.with_name("a.blend").write_bytes(b"")
    job.write_text('kind = "generalized-cylinder"\ntrajectory = { file = "a.blend", object = "Curve" }')
    assert main(["check", str(job)]) == 1
    assert capsys.readouterr().err == f"{job}:2: trajectory.file: needs Blender to be read, got 'a.blend'\n"
    wrong = job.with_name("wrong.toml")
    wrong.write_text("kind = 3")
    assert main(["check", str(wrong), str(job)]) == 2
    with pytest.raises(sw.ShapeError, match="needs Blender"):
        sw.load(job)


def test_what_blender_prints_is_no_result(scene, job, capfd):
    job.with_name("a.blend").write_bytes(b"no file of Blender's")
    job.write_text('kind = "generalized-cylinder"\ntrajectory = { file = "a.blend", object = "Curve" }')
    assert main(["check", str(job)]) == 2
    told = capfd.readouterr()
    assert told.out == "" and told.err.startswith(f"{job}:2: trajectory.object: must be in a .blend file that Blender ")


def test_help_is_a_result(capsys):
    assert main(["render", "--help"]) == 0
    told = capsys.readouterr()
    assert "--frame" in told.out and not told.err


def test_python_runs_the_library_as_a_program(job):
    done = subprocess.run(
        [sys.executable, "-m", "sweep_addon", "check", str(job)], cwd=CHECKOUT, capture_output=True, text=True
    )
    if "No module named" in done.stderr:
        pytest.skip("this host's Python is started by Blender alone")
    assert (done.returncode, done.stderr) == (0, "") and done.stdout.startswith(str(job))


def test_command_that_pip_installs_is_the_same_program(job):
    entry = tomllib.loads((CHECKOUT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["scripts"]["sweep"]
    module, function = entry.split(":")
    script = f"import sys; from {module} import {function}; sys.exit({function}())"  # as pip writes it
    wrong = job.with_name("wrong.toml")
    wrong.write_text("kind = 3")
    done = subprocess.run(
        [sys.executable, "-c", script, "check", str(job), str(wrong)], cwd=CHECKOUT, capture_output=True, text=True
    )
    if "No module named" in done.stderr:
        pytest.skip("this host's Python is started by Blender alone")
    assert done.returncode == 2 and done.stdout.startswith(f"{job}: ") and done.stderr.startswith(f"{wrong}:1: kind: ")


@pytest.mark.parametrize(
    "arguments", [("check", "docs/demo.toml"), ("build", "a.toml", "-o", "a.glb"), ("describe",), ()]
)
def test_without_numpy_a_sentence_says_what_is_missing(arguments):
    line = [sys.executable, "-S", "-m", "sweep_addon", *arguments]  # without the packages that are installed
    there = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    done = subprocess.run(line, cwd=CHECKOUT, env=there, capture_output=True, text=True)
    if "No module named sweep_addon" in done.stderr:
        pytest.skip("this host's Python is started by Blender alone")
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith("Sweep needs NumPy, which ") and "pip install numpy" in done.stderr
    assert done.stderr.count("\n") == 1


def signed_volume(triangles):
    a, b, c = triangles.transpose(1, 0, 2)
    return np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6


def stl_triangles(data):
    (count,) = struct.unpack_from("<I", data, 80)
    assert len(data) == 84 + 50 * count
    records = np.frombuffer(data, np.uint8, offset=84).reshape(count, 50)
    return records[:, 12:48].copy().view("<f4").reshape(count, 3, 3).astype(float)


def obj_vertices(data):
    lines = (line.split() for line in data.decode().splitlines())
    return np.array([line[1:4] for line in lines if line[:1] == ["v"]], dtype=float)


def glb_bounds(data):
    magic, version, length = struct.unpack_from("<4sII", data)
    assert (magic, version, length) == (b"glTF", 2, len(data))
    (size,) = struct.unpack_from("<I", data, 12)
    document = json.loads(data[20 : 20 + size])
    found = [primitive["attributes"]["POSITION"] for mesh in document["meshes"] for primitive in mesh["primitives"]]
    accessors = [document["accessors"][index] for index in found]
    return np.min([a["min"] for a in accessors], axis=0), np.max([a["max"] for a in accessors], axis=0), document


def built(job, suffix, capfd):
    output = job.with_suffix(suffix)
    assert main(["build", str(job), "--output", str(output)]) == 0
    assert capfd.readouterr().out == f"{output}\n"
    assert not list(job.parent.glob("*.part"))
    return output.read_bytes()


def test_models_hold_the_shape(scene, job, capfd):
    mesh = TUBE.mesh()
    triangles = stl_triangles(built(job, ".stl", capfd))
    assert signed_volume(triangles) == pytest.approx(mesh.volume(), rel=1e-5)
    high = mesh.vertices.max(axis=0)
    assert np.allclose(obj_vertices(built(job, ".obj", capfd)).max(axis=0), high[[0, 2, 1]], atol=1e-5)  # y is up
    low, high_glb, document = glb_bounds(built(job, ".glb", capfd))
    assert np.allclose(high_glb, high[[0, 2, 1]], atol=1e-5)
    assert len(document["materials"]) == 2 and len(document["nodes"]) == 1
    assert f"element vertex {len(mesh.vertices)}" in built(job, ".ply", capfd)[:2000].decode("latin-1")


def obj_triangles(data):
    """Faces of more corners in fans, as many readers have them."""
    lines = [line.split() for line in data.decode().splitlines() if line[:2] == "f "]
    faces = [[int(corner.split("/")[0]) - 1 for corner in line[1:]] for line in lines]
    return obj_vertices(data)[[(face[0], *pair) for face in faces for pair in pairwise(face[1:])]]


def glb_triangles(data):
    (size,) = struct.unpack_from("<I", data, 12)
    document, places = json.loads(data[20 : 20 + size]), memoryview(data)[28 + size :]

    def read(number):
        accessor = document["accessors"][number]
        view = document["bufferViews"][accessor["bufferView"]]
        kind = {5123: "<u2", 5125: "<u4", 5126: "<f4"}[accessor["componentType"]]
        count = accessor["count"] * {"SCALAR": 1, "VEC3": 3}[accessor["type"]]
        return np.frombuffer(places, kind, count, view.get("byteOffset", 0))

    parts = [part for mesh in document["meshes"] for part in mesh["primitives"]]
    found = [read(part["attributes"]["POSITION"]).reshape(-1, 3)[read(part["indices"])] for part in parts]
    return np.concatenate(found).reshape(-1, 3, 3).astype(float)


@pytest.mark.parametrize("twist", ["2 * pi * t", "-2 * pi * t"])
@pytest.mark.parametrize(
    ("suffix", "read"), [(".stl", stl_triangles), (".glb", glb_triangles), (".obj", obj_triangles)]
)
@pytest.mark.parametrize("bored", [False, True])
def test_models_of_twisted_bars_are_as_thick_as_lines_between_their_rings_make_them(
    scene, tmp_path, capfd, suffix, read, twist, bored
):
    """Turned by an angle from ring to ring, the section is on average 1 - (1 - cos angle) / 3 of the contour's."""
    bar = sw.GeneralizedCylinder(sw.contours.Rectangle(0.1, 0.1), sw.trajectories.Line(end=(0, 0, 1)), twist=twist)
    step = 2 * np.pi / (bar.mesh().rings - 1)
    expected = 0.01 * (1 - (1 - np.cos(step)) / 3) - 0.02**2 * bored
    job = tmp_path / "bar.toml"
    job.write_text(sw.dump(bar - sw.solids.Block(0.02, 0.02, 3.0) if bored else bar))
    found = read(built(job, suffix, capfd))
    assert signed_volume(found) == pytest.approx(expected, rel=1e-4)
    ends = np.round(found, 5)
    edges = Counter(map(tuple, np.concatenate((ends, np.roll(ends, -1, axis=1)), axis=2).reshape(-1, 6).tolist()))
    assert all(edges[edge[3:] + edge[:3]] == times for edge, times in edges.items())


def test_models_hold_loose_edges_and_points(scene, tmp_path, capfd):
    """Of an area, a dangling edge and two points turned in part: 42 edges of the one, the other where it was."""
    job = tmp_path / "mixed.toml"
    job.write_bytes(presets.BY_NAME["mixed_dimension_every_dimension"].path.read_bytes())
    *_, document = glb_bounds(built(job, ".glb", capfd))
    primitives = {each.get("mode", 4): each for mesh in document["meshes"] for each in mesh["primitives"]}
    lines, points = primitives[1]["indices"], primitives[0]["attributes"]["POSITION"]
    assert document["accessors"][lines]["count"] == 2 * 42 and document["accessors"][points]["count"] == 1
    assert built(job, ".obj", capfd).count(b"\nl ") == 42
    assert b"element edge 42\n" in built(job, ".ply", capfd)


def test_a_blend_file_holds_the_scene(scene, job, capfd):
    import bpy

    built(job, ".blend", capfd)
    bpy.ops.wm.open_mainfile(filepath=str(job.with_suffix(".blend")))
    assert {ob.name for ob in bpy.data.objects} == {
        "tube",
        "Camera",
        "Key",
        "Fill",
        "Rim",
    }  # no ground where nothing is behind
    ob = bpy.data.objects["tube"]
    ends = np.zeros(len(ob.data.polygons), np.int32)
    ob.data.polygons.foreach_get("material_index", ends)
    assert set(ends) == {0, 1} and [material.name for material in ob.data.materials] == ["Side", "Caps"]
    assert_live(ob)


def assert_live(ob):
    """The mesh knows what it is made from, and follows it."""
    assert sw.from_object(ob) == TUBE and len(ob.data.vertices) == len(TUBE.mesh().vertices)
    width = max(vertex.co.x for vertex in ob.data.vertices)
    ob.data.sweep.generalized_cylinder.contour_rectangle_width *= 2
    assert max(vertex.co.x for vertex in ob.data.vertices) == pytest.approx(2 * width)


def alone(*arguments):
    """Run Python where Blender is a module of it and no extension is enabled."""
    done = subprocess.run([sys.executable, *arguments], cwd=CHECKOUT, capture_output=True, text=True, timeout=120)
    # Blender says this itself, in a container that has no /etc/mtab
    said = [line for line in done.stderr.splitlines() if "list of mounted file-systems" not in line]
    done.stderr = "\n".join(said)
    return done


def test_a_blend_file_that_python_alone_wrote_is_live(blender_module, scene, job):
    import bpy

    output = job.with_suffix(".blend")
    done = alone("-m", "sweep_addon", "build", str(job), "--output", str(output))
    assert (done.returncode, done.stdout, done.stderr) == (0, f"{output}\n", "")
    bpy.ops.wm.open_mainfile(filepath=str(output))
    assert_live(bpy.data.objects["tube"])


def test_where_the_extension_is_not_enabled_no_object_is_a_sweep(blender_module, scene):
    done = alone("-c", """
import bpy, sweep_addon as sw
ob = sw.to_object(sw.GeneralizedCylinder(), "tube")
try:
    sw.from_object(ob)
except sw.ShapeError as refusal:
    print(len(ob.data.polygons) > 0, refusal)
""")  # fmt: skip
    assert (done.stdout, done.stderr) == ("True object: must be a sweep, got 'tube'\n", "")


def test_a_shape_that_cannot_be_made_is_refused_at_its_line(scene, job, capsys):
    job.write_text(sw.dump(TUBE).replace('"1 - t/2"', '"1/t"'))
    assert main(["build", str(job), "--output", str(job.with_suffix(".glb"))]) == 2
    told = capsys.readouterr().err
    assert told.startswith(f"{job}:3: scale_x: must be finite everywhere, got inf at ") and told.count("\n") == 1
    with pytest.raises(sw.ShapeError) as refusal:
        sw.to_object(sw.load(job))
    assert refusal.value.key == "scale_x" and refusal.value.sentence.startswith("must be finite everywhere")


def test_a_picture_is_filled_to_its_margin(scene, job, capfd):
    import bpy

    output = job.with_suffix(".png")
    assert main(["render", str(job), "--output", str(output)]) == 0
    assert capfd.readouterr().out == f"{output}\n"
    image = bpy.data.images.load(str(output))
    assert tuple(image.size) == (160, 120)
    alpha = np.array(image.pixels[:]).reshape(120, 160, 4)[..., 3]
    rows, columns = np.flatnonzero(alpha.any(axis=1)), np.flatnonzero(alpha.any(axis=0))
    bounds = np.array([rows[0], 119 - rows[-1], columns[0], 159 - columns[-1]]) / [120, 120, 160, 160]
    assert bounds.min() == pytest.approx(0.1, abs=0.025)
    assert bounds[:2] == pytest.approx(bounds[1::-1], abs=0.025)  # the tall way is filled, and even


@pytest.mark.parametrize(
    "arguments, sentence",
    {
        ("build", "-o", "a.png"): "output: must end in .blend, .glb, .stl, .obj, .ply, got 'a.png'",
        ("render", "-o", "a.glb"): "output: must end in .png, .jpg, .webp, .exr, got 'a.glb'",
        ("build", "-o", "."): "output: must end in .blend, .glb, .stl, .obj, .ply, got '.'",
        ("build", "-o", "tube.toml/a.glb"): "output: must be in a folder, got ",
        ("render", "-o", "a.png", "--frame", "2"): "frame: must be from 1 to 1, the pictures of tube.toml, got 2",
    }.items(),
)
def test_a_wrong_output_is_refused_before_anything_is_done(scene, job, arguments, sentence, capsys, monkeypatch):
    monkeypatch.chdir(job.parent)
    assert main([arguments[0], str(job), *arguments[1:]]) == 2
    told = capsys.readouterr()
    assert told.err.startswith(sentence) and told.err.count("\n") == 1
    assert sorted(path.name for path in job.parent.iterdir()) == ["tube.toml"]


def test_a_file_in_the_place_of_the_folder_is_refused(scene, job, capsys):
    assert main(["build", str(job), "--output-dir", str(job)]) == 2
    assert re.fullmatch("output-dir: must be a folder, got '.*\n", capsys.readouterr().err)


def test_a_folder_that_is_missing_is_made(scene, job):
    output = job.parent / "new" / "deep" / "tube.stl"
    assert main(["build", str(job), "--output", str(output)]) == 0 and output.is_file()


def test_progress_is_told_in_a_log_where_it_is_asked_for(scene, job, capfd):
    line = ["render", str(job), "--output", str(job.with_name("tube.png"))]
    assert main(line) == 0 and not capfd.readouterr().err
    assert main([*line, "--progress"]) == 0
    assert re.search(r"rendering tube.png, \d+ x \d+: sample \d+ of \d+\n", capfd.readouterr().err)


def test_what_cannot_be_written_leaves_nothing(scene, job, capsys, monkeypatch):
    def give_up(path):
        Path(path).write_text("half")
        raise RuntimeError("Error: the disk is full\n")

    monkeypatch.setitem(verbs.MODELS, ".stl", give_up)
    output = job.with_suffix(".stl")
    output.write_text("the old one")
    assert main(["build", str(job), "--output", str(output)]) == 1
    assert capsys.readouterr().err == "Error: the disk is full\n"
    assert output.read_text() == "the old one" and not list(job.parent.glob("*.part"))


def test_an_exporter_that_writes_nothing_has_failed(scene, job, capsys, monkeypatch):
    monkeypatch.setitem(verbs.MODELS, ".stl", lambda path: None)
    assert main(["build", str(job), "--output", str(job.with_suffix(".stl"))]) == 1
    assert capsys.readouterr().err == "Blender's exporter wrote no tube.stl\n"
    assert [path.name for path in job.parent.iterdir()] == ["tube.toml"]


def test_a_folder_that_was_there_stays(scene, job):
    theirs = job.with_name("tube.stl.part")
    theirs.mkdir()
    (theirs / "kept.txt").write_text("kept")
    assert main(["build", str(job), "--output", str(job.with_suffix(".stl"))]) == 0
    assert (theirs / "kept.txt").read_text() == "kept"
