# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line: ``blender --background --command sweep VERB ...`` or ``python -m sweep_addon VERB ...``.

Results go to standard output, a refusal to standard error as one sentence. It ends with 0, with 1 where something
failed, or with 2 where what it was told is wrong.
"""

import argparse
import re
import sys

from ..core.declared.hints import meant
from ..core.declared.parameters import ShapeError
from ..core.declared.wording import shown
from ..core.version import version
from . import grammar, removing, verbs
from .export import MODELS, PICTURES, silent
from .stopping import FAILED, STOPPED

DONE, REFUSED = 0, 2


class Parser(argparse.ArgumentParser):
    """An argument parser whose refusal is one sentence."""

    def error(self, message):
        chosen = re.search(r"invalid choice: '([^']*)' \(choose from (.*)\)", message)
        near = meant(re.findall(r"[\w-]+", chosen[2]), chosen[1]) if chosen else ""
        self.exit(REFUSED, f"{self.prog}: {message}{near}; see {self.prog} --help\n")


def whole(text):
    """The whole number that a text is."""
    try:
        return int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"must be a whole number, got {shown(text)}") from None


def number(text):
    """The number that a text is."""
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"must be a number, got {shown(text)}") from None


def parser():
    """The verbs and what each may be told."""
    made = Parser(prog="sweep", description="Shapes made by moving a generator along a trajectory, from job files.")
    made.add_argument("--version", action="version", version=f"sweep {version()}")
    commands = made.add_subparsers(metavar="VERB", required=True)

    build = commands.add_parser("build", help="write a shape as a model", description=verbs.build.__doc__)
    render = commands.add_parser("render", help="write a picture of a shape", description=verbs.render.__doc__)
    for verb, act, suffixes in ((build, verbs.build, MODELS), (render, verbs.render, PICTURES)):
        names = ", ".join(suffixes)
        verb.add_argument("jobs", metavar="JOB", nargs="+", help="a job file (.toml)")
        where = verb.add_mutually_exclusive_group(required=True)
        where.add_argument("-o", "--output", metavar="FILE", help=f"what to write for one job: {names}")
        where.add_argument("-d", "--output-dir", metavar="DIR", help="where to write for many jobs, each its own file")
        verb.add_argument("--format", choices=[suffix[1:] for suffix in suffixes], default=list(suffixes)[0][1:],
                          help="of the files in DIR (%(default)s)")  # fmt: skip
        verb.add_argument("--again", action="store_true", help="write also what is already finished in DIR")
        verb.add_argument("--parallel", metavar="N", type=whole, default=1, help="processes at a time (%(default)s)")
        verb.set_defaults(act=act)
    render.add_argument("--progress", action="store_true", help="say how far it is also where that is no terminal")
    render.add_argument("--frame", metavar="N", type=whole, default=0, help="only this picture of a turn, from 1")

    check = commands.add_parser("check", help="say whether jobs are right", description=verbs.check.__doc__)
    check.add_argument("jobs", metavar="JOB", nargs="+", help="a job file (.toml)")
    check.set_defaults(act=verbs.check)

    verify = commands.add_parser("verify", help="say whether programs of machines make their parts",
                                 description=verbs.verify.__doc__)  # fmt: skip
    verify.add_argument("jobs", metavar="JOB", nargs="+", help="a job file (.toml) of machined stock")
    verify.add_argument("--part", metavar="PART", help="a job file of the desired part, instead of what the jobs say")
    verify.set_defaults(act=verbs.verify)

    remove = commands.add_parser("remove", help="find how a part gets out of an assembly",
                                 description=removing.remove.__doc__)  # fmt: skip
    remove.add_argument("part", metavar="PART", help="a job file (.toml) of the part")
    remove.add_argument("others", metavar="OTHER", nargs="+", help="job files of what stays where it is")
    remove.add_argument("--tolerance", metavar="T", type=number, help="the contact tolerance in metres")
    remove.add_argument("--seed", metavar="S", type=whole, default=0, help="of the random motions that are tried last")
    remove.add_argument(
        "--budget", metavar="N", type=whole, help="how many poses to try where straight ways are blocked"
    )
    remove.set_defaults(act=removing.remove)

    derive = commands.add_parser("derive", help="print the word of a grammar", description=grammar.derive.__doc__)
    derive.add_argument("grammar", metavar="FILE", help="a text with an axiom and productions; - for standard input")
    derive.add_argument("-n", "--generations", metavar="N", type=whole, help="how many steps, else as many as it says")
    derive.add_argument("--seed", metavar="S", type=whole, help="of its random numbers, else as it says")
    derive.add_argument("--count", action="store_true", help="only the number of modules of each generation")
    derive.set_defaults(act=grammar.derive)

    describe = commands.add_parser("describe", help="say what a job may tell", description=verbs.describe.__doc__)
    about = "a shape, one of its choices, render, a preset, or a grammar; - for standard input"
    describe.add_argument("shape", metavar="SHAPE", nargs="?", help=about)
    describe.add_argument("--schema", action="store_true", help="the JSON Schema of job files, for editors")
    describe.add_argument("--markdown", action="store_true", help="as a table for the docs")
    describe.set_defaults(act=verbs.describe)
    return made


def main(arguments):
    """Run one verb.

    Parameters
    ----------
    arguments : list of str
        What follows the program's name.

    Returns
    -------
    int
        The exit code.
    """
    if "bpy" in sys.modules:
        with silent():  # without Blender's greeting, which waits to be sent
            pass
    try:
        told = parser().parse_args(arguments)
        told.arguments = arguments
        return told.act(told)
    except SystemExit as stop:  # argparse, which has said why
        return stop.code or DONE
    except ShapeError as refusal:
        sys.stderr.write(f"{refusal}\n")
        return verbs.code_of(refusal)
    except verbs.CommandError as failure:
        sys.stderr.write(f"{failure}\n")
        return FAILED
    except OSError as error:  # a full disk
        where = f"{error.filename}: " if error.filename else ""
        sys.stderr.write(f"{where}{error.strerror or error}\n")
        return FAILED
    except (RuntimeError, MemoryError) as error:  # an exporter that gave up
        said = str(error).strip().splitlines() or [type(error).__name__]
        sys.stderr.write(f"{said[-1]}\n")
        return FAILED
    except KeyboardInterrupt:
        sys.stderr.write(STOPPED)
        return FAILED
