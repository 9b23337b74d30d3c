# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Growing: from the parameters of a plant to its mesh; what the last one needed is kept for the next."""

from dataclasses import replace
from functools import lru_cache

import numpy as np

from ..declared.parameters import ShapeError, at
from ..declared.texts import Grammar, Values
from ..grammars import Budget, GrammarError, LSystem
from ..grammars.deriving.budget import LateError, ranged, sized
from ..grammars.deriving.growth import bounds, foretold
from ..grammars.deriving.noting import notes
from ..grammars.meshing import uniting
from ..grammars.meshing.chart import Skin
from ..vectors import norms

NONE = Values()
QUICK, MOMENT = 400_000, 0.3  # modules, and seconds, up to which a word is derived while somebody waits
FEW = 1_000  # modules up to which tubes are united while somebody waits
BYTES = 50  # of a module of a word, as many as the default budget allows
DERIVED, DRAWN = 0.5, 0.7  # parts of the work
THICK, SOME = 0.5, 1_000  # of the size of a figure: tubes beyond are most likely told in other units than lengths
NOTHING = "The word draws nothing: segments are F and G, polygons stand in { }, and organs behind ~."
CLUMSY = (
    "Tubes are up to {:.3g} m thick in a figure of {:.3g} m: diameters, by ! or Width, are in metres too. "
    "A homomorphism of maximum depth 1 makes them smaller, !(w) -> !(w/100)."
)
LYING = "A figure with branches lies on the ground, along x: Upright, Upwards lets a plant stand."
LENGTHS, MOST_LENGTHS = {}, 64  # of the words that were derived last


def read(text, constants=NONE):
    """The system of a text, with values for some of its constants."""
    found = tried(text, constants)
    if isinstance(found, ShapeError):
        raise found.inside("")
    return found


@lru_cache(maxsize=16)
def tried(text, constants):
    """The system of a text, or its refusal: the sidebar asks with each draw, whatever somebody has written.

    What is kept is a refusal that nobody has raised, so that it keeps no frames, and no two threads raise the same.
    """
    try:
        return LSystem.parse(str(text), dict(constants))
    except ShapeError as refusal:
        return refusal.inside("")


def problems(text):
    """What is wrong in a text, line by line: a tuple of Problem."""
    try:
        read(text)
    except GrammarError as refusal:
        return refusal.problems
    return ()


def free(text):
    """The constants of a text that need no others, by name: those that people may turn at will."""
    return {constant.name: constant for constant in read(text).constants if not constant.formula.names}


def followed(text):
    """The numbers that a text says by constants, which alone turn them: their names.

    >>> followed(Grammar("#define a 20\\n#angle a\\n#step 2\\naxiom: F"))
    {'angle'}
    """
    return {name for name, _, _ in read(text).following}


def other(text, constants):
    """Those of some values that are not what the text says anyway."""
    plain = {name: constant.value for name, constant in free(text).items()}
    order = [constant.name for constant in read(text).constants]
    return Values({name: constants[name] for name in order if name in constants and plain.get(name) != constants[name]})


def system(plant):
    """The system of a plant, with the plant's own numbers."""
    found = read(plant.system, plant.constants)
    own = {name: getattr(plant, name) for name in ("angle", "step", "width")}
    return replace(found, **own) if any(getattr(found, name) != value for name, value in own.items()) else found


def takes_long(plant):
    """Whether a plant takes too long while somebody drags a slider: its word is long, or its tubes are to be united."""
    most = FEW if is_united(plant) else QUICK
    sizes, limits = known(plant.system, plant.constants, plant.generations)
    if sizes:
        return most < max(sizes) <= plant.budget
    if limits and limits[0] > plant.budget:
        return False  # it is refused at once
    word = quick(*asked(plant))
    return word is None or len(word) > most


@lru_cache(maxsize=16)
def known(text, constants, generations):
    """What is known of the sizes of words before they are derived: those of all generations, or limits, or neither."""
    tables = read(text, constants).compiled
    sizes = foretold(tables, generations)
    return sizes, None if sizes else bounds(tables, generations)


def asked(plant):
    """What the word of a plant hangs on."""
    return told(plant), plant.constants, plant.generations, plant.seed, plant.budget


def told(plant):
    """The text of a plant; where it asks a turtle, whose answers hang on the plant's own numbers, with these."""
    if not read(plant.system, plant.constants).compiled.queries:
        return plant.system
    heading = {None: system(plant).heading, True: "z", False: "x"}[plant.upright.upright]
    return Grammar(replace(system(plant), heading=heading))


def quick(text, constants, generations, seed, budget):
    """The word of a text; None where it is long, which is asked anew each time: the machine may have been busy."""
    try:
        return word(text, constants, generations, seed, min(budget, QUICK))
    except LateError:
        return None
    except ShapeError as refusal:
        if refusal.key != "generations" or budget <= QUICK:
            raise
        return None


