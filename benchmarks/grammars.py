# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How fast grammars derive and turtles draw, beside a peer where one is in the same run, else beside figures quoted.

cpfg and lpfg (vlab, C and C++) and L-Py 3.15 have no package for pip. Their figures were taken on an idle machine of
the same kind: they tell the order of magnitude, ratios within this run tell more.
"""

import bpy
from measuring import medians, short, table, tell
from peers import evaluated

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.bridge import meshes

try:
    from LindenmayerSystem import LSystem as SplitAndJoin
except ImportError:
    SplitAndJoin = None

ROUNDS, TIMES = 5, 4

KOCH = "#angle 90\naxiom: F\nF -> F+F-F-F+F"
PLANT = "#angle 22.5\naxiom: X\nX -> F-[[X]+X]+F[+FX]-X\nF -> FF"
BENT = PLANT.replace("-X", "&X").replace("+F[", "/F[")
CHANCE = "#angle 25.7\naxiom: F\nF -(0.33)-> F[+F]F[-F]F\nF -(0.33)-> F[+F]F\nF -(0.34)-> F[-F]F"
HONDA = """axiom: A(1,10)
A(l,w) -> !(w)F(l)[&(45)B(l*0.6,w*0.707)]/(137.5)A(l*0.9,w*0.707)
B(l,w) -> !(w)F(l)[-(45)$C(l*0.6,w*0.707)]C(l*0.9,w*0.707)
C(l,w) -> !(w)F(l)[+(45)$B(l*0.6,w*0.707)]B(l*0.9,w*0.707)"""
SIGNALS = "#angle 22.5\n#ignore +-F\naxiom: F1F1F1\n+ -> -\n- -> +\n" + "\n".join(
    f"{rule[0]}<{rule[1]}>{rule[2]} -> {rule[4:]}"
    for rule in "000 1|001 1[-F1F1]|010 1|011 1|100 0|101 1F1|110 1|111 0".split("|")
)
CELLS = """#ignore f~H
axiom: -(90)F(0,0,900)F(4,1,900)F(0,0,900)
F(s,t,c) : t==1 && s>=6 -> F(s/3*2,2,c)f(1)F(s/3,1,c)
F(s,t,c) : t==2 && s>=6 -> F(s/3,2,c)f(1)F(s/3*2,1,c)
F(h,i,k)<F(s,t,c)>F(o,p,r) : s>3.9 || c>0.4 -> F(s+0.1,t,c+0.25*(k+r-3*c))
F(h,i,k)<F(s,t,c)>F(o,p,r) : !(s>3.9 || c>0.4) -> F(0,0,900)~H(1)
H(s) : s<3 -> H(s*1.1)"""
DERIVED = {  # name: text, generations, millions of modules a second that are asked for, and what peers were measured at
    "D0L, Koch curve": (KOCH, 9, 1000, "cpfg 33-48, lpfg 42, L-Py 6.9"),
    "D0L with branches, ABOP 1.24 f": (PLANT, 9, 1000, "cpfg 36-45, lpfg 38, L-Py 6.5"),
    "stochastic, ABOP 1.27": (CHANCE, 10, 90, "lpfg 31, cpfg 27, L-Py 4.9"),
    "parametric, ABOP 2.6 a": (HONDA, 17, 50, "lpfg 23.7, cpfg 5.1, L-Py 2.2"),
    "context, ABOP 1.31 b, module-steps": (SIGNALS, 40, 50, "cpfg 12-14, lpfg 2.6, L-Py 1.1"),
    "conditions on short words, heterocysts, module-steps": (CELLS, 400, 8, ""),
}
DRAWN = {
    "2D without branches, Koch curve": (KOCH, 9, 100, ""),
    "2D with branches, ABOP 1.24 f": (PLANT, 9, 25, "Animation Nodes 53-55 with the derivation"),
    "3D, ABOP 1.24 f bent out of its plane": (BENT, 8, 12, ""),
    "3D, levelled, ABOP 2.6 a": (HONDA, 17, 15, "L-Py 1.6"),
    "tropism, ABOP 1.24 f": (f"#tropism 0 0 -1 0.22\n{PLANT}", 8, 5, ""),
    "tropism, ABOP 1.27": (f"#tropism 0 0 -1 0.22\n{CHANCE}", 10, 3, ""),
}
TURNED = "#define a 22.5\naxiom: X{}\nX -> F-(a)[[X]+(a)X]+(a)F[+(a)FX]-(a)X\nF -> FF"
MADE = {  # name: generations, sides, whether with texture coordinates and attributes, and the milliseconds asked for
    "130,304 vertices, bare": (7, 4, False, 40),
    "130,304 vertices, with UVs and eight attributes": (7, 4, True, 55),
    "1,045,504 vertices, bare": (8, 8, False, 200),
    "1,045,504 vertices, with UVs and eight attributes": (8, 8, True, 300),
}
DRAGGED = "130,304 vertices with all that, a constant dragged", 60
MESHES = """
From the text of a grammar, ABOP 1.24 f, to a mesh of Blender that was not there before, its edges known; no text and no
faces are those of the round before. And from a constant that is set to the mesh that Blender shows.

