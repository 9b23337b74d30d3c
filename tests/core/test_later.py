# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Registering imports no shapes, and declaring shapes nothing that only makes meshes: people wait for it."""

import ast
import subprocess
import sys
from dataclasses import fields, replace
from importlib import import_module
from pathlib import Path

import pytest

from sweep_addon.core.declared.coercing import coerce
from sweep_addon.core.declared.parameters import Parameter, inside, parameters
from sweep_addon.core.later import later
from sweep_addon.core.shapes.kinds import SHAPES
from sweep_addon.core.variation.laws import Constant, Formula

LIBRARY = Path(__file__).resolve().parents[2] / "sweep_addon"
# Modules of the core of which what shapes are declared of has no need: whoever first adds one waits for the others.
WAITING = """
    variation.along stations.bending rings.bevels rings.body meshes.boundary rings.caps stations.cells
    variation.changing grids.chart stations.chebyshev rings.closing meshes.components declared.description
    declared.digest meshes.dimensions rings.domes rings.draft grids.drawn rings.enclosing envelopes.envelope
    formulas.expressions meshes.facets declared.forms formulas.functions grids.grid declared.hints grids.in_plane
    formulas.jets meshes.joining kept grids.laying grids.leaning variation.matching meshes.mesh rings.mitres
    variation.motion rings.parting meshes.polyhedron envelopes.reach meshes.regularizing stations.rotations
    meshes.runs rings.cutting stations.search meshes.sheets stations.spreading rings.steps stations.transport
    meshes.triangulate rings.trimming rings.volume_true meshes.welding rings.events rings.meetings rings.roofs
    rings.wavefront shapes.roofing contours.arcs contours.arrangement
    contours.crossing contours.filling contours.flatten contours.fonts contours.loops contours.nesting
    contours.orientation contours.planar contours.ranges contours.reading contours.rounding contours.section
    contours.svg contours.svg_document contours.symmetry distance.nearest_points grammars shapes.carrying
    shapes.directing shapes.extruding shapes.growing shapes.revolving offsets.offset swept variation.rails
    self_intersection.cells self_intersection.cylinders self_intersection.detect self_intersection.faces
    self_intersection.folds self_intersection.lattice self_intersection.local self_intersection.pd_curves
    self_intersection.places self_intersection.screws self_intersection.stretches self_intersection.thickness
    machining.programs machining.cutting machining.verification machining.remains shapes.milling
    trajectories.arc_length trajectories.breaks trajectories.gpx trajectories.neighbours trajectories.table
""".split()
DECLARED = """
import sys
from sweep_addon.core.declared.parameters import inside, parameters
from sweep_addon.core.shapes.kinds import SHAPES

def ask(declared):
    for p in declared:
        ask(parameters(p.item) if p.item else ())
        for kind in p.kinds:
            ask(inside(p, kind))

for shape in SHAPES:
    ask(parameters(shape))
print(*sys.modules)
"""


def test_declaring_every_shape_imports_nothing_that_makes_meshes():
    told = subprocess.run([sys.executable, "-c", DECLARED], cwd=LIBRARY.parent, capture_output=True, text=True)
    assert not told.stderr
    imported = told.stdout.split()
    assert "sweep_addon.core.shapes" in imported
    assert [name for name in WAITING if f"sweep_addon.core.{name}" in imported] == []


@pytest.mark.parametrize("name", WAITING)
def test_what_waits_is_a_module(name):
    assert import_module(f"sweep_addon.core.{name}")


def waiting():
    """What the core says will be imported later: a module, and what is meant of it."""
    for file in LIBRARY.glob("core/**/*.py"):
        text = file.read_text(encoding="utf-8")
        for node in ast.walk(ast.parse(text)) if "later(" in text else ():
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "later":
                if all(isinstance(argument, ast.Constant) for argument in node.args):
                    yield [argument.value for argument in node.args]


def test_what_is_imported_later_is_there():
    found = list(waiting())
    assert len(found) > 20
    for module, *names in found:
        held = import_module(f"sweep_addon.{module}")
        assert [name for name in names if not hasattr(held, name)] == []


