# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/blender speaks Blender's command line, whether the real one or the bpy wheel is behind it."""

import importlib.util
import os
import subprocess
from pathlib import Path

import pytest

LAUNCHER = Path(__file__).resolve().parents[1] / "scripts" / "blender"
pytestmark = pytest.mark.skipif(not importlib.util.find_spec("bpy"), reason="needs Blender, and this host has none")

SMALL_SCENE = """
import bpy
scene = bpy.context.scene
scene.render.engine, scene.cycles.samples = "CYCLES", 1
scene.render.resolution_x = scene.render.resolution_y = 16
"""
AGAIN = """
import subprocess
print(subprocess.run([bpy.app.binary_path, "--version"]).returncode, "again")
"""


@pytest.fixture(scope="module")
def version():
    """What is answered to who asks for the version."""
    return blender("--version")


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    """The folder in which one Blender has rendered, after it ran a script twice and started itself; and its words."""
    folder = tmp_path_factory.mktemp("session")
    script = folder / "a script.py"
    script.write_text("import bpy, sys; print(bpy.context.scene.frame_start, sys.argv[sys.argv.index('--') + 1 :])")
    options = ("-s", 3, "--python", script, "-s", 4, "--python", script, "--python-expr", SMALL_SCENE + AGAIN)
    frames = folder / "frames"
    return frames, blender(*options, "-o", frames / "###", "-F", "PNG", "-f", "2,5..6", "--", "--engine", "own").stdout


def blender(*arguments):
    command = [LAUNCHER, "--background", "--factory-startup", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=120)


def test_version_is_a_supported_one(version):
    answer = version.stdout
    major, minor = answer.split()[1].split(".")[:2]
    assert answer.startswith("Blender ") and (int(major), int(minor)) >= (4, 5)


def test_a_terminal_is_told_which_blender_it_is_and_how_to_get_another(version):
    pty = pytest.importorskip("pty", reason="Windows has no such terminals")
    screen, terminal = pty.openpty()
    done = subprocess.run([LAUNCHER, "--version"], stdout=subprocess.PIPE, stderr=terminal, text=True, timeout=120)
    os.close(terminal)
    told = os.read(screen, 1000).decode()
    os.close(screen)
    assert "scripts/blender: " in told and "SWEEP_BLENDER=" in told and "BLENDER=PROGRAM" in told
    assert done.stdout.startswith("Blender ")
    assert "scripts/blender: " not in version.stderr  # nor is a log


@pytest.mark.parametrize(
    ("options", "code"),
    [
        (["--python-exit-code", "3", "--python-expr", "1 / 0"], 3),
        (["--python-expr", "1 / 0"], 0),
        (["--python-exit-code", "3", "--python-expr", "import sys; sys.exit(4)"], 4),
        (["--command", "nobody-registered-this"], 1),
    ],
)
def test_exit_code_is_blenders(options, code):
    assert blender(*options).returncode == code


def test_options_act_in_order_and_arguments_after_two_dashes_are_the_script_s(session):
    _, told = session
    lines = [line for line in told.splitlines() if "own" in line]
    assert lines == ["3 ['--engine', 'own']", "4 ['--engine', 'own']"], told


def test_rendered_frames_are_named_by_their_number(session):
    frames, told = session
    assert sorted(path.name for path in frames.glob("*")) == ["002.png", "005.png", "006.png"], told


def test_a_script_can_start_the_same_blender(session):
    assert "0 again" in session[1], session[1]