"""
INTRODUCTION = f"""
### Grammars

Words derived from the text of their grammar, single-threaded, and figures drawn from words: medians of {ROUNDS} rounds.
Each is done {TIMES} times in its turn: *first* comes after other work, in memory that nobody has touched yet; all else
is the last time, as of who makes one after the other. Where a peer was installed for the same run it has a row; figures
of other programs are quoted, from an idle machine.

"""


def replaced(text, generations):
    """How many modules a derivation looks at: the last word, or where contexts are read all words before."""
    sizes = sw.LSystem.parse(text).sizes(generations)
    return sum(sizes[:-1]) if "<" in text else sizes[-1]


def maker(generations, sides, laid):
    """Makes a mesh of a new text and removes the one before."""
    made = []

    def action(number):
        for mesh in made:
            bpy.data.meshes.remove(mesh)
        told = PLANT.replace("axiom: X", "axiom: X" + "[F]" * (number % 7))  # which no faces are kept for
        texture = "lengths" if laid else "none"
        plant = sw.Plant(f"{told}\n# {number}", generations, output={"kind": "tubes", "sides": sides},
                         texture=texture, attributes=laid)  # fmt: skip
        made[:] = [bpy.data.meshes.new("plant")]
        meshes.write(made[0], plant.mesh("f4"))

    return action


def dragged():
    """Turns a constant of a live plant, and asks for the mesh."""
    ob = sw.to_object(sw.Plant(TURNED.format(""), 7, output={"kind": "tubes", "sides": 4}))

    def action(number):
        ob.data.sweep.plant.constants["a"] = 22.5 + 0.01 * number
        ob.data.update_tag()
        evaluated(ob)

    return action


def main():
    systems = {name: sw.LSystem.parse(text) for name, (text, *_) in (DERIVED | DRAWN).items()}
    words = {name: systems[name].derive(generations) for name, (_, generations, *_) in DRAWN.items()}
    actions = {name: lambda _, s=systems[name], n=row[1]: s.derive(n) for name, row in DERIVED.items()}
    actions |= {name: lambda _, word=words[name]: word.figure() for name in DRAWN}
    actions |= {name: maker(*row[:3]) for name, row in MADE.items()} | {DRAGGED[0]: dragged()}
    if SplitAndJoin:
        actions["peer"] = lambda _: SplitAndJoin(["F"], ["+", "-"], "F", {"F": "F+F-F-F+F"}, 9)
    first, found = medians(actions, ROUNDS, TIMES)
    rows = []
    for name, (text, generations, asked, quoted) in (DERIVED | DRAWN).items():
        count = len(words[name]) if name in words else replaced(text, generations)
        times = short(first[name]), short(found[name])
        rows.append([name, f"{count:,}", *times, short(count / found[name] / 1000), asked, quoted])
    if SplitAndJoin:
        count = sw.LSystem.parse(KOCH).sizes(9)[-1]
        rows.insert(1, ["the same by LindenmayerSystem 1.0", f"{count:,}", short(first["peer"]), short(found["peer"]),
                        short(count / found["peer"] / 1000), "", ""])  # fmt: skip
    titles = ["", "modules", "first, ms", "ms", "million modules a second", "asked", "quoted, million a second"]
    asked = {name: row[3] for name, row in MADE.items()} | dict([DRAGGED])
    rows_made = [[name, short(first[name]), short(found[name]), most] for name, most in asked.items()]
    made = table(["", "first, ms", "ms", "asked"], rows_made)
    tell(INTRODUCTION + table(titles, rows) + "\n" + MESHES + made)


main()
