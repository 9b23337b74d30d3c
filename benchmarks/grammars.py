# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How fast grammars derive and turtles draw, beside a peer where one is in the same run, else beside figures quoted.

cpfg and lpfg (vlab, C and C++) and L-Py 3.15 have no package for pip. Their figures were taken on an idle machine of
the same kind: they tell the order of magnitude, ratios within this run tell more.
"""

from measuring import medians, short, table, tell

from bl_ext.user_default import sweep_addon as sw

try:
    from LindenmayerSystem import LSystem as SplitAndJoin
except ImportError:
    SplitAndJoin = None

ROUNDS = 5

KOCH = "#angle 90\naxiom: F\nF -> F+F-F-F+F"
PLANT = "#angle 22.5\naxiom: X\nX -> F-[[X]+X]+F[+FX]-X\nF -> FF"
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
    "3D, levelled, ABOP 2.6 a": (HONDA, 17, 15, "L-Py 1.6"),
    "tropism, ABOP 1.24 f": (f"#tropism 0 0 -1 0.22\n{PLANT}", 8, 5, ""),
    "tropism, ABOP 1.27": (f"#tropism 0 0 -1 0.22\n{CHANCE}", 10, 3, ""),
}
INTRODUCTION = f"""
### Grammars

Words derived from the text of their grammar, single-threaded, and figures drawn from words: medians of {ROUNDS} rounds.
Where a peer was installed for the same run it has a row; figures of other programs are quoted, from an idle machine.

"""


def replaced(text, generations):
    """How many modules a derivation looks at: the last word, or where contexts are read all words before."""
    sizes = sw.LSystem.parse(text).sizes(generations)
    return sum(sizes[:-1]) if "<" in text else sizes[-1]


def main():
    systems = {name: sw.LSystem.parse(text) for name, (text, *_) in (DERIVED | DRAWN).items()}
    words = {name: systems[name].derive(generations) for name, (_, generations, *_) in DRAWN.items()}
    actions = {name: lambda _, s=systems[name], n=row[1]: s.derive(n) for name, row in DERIVED.items()}
    actions |= {name: lambda _, word=words[name]: word.figure() for name in DRAWN}
    if SplitAndJoin:
        actions["peer"] = lambda _: SplitAndJoin(["F"], ["+", "-"], "F", {"F": "F+F-F-F+F"}, 9)
    found = medians(actions, ROUNDS)[1]
    rows = []
    for name, (text, generations, asked, quoted) in (DERIVED | DRAWN).items():
        count = len(words[name]) if name in words else replaced(text, generations)
        rows.append([name, f"{count:,}", short(found[name]), short(count / found[name] / 1000), asked, quoted])
    if SplitAndJoin:
        count = sw.LSystem.parse(KOCH).sizes(9)[-1]
        rows.insert(1, ["the same by LindenmayerSystem 1.0", f"{count:,}", short(found["peer"]),
                        short(count / found["peer"] / 1000), "", ""])  # fmt: skip
    titles = ["", "modules", "ms", "million modules a second", "asked", "quoted, million a second"]
    tell(INTRODUCTION + table(titles, rows))


main()
