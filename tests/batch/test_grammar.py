# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grammars on the command line: words, sizes and classes on standard output, and every wrong line on standard error."""

import io
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from sweep_addon.batch.command import main

TREE = "#define r 0.5\n#generations 2\naxiom: F(1)\nF(l) -> F(l)[+F(l*r)]\n"


@pytest.fixture
def tree(tmp_path):
    path = tmp_path / "tree.l"
    path.write_text(TREE)
    return str(path)


def told(capsys, *arguments):
    """The exit code, standard output and standard error of a command."""
    code = main(list(arguments))
    said = capsys.readouterr()
    return code, said.out, said.err


def test_derive_prints_the_word(tree, capsys):
    assert told(capsys, "derive", tree) == (0, "F(1)[+F(0.5)][+F(0.5)[+F(0.25)]]\n", "")
    assert told(capsys, "derive", tree, "-n", "1") == (0, "F(1)[+F(0.5)]\n", "")


def test_derive_counts_modules_of_each_generation(tree, capsys):
    assert told(capsys, "derive", tree, "--count", "-n", "3") == (0, "1\n5\n13\n29\n", "")


def test_a_seed_decides_between_productions(tmp_path, capsys):
    path = tmp_path / "chance.l"
    path.write_text("axiom: AAAAAAAAAAAAAAAAAAAA\nA -(0.5)-> B\nA -(0.5)-> C\n")
    words = [told(capsys, "derive", str(path), "-n", "1", "--seed", str(seed))[1] for seed in (1, 1, 2)]
    assert words[0] == words[1] != words[2]
    assert set(words[0].strip()) == {"B", "C"}


def test_describe_says_class_and_size(tree, capsys):
    code, out, err = told(capsys, "describe", tree)
    assert (code, err) == (0, "")
    assert out.splitlines()[0] == "class: parametric bracketed D0L-system"
    assert "size: 13 modules after 2 generations" in out and "constant: r = 0.5" in out


def test_describe_says_what_constants_are_turned_by(tmp_path, capsys):
    path = tmp_path / "tree.l"
    path.write_text(
        "#define r1 0.9  # 0.5 .. 1.2 how much shorter\n#define l 2 /* 1 .. 3.5 m of the trunk */\n"
        "#define q (1 - r1)^2\n#define n 3 # boughs\naxiom: F\n"
    )
    assert told(capsys, "describe", str(path))[1].splitlines()[-4:] == [
        "constant: r1 = 0.9, 0.5 to 1.2: how much shorter",
        "constant: l = 2 m, 1 to 3.5: of the trunk",
        "constant: q = 0.01",
        "constant: n = 3: boughs",
    ]


@pytest.fixture
def written(monkeypatch):
    """A function that writes bytes to standard input."""
    return lambda data: monkeypatch.setattr(sys, "stdin", SimpleNamespace(buffer=io.BytesIO(data)))


def test_a_minus_reads_standard_input(written, capsys):
    written(TREE.encode())
    assert told(capsys, "derive", "-", "-n", "1") == (0, "F(1)[+F(0.5)]\n", "")
    written("ω : F\nF → FF".encode())
    assert told(capsys, "describe", "-")[1].splitlines()[0] == "class: D0L-system"


@pytest.mark.parametrize("verb", ["derive", "describe"])
def test_what_standard_input_has_wrong_is_told_with_its_place(verb, written, capsys):
    written(b"axiom: F\nF -> F]\n")
    code, out, err = told(capsys, verb, "-")
    assert (code, out) == (2, "")
    assert err.splitlines()[0] == "standard input:2:7: expected '[' before it, found ']'"
    for data in (b"\xff\xfe\x00", b"axiom: " + b"A" * 5_000_000):
        written(data)
        assert told(capsys, verb, "-")[2].startswith("standard input: must ")


def test_every_wrong_line_is_told_with_its_place(tmp_path, capsys):
    path = tmp_path / "wrong.l"
    path.write_text("axiom: F(1\nF(x) -> F(x*)\n")
    code, out, err = told(capsys, "derive", str(path))
    assert (code, out) == (2, "")
    assert err.splitlines()[0] == f"{path}:1:9: expected ')' after it, found '('"
    assert err.splitlines()[2] == " " * 12 + "^"
    assert err.splitlines()[3] == f"{path}:2:13: expected a value, found the end of the formula"


@pytest.mark.parametrize("data", [b"\xff\xfe\x00", b"axiom: A\x00B", None, b"axiom: " + b"A" * 5_000_000])
def test_what_is_no_grammar_is_refused_in_a_line(tmp_path, capsys, data):
    path = tmp_path / "none.l"
    if data is not None:
        path.write_bytes(data)
    code, out, err = told(capsys, "derive", str(path))
    assert (code, out) == (2, "") and err.startswith(f"{path}:")


def test_a_runaway_grammar_is_refused_with_its_size(tmp_path, capsys):
    path = tmp_path / "runaway.l"
    path.write_text("axiom: F\nF -> FFFFFFFFFF\n")
    code, out, err = told(capsys, "derive", str(path), "-n", "12")
    assert (code, out) == (2, "")
    assert err == "generations: must make at most 20,000,000 modules, but 12 make 1,000,000,000,000\n"


def test_a_device_without_end_is_no_grammar(capsys):
    if not Path("/dev/zero").exists():
        pytest.skip("needs /dev/zero, which this system has not")
    for verb in ("derive", "describe"):
        assert told(capsys, verb, "/dev/zero") == (2, "", "/dev/zero: must have at most 4,000,000 bytes\n")
