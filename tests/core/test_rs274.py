# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Programs of machines: the moves that LinuxCNC's own interpreter makes of them, or a refusal that says why not."""

import gzip
import re

import numpy as np
import pytest
import rs274_oracle as oracle

import sweep_addon as sw
from sweep_addon.core.machining.programs import plain, reading

REFUSED_HERE = {  # by what the refusal says, of programs that LinuxCNC runs, or runs farther
    "a cycle of a lathe": {"linuxcnc_g71-with-g70.ngc"},
    "threads of a lathe": {"linuxcnc_g76only.ngc"},
    "programs of three axes": {"linuxcnc_g53.ngc", "linuxcnc_unit-conversion.ngc"},
    "in the plane of G17 alone": {"linuxcnc_g19-g98-g84.ngc"},
}  # fmt: skip
READ_TO_THE_END = {"camotics_text.ngc"}  # whose last line is a % that no other goes with, which LinuxCNC minds


@pytest.mark.thorough
@pytest.mark.parametrize("path", oracle.ORACLES, ids=lambda path: path.name.removesuffix(".canon.gz"))
def test_a_real_program_makes_the_moves_of_linuxcnc_or_is_refused_by_name(path):
    told = oracle.Told(path)
    here, refused = oracle.read_here(oracle.text_of(path))
    differ, (_, missing) = oracle.differences(here, told.moves)
    assert differ == []
    name = path.name.removesuffix(".canon.gz")
    reasons = [reason for reason, names in REFUSED_HERE.items() if name in names]
    if (reasons or told.refusal) and name not in READ_TO_THE_END:
        assert re.match(r"line \d+ ", refused)
        assert told.refusal or reasons[0] in refused
    else:
        assert (refused, missing) == ("", 0)
        assert len(here) >= len([move for move in told.moves if move.kind in "AN"])


@pytest.mark.parametrize(
    "contour",
    [  # of those that LinuxCNC refuses with "without gouging"
        "G41.1 D2\nG0 X3.067567 Y3.334976\nG3 X4.253967 Y5.257473 I0.78502 J0.842874\nG1 X-3.770591 Y-4.964904",
        "G42.1 D2\nG1 X-6 Y-2\nG2 X-4.065925 Y-6.73397 I2.898274 J-1.577973\n"
        "G2 X0.813185 Y-12.938983 I4.598489 J-1.404899",
        "G41.1 D2\nG1 X7 Y7\nX3 Y0.4\nX6.5 Y4.5\nG2 X9.5 Y5.2 R1.5",
        "G41.1 D2\nG1 X4 Y-3\nG0 X4 Y1\nG1 X3 Y-4",
    ],
)
def test_a_corner_that_the_tool_does_not_fit_into_is_refused(contour):
    with pytest.raises(sw.ShapeError, match=r"line \d+ goes into a corner that .* not fit into"):
        sw.machining.read(f"G21 F100\nG0 X0 Y0 Z0\n{contour}\nG40\nM2")


def test_round_a_square_the_tool_stays_its_radius_away():
    """Left of it: the first move ends where the second begins, arcs go round the other corners."""
    text = "G21 F100\nG0 X-20 Y0 Z0\nG41 D7 G1 X0\nY10\nX10\nY0\nX-20\nG40 G0 Y-20\nM2"
    path = sw.machining.read(text, {7: 0.004}.get)
    ends = [[-20, 0], [-2, 2], [-2, 10], [0, 12], [10, 12], [12, 10], [12, 0], [10, -2], [-20, -2], [-20, -20]]
    assert (path.points[:, :2] * 1e3).round(9).tolist() == ends
    assert (path.centres[:, :2] * 1e3).round(9).tolist() == [[0, 10], [10, 10], [10, 0]]
    assert path.turns[:, 2] == pytest.approx([-np.pi / 2] * 3)


def test_beside_a_contour_that_is_turned_and_moved_the_tool_is_as_well():
    """Also where it goes up and down in a corner that is cut short: rounding tells places apart that are one."""
    contour = "F100 G0 X-20 Y0 Z0\nG41.1 D4 G1 X0\nZ1\nZ2\nY10\nG2 X10 Y20 R10\nG1 Z-1\nX10 Y0\nG40 G0 X0 Y-20\nM2"
    plainly, turned = (sw.machining.read(f"G21 G10 L2 P1 {where}\n{contour}") for where in ("X0", "X3 Y-7 Z1 R33"))
    x, y, z = plainly.points.T
    place = (x + 1j * y) * np.exp(1j * np.radians(33)) + 0.003 - 0.007j
    assert np.allclose(turned.points, np.column_stack((place.real, place.imag, z + 0.001)), rtol=0, atol=1e-12)
    assert np.allclose(turned.turns, plainly.turns) and len(plainly) > 9