def registering():
    """What operators, panels and properties import of the library when Blender starts: a file, and a module."""
    files = [file for part in ("operators", "panels") for file in LIBRARY.parent.glob(f"{part}/*.py")]
    for file in (*files, *(LIBRARY / f"properties/{name}.py" for name in ("handlers", "kept", "sweep"))):
        for node in ast.parse(file.read_text(encoding="utf-8")).body:
            path = (getattr(node, "module", None) or "").split(".")
            if not AT_ONCE.isdisjoint(path):
                yield file.stem, ".".join(path[path.index("sweep_addon") + 1 :] if "sweep_addon" in path else path)


AT_ONCE = {"bridge", "core"}
LIGHT = {"core", "core.later", "core.declared.names", "core.declared.refusals"}
LOADED_LATER = {"csg_tree", "frame_lines", "l_system", "machining", "written"}  # panels, when they are drawn


def test_registering_imports_names_and_refusals_alone():
    """All else follows from the table of `properties.kept`, and is imported when it is used."""
    found = [(file, module) for file, module in registering() if file not in LOADED_LATER]
    assert len(found) > 20 and LIGHT == {module for _, module in found}


def test_these_import_no_numpy_and_no_shape():
    imports = "; ".join(f"import sweep_addon.{module}" for module in sorted(LIGHT))
    script = (
        f"import sys; {imports}; print(*(name for name in sys.modules if name.startswith(('numpy', 'sweep_addon'))))"
    )
    told = subprocess.run([sys.executable, "-c", script], cwd=LIBRARY.parent, capture_output=True, text=True)
    packages = {"sweep_addon", "sweep_addon.core", "sweep_addon.core.declared"}
    assert set(told.stdout.split()) == packages | {f"sweep_addon.{module}" for module in LIGHT}, told.stderr


def test_what_stands_for_a_class_knows_its_objects():
    array, error = later("core.declared.parameters", "Array", "ShapeError")
    assert isinstance(array([1.0]), array) and not isinstance(array([1.0]), error)


def defaults(declared):
    """Every value that is declared as a default, of the kinds of unions too."""
    for p in declared:
        yield from (p.default, *p.others) if p.kinds else ()
        yield from defaults(parameters(p.item)) if p.item else ()
        for kind in p.kinds:
            yield from defaults(inside(p, kind))


@pytest.mark.parametrize("shape", SHAPES)
def test_every_declared_default_passes_the_check_that_declaring_may_leave_out(shape):
    found = list(defaults(parameters(shape)))
    assert found
    for value in found:
        assert replace(value) == value  # made anew, checked


@pytest.mark.parametrize("number", [0.0, -1.0, 1e-12, 1 / 3, -1e12, 123456789.0])
def test_the_formula_of_a_constant_is_one_though_it_is_not_checked(number):
    said = Formula.like(Constant(number))
    assert Formula(said.text) == said
    assert said.evaluate(u=0.0, t=0.0, s=0.0) == pytest.approx(number, rel=1e-5)


def every(declared):
    """Some parameters, and those of all kinds that they may be of."""
    for p in declared:
        yield p
        yield from every(parameters(p.item)) if p.item else ()
        for kind in p.kinds:
            yield from every(inside(p, kind))


@pytest.mark.parametrize("shape", SHAPES)
def test_every_word_that_a_field_says_is_one_that_parameters_have(shape):
    """Parameters are made without asking, and a word that nobody knows would be said to nobody."""
    found, known = list(every(parameters(shape))), {field.name for field in fields(Parameter)}
    kept = known | {"kinds", "item", "is_list"}  # once somebody has asked
    assert found
    assert [(p.name, word) for p in found for word in vars(p) if word not in kept] == []


@pytest.mark.parametrize("shape", SHAPES)
def test_every_default_is_within_its_limits_and_of_its_type(shape):
    found = list(every(parameters(shape)))
    assert found
    for p in found:
        kept = coerce(p, p.default)
        assert (p.name, kept, type(kept)) == (p.name, p.default, type(p.default))
