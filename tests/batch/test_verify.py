# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb verify: whether a program makes its part, by the exit code and in sentences with the lines."""

import pytest

from sweep_addon.batch.command import main

STOCK = """kind = "machined-stock"
program = { file = "part.nc" }
cell = 0.001

[tool]
kind = "flat-end"

[stock]
kind = "box"
low = [-0.02, -0.02, -0.01]
high = [0.02, 0.02, 0.0]
"""
PART = """kind = "placed"
matrix = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -0.006]]
[solid]
kind = "block"
width = 0.04
depth = 0.04
height = 0.008
"""
RIGHT = "(part \xb0)\nG21 F9\nG0 X0 Y0 Z5\nG1 Z-2\nX9\nG0 Z5\n"


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "stock.toml").write_text(STOCK)
    (tmp_path / "part.toml").write_text(PART)
    (tmp_path / "part.nc").write_bytes(RIGHT.encode("latin-1"))
    return tmp_path


def verify(folder, *told):
    return main(["verify", str(folder / "stock.toml"), *told])


def test_a_right_program_ends_with_0(folder, capsys):
    assert verify(folder, "--part", str(folder / "part.toml")) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].endswith("stock.toml: right") and "Up to 2 mm are left above the part" in lines[1]
    assert verify(folder) == 0
    assert capsys.readouterr().out.splitlines() == [
        f"{folder / 'stock.toml'}: right",
        f"{folder / 'stock.toml'}: There was no part to compare with.",
    ]


def test_a_program_that_gouges_ends_with_1_and_names_the_line(folder, capsys):
    (folder / "part.nc").write_text(RIGHT.replace("X9", "X9 Z-2.5"))
    assert verify(folder, "--part", str(folder / "part.toml")) == 1
    first, second, *_ = capsys.readouterr().out.splitlines()
    assert first.endswith("stock.toml: wrong")
    assert "The program cuts up to 0.5 mm into the part" in second and second.endswith(", by line 5.")


def test_a_rapid_move_through_the_stock_ends_with_1_without_a_part_too(folder, capsys):
    (folder / "part.nc").write_text(RIGHT.replace("X9", "G0 X9"))
    assert verify(folder) == 1
    assert "Rapid moves cut up to 2 mm into the stock, by line 5." in capsys.readouterr().out


def test_what_is_told_wrong_ends_with_2(folder, capsys):
    (folder / "part.nc").write_text("G0 X1\nG33 K2\n")
    assert verify(folder) == 2
    refused = capsys.readouterr().err
    assert refused.startswith(f"{folder / 'stock.toml'}:2: ") and refused.count("\n") == 1
    assert "part.nc: line 2 has G33, a move that the spindle times, which is not read" in refused
    assert main(["verify", str(folder / "part.toml")]) == 2
    assert "kind: must be machined-stock, got 'placed'" in capsys.readouterr().err