def test_arcs_of_several_turns_have_as_many_beside_the_contour():
    text = "G21 F100 G0 X0 Y0 Z0\nG41.1 D2 G1 X10\nG3 X10 Y0 I0 J5 P3 Z-3\nX15 Y5 J5 P2\nG40 G1 X0\nM2"
    path = sw.machining.read(text)
    assert path.turns[:, 2] == pytest.approx([6 * np.pi, 2.5 * np.pi])
    assert path.points[path.arcs] * 1e3 == pytest.approx(np.array([(10, 1, -3), (14, 5, -3)]))
    entering = sw.machining.read("G21 F100 G0 X0 Y0 Z0\nG41.1 D2 G3 X10 Y0 I5 P2\nX0 I-5\nG40 G1 X0 Y50\nM2")
    assert entering.turns[:, 2] // (2 * np.pi) == pytest.approx([1, 0])


@pytest.mark.parametrize("diameter", [0.004, 0.006, 0.008])
def test_what_is_cut_beside_a_contour_does_not_hang_on_how_wide_the_tool_is(diameter):
    """A boss of 20 mm with round corners of 4 stays, of which 2 mm are seen."""
    text = "G21 F100\nG0 X-20 Y0 Z5\nZ-2\nG41 G1 X-10\nY6\nG2 X-6 Y10 R4\nG1 X6\nG2 X10 Y6 R4\nG1 Y-6\n"
    text += "G2 X6 Y-10 R4\nG1 X-6\nG2 X-10 Y-6 R4\nG1 Y1\nG40 X-20\nG0 Z5\nM2"
    block = sw.machining.Box(low=(-0.011, -0.011, -0.002), high=(0.011, 0.011, 0.0))
    left = sw.MachinedStock(text, tool=sw.machining.FlatEnd(diameter), stock=block, cell=1e-4).mesh().volume()
    area, around = 20**2 - (4 - np.pi) * 4**2, 4 * 12 + 2 * np.pi * 4
    assert left * 1e9 == pytest.approx(2 * area, abs=2 * around * 0.1 / 2)  # walls lean by up to a cell


CHANGED = """G21 G90 F300
G91 G28 Z0
G90 T1 M6
G0 X0 Y0
Z5
G1 Z-1
X10
G0 Z5
G91 G28 Z0
G90 T2 M6
G0 X10 Y10
Z5
G1 Z-1
X0
G0 Z5
G28 G91 Z0 Y0
M30"""


@pytest.mark.parametrize("away", ["G91 G28 Z0", "G53 G0 Z0"])
def test_moves_to_a_place_that_is_not_told_and_back_are_left_out(away):
    """As of most programs of Fanuc's dialect, which change tools there: until all axes are told a place again."""
    program = CHANGED.replace("G91 G28 Z0", away)
    path = sw.machining.read(program)
    starts, ends, moves = path.segments(1e-6)
    slots = [(0, 0, 5), (0, 0, -1), (10, 0, -1), (10, 0, 5)], [(10, 10, 5), (10, 10, -1), (0, 10, -1), (0, 10, 5)]
    assert (starts * 1e3).round(9).tolist() == [list(place) for slot in slots for place in slot[:-1]]
    assert (ends * 1e3).round(9).tolist() == [list(place) for slot in slots for place in slot[1:]]
    assert path.lines[moves].tolist() == [6, 7, 8, 13, 14, 15]
    assert path.lines[path.apart[path.apart > path.first]].tolist() == [9, 11, 12, 16]
    told = sw.MachinedStock(program, cell=5e-4).verify().sentences()
    sentence = "Moves to places of the machine and back (G28, G53) are not looked at, by 4 lines, from line 9 on"
    assert any(each.startswith(sentence) for each in told)


