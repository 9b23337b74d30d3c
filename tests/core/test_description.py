# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a shape may be told is described completely, for people and for editors."""

import json
import tomllib

import pytest

from sweep_addon.core.declared.description import describe, schema
from sweep_addon.core.declared.forms import dump
from sweep_addon.core.declared.parameters import inside, parameters
from sweep_addon.core.shapes.kinds import SHAPES, GeneralizedCylinder

ROWS = {row.key: row for row in describe(GeneralizedCylinder)}


def test_rows_say_what_is_taken_and_in_which_limits():
    row = ROWS["contour(circle).radius"]
    assert (row.takes, row.limits, row.default) == ("number", "m, more than 0", 0.1)
    assert ROWS["twist"].takes == "constant (number) | formula (text) | points (list of lists of 2 numbers)"
    assert (ROWS["twist"].limits, ROWS["twist"].default) == ("rad", 0.0)
    assert ROWS["trajectory(polyline).points"].limits == "m, at most 200000 points"
    assert ROWS["trajectory"].default == "helix" and "helix" in ROWS["trajectory"].takes
    assert ROWS["frame(fixed-up).up"].takes == "list of 3 numbers"


@pytest.mark.parametrize("shape", SHAPES)
def test_every_parameter_has_a_row_with_a_doc(shape):
    found = {row.key: row.doc for row in describe(shape)}
    assert {p.name for p in parameters(shape)} <= found.keys() and all(found.values())


def test_the_schema_is_a_schema_and_accepts_what_is_written():
    jsonschema = pytest.importorskip("jsonschema")
    made = json.loads(json.dumps(schema(SHAPES)))
    jsonschema.Draft202012Validator.check_schema(made)
    validator = jsonschema.Draft202012Validator(made)
    for shape in SHAPES:
        validator.validate(tomllib.loads(dump(shape())))
    table = tomllib.loads(dump(GeneralizedCylinder(scale_x="t", twist=[(0, 1), (1, 2)], frame="frenet")))
    validator.validate(table)
    for wrong in ({"radios": 1}, {"kind": "tube"}, {"scale_x": True}, {"contour": {"kind": "circle", "radius": 0}}):
        assert list(validator.iter_errors(table | wrong)), wrong


def test_the_schema_knows_every_kind_of_every_choice():
    """Without a validator: walk both declarations side by side."""
    for shape, form in zip(SHAPES, schema(SHAPES)["anyOf"], strict=True):
        for p in parameters(shape):
            tables = [choice for choice in form["properties"][p.name].get("anyOf", ()) if "properties" in choice]
            assert len(tables) == len(p.kinds)
            for kind, table in zip(p.kinds, tables, strict=True):
                assert [q.name for q in inside(p, kind)] == [name for name in table["properties"] if name != "kind"]
