# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A layout that writes down what a panel asks it for."""

from types import SimpleNamespace

import bpy


class Layout:
    """A layout that checks what it is asked to draw against what Blender knows, and writes it down."""

    def __init__(self, drawn=None, folded=False):
        self.drawn, self.folded = [] if drawn is None else drawn, folded

    def part(self, **_):
        self.drawn.append("part")
        return Layout(self.drawn, self.folded)

    row = column = split = box = part

    def panel(self, idname, **_):
        return self.part(), None if self.folded else self.part()

    def label(self, text="", icon="NONE", icon_value=0):
        assert icon in bpy.types.UILayout.bl_rna.functions["label"].parameters["icon"].enum_items
        self.drawn.append(text)

    def template_icon(self, icon_value, scale):
        assert icon_value >= 0 and scale > 0  # in background there are no icons, and each has the number 0
        self.drawn.append("picture")

    def progress(self, factor, text=""):
        assert 0 <= factor <= 1
        self.drawn.append(text)

    def separator(self, **_):
        self.drawn.append("separator")

    def context_pointer_set(self, name, data):
        assert isinstance(data, bpy.types.bpy_struct)

    def prop(self, data, name, text="", **_):
        own = name[2:-2] if name.startswith('["') else ""  # of the data alone, by its name between quotes
        assert own in data if own else name in data.bl_rna.properties
        self.drawn.append(name)

    prop_menu_enum = prop

    def template_ID(self, data, name, new="", open=""):  # noqa: N802, as Blender spells it
        self.prop(data, name)
        for idname in filter(None, (new, open)):
            self.operator(idname)

    def menu(self, name, text="", icon="NONE", icon_value=0):
        assert hasattr(bpy.types, name)
        self.drawn.append(name)

    def operator(self, idname, text="", icon="NONE", **_):
        space, verb = idname.split(".")
        known = getattr(getattr(bpy.ops, space), verb).get_rna_type()
        self.drawn += [idname, text] if text else [idname]
        return Options(known)


class Options:
    """The options of a button: only those that the operator has, and only values that it takes."""

    def __init__(self, known):
        object.__setattr__(self, "known", known)

    def __setattr__(self, name, value):
        option = self.known.properties[name]
        assert option.type != "ENUM" or value in (option.enum_items.keys() or self.asked_for(name))

    def asked_for(self, name):
        """The items that a function gives."""
        declared = getattr(bpy.types, self.known.identifier).__annotations__[name].keywords["items"]
        return [item[0] for item in declared(None, bpy.context)]


def context_of(ob=None, mode="OBJECT", width=300, others=()):
    """The context in which a panel is drawn, this object active and selected."""
    return SimpleNamespace(
        active_object=ob,
        object=ob,
        mode=mode,
        region=SimpleNamespace(width=width),
        preferences=SimpleNamespace(system=SimpleNamespace(ui_scale=1.0)),  # without a window it is 0
        selected_objects=[*([ob] if ob else []), *others],
        scene=bpy.context.scene,
        window_manager=bpy.context.window_manager,
        view_layer=bpy.context.view_layer,
    )