def test_a_place_of_the_machine_counts_where_the_program_has_set_an_offset_or_cuts_from_there():
    offset = sw.machining.read("F9 G10 L2 P1 Z-7\nG0 X0 Y0 Z5\nG1 Z-1\nG53 G0 Z0\nG0 X9")
    assert (offset.points[:, 2] * 1e3).round(9).tolist() == [-2, -8, 0, 0] and not len(offset.apart)
    cut = sw.machining.read("F9 G0 X0 Y0 Z5\nG1 Z-1\nG53 G0 Z0\nG0 X9\nG1 X12")
    starts, _, moves = cut.segments(1e-6)
    assert (
        cut.apart.tolist() == [2, 3] and (starts[-1] * 1e3).round(9).tolist() == [9, 0, 0] and moves.tolist() == [1, 4]
    )


def test_a_home_that_the_program_tells_is_gone_to():
    """As LinuxCNC does: by the place that the words say, and then those axes alone."""
    text = "G0 X1 Y2 Z3\nG28.1\nX9 Y9\nG28 X5\nG91 G28 Z1\nG90 G0 X20 Y20 Z20\nG28"
    assert ends(text) == [
        [1, 2, 3], [9, 9, 3], [5, 9, 3], [1, 9, 3], [1, 9, 4], [1, 9, 3], [20, 20, 20], [1, 2, 3],
    ]  # fmt: skip


def test_the_programs_are_there():
    assert len(oracle.ORACLES) == 61
    assert sum(len(oracle.Told(path).moves) for path in oracle.ORACLES[:40]) > 10_000


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        ("2 + 3 * 4 ** 2 ** 2 / 8", 2 + 3 * (4**2) ** 2 / 8),  # of operators that bind alike the left one is first
        ("[1 + 2] * -3", -9),
        ("- - 2 ** 2", 4),  # a sign binds more than an operator
        ("10 MOD 3", 1), ("-10 mod 3", 2), ("7 gt 3 and 0 or 1 xor 1", 0),
        ("1.00005 eq 1", 1), ("1.001 eq 1", 0), ("1 ne 2", 1), ("1 le 1.00005", 1), ("2 ge 2.00005", 1), ("2 lt 2", 0),
        ("sin[30] + cos[60] + tan[45]", 2), ("asin[1] + acos[0] + atan[1]/[-1]", 315),
        ("sqrt[abs[-16]] + exp[0] + ln[1]", 5), ("round[-2.5] + round[2.5] + fix[-2.1] + fup[2.1]", 0),
        ("#1 + ##2 + #<deep> + #[1 + 1]", 5 + 5 + 7 + 1), ("exists[#<deep>] + exists[#<shallow>]", 1), (".5e", None),
    ],
)  # fmt: skip
def test_an_expression_is_what_the_language_says(expression, expected):
    program = f"#1 = 5\n#2 = 1\n#<deep> = 7\nG0 X0 Y0 Z0\nG0 X[{expression}]"
    if expected is None:
        with pytest.raises(sw.ShapeError, match=r"^line 5 needs ']' before 'e]'$"):
            sw.machining.read(program)
    else:
        assert sw.machining.read(program).points[-1, 0] == pytest.approx(expected * 1e-3, abs=1e-15)


def ends(text):
    """Where the moves of a program end, in millimetres."""
    return np.round(sw.machining.read(text).points * 1e3, 9).tolist()


def test_parameters_of_a_line_are_set_after_it_is_read():
    assert ends("#1 = 3\n#1 = 4 G0 X#1\nX#1") == [[3, 0, 0], [4, 0, 0]]


def test_subroutines_have_arguments_names_and_values_of_their_own():
    text = """
        #1 = 7
        o<corner> sub
        #<size> = [#1 * 2]
        G0 X#<size> Y#2
        o<corner> endsub [#<size> + 1]
        o<corner> call [2] [5]
        G0 X#1 Y#<_value> Z[exists[#<size>]]
    """
    assert ends(text) == [[4, 5, 0], [7, 5, 0]]


def test_loops_and_branches_go_where_they_lead():
    text = """
        #1 = 0
        o1 repeat [2]
          #1 = [#1 + 1]
          G0 X#1
        o1 endrepeat
        o2 while [1]
          #1 = [#1 + 1]
          o3 if [#1 lt 5]
            o2 continue
          o3 elseif [#1 eq 6]
            o2 break
          o3 else
            G0 X#1
          o3 endif
        o2 endwhile
        o4 do
          #1 = [#1 - 3]
          G0 X#1
        o4 while [#1 gt 0]
    """
    assert [x for x, _, _ in ends(text)] == [1, 2, 5, 3, 0]


def test_a_comment_before_a_loop_is_no_part_of_it():
    assert ends("(twice) o1 repeat [2]\nG91 G0 X1 (a step)\nN30 (again) o1 endrepeat") == [[1, 0, 0], [2, 0, 0]]