@lru_cache(maxsize=2)
def word(text, constants, generations, seed, modules):
    """The word of a text, which is kept for further meshes of it once it is derived.

    What its system says of angles, lengths and widths does not count for it.
    """
    return read(text, constants).derive(generations, seed, Budget(modules, seconds=MOMENT))


def drawn(word, budget, system, upright):
    """What the turtle of a system draws of a word."""
    return word.figure(upright, within(budget), system)


figure = lru_cache(maxsize=1)(drawn)  # of a word that is not long


def mesh(plant, dtype):
    """The mesh of a plant; `Plant.mesh` says of what."""
    return skinned(shown(plant), plant, dtype)


@lru_cache(maxsize=4)
def united(plant):
    """The solid of the tubes of a plant; `Plant.united` says of what."""
    from ..solids import Triangles

    plant.require_solid()
    return Triangles.of(mesh(replace(plant, output=replace(plant.output, united=True)), np.float64))


def axes(plant):
    """The poly-lines of a plant; `Plant.axes` says of what."""
    skin = Skin(shown(plant))
    return skin.points, skin.radius, np.append(skin.first, skin.rings)


def made(plant, progress, dtype=np.float64):
    """The mesh of a plant that takes long, told of as far as it is."""
    figure = at_length(plant, progress)
    progress(DRAWN)
    skin = skinned(figure, plant, dtype)
    progress(1.0)
    return skin


def shown(plant):
    """The figure of a plant, which is kept where its word is not long."""
    sizes, _ = known(plant.system, plant.constants, plant.generations)
    word = None if sizes and max(sizes) > QUICK else quick(*asked(plant))
    if word is None:
        return at_length(plant, lambda part: None)
    remember(plant, word)
    return figure(word, plant.budget, system(plant), plant.upright.upright)


def at_length(plant, progress):
    """The figure of a plant whose word may be long."""
    grown = read(told(plant), plant.constants)
    word = grown.derive(plant.generations, plant.seed, within(plant.budget), lambda part: progress(DERIVED * part))
    remember(plant, word)
    return drawn(word, plant.budget, system(plant), plant.upright.upright)


def remember(plant, word):
    """Keep how many modules a word has, by what it hangs on: of many no more is known before they are derived."""
    while len(LENGTHS) >= MOST_LENGTHS:
        LENGTHS.pop(next(iter(LENGTHS)), None)
    LENGTHS[asked(plant)] = len(word)


def skinned(figure, plant, dtype):
    """The mesh of a figure as a plant asks for it."""
    sides, apart = getattr(plant.output, "sides", 0), getattr(plant.output, "apart", False)
    with at("output" if sides else "budget"):
        made = figure.mesh(sides, plant.texture, plant.attributes, dtype, within(plant.budget), apart)
        if is_united(plant):
            made = uniting.united(made).astype(dtype)
    found = (*seen(figure, made, sides), *lying(figure, plant), *noted(plant.system, plant.constants))
    return replace(made, told=(*made.told, *found))


def seen(figure, made, sides):
    """What is odd about what is drawn: that there is nothing, or tubes that hide how they branch."""
    if not len(made.vertices):
        yield NOTHING
    if sides and len(figure):
        thick, some = float(figure.width.max()), figure.end[:: 1 + len(figure) // SOME]
        if thick > THICK * norms(np.ptp(some, axis=0)):  # of a figure that is large enough some places tell it
            size = float(norms(np.ptp(figure.bounds, axis=0)))
            if thick > THICK * size:
                yield CLUMSY.format(thick, size)


def lying(figure, plant):
    """That a figure lies which may be meant as a plant: nobody has said where its turtle looks at first."""
    said = plant.upright.upright is not None or system(plant).heading
    if not said and len(figure) and (figure.branch != figure.branch[0]).any() and not np.ptp(figure.bounds[:, 2]):
        yield LYING


def is_united(plant):
    """Whether the tubes of a plant are to be one solid."""
    return getattr(plant.output, "united", False)


@lru_cache(maxsize=16)
def noted(text, constants):
    """What the system of a text says and never does."""
    return tuple(notes(read(text, constants)))


def within(modules):
    """The budget of words of so many modules, and of what is drawn of them."""
    return Budget(modules, max(Budget().bytes, BYTES * modules))


def size(plant):
    """How many modules the word of a plant has, or what is known of that before it is derived: a sentence."""
    here, more = plant.generations, plant.generations + 1
    sizes, _ = known(plant.system, plant.constants, more)
    if sizes and len(sizes) > more:
        return f"{sized(sizes[here])} modules; next step {sized(sizes[more])}"
    sizes, limits = known(plant.system, plant.constants, here)
    if sizes:
        return f"More than {sized(sizes[-1])} modules"
    if asked(plant) in LENGTHS:
        return f"{sized(LENGTHS[asked(plant)])} modules"
    if limits:
        return f"{ranged(*limits)} modules"
    return "How many modules there will be hangs on what happens"
