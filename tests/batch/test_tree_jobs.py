# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Jobs of trees: checked and described without Blender, built as live trees and as models of what they show."""

import struct

import numpy as np
import pytest

import sweep_addon as sw
from sweep_addon import presets
from sweep_addon.batch.command import main

ROOFS = "sweep_csg_two_triangles"
UNION = 0.9 + 0.42 - 0.7 * (0.6 - 0.5 + 0.4 / 3)  # m3: both prisms, less the integral of the product of their widths


@pytest.fixture
def job(tmp_path):
    path = tmp_path / "roofs.toml"
    path.write_bytes(presets.BY_NAME[ROOFS].path.read_bytes())
    return path


def test_the_union_of_two_swept_triangles_has_the_volume_of_its_integral():
    assert presets.shape(ROOFS).mesh().volume() == pytest.approx(UNION, rel=1e-12)


def test_the_drilled_bend_is_one_solid_with_one_hole_through_it():
    shape = presets.shape("sweep_csg_drilled_bend")
    mesh = shape.mesh()
    assert mesh.euler_characteristic() == 0 and not len(mesh.boundary_edges())
    assert mesh.volume() < shape.base.mesh().volume() - np.pi * 0.09**2 * 0.5


def test_check_makes_the_mesh_of_a_tree_and_points_at_a_line(job, tmp_path, capsys):
    assert main(["check", str(job)]) == 0
    mesh = presets.shape(ROOFS).mesh()
    assert f"{len(mesh.vertices):,} vertices and {len(mesh.offsets) - 1:,} faces" in capsys.readouterr().out
    wrong = tmp_path / "wrong.toml"
    wrong.write_text(job.read_text().replace('operation = "union"', 'operation = "onion"'))
    assert main(["check", str(wrong)]) == 2
    line = wrong.read_text().split("\n").index('operation = "onion"') + 1
    assert capsys.readouterr().err.startswith(f"{wrong}:{line}: steps.1.operation: must be one of union, ")


OPEN = """kind = "tree"
[[steps]]
operation = "difference"
[steps.operand]
kind = "generalized-cylinder"
trajectory = "line"
end = "open"
"""


def test_build_refuses_the_open_operand_that_check_refuses(scene, tmp_path, capsys):
    job = tmp_path / "open.toml"
    job.write_text(OPEN)
    told = f"{job}:4: steps.1.operand: A solid needs a closed contour and closed ends, got an open surface\n"
    assert main(["check", str(job)]) == 2 and capsys.readouterr().err == told
    assert main(["build", str(job), "--output", str(tmp_path / "open.stl")]) == 2 and capsys.readouterr().err == told
    assert not (tmp_path / "open.stl").exists()


@pytest.mark.parametrize("node", ["tree", "placed", "swept-solid", "rigid-motion"])
def test_nodes_of_trees_are_described(node, capsys):
    assert main(["describe", node]) == 0
    assert capsys.readouterr().out.startswith(f"{node}: ")


def test_a_blend_file_holds_the_tree_live(scene, job, capfd):
    import bpy
    from scenes import shown

    output = job.with_suffix(".blend")
    assert main(["build", str(job), "--output", str(output)]) == 0
    assert capfd.readouterr().out == f"{output}\n"
    bpy.ops.wm.open_mainfile(filepath=str(output))
    result = bpy.data.objects["roofs"]
    (operand,) = result.children
    assert shown(result).volume() == pytest.approx(UNION, rel=1e-5)
    assert operand.hide_render and operand.display_type == "WIRE" and not result.hide_render
    operand.data.sweep.generalized_cylinder.trajectory_line_end = (2.0, 0.0, 0.0)
    assert shown(result).volume() == pytest.approx(UNION + 0.21, rel=1e-5)