def test_a_loop_is_left_for_what_comes_after_it_though_others_have_its_label():
    """Each runs once up to its own word, whose label the loop before, the one within and the one after have too."""
    loop = "#1 = 0\no1 while [#1 lt 2]\n#1 = [#1 + 1]\no1 repeat [1]\no1 endrepeat\n{}\nG0 X9\no1 endwhile\nG0 X#1\n"
    assert [x for x, _, _ in ends(loop.format("o1 continue") + loop.format("o[2 - 1] break"))] == [2, 1]


def test_arcs_by_radius_are_those_by_centre():
    """From 3 to 12 o'clock of a circle: a quarter, and with a negative radius the other three quarters."""
    for code, radius, centre, turn in [(3, 10, 0, 0.5), (2, -10, 0, -1.5), (2, 10, 0.01, -0.5), (3, -10, 0.01, 1.5)]:
        arc = sw.machining.read(f"F9 G0 X10 Y0 Z0\nG{code} X0 Y10 R{radius}")
        assert np.allclose(arc.centres, [centre, centre, 0], atol=1e-15)
        assert np.allclose(arc.turns, [0, 0, turn * np.pi])


@pytest.mark.parametrize("tolerance", [1e-4, 1e-5])
def test_chords_of_a_helix_stay_within_the_tolerance(tolerance):
    path = sw.machining.read("F9 G0 X10 Y0 Z0\nG3 X10 Y0 Z-6 I-10 P3")
    starts, ends, moves = path.segments(tolerance)
    middle = np.linalg.norm(((starts + ends) / 2)[moves == 1, :2], axis=1)
    assert np.allclose(np.linalg.norm(ends[:, :2], axis=1), 0.01, atol=1e-15)
    assert 0.5 * tolerance < 0.01 - middle.min() <= tolerance
    angle = np.unwrap(np.arctan2(*ends[moves == 1][:, 1::-1].T))
    assert np.allclose(ends[moves == 1][:, 2], -0.006 * (angle - angle[0] + angle[1] - angle[0]) / (6 * np.pi))


def test_moves_from_an_unknown_place_are_told_from_the_others():
    """A rapid move comes from wherever the tool was, until each axis has been told a place, or something is cut."""
    assert sw.machining.read("F9 G0 Z5\nX1 Y1\nG1 Z-1").first == 2
    assert sw.machining.read("F9 G1 X5").first == 0
    assert sw.machining.read("G0 X1").first == 1


