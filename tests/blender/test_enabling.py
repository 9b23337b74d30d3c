# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What Blender reads of an operator or a panel when it is registered imports nothing that only its use needs."""

from importlib.util import find_spec, module_from_spec
from inspect import getmembers, isclass
from pathlib import Path
from typing import get_type_hints

import pytest

bpy = pytest.importorskip("bpy")

from sweep_addon.core.later import Later

PACKAGE = Later.__module__.removesuffix(".sweep_addon.core.later")
ROOT = Path(find_spec(PACKAGE).origin).parent
NAMES = [f"{part}.{file.stem}" for part in ("operators", "panels") for file in sorted((ROOT / part).glob("[!_]*.py"))]


def refuse(waiting):
    raise AssertionError(f"{waiting.module} is imported")


@pytest.mark.parametrize("name", NAMES)
def test_registering_asks_nothing_of_what_is_imported_later(monkeypatch, name):
    monkeypatch.setattr(Later, "meant", property(refuse))
    spec = find_spec(f"{PACKAGE}.{name}")
    module = module_from_spec(spec)  # beside the one that is enabled
    spec.loader.exec_module(module)
    own = [cls for _, cls in getmembers(module, isclass) if cls.__module__ == spec.name]
    for cls in own:
        get_type_hints(cls)  # as Blender does; from Python 3.14 on annotations are made when they are asked for
