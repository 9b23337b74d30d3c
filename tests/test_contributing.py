# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The worked example of CONTRIBUTING.md, carried out on a copy of the library."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

CHECKOUT = Path(__file__).resolve().parents[1]
BLOCK = re.compile(r"```python\n# (sweep_addon/\S+)\n(.*?)```", re.DOTALL)

TRIED = """
from math import pi, sin
import sweep_addon as sw
slot = sw.GeneralizedCylinder(contour={"kind": "slot", "span": 3.0, "width": 1.0}, trajectory=sw.trajectories.Line())
mesh, area = slot.mesh(), 3.0 * 1.0 + 32 / 2 * 0.5**2 * sin(2 * pi / 32)
assert len(mesh.boundary_edges()) == 0 and abs(mesh.volume() - area) < 1e-12
assert sw.dump(slot).count("slot") == 1
try:
    sw.GeneralizedCylinder(contour={"kind": "slot", "width": -1})
except sw.ShapeError as error:
    print(error)
"""


@pytest.fixture
def changed(tmp_path):
    """A copy of the library with the example's blocks in it."""
    if not (CHECKOUT / "CONTRIBUTING.md").exists():
        pytest.skip("the installed zip has no CONTRIBUTING.md")
    shutil.copytree(CHECKOUT / "sweep_addon", tmp_path / "sweep_addon")
    blocks = BLOCK.findall((CHECKOUT / "CONTRIBUTING.md").read_text())
    assert len(blocks) == 2 and sum(text.count("\n") for _, text in blocks) <= 40
    for name, text in blocks:
        path = tmp_path / name
        path.write_text(text if not path.exists() else merged(path.read_text(), text))
    return tmp_path


def merged(module, block):
    """The lines of a block in place of those that assign the same name, or before the first assignment."""
    for line in block.splitlines():
        name = line.split(" = ")[0] + " = "
        pattern = re.compile(rf"^{re.escape(name)}.*$", re.MULTILINE)
        if pattern.search(module):
            module = pattern.sub(line, module)
        else:
            module = module.replace("\nContour = ", f"\n{line}\nContour = ")
    return module


def python(folder, *arguments):
    return subprocess.run([sys.executable, *arguments], cwd=folder, capture_output=True, text=True, timeout=120)


@pytest.mark.skipif("bpy" in sys.modules, reason="plain Python is enough: it starts interpreters of its own")
def test_two_blocks_bring_a_contour_to_scripts_jobs_and_the_command_line(changed):
    tried = python(changed, "-c", TRIED)
    assert tried.stdout.strip() == "contour.width: must be more than 0, got -1", tried.stderr
    described = python(changed, "-m", "sweep_addon", "describe", "generalized-cylinder")
    assert "contour(slot).span" in described.stdout, described.stderr


def test_the_same_two_blocks_bring_it_to_blender(scene, changed):
    import bpy

    script = (
        "import bpy, sweep_addon.properties as p; p.register(); "
        "g = bpy.types.Mesh.bl_rna.properties['sweep'].fixed_type.properties['generalized_cylinder'].fixed_type; "
        "s = g.properties['contour_slot_span']; print(s.unit, s.description); p.unregister()"
    )
    if not bpy.app.binary_path:
        tried = python(changed, "-c", script)
    else:
        command = [bpy.app.binary_path, "--background", "--factory-startup", "--python-exit-code", "1", "--python-expr"]
        script = f"import sys; sys.path.insert(0, {str(changed)!r}); {script}"
        tried = subprocess.run([*command, script], capture_output=True, text=True, timeout=120)
    assert "LENGTH Distance between the centres of the ends" in tried.stdout, tried.stderr