def test_plain_lines_read_at_once_are_those_read_one_by_one(monkeypatch):
    """In a work offset that is turned, by places and by steps, with comments behind some."""
    random = np.random.default_rng(3)
    lines = ["G10 L2 P1 X3 Y4 R30", "G0 X0 Y0 Z5", "G92 X1", "G1 F100 X1"]
    for number in random.uniform(-9, 9, (60, 3)).round(3):
        words = [f"{letter}{n}" for letter, n in zip("XYZ", number, strict=True) if random.random() < 0.7] or ["X1"]
        lines.append(
            "".join([random.choice(["", "G0", "G01", "g1"]), *words, random.choice(["", "F7", " f8.5 (aside)", ";F"])])
        )
    text = "\n".join([*lines, "G91", *lines[4:]])
    assert plain.LINE.match(lines[5]) and sum(bool(plain.LINE.match(line)) for line in lines) > 50
    quick = sw.machining.read(text)
    monkeypatch.setattr(plain, "FEWEST", np.inf)
    slow = sw.machining.read(text)
    assert np.allclose(quick.points, slow.points, atol=1e-15)
    assert [getattr(quick, name).tolist() for name in ("kinds", "lines", "tools")] == [
        getattr(slow, name).tolist() for name in ("kinds", "lines", "tools")
    ]


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("G0 X1\nG1 X2", "line 2 moves at a feed before there is one: F"),
        ("G1 F9 X1\nX2\nX3\nX4\nG93\nX5", "line 6 moves at a feed without its F, which G93 needs with each move"),
        ("X1", "line 1 has X without a G code that says how to move"),
        ("G0 X1 X2", "line 1 has two words X"),
        ("G0 G1 X1", "line 1 has G0 and G1, of which only one can be meant"),
        ("G12.3", "line 1 has G12.3, which is not known"),
        ("M123", "line 1 has M123, which is not known"),
        ("G1 F9 X0 Y0 Z0\nG28 Z0\nG1 X3", "line 3 moves at a feed while Z is at the home of the machine, which the"),
        ("G0 X0 Y0 Z0\nG91 G28 Z0\nG92 X2 Z0", "line 3 sets Z by the home of the machine, which the"),
        ("G0 X0 Y0 Z0\nG28\nG10 L20 P1 Y0", "line 3 sets Y by the home of the machine, which the"),
        ("G0 X0 Y0 Z0\nG28\nG30.1", "line 3 sets a home at one that the program does not tell"),
        ("G41.1 D3\nG28", "line 2 has G28 while G41 or G42 compensates: G40 ends that"),
        ("G41 D1", "line 1 has G41 for tool 1, whose diameter is not told"),
        ("G41.1", "line 1 needs the diameter D of the tool for G41.1"),
        ("G19\nG42.1 D3", "line 2 has G42.1 in another plane than those of G17 and, not turned, G18"),
        ("G41.1 D3 L1", "line 1 has G41.1 with L, which is of lathes"),
        ("G41.1 D3\nG42.1 D3", "line 2 has G42.1 while G41 or G42 compensates: G40 ends that"),
        ("G41.1 D3\nG20", "line 2 has G20 while G41 or G42 compensates: G40 ends that"),
        ("G41.1 D3\nG10 L2 P1 X3", "line 2 has G10 while G41 or G42 compensates: G40 ends that"),
        ("F9 G41.1 D3\nG81 X9 Z-1 R1", "line 2 has G81 while G41 or G42 compensates: G40 ends that"),
        ("G41.1 D3\nT1 M6", "line 2 changes the tool while G41 or G42 compensates: G40 ends that"),
        ("F9 G41.1 D3\nG1 X1.5", "line 2 begins to compensate with a move of 1.5 mm, no more than the tool's radius"),
        ("F9 G41.1 D3\nG1 X9\nG40\nG2 X0 R9", "line 4 has an arc right after G40, where a straight move must lead"),
        ("F9 G41.1 D3\nG1 X9\nG3 X10 Y1 J1", "line 3 has an arc of radius 1 mm inside which the tool does not fit"),
        ("G0 A90", "line 1 moves A to 90; programs of three axes are read, and others keep 0"),
        ("G0 X[1 + ]", "line 1 needs a number before ']'"),
        ("G0 X[1", "line 1 needs ']' at its end"),
        ("G0 X\u0661", "line 1 needs a number before '\u0661'"),
        ("G1 F9 X1 Y1 Z1\nX2\nX\u0662\nX3\nX4\nX5", "line 3 needs a number before '\u0662'"),
        ("G0 X#<size>", "line 1 asks for parameter #<size>, which is not set"),
        ("G0 X#5063", "line 1 asks for parameter #5063, which only a machine knows"),
        ("#5221 = 3", "line 1 sets parameter #5221, which is the machine's: a program may set #1 to #5000"),
        ("G0 X[1/0]", "line 1 calculates 1 / 0, which has no value"),
        ("G0 X[sqrt[-1]]", "line 1 calculates sqrt[-1], which has no value"),
        ("G0 X[[0 - 8] ** 0.5]", "line 1 calculates -8 ** 0.5, which has no value"),
        ("G0 X[10**10]", "line 1 moves to 1e+07 m, farther than any machine"),
        ("G1 F9 X1\nX2\nX3\nX4\nX-2000000000\nX6", "line 5 moves to -2e+06 m, farther than any machine"),
        ("o<x> call", "line 1 calls subroutine o<x>, which the text does not have"),
        ("o1 while [1]", "line 1 begins while, which does not end: endwhile"),
        ("o1 endif", "line 1 has endif of a label that nothing was begun with"),
        ("o1 break", "line 1 has break outside of a loop of its label"),
        ("o1 if [1]\no2 do\no1 endif\no2 while [0]", "line 3 ends if before do in it has ended"),
        ("G17\n(not closed", "line 2 has a bracket of a comment without the other"),
        ("G1 F9 X1\nG2 X2 R0.1", "line 2 has an arc of radius 0.1 between ends that are 1 apart"),
        ("G1 F9 X1\nG2 X2 I1", "line 2 has an arc without radius"),
        ("G1 F9 X1\nG2 X2 I0.4", "line 2 has an arc whose ends are 0.4 mm and 0.6 mm from its centre, which must"),
        ("G1 F9 X1\nG2 X2", "line 2 has an arc without its radius R or centre I, J, K"),
        ("G81 F9 X1 R1", "line 1 needs Z, the depth of its canned cycle"),
        ("G81 F9 X1 Z-1", "line 1 needs R, the height above which its canned cycle moves fast"),
        ("G83 F9 X1 Z-1 R1", "line 1 needs Q, how deep each peck of G83 goes, of more than 0"),
        ("G81 F9 Z2 R1", "line 1 has R, where its canned cycle begins to feed, below the depth it goes to"),
        ("T9999999999 M6", "line 1 needs the number of a tool for T, from 0 to 2147483647, got 1e+10"),
        ("M61 Q-1", "line 1 needs the number of a tool for Q, from 0 to 2147483647, got -1"),
        ("G1 F9 X1\n\n\n\n\n\n", ""),
        ("%\nG0 X1\n%\nG99.9", ""),
        ("G0 X1\n%\n", ""),
        ("G0 X1\n%\nG0 X2", "line 2 has a word that no program has before '%', of letters and numbers"),
        ("G0 X1 ; comment (of any kind\n/ G99.9", ""),
    ],
)  # fmt: skip
def test_what_is_wrong_or_not_known_is_told_with_its_line(text, sentence):
    if not sentence:
        assert len(sw.machining.read(text)) == 1
        return
    with pytest.raises(sw.ShapeError, match="^" + re.escape(sentence)):
        sw.machining.read(text)


