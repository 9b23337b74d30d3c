# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's command line, spoken by the bpy wheel: as much of it as tests, pipelines and render farms use.

Options act in the order they are given, as they do in Blender. An option that is not known here is refused.
"""

import importlib.metadata
import os
import runpy
import shutil
import sys
import traceback
from pathlib import Path

LAUNCHER = Path(__file__).resolve().parents[1] / "blender"
HELP = """The bpy wheel behind Blender's command line. It has no window. It knows:
  FILE.blend  --background  --factory-startup  --addons NAMES  --command NAME ARGS
  --python FILE  --python-expr TEXT  --python-exit-code N  --python-use-system-env
  --scene NAME  --engine NAME  --render-output PATH  --render-format NAME  --use-extension 0|1  --threads N
  --frame-start N  --frame-end N  --frame-jump N  --render-frame N[,N|N..N]  --render-anim  --version  --help"""
LONG = {
    **{"-b": "--background", "-c": "--command", "-P": "--python", "-S": "--scene", "-E": "--engine", "-t": "--threads"},
    **{"-o": "--render-output", "-F": "--render-format", "-x": "--use-extension", "-f": "--render-frame"},
    **{"-s": "--frame-start", "-e": "--frame-end", "-j": "--frame-jump", "-a": "--render-anim", "-h": "--help"},
    **{"-v": "--version", "-q": "--quiet", "-noaudio": "-noaudio"},
}
NOTHING_TO_DO = {"--background", "--factory-startup", "--python-use-system-env", "--quiet", "-noaudio"}


class Session:
    """One run: what the options did so far."""

    def __init__(self, words):
        self.words = words
        self.exit_code_on_exception = 0
        self.commands = {}

    def run(self):
        while self.words:
            word = self.words.pop(0)
            if word == "--":
                break
            if not word.startswith("-"):
                bpy.ops.wm.open_mainfile(filepath=os.path.abspath(word))
                continue
            name = LONG.get(word, word)
            if name == "--command":
                return self.command(*self.words)
            if name in NOTHING_TO_DO:
                continue
            act = getattr(self, f"do_{name[2:].replace('-', '_')}", None) if name.startswith("--") else None
            if not act:
                sys.exit(f"The bpy wheel does not know the option {word}; see --help")
            act()
        return 0

    def value(self):
        if not self.words:
            sys.exit("The last option has no value")
        return self.words.pop(0)

    def command(self, name="", *arguments):
        if name == "extension":
            import bl_pkg

            return bl_pkg.cli_extension(list(arguments))
        if name not in self.commands:
            sys.exit(f"There is no command {name!r}; there are {', '.join(['extension', *sorted(self.commands)])}")
        return self.commands[name](list(arguments))

    def do_addons(self):
        import addon_utils

        for name in self.value().split(","):
            addon_utils.enable(name, default_set=True)

    def do_python_exit_code(self):
        self.exit_code_on_exception = int(self.value())

    def do_python(self):
        path = self.value()
        self.attempt(lambda: runpy.run_path(path, run_name="__main__"))

    def do_python_expr(self):
        text = self.value()  # the person's own command line, as trusted as the person
        self.attempt(lambda: exec(compile(text, "<--python-expr>", "exec"), {"__name__": "__main__"}))

    def attempt(self, script):
        try:
            script()
        except Exception:
            traceback.print_exc()
            if self.exit_code_on_exception:
                sys.exit(self.exit_code_on_exception)

    def do_scene(self):
        bpy.context.window.scene = bpy.data.scenes[self.value()]

    def do_engine(self):
        bpy.context.scene.render.engine = self.value()

    def do_threads(self):
        render, number = bpy.context.scene.render, int(self.value())
        render.threads_mode, render.threads = ("FIXED", number) if number else ("AUTO", render.threads)

    def do_render_output(self):
        bpy.context.scene.render.filepath = self.value()

    def do_render_format(self):
        bpy.context.scene.render.image_settings.file_format = self.value()

    def do_use_extension(self):
        bpy.context.scene.render.use_file_extension = self.value() != "0"

    def do_frame_start(self):
        bpy.context.scene.frame_start = int(self.value())

    def do_frame_end(self):
        bpy.context.scene.frame_end = int(self.value())

    def do_frame_jump(self):
        bpy.context.scene.frame_step = int(self.value())

    def do_render_frame(self):
        """Frames 1,3,5..8, each rendered as an animation of one frame: its number goes into its name."""
        scene = bpy.context.scene
        kept = scene.frame_start, scene.frame_end
        for part in self.value().split(","):
            first, _, last = part.partition("..")
            scene.frame_start, scene.frame_end = int(first), int(last or first)
            bpy.ops.render.render(animation=True)
        scene.frame_start, scene.frame_end = kept

    def do_render_anim(self):
        bpy.ops.render.render(animation=True)


def main(words):
    first = [LONG.get(word, word) for word in words]
    if "--version" in first[: first.index("--command") if "--command" in first else None]:
        print("Blender", importlib.metadata.version("bpy"))
        return 0
    if first[:1] == ["--help"] or not words:
        print(HELP)
        return 0 if words else 1

    sys.argv = [str(LAUNCHER), *words]
    session = Session(list(words))
    start(session.commands, factory="--factory-startup" in first)
    return session.run() or 0


def start(commands, factory):
    """Import bpy as a Blender that knows its executable, reads preferences, and remembers registered commands."""
    global bpy
    import bpy

    bpy.app.binary_path = str(LAUNCHER)
    register = bpy.utils.register_cli_command

    def remember(name, function):
        commands[name] = function
        return register(name, function)

    bpy.utils.register_cli_command = remember
    if not factory:
        bpy.ops.wm.read_userpref()
        bpy.ops.wm.read_homefile()


def leave(code):
    """End at once: the 4.5 wheel never ends by itself while an extension's handler is registered."""
    if "bpy" in globals():
        shutil.rmtree(bpy.app.tempdir, ignore_errors=True)
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)


if __name__ == "__main__":
    try:
        code = main(sys.argv[1:])
    except SystemExit as stop:
        code = stop.code if isinstance(stop.code, int) else int(stop.code is not None)
        if code and not isinstance(stop.code, int):
            print(stop.code, file=sys.stderr)
    except Exception:
        traceback.print_exc()
        code = 1
    leave(code)
