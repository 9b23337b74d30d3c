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

try:
    import numpy  # noqa: F401, so that where it is missing one sentence says so
except ModuleNotFoundError as missing:
    NEEDED = f"Sweep needs NumPy, which {sys.executable} has not: pip install numpy, in a virtual environment of it."
    if sys.argv[:1] == ["-m"]:  # python -m sweep_addon, which finds the package before it runs it
        sys.exit(NEEDED)
    raise ModuleNotFoundError(NEEDED, name=missing.name) from None

from .core import contours, machining, solids, trajectories
from .core.declared.parameters import ShapeError
from .core.rings import corners, ends, limits
from .core.shapes.canal_surface import CanalSurface
from .core.shapes.general_sweep import GeneralSweep
from .core.shapes.generalized_cylinder import GeneralizedCylinder
from .core.shapes.machined_stock import MachinedStock
from .core.shapes.offset_surface import OffsetSurface
from .core.shapes.pd_curve_sweep import PDCurveSweep
from .core.shapes.plant import Plant
from .core.shapes.rotational_sweep import RotationalSweep
from .core.shapes.translational_sweep import TranslationalSweep
from .core.stations import directions, frames, sampling
from .core.variation import laws

__all__ = [
    "CanalSurface",
    "Curves",
    "Edges",
    "GeneralSweep",
    "GeneralizedCylinder",
    "GrammarError",
    "LSystem",
    "MachinedStock",
    "Mesh",
    "OffsetSurface",
    "PDCurve",
    "PDCurveSweep",
    "Placed",
    "Plant",
    "RigidMotion",
    "Rotation",
    "RotationalSweep",
    "ShapeError",
    "SweptContour",
    "SweptSolid",
    "Translation",
    "TranslationalSweep",
    "Tree",
    "Tubes",
    "classify",
    "contours",
    "corners",
    "directions",
    "disassembly",
    "dump",
    "ends",
    "frames",
    "inverse_sweep",
    "laws",
    "limits",
    "load",
    "machining",
    "presets",
    "reach",
    "removal_path",
    "sampling",
    "solids",
    "sweep_to_csg",
    "trajectories",
]
if find_spec("bpy"):  # else `import *` would ask for what plain Python does not have
    __all__ += ["from_object", "to_object"]

SPACES = (
    "contours", "corners", "directions", "ends", "frames", "laws", "limits", "machining", "sampling", "solids",
    "trajectories",
)  # fmt: skip
LATER = {
    "Curves": ".core.shapes.plant",
    "Edges": ".core.shapes.plant",
    "GrammarError": ".core.grammars",
    "LSystem": ".core.grammars",
    "Mesh": ".core.meshes.mesh",
    "PDCurve": ".core.stations.pd_curve",
    "Placed": ".core.csg",
    "RigidMotion": ".core.csg",
    "Rotation": ".core.csg",
    "SweptContour": ".core.csg",
    "SweptSolid": ".core.csg",
    "Translation": ".core.csg",
    "Tree": ".core.csg",
    "Tubes": ".core.shapes.plant",
    "classify": ".core.membership",
    "inverse_sweep": ".core.membership",
    "disassembly": ".core.removal",
    "dump": ".core.declared.forms",
    "load": ".batch.job",
    "to_object": ".bridge.objects",
    "from_object": ".bridge.objects",
    "reach": ".core.envelopes.reach",
    "removal_path": ".core.removal",
    "sweep_to_csg": ".core.conversion",
}


def __dir__():
    return __all__  # what a console offers


def __getattr__(name):
    # Jobs, Blender and what takes long are loaded when they are asked for: most scripts need none.
    from importlib import import_module

    if name == "__version__":
        return import_module(".core.version", __package__).version()
    if name == "presets":
        return import_module(".presets", __package__)
    if name not in LATER:
        found = [f"{space}.{name}" for space in SPACES if name in dir(globals()[space])]
        where = f": it is {' or '.join(found)}" if found else ""
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}{where}")
    try:
        return getattr(import_module(LATER[name], __package__), name)
    except ModuleNotFoundError as error:
        if error.name != "bpy":
            raise
        raise ModuleNotFoundError(f"{name} needs Blender, or its module bpy", name="bpy") from None