@pytest.mark.parametrize(
    ("text", "got"),
    [
        (gzip.compress(b"G0 X1 Y2\n" * 99).decode("latin-1"), "bytes that are no text, as those of a compressed file"),
        (gzip.compress(b"G0 X1 Y2\n" * 99).decode("utf-8", "replace"), "bytes that are no text, as those of a compre"),
        ("PK\3\4\nG1 X2", "bytes that are no text, as those of a compressed file"),
        ("<html>\n<body>", "'<html>'"),
        ("solid part\nfacet normal 0 0 1", "'solid part'"),
        ("BEGIN PGM 1 MM", "'BEGIN PGM 1 MM'"),
        ('{"kind": "block"}', '\'{"kind": "block"}\''),
        ("%PDF-1.4", "'%PDF-1.4'"),
    ],
)
def test_what_is_no_program_at_all_is_refused_as_that(text, got):
    with pytest.raises(sw.ShapeError) as refusal:
        sw.machining.read(text)
    needed = 'line 1 is of no program of RS-274 ("G-code"), whose lines are of words as G1 X2.5, got '
    assert str(refusal.value).startswith(needed + got) and refusal.value.line == 1


def test_a_slip_in_the_first_line_of_a_program_is_told_as_that():
    with pytest.raises(sw.ShapeError, match="^line 1 needs a number before 'oto0'$"):
        sw.machining.read("GOTO 0\nG1 X2")


@pytest.mark.parametrize(
    "text",
    [
        "o1 while [1]\no1 endwhile",
        "o1 sub\no1 call\no1 endsub\no1 call",
        "O1\nM98 P1\nM99",
        "o1 repeat [1000000000]\no1 endrepeat",
        "M98 P7 L999999999\nM30\nO7\nM99",
        "G0 X0 Y0 Z9\nG91 G81 F9 X1 Z-1 R1 L999999999",
        "G0 X0 Y0 Z9\nG83 F9 X1 Z-1 R1 Q0.0000000001",
        "G1 F9 X" + "[" * 5000 + "1" + "]" * 5000,
        "G1 F9 X" + "-" * 5000 + "1",
        "G1 F9 X[" + "1+" * 9000 + "1]",
        "G1 F9 X[9**9**9**9]",
        "G2 F9 X1 Y0 R1 P1000000000",
        " " * 100_000 + "G0 X1 Q",
        "G1 F9 X0 Y0 Z0\nX" + "1" * 100_000 + "Q",
        "\n".join(f"o{number} if [1]" for number in range(50_000)),
        "o1 while [1]\no2 if [0]\n" + "o2 elseif [0]\n" * 10_000 + "o2 endif\no1 endwhile",
    ],
)
def test_a_hostile_program_is_refused_soon(text, monkeypatch):
    monkeypatch.setattr(reading, "MOST_STEPS", 20_000)  # of a million, which take some seconds
    with pytest.raises(sw.ShapeError, match=r"^line \d+ "):
        sw.machining.read(text)
