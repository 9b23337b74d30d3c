# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One suite for every host: plain Python, the bpy wheel, the real Blender, the installed zip.

Where there is a Blender, the extension is enabled before the tests are read: the installed one if there is one, else
this checkout, linked into Blender's extensions, which makes it a live extension. `import sweep_addon` is then the
library inside the extension, so that no module exists twice. Blender's user folder is a temporary one.

A test that asks for the `scene` fixture gets an empty scene, and is skipped where there is no Blender.
A test marked `large` runs only with ``SWEEP_FULL=1``, which also draws many more random inputs
and hypothesis examples. ``SWEEP_BRIEF=1`` says that other hosts do the same at length: then fewer are drawn,
of tests of the core that have ten cases or more one in ten is run, and of those marked `thorough` no others; of what
another host runs with the same NumPy or in the same Blender, the bpy wheel and the installed zip run one in ten tests
of each file.
``SWEEP_FAST=1`` leaves out those that slow.txt names, as `scripts/slow_tests` has measured them.
"""

import atexit
import gc
import importlib.util
import itertools
import os
import shutil
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict
from importlib.machinery import ModuleSpec
from pathlib import Path

import pytest
from hypothesis import settings

CHECKOUT = Path(__file__).resolve().parents[1]
EXTENSION = "bl_ext.user_default.sweep_addon"
TEMPORARY = "sweep-tests-"  # how the name of a temporary user folder starts
FULL = os.environ.get("SWEEP_FULL") == "1"
BRIEF = os.environ.get("SWEEP_BRIEF") == "1" and not FULL
LARGE = pytest.mark.skip(reason="large: runs with SWEEP_FULL=1 (scripts/test --full)")
FAST = os.environ.get("SWEEP_FAST") == "1"
SLOW = pytest.mark.skip(reason="slow: runs without SWEEP_FAST=1 (scripts/test --fast)")
TESTS = CHECKOUT / "tests"
CORE, BLENDER, LAUNCHER = TESTS / "core", TESTS / "blender", TESTS / "test_launcher.py"
ELSEWHERE = pytest.mark.skip(reason="runs in another host with the same NumPy or Blender, or with SWEEP_FULL=1")
KEPT = 10  # of ten cases or more of a test, one in so many is for every host
THOROUGH = pytest.mark.skip(reason="plain Python runs it, without SWEEP_BRIEF=1; others with SWEEP_FULL=1")

settings.register_profile("brief", deadline=None, database=None, derandomize=True, max_examples=10)
settings.register_profile("usual", deadline=None, database=None, derandomize=True, max_examples=30)
settings.register_profile("full", deadline=None, database=None, derandomize=True, max_examples=1000)
settings.load_profile("full" if FULL else "brief" if BRIEF else "usual")


def isolate_user_folder():
    """Give the Blender to come a user folder of its own: it reads these variables only when it starts."""
    folder = os.environ.get("SWEEP_BLENDER_USER")
    if not folder:
        folder = tempfile.mkdtemp(prefix=TEMPORARY)
        atexit.register(shutil.rmtree, folder, ignore_errors=True)
    os.environ["BLENDER_USER_RESOURCES"] = folder
    os.environ.pop("BLENDER_USER_EXTENSIONS", None)


if "bpy" not in sys.modules:  # else this is a running Blender, started with the folder it should have
    isolate_user_folder()


class InsideTheExtension:
    """An import finder for which `sweep_addon.x` is the module inside the extension."""

    @classmethod
    def find_spec(cls, name, path=None, target=None):
        if name.partition(".")[0] == "sweep_addon":
            return ModuleSpec(name, cls)

    @staticmethod
    def create_module(spec):
        return None

    @staticmethod
    def exec_module(module):
        name = module.__name__
        sys.modules[name] = importlib.import_module(f"{EXTENSION}.{name}")


def pytest_configure(config):
    if importlib.util.find_spec("bpy"):
        config.sweep_place = enable_extension()
        sys.meta_path.insert(0, InsideTheExtension)
    else:
        sys.path.insert(0, str(CHECKOUT))


def enable_extension():
    import bpy  # before addon_utils, which cannot be imported without it

    import addon_utils

    repositories = bpy.context.preferences.extensions.repos
    place = Path(next(r for r in repositories if r.module == "user_default").directory, "sweep_addon")
    if not place.exists():
        place.parent.mkdir(parents=True, exist_ok=True)
        place.symlink_to(CHECKOUT, target_is_directory=True)
    addon_utils.enable(EXTENSION, default_set=True, handle_error=fail)
    return place


def fail(error):
    raise pytest.UsageError(f"the extension does not register: {error}") from error


def pytest_sessionfinish(session, exitstatus):
    session.config.sweep_status = int(exitstatus)


@pytest.hookimpl(trylast=True)
def pytest_unconfigure(config):
    """Take the extension off, and leave the wheel at once: the traceback of a failed test can hold what keeps 4.5 from
    ever exiting, as a handler does that is left registered."""
    if not hasattr(config, "sweep_place"):
        return
    import bpy

    import addon_utils

    addon_utils.disable(EXTENSION, default_set=True)
    if not bpy.app.binary_path and hasattr(config, "sweep_status"):
        if Path(os.environ["BLENDER_USER_RESOURCES"]).name.startswith(TEMPORARY):
            shutil.rmtree(os.environ["BLENDER_USER_RESOURCES"], ignore_errors=True)
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(config.sweep_status)


def pytest_report_header(config):
    if not hasattr(config, "sweep_place"):
        return "sweep: no Blender here; tests that need one are skipped"
    import bpy

    kind = "the installed zip" if is_installed(config) else "this checkout"
    return f"sweep: Blender {bpy.app.version_string}, the extension is {kind}"


def pytest_collection():
    gc.disable()  # little of what is made of tests is garbage, and looking for it takes a fifth of the time


def pytest_collection_finish():
    """Let the garbage collector not look again and again at what lives to the end: all tests and all modules."""
    gc.enable()
    gc.collect()
    gc.freeze()


def pytest_collection_modifyitems(config, items):
    for item in items:
        if not FULL and item.get_closest_marker("large"):
            item.add_marker(LARGE)
    if FAST:
        slow = set(Path(__file__).with_name("slow.txt").read_text().split())
        for item in items:
            if item.nodeid.partition("[")[0] in slow:
                item.add_marker(SLOW)
    if BRIEF:
        left = set(left_to_others(items))
        for item in left:
            item.add_marker(THOROUGH)
        for item in run_elsewhere((item for item in items if item not in left), folders_run_elsewhere(config)):
            item.add_marker(ELSEWHERE)


def is_installed(config):
    """Whether the extension is that of a zip, and not this checkout."""
    return hasattr(config, "sweep_place") and not config.sweep_place.is_symlink()


def folders_run_elsewhere(config):
    """The tests of which this host shows only that they run here too.

    NumPy alone has the NumPy of the bpy wheel; the Blender of the installed zip runs the checkout and its launcher too.
    """
    if not hasattr(config, "sweep_place"):
        return ()
    import bpy

    if is_installed(config):
        return CORE, BLENDER, LAUNCHER
    return () if bpy.app.binary_path else (CORE,)


def run_elsewhere(items, folders):
    """Of tests in some folders nine in ten of each file, and all of one that is named itself."""
    number = defaultdict(itertools.count)
    for item in items:
        if item.path in folders or not set(folders).isdisjoint(item.path.parents) and next(number[item.path]) % KEPT:
            yield item


def left_to_others(items):
    """The items that hosts leave out which are brief.

    Of a test that has ten cases or more, and is thorough or of the core, all but every tenth; all of a thorough one
    that has fewer.
    """
    cases = Counter(map(test_of, items))
    number = defaultdict(itertools.count)
    for item in items:
        test = test_of(item)
        thorough, many = bool(item.get_closest_marker("thorough")), cases[test] >= KEPT
        if (thorough or many and CORE in item.path.parents) and not (many and next(number[test]) % KEPT == 0):
            yield item


def test_of(item):
    """The test that an item is a case of; a case that is marked itself is a test of its own."""
    singly = any(mark.name == "thorough" for mark in getattr(getattr(item, "callspec", None), "marks", ()))
    return item.nodeid if singly else item.nodeid.partition("[")[0]


@pytest.fixture
def draws():
    """How many random inputs a test draws; where each takes long, it is a part of them."""
    return 1000 if FULL else 30 if BRIEF else 100


MADE = {}  # meshes by their shapes


@pytest.fixture
def made_once(monkeypatch):
    """Equal general sweeps have one mesh in all tests that ask for this; that of a preset takes ten seconds to make."""
    from sweep_addon.core.shapes.general_sweep import GeneralSweep

    make = GeneralSweep.mesh

    def known(shape, dtype=float):
        if shape not in MADE:
            MADE[shape] = make(shape)
        return MADE[shape].astype(dtype)

    monkeypatch.setattr(GeneralSweep, "mesh", known)


@pytest.fixture
def blender_module():
    """Skip where Blender is no module of this Python."""
    if subprocess.run([sys.executable, "-c", "import bpy"], capture_output=True).returncode:
        pytest.skip("this host's Python is started by Blender alone, or has none")


@pytest.fixture
def scene():
    """An empty scene in Blender, the extension enabled."""
    if not importlib.util.find_spec("bpy"):
        pytest.skip("needs Blender, and this host has none")
    import bpy

    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    return bpy.context.scene