@pytest.mark.parametrize("suffix", [".stl", ".ply", ".obj", ".glb"])
def test_models_hold_what_a_tree_shows(scene, job, suffix):
    output = job.with_suffix(suffix)
    assert main(["build", str(job), "--output", str(output)]) == 0
    data = output.read_bytes()
    if suffix == ".stl":
        (count,) = struct.unpack_from("<I", data, 80)
        records = np.frombuffer(data, np.uint8, offset=84).reshape(count, 50)
        triangles = records[:, 12:48].copy().view("<f4").reshape(count, 3, 3).astype(float)
        volume = np.einsum("ij,ij->i", triangles[:, 0], np.cross(triangles[:, 1], triangles[:, 2])).sum() / 6
        assert volume == pytest.approx(UNION, rel=1e-5)
    else:
        base = sw.TranslationalSweep(sw.contours.Outline([[(-0.5, 0), (0.5, 0), (0, 0.9)]]), height=2.0)
        alone = job.with_name("base.toml")
        alone.write_text(sw.dump(base))
        assert main(["build", str(alone), "--output", str(alone.with_suffix(suffix))]) == 0
        assert len(data) > len(alone.with_suffix(suffix).read_bytes()) + 100


PLANT = """kind = "tree"
[base]
kind = "block"
width = 10.0
depth = 10.0
height = 10.0
[[steps]]
operation = "difference"
[steps.operand]
kind = "plant"
system = { file = "bar.l" }
upright = "upwards"
[steps.operand.constants]
long = 1.5
"""
BAR = "#define long 1\naxiom: [!(0.2) F(2*long)] f(0.7) !(0.1) F(3)"  # the thin one begins within the thick one
TUBES = 2 * np.sqrt(2) * (3 * 0.1**2 + 0.7 * 0.05**2)  # m3 of both octagonal tubes, at 1.5


@pytest.fixture
def drilled(tmp_path):
    pytest.importorskip("manifold3d")
    (tmp_path / "bar.l").write_text(BAR)
    path = tmp_path / "drilled.toml"
    path.write_text(PLANT)
    return path


def test_a_job_may_have_a_plant_as_an_operand(drilled, capsys):
    assert sw.load(drilled).mesh().volume() == pytest.approx(1000 - TUBES, rel=1e-9)
    assert main(["check", str(drilled)]) == 0
    assert "vertices" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("right", "wrong", "said"),
    [
        ("long = 1.5", "lang = 1.5", "steps.1.operand.constants.lang: is no constant"),
        ('upright = "upwards"', 'output = "edges"', "steps.1.operand.output: must be tubes for a solid, got 'edges'"),
        ('upright = "upwards"', "generations = -1", "steps.1.operand.generations: must be at least 0, got -1"),
        ('{ file = "bar.l" }', '{ file = "gone.l" }', "steps.1.operand.system.file: must be a file that exists"),
        ('{ file = "bar.l" }', '"axiom: F["', "steps.1.operand.system: line 1, column 9: expected ']'"),
    ],
)
def test_check_points_at_what_is_wrong_of_a_plant_in_a_tree(drilled, right, wrong, said, capsys):
    drilled.write_text(PLANT.replace(right, wrong))
    line = next(number for number, text in enumerate(PLANT.split("\n"), 1) if right in text)
    assert main(["check", str(drilled)]) == 2
    assert capsys.readouterr().err.startswith(f"{drilled}:{line}: {said}")


def test_a_plant_in_a_tree_is_built_live(scene, drilled):
    import bpy
    from scenes import shown

    output = drilled.with_suffix(".blend")
    assert main(["build", str(drilled), "--output", str(output)]) == 0
    bpy.ops.wm.open_mainfile(filepath=str(output))
    result = bpy.data.objects["drilled"]
    assert shown(result).volume() == pytest.approx(1000 - TUBES, rel=1e-5)
    (operand,) = result.children
    operand.data.sweep.plant.constants["long"] = 1.0
    operand.data.update_tag()
    assert shown(result).volume() == pytest.approx(1000 - 2 * np.sqrt(2) * (0.02 + 1.7 * 0.05**2), rel=1e-5)


def test_build_tells_of_a_tree_of_which_nothing_is_left(scene, tmp_path, capsys):
    path = tmp_path / "nothing.toml"
    path.write_text(sw.dump(sw.solids.Block() - sw.solids.Block(9.0, 9.0, 9.0)))
    assert main(["build", str(path), "--output", str(tmp_path / "nothing.blend")]) == 0
    assert f"{path}: Tree: nothing is left: the steps take all of it away." in capsys.readouterr().err
