"""Tests with a window: generators named test_*, a step at a time by a timer, which is how Blender
goes on in between. What they yield is how long they wait, in seconds."""

import os
import sys
import traceback

import bpy


def view():
    """The 3D View's context, to run operators in."""
    window = bpy.context.window_manager.windows[0]
    area = next(a for a in window.screen.areas if a.type == "VIEW_3D")
    region = next(r for r in area.regions if r.type == "WINDOW")
    return {"window": window, "area": area, "region": region}


def press(key):
    """A key goes down and up in the 3D View."""
    of = view()
    area = of["area"]
    place = {"x": area.x + area.width // 2, "y": area.y + area.height // 2}
    for value in ("PRESS", "RELEASE"):
        of["window"].event_simulate(type=key, value=value, **place)


def hover(x, y):
    """The mouse goes to a place in the window."""
    view()["window"].event_simulate(type="MOUSEMOVE", value="NOTHING", x=x, y=y)


def click(x, y):
    """The mouse goes to a place, and clicks."""
    drag((x, y), (x, y))


def drag(start, end):
    """The mouse goes from one place to another with its button down."""
    window = view()["window"]
    hover(*start)
    window.event_simulate(type="LEFTMOUSE", value="PRESS", x=start[0], y=start[1])
    if end != start:
        for i in range(1, 21):
            hover(*(round(a + (b - a) * i / 20) for a, b in zip(start, end)))
    window.event_simulate(type="LEFTMOUSE", value="RELEASE", x=end[0], y=end[1])


class Failed(Exception):
    pass


def check(holds, words):
    if not holds:
        raise Failed(words)


def run(module):
    tests = [(n, f) for n, f in vars(module).items() if n.startswith("test_")]
    left, failed, current = list(tests), [], []

    def step():
        if not current:
            if not left:
                end()
            name, function = left.pop(0)
            print(name, "...", flush=True)
            current[:] = [name, function()]
        try:
            return next(current[1])
        except StopIteration:
            print("ok", flush=True)
        except BaseException:
            failed.append(current[0])
            traceback.print_exc(file=sys.stdout)
        current.clear()
        return 0.1

    def end():
        import craze_blender

        craze_blender.unregister()
        print(f"Ran {len(tests)} tests, {len(failed)} failed", flush=True)
        os._exit(3 if failed or not tests else 0)

    bpy.app.timers.register(step, first_interval=1.0, persistent=True)
