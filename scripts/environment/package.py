# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The zip that users install: what Blender packs of the checkout, with the pinned wheels added."""

import json
import re
import shutil
import subprocess
import zipfile

from . import BUILD, CHECKOUT, SetupError
from .packages import wheels
from .steps import show

WORK = BUILD / "package"
LOGGED = re.compile(r"\d+:\d\d\.\d+ ")  # a line of Blender's own log, which may warn of the machine


def package(blender):
    """Build and validate the zip; its path."""
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    bare, source = WORK / "bare.zip", WORK / "source"
    extension(blender, "validate", CHECKOUT)
    extension(blender, "build", "--source-dir", CHECKOUT, "--output-filepath", bare)
    with zipfile.ZipFile(bare) as packed:
        packed.extractall(source)

    add_wheels(source)
    extension(blender, "build", "--source-dir", source, "--output-dir", WORK)
    bare.unlink()
    (result,) = WORK.glob("*.zip")
    extension(blender, "validate", result)
    return result.rename(BUILD / result.name)


def add_wheels(source):
    manifest = source / "blender_manifest.toml"
    names = []
    (source / "wheels").mkdir()
    for wheel in wheels():
        shutil.copy(wheel, source / "wheels")
        names.append(f"./wheels/{wheel.name}")
    text = manifest.read_text()
    manifest.write_text(re.sub(r"^\[", f"wheels = {json.dumps(names)}\n\n[", text, count=1, flags=re.MULTILINE))


def extension(blender, *arguments):
    """Run a command of Blender's extension tool; a warning counts as a failure."""
    command = [*blender.command, "--background", "--factory-startup", "--command", "extension", *map(str, arguments)]
    try:
        answer = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300)
    except subprocess.TimeoutExpired:
        raise SetupError(f"blender --command extension {arguments[0]}: no end after 300 s") from None
    lines = [line for line in answer.stdout.splitlines() if not LOGGED.match(line)]
    if answer.returncode or re.search(r"warn|error", "\n".join(lines), re.IGNORECASE):
        raise SetupError(f"blender --command extension {arguments[0]}: {answer.stdout.strip()}")
    show(f"extension {arguments[0]}: ok")
