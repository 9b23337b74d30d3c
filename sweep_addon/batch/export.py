# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Export: files written whole or not at all, in the formats that Blender writes."""

import ctypes
import errno
import io
import os
import shutil
import sys
import tempfile
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from pathlib import Path

from ..core.declared.parameters import require
from .stopping import unfinished


def save_blend(path):
    import bpy

    bpy.ops.wm.save_as_mainfile(filepath=path, copy=True, check_existing=False)


def save_glb(path):
    import bpy

    loose = {"use_mesh_edges": True, "use_mesh_vertices": True}  # of a sweep of mixed dimension
    bpy.ops.export_scene.gltf(filepath=path, export_format="GLB", use_selection=True, export_apply=True, **loose)


def save_stl(path):
    import bpy

    bpy.ops.wm.stl_export(filepath=path, export_selected_objects=True, check_existing=False)


def save_obj(path):
    import bpy

    bpy.ops.wm.obj_export(filepath=path, export_selected_objects=True, check_existing=False)


def save_ply(path):
    import bpy

    # texture coordinates would tear the surface open along their seams: this format has them at vertices only
    bpy.ops.wm.ply_export(filepath=path, export_selected_objects=True, export_uv=False, check_existing=False)


ROOM = 1 << 16  # bytes, at random so that no disk makes fewer of them
MODELS = {".blend": save_blend, ".glb": save_glb, ".stl": save_stl, ".obj": save_obj, ".ply": save_ply}
PICTURES = {".png": "PNG", ".jpg": "JPEG", ".webp": "WEBP", ".exr": "OPEN_EXR"}


def check_output(path, suffixes):
    """The absolute path of an output, refused before anything is done for it."""
    told, path = str(path), Path(path).absolute()
    require(path.suffix.lower() in suffixes, f"must end in {', '.join(suffixes)}", told, "output")
    there = next(folder for folder in path.parents if folder.exists())
    require(there.is_dir(), "must be in a folder", str(there), "output")
    require(not path.is_dir(), "must be a file", str(path), "output")
    return path


def save_model(output):
    """Write the scene (.blend), or its selected objects, in the format that the output's suffix names.

    In any format but Blender's own, which keeps shapes live, bent faces are cut about their middle first: exporters and
    readers cut them along a diagonal each, and a twisted bar got up to an eighth thinner.
    """
    suffix = output.suffix.lower()
    with whole(output) as path, silent(), redirect_stderr(io.StringIO()):  # exporters print what they raise
        if suffix != ".blend":
            cut_bent_faces()
        MODELS[suffix](str(path))


def cut_bent_faces():
    """Cut those of all meshes in the scene, also of the operands whose Booleans make a tree."""
    import bpy

    from ..bridge.bent_faces import cut_about_the_middle

    for mesh in {ob.data for ob in bpy.context.scene.objects if ob.type == "MESH"}:
        cut_about_the_middle(mesh)


@contextmanager
def whole(output):
    """A path to write to, whose files are moved to the output's place once all of them are complete.

    Parameters
    ----------
    output : Path
        Absolute. Other files written beside it, as an .obj's materials, go to its folder too.
    """
    output.parent.mkdir(parents=True, exist_ok=True)
    part = output.with_name(f".sweep-{output.name}.part")  # a name that is this program's alone
    shutil.rmtree(part, ignore_errors=True)  # of a run that was killed
    unfinished.add(part)
    try:
        with about(output):
            part.mkdir()
        try:
            yield part / output.name
        finally:
            require_room(part, output)
        if not (part / output.name).is_file():
            raise RuntimeError(f"Blender's exporter wrote no {output.name}")
        for file in sorted(part.iterdir(), key=lambda file: file.name == output.name):  # the output last
            os.replace(file, output.with_name(file.name))
    finally:
        shutil.rmtree(part, ignore_errors=True)
        unfinished.discard(part)


def require_room(folder, output):
    """Raise the error of a full disk where there is no room for more: exporters write what fits, and say nothing."""
    with about(output):
        with tempfile.TemporaryFile(dir=folder, buffering=0) as more:
            written = more.write(os.urandom(ROOM))
            os.fsync(more.fileno())
        if written < ROOM:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


@contextmanager
def about(output):
    """Tell what the system refuses by the name of the output, not by that of what it is written to."""
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(output)) from error


@contextmanager
def silent():
    """Keep what Blender prints off standard output, which is for results; also what it has printed and not sent yet."""
    sys.stdout.flush()
    kept, nothing = os.dup(1), os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nothing, 1)
        with redirect_stdout(io.StringIO()):  # operators print by way of Python
            yield
    finally:
        ctypes.CDLL("ucrtbase" if sys.platform == "win32" else None).fflush(None)
        os.dup2(kept, 1)
        os.close(kept)
        os.close(nothing)
