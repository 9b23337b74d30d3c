# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A deriver that reads a word from left to right, one module after the other: what the one by arrays is compared with.

It follows the book: a left context skips complete branches and steps out of its own, a right context skips branches and
ends where its own does. Productions of a group are tried before those of every step; decompositions and homomorphisms
replace what they have made until nothing matches, or as often as their depth says.
"""

from hashlib import blake2b

GOLDEN, ALL = 0x9E3779B97F4A7C15, 2**64 - 1
LEVELS, DECOMPOSED, INTERPRETED = 512, 1, 256  # moments of random numbers: of steps, and of levels within them


def mixed(x):
    x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9 & ALL
    x = (x ^ x >> 27) * 0x94D049BB133111EB & ALL
    return x ^ x >> 31


def salt(names, k):
    ordinal = names[:k].count(names[k])
    return int.from_bytes(blake2b(f"{ordinal} {names[k]}".encode(), digest_size=8).digest(), "little")


def even(key, moment, draw):
    return (mixed(key + (moment * 1024 + draw + 1) * GOLDEN & ALL) >> 11) / 2**53


def children(modules, values, key, moment, first=False):
    """Successors as (name, parameters, key)."""
    names = [module.name for module in modules]
    numbers = {f"draw {k}": even(key, moment, 1 + k) for k in range(20)}
    for k, module in enumerate(modules):
        parameters = tuple(float(p.run(values | numbers)) for p in module.parameters)
        yield module.name, parameters, mixed(key + salt(names, k) & ALL) if first or len(modules) > 1 else key


def derive(system, generations, seed=0):
    """The words of all generations, each a list of (name, parameters, key)."""
    words = [decomposed(system, list(children(system.axiom, {}, mixed((seed + 1) * GOLDEN & ALL), 0, True)), 0)]
    for step in range(1, generations + 1):
        word, new, depth, cut, sections = words[-1], [], 0, None, [*of_step(system, step), system.productions]
        for at, module in enumerate(word):
            depth += (module[0] == "[") - (module[0] == "]")
            if cut is not None and depth < cut:
                cut = None
            if cut is None and module[0] == "%":
                cut = depth
            if cut is None:
                told = rewritten(system, sections, word, at, step * LEVELS)
                new += [module] if told is None else told
        words.append(decomposed(system, new, step))
    return words


def of_step(system, step):
    """The productions of the group of a step, in a list that is empty where it has none."""
    groups = dict(system.groups)
    if system.schedule:
        listed, again = system.schedule
        number = listed[(step - 1) % len(listed)] if again else listed[min(step, len(listed)) - 1]
    else:
        number = max((number for number in groups if number <= step), default=None)
    return [groups[number]] if number in groups else []


def decomposed(system, word, step):
    return repeated(system, system.decomposition, system.decomposition_depth, word, step * LEVELS + DECOMPOSED)


def interpreted(system, word, step):
    """The word that a turtle is told."""
    return repeated(system, system.homomorphism, system.homomorphism_depth, word, step * LEVELS + INTERPRETED)


def repeated(system, rules, depth, word, moment):
    """The word whose modules are replaced level by level, of which only what the last level made is replaced again."""
    fresh = [True] * len(word)
    for level in range(101 if depth is None else depth):
        new, made, changed = [], [], False
        for at, module in enumerate(word):
            told = rewritten(system, [rules], word, at, moment + level) if fresh[at] else None
            changed |= told is not None
            new += [module] if told is None else told
            made += [told is not None] * (len(new) - len(made))
        word, fresh = new, made
        if not changed:
            break
    return word


def rewritten(system, sections, word, at, moment):
    """The modules that replace one; None where no production is taken."""
    key = word[at][2]
    for rules in sections:
        for rule in rules:
            values = matched(system, rule, word, at, moment)
            if values is None:
                continue
            if rule.probability is None:
                return list(children(rule.successor, values, key, moment))
            drawn, total = even(key, moment, 0), 0.0
            for other in rules:  # those with the same head share the chance
                if other.probability and head(other) == head(rule):
                    total += other.chance
                    if drawn < total:
                        return list(children(other.successor, values, key, moment))
            return None
    return None


def head(rule):
    return rule.predecessor, rule.left, rule.right, rule.condition and rule.condition.text


def matched(system, rule, word, at, moment):
    """The values of parameters where a rule matches, or None."""
    values = {}
    if not bind(rule.predecessor, word[at], values):
        return None
    place = at
    for module, laterals in reversed(stem(rule.left)):
        place = before(system, word, place)
        if place is None or not bind(module, word[place], values):
            return None
        if not follow(system, word, place + 1, laterals, values):
            return None
    if not follow(system, word, at + 1, rule.right, values):
        return None
    condition = rule.condition
    if condition:
        values |= {f"draw {k}": even(word[at][2], moment, 1 + k) for k in range(20)}
        if not condition.run(values):
            return None
    return values


def stem(patterns):
    """What stands on the axis of a left context, each with the branches behind it."""
    found, depth = [], 0
    for pattern in patterns:
        if pattern.name == "[" or depth:
            depth += (pattern.name == "[") - (pattern.name == "]")
            found[-1][1].append(pattern)
        else:
            found.append((pattern, []))
    return found


def follow(system, word, place, patterns, values):
    """Whether patterns are what is found from a place on; those in brackets begin branches."""
    for wanted in patterns:
        if wanted.name == "]":
            place = past(word, place)
            continue
        place = behind(system, word, place, wanted.name == "[")
        if place is None or not bind(wanted, word[place], values):
            return False
        place += 1
    return True


def bind(pattern, module, values):
    if (pattern.name, len(pattern.parameters)) != (module[0], len(module[1])):
        return False
    values.update(zip(pattern.parameters, module[1], strict=True))
    return True


def hidden(system, name):
    return name not in system.consider if system.consider is not None else name in (system.ignore or ())


def before(system, word, place):
    depth = 0
    for at in range(place - 1, -1, -1):
        name = word[at][0]
        depth += (name == "]") - (name == "[")
        if name == "[" and depth < 0:
            depth = 0
        elif depth == 0 and name not in "[]" and not hidden(system, name):
            return at
    return None


def behind(system, word, place, branch):
    """The next module of the same branch, or its next branch; None at its end."""
    while place < len(word):
        name = word[place][0]
        if name == "]":
            return None
        if name == "[" and not branch:
            place = past(word, place + 1)
        elif name == "[" or not hidden(system, name) and not branch:
            return place
        elif branch and not hidden(system, name):
            return None
        else:
            place += 1
    return None


def past(word, place):
    """The place behind the bracket that closes the branch that a place is in."""
    depth = 1
    while depth:
        depth += (word[place][0] == "[") - (word[place][0] == "]")
        place += 1
    return place


def text(word):
    """A word as the book prints it."""
    return "".join(n + (f"({','.join(f'{p:.6g}' for p in ps)})" if ps else "") for n, ps, _ in word)
