# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The checkout as a live extension: Blender with a user folder of its own, into which the checkout is linked."""

import os

from . import BUILD, CHECKOUT, packages

NAME = "bl_ext.user_default.sweep_addon"
USER = BUILD / "blender-user"


def started(blender, *arguments):
    """The command that starts a Blender with the extension enabled, and its environment variables."""
    place = USER / "extensions" / "user_default" / "sweep_addon"
    place.parent.mkdir(parents=True, exist_ok=True)
    if not place.is_symlink() or place.resolve() != CHECKOUT:
        place.unlink(missing_ok=True)
        place.symlink_to(CHECKOUT, target_is_directory=True)
    options = ("--factory-startup", "--python-use-system-env", "--python-exit-code", "1", "--addons", NAME)
    return [*blender.command, *options, *arguments], variables(blender, USER, "libraries")


def sweep(blender, *arguments):
    """The same, to run the command `sweep`."""
    return started(blender, "--background", "--command", "sweep", *map(str, arguments))


def variables(blender, user, *parts):
    """A Blender's environment variables: its user folder, and packages for its Python; the wheel's has them."""
    path = {"PYTHONPATH": packages.inside(*parts)} if blender.real else {}
    return {**os.environ, "BLENDER_USER_RESOURCES": str(user), **path}
