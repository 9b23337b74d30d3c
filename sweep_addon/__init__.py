# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweep: shapes made by moving a generator along a trajectory, and by grammars.

Plain Python needs NumPy alone; inside Blender ``to_object`` makes a shape a live object of the scene.

>>> import sweep_addon as sw
>>> tube = sw.GeneralizedCylinder(contour=sw.contours.Circle(0.1), trajectory=sw.trajectories.Helix(turns=2))
>>> len(tube.mesh().boundary_edges())
0
"""

import sys
from importlib.util import find_spec
from typing import TYPE_CHECKING

if not find_spec("numpy"):
    NEEDED = f"Sweep needs NumPy, which {sys.executable} has not: pip install numpy, in a virtual environment of it."
    if sys.argv[:1] == ["-m"]:  # python -m sweep_addon, which finds the package before it runs it
        sys.exit(NEEDED)
    raise ModuleNotFoundError(NEEDED, name="numpy")

if TYPE_CHECKING:  # for editors, which complete names and run nothing
    from . import presets
    from .batch.job import load
    from .bridge.objects import from_object, to_object
    from .core import contours, machining, solids, trajectories
    from .core.conversion import sweep_to_csg
    from .core.csg import Placed, RigidMotion, Rotation, SweptContour, SweptSolid, Translation, Tree
    from .core.declared.forms import dump
    from .core.declared.refusals import ShapeError
    from .core.envelopes.reach import reach
    from .core.grammars import GrammarError, LSystem
    from .core.membership import classify, inverse_sweep
    from .core.meshes.mesh import Mesh
    from .core.removal import disassembly, removal_path
    from .core.rings import corners, ends, limits
    from .core.shapes.canal_surface import CanalSurface
    from .core.shapes.general_sweep import GeneralSweep
    from .core.shapes.generalized_cylinder import GeneralizedCylinder
    from .core.shapes.machined_stock import MachinedStock
    from .core.shapes.offset_surface import OffsetSurface
    from .core.shapes.pd_curve_sweep import PDCurveSweep
    from .core.shapes.plant import Curves, Edges, Plant, Tubes
    from .core.shapes.rotational_sweep import RotationalSweep
    from .core.shapes.translational_sweep import TranslationalSweep
    from .core.stations import directions, frames, sampling
    from .core.stations.pd_curve import PDCurve
    from .core.variation import laws

# Loaded when they are asked for, as most scripts need few of them, and starting Blender none.
SPACES = {
    "contours": ".core.contours",
    "corners": ".core.rings.corners",
    "directions": ".core.stations.directions",
    "ends": ".core.rings.ends",
    "frames": ".core.stations.frames",
    "laws": ".core.variation.laws",
    "limits": ".core.rings.limits",
    "machining": ".core.machining",
    "presets": ".presets",
    "sampling": ".core.stations.sampling",
    "solids": ".core.solids",
    "trajectories": ".core.trajectories",
}
NAMES = {
    "CanalSurface": ".core.shapes.canal_surface",
    "Curves": ".core.shapes.plant",
    "Edges": ".core.shapes.plant",
    "GeneralSweep": ".core.shapes.general_sweep",
    "GeneralizedCylinder": ".core.shapes.generalized_cylinder",
    "GrammarError": ".core.grammars",
    "LSystem": ".core.grammars",
    "MachinedStock": ".core.shapes.machined_stock",
    "Mesh": ".core.meshes.mesh",
    "OffsetSurface": ".core.shapes.offset_surface",
    "PDCurve": ".core.stations.pd_curve",
    "PDCurveSweep": ".core.shapes.pd_curve_sweep",
    "Placed": ".core.csg",
    "Plant": ".core.shapes.plant",
    "RigidMotion": ".core.csg",
    "Rotation": ".core.csg",
    "RotationalSweep": ".core.shapes.rotational_sweep",
    "ShapeError": ".core.declared.refusals",
    "SweptContour": ".core.csg",
    "SweptSolid": ".core.csg",
    "Translation": ".core.csg",
    "TranslationalSweep": ".core.shapes.translational_sweep",
    "Tree": ".core.csg",
    "Tubes": ".core.shapes.plant",
    "classify": ".core.membership",
    "disassembly": ".core.removal",
    "dump": ".core.declared.forms",
    "from_object": ".bridge.objects",
    "inverse_sweep": ".core.membership",
    "load": ".batch.job",
    "reach": ".core.envelopes.reach",
    "removal_path": ".core.removal",
    "sweep_to_csg": ".core.conversion",
    "to_object": ".bridge.objects",
}
IN_BLENDER = {"from_object", "to_object"}
__all__ = sorted({*SPACES, *NAMES} - (set() if find_spec("bpy") else IN_BLENDER))  # `import *` asks for all of them


def __dir__():
    return __all__  # what a console offers


def __getattr__(name):
    from importlib import import_module

    if name in SPACES:
        return import_module(SPACES[name], __package__)
    if name == "__version__":
        return import_module(".core.version", __package__).version()
    if name.startswith("__"):  # tools ask for many
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    if name not in NAMES:
        found = [f"{space}.{name}" for space in SPACES if name in dir(import_module(SPACES[space], __package__))]
        where = f": it is {' or '.join(found)}" if found else ""
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}{where}")
    try:
        return getattr(import_module(NAMES[name], __package__), name)
    except ModuleNotFoundError as error:
        if error.name != "bpy":
            raise
        raise ModuleNotFoundError(f"{name} needs Blender, or its module bpy", name="bpy") from None
