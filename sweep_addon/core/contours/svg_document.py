# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""An SVG document from a stranger: its elements, once it is certain that they can be interpreted quickly and safely."""

import re
from xml.etree import ElementTree

from ..declared.documents import DEEPEST, parsed, plain
from ..declared.parameters import require
from .reading import library

LARGEST = 2_000_000  # characters, repeated uses counted again
UNSEEN = {"mask", "marker", "filter", "linearGradient", "radialGradient", "foreignObject", "script"}
HREFS = "href", "{http://www.w3.org/1999/xlink}href"
PLACE = {"x", "y", "width", "height"}
INCH = 96.0  # units of a drawing that has no viewBox
UNKNOWN = 1000.0  # its size where it names none
IMPORTANT = re.compile(r"\s*!\s*important\b")


def tree(data):
    """The root element of a document, without what is never seen, and the width and height that percentages are of.

    It has lost its viewport, so that its lengths are in the drawing's own units.

    Raises
    ------
    ShapeError
        For what is no SVG, for entities (a few lines of which can stand for terabytes), and for elements nested or
        used over and over.
    """
    require(data.strip(), "must be an SVG drawing", "nothing")
    require(len(data) <= LARGEST, f"must have at most {LARGEST} characters", len(data))
    root = parsed(data)
    require(plain(root) == "svg", "must have an svg element at its root", plain(root))
    uses = Uses(root)
    uses.measured(root)
    hide(root)
    spell(root)
    place(root, uses)
    return root, *own_size(root)


class Uses:
    """How large and how deep elements are when every ``use`` has been replaced by what it uses."""

    def __init__(self, root):
        self.named = {element.get("id"): element for element in root.iter() if element.get("id")}
        self.known = {}
        self.open = set()

    def measured(self, element, level=0):
        """The characters and the depth of an element; refuses too much of either, and uses that use themselves."""
        require(element not in self.open, "must have no use of an element within itself", element.get("id") or "use")
        require(level <= DEEPEST, f"must have elements and uses nested at most {DEEPEST} deep", level)
        if element not in self.known:
            self.open.add(element)
            parts = [self.measured(part, level + 1) for part in (*element, *self.used(element))]
            self.open.remove(element)
            size = sum(map(len, element.attrib.values())) + 1 + sum(part[0] for part in parts)
            require(size <= LARGEST, f"must have at most {LARGEST} characters with its uses replaced", size)
            self.known[element] = size, 1 + max((part[1] for part in parts), default=0)
        size, depth = self.known[element]
        require(
            level + depth <= DEEPEST + 1, f"must have elements and uses nested at most {DEEPEST} deep", level + depth
        )
        return size, depth

    def used(self, element):
        if plain(element) != "use":
            return []
        names = [element.get(key, "")[1:] for key in HREFS]
        return [self.named[name] for name in names if name in self.named][:1]


def hide(root):
    """Take out what is drawn nowhere, put symbols where only a use shows them, and let lengths be the file's own."""
    for parent in list(root.iter()):
        for i, element in enumerate(list(parent)):
            if plain(element) in UNSEEN:
                parent.remove(element)
            elif plain(element) == "symbol":
                wrapper = ElementTree.Element(element.tag.replace("symbol", "defs"))
                wrapper.append(element)
                parent.remove(element)
                parent.insert(i, wrapper)


def spell(root):
    """Spell properties as the parser knows them."""
    for element in root.iter():
        if plain(element) == "style":
            element.text = IMPORTANT.sub("", element.text or "")
        for key, value in list(element.attrib.items()):
            if key == "style":
                element.set(key, IMPORTANT.sub("", value))
            elif key in ("fill", "fill-rule", "visibility", "display"):
                element.set(key, value.strip())
                if value.strip() == "inherit":
                    del element.attrib[key]


def place(parent, uses):
    """Put what has a viewBox of its own where it belongs: svg elements, which the parser moves twice, and symbols."""
    for i, element in enumerate(parent):
        symbol = next((each for each in uses.used(element) if plain(each) == "symbol" and each.get("viewBox")), None)
        if symbol is not None:
            parent[i] = instance(element, symbol)
        elif plain(element) == "svg" and element.get("viewBox") and ("x" in element.keys() or "y" in element.keys()):
            parent[i] = moved(element)
        place(parent[i], uses)


def instance(use, symbol):
    """A group of what a use of a symbol draws, in a viewport as large as the use says."""
    own = {key: value for key, value in use.items() if key not in HREFS and key not in PLACE}
    size = {key: use.get(key) or symbol.get(key) or "100%" for key in ("width", "height")}
    box = {key: symbol.get(key) for key in ("viewBox", "preserveAspectRatio") if symbol.get(key)}
    group = ElementTree.Element(use.tag.replace("use", "g"), own)
    x, y = (use.get(key, "0") for key in ("x", "y"))
    viewport = ElementTree.SubElement(group, use.tag.replace("use", "svg"), {"x": x, "y": y, **size, **box})
    kept = {key: value for key, value in symbol.items() if key not in box and key not in PLACE and key != "id"}
    ElementTree.SubElement(viewport, group.tag, kept).extend(symbol)
    return group


def moved(viewport):
    """A group that moves a viewport to its place."""
    x, y = (length(viewport.attrib.pop(key, "0"), 0.0) for key in ("x", "y"))
    group = ElementTree.Element(viewport.tag.replace("svg", "g"), {"transform": f"translate({x} {y})"})
    group.append(viewport)
    return group


def own_size(root):
    """Width and height of the drawing in its own units; takes the viewport off it."""
    viewport = {
        key: root.attrib.pop(key, "") for key in ("viewBox", "width", "height", "preserveAspectRatio", "x", "y")
    }
    box = viewport["viewBox"].replace(",", " ").split()
    return tuple(length(text) for text in (box[2:4] if len(box) == 4 else (viewport["width"], viewport["height"])))


def length(text, unknown=UNKNOWN):
    """A length in units of the drawing; what is relative or none is not known."""
    try:
        return float(library("svgelements", "svgelements").Length(text).value(ppi=INCH))
    except (ValueError, TypeError):
        return unknown
