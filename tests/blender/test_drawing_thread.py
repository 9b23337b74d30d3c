# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What other threads would write is written by the thread that draws: here that of the test, which gives turns."""

from threading import Event, Thread, get_ident

import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import extent, square, sweep

from sweep_addon.properties import drawing_thread, live, rendering


@pytest.fixture
def window(monkeypatch):
    """A window of the test's own."""
    own = drawing_thread.Window()
    monkeypatch.setattr(drawing_thread, "window", own)
    return own


@pytest.fixture
def writers():
    return []


@pytest.fixture
def asking(writers):
    """A function that starts a thread which asks for a turn in which it is noted who writes."""

    def ask(call=lambda: None):
        def write():
            writers.append(get_ident())
            call()

        thread = Thread(target=drawing_thread.in_drawing_thread, args=(write,), daemon=True)
        thread.start()
        return thread

    return ask


def test_the_thread_that_draws_writes_at_once(window, writers):
    drawing_thread.in_drawing_thread(writers.append, get_ident())
    assert writers == [get_ident()] and not window.waiting


def test_another_thread_waits_for_its_turn(window, writers, asking, monkeypatch):
    monkeypatch.setattr(window, "patience", 10.0)
    thread = asking()
    thread.join(0.1)
    assert thread.is_alive() and not writers
    window.give()
    thread.join(5)
    assert not thread.is_alive() and writers == [get_ident()]


def test_where_no_turn_comes_it_writes_itself_and_is_quicker_to_do_so_again(window, writers, asking):
    thread = asking(lambda: drawing_thread.in_drawing_thread(writers.append, get_ident()))  # what it calls may ask too
    thread.join(5)
    assert not thread.is_alive() and writers == [thread.ident, thread.ident]
    assert window.patience == drawing_thread.MOMENT
    window.give()
    assert len(writers) == 2 and window.patience == drawing_thread.PATIENCE


def test_a_window_that_closes_a_file_is_not_waited_for(window, writers, asking, monkeypatch):
    monkeypatch.setattr(window, "patience", 60.0)
    thread = asking()
    window.before_close()
    thread.join(5)
    assert writers == [thread.ident]


def test_nothing_is_written_while_the_window_evaluates(window, writers, asking):
    window.before_close()
    window.before_evaluation()
    thread = asking()
    thread.join(0.2)
    assert thread.is_alive() and not writers
    window.after_evaluation()
    thread.join(5)
    assert writers == [thread.ident]


def test_the_window_evaluates_when_what_is_written_is_whole(window, asking):
    window.before_close()
    begun, end = Event(), Event()
    thread = asking(lambda: [begun.set(), end.wait()])
    begun.wait()
    other = Thread(target=window.before_evaluation, daemon=True)
    other.start()
    other.join(0.1)
    assert other.is_alive() and not window.evaluating
    end.set()
    other.join(5)
    thread.join(5)
    assert window.evaluating


def test_who_asked_is_told_what_went_wrong(window):
    told = []

    def ask():
        with pytest.raises(ZeroDivisionError) as error:
            drawing_thread.in_drawing_thread(lambda: 1 / 0)
        told.append(error)

    thread = Thread(target=ask)
    thread.start()
    while thread.is_alive():
        window.give()
    assert told


def test_a_mesh_that_another_thread_has_had_made_is_held_until_the_end(scene, window, writers, monkeypatch):
    """Of two, one is not as it was made last; the contour that both follow is scaled while it is held."""
    held, put, profile = rendering.held, live.put, square()
    ob, other = sweep(contour=profile), sweep(contour=profile)
    depsgraph = bpy.context.evaluated_depsgraph_get()
    ob.data.sweep.made = "otherwise"
    monkeypatch.setattr(live, "put", lambda *made: [writers.append(get_ident()), put(*made)])
    thread = Thread(target=lambda: [held.remake(each.data, depsgraph) for each in (ob, other)])
    thread.start()
    while thread.is_alive():
        window.give()
    assert writers == [get_ident()] and ob.data in held and other.data not in held and rendering.goes_on()
    profile.scale.x = 3
    bpy.context.view_layer.update()
    assert extent(ob) == pytest.approx((1, 1, 2)) and extent(other) == pytest.approx((3, 1, 2))
    held.release()
    assert extent(ob) == pytest.approx((3, 1, 2)) and not rendering.goes_on()
