"""What is said of work under way: in the status bar and in the panel. Headers keep their menus, as
the user goes on working."""

from __future__ import annotations

from typing import Any

import bpy


class _Said:
    text = ""
    failed = False
    workspaces: set[str] = set()  # whose status bars say it; the user may go from one to another


def shown() -> tuple[str, bool]:
    """What the panel says, and whether it is an error."""
    return _Said.text, _Said.failed


def say(work: Any, stop: str = "") -> None:
    """How far a Work is; `stop`: what ends it."""
    doing, fraction = work.says()
    _say(f"craze: {doing}" + ("" if fraction is None else f", {fraction:.0%}"), stop, False)


def fail(error: str) -> None:
    """An error that no operator can report; stays until something else is said."""
    _say(f"craze: {error}", "", True)


def clear() -> None:
    """Nothing is under way."""
    for name in _Said.workspaces:
        workspace = bpy.data.workspaces.get(name)
        if workspace is not None:
            workspace.status_text_set(None)
    _Said.workspaces = set()
    _Said.text, _Said.failed = "", False
    _draw()


def _say(text: str, stop: str, failed: bool) -> None:
    _Said.text, _Said.failed = text, failed
    for window in bpy.context.window_manager.windows:
        window.workspace.status_text_set(text + (f"   ({stop})" if stop else ""))
        _Said.workspaces.add(window.workspace.name)
    _draw()


def _draw() -> None:
    """Sidebars, which cost little; not what they lie upon."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            for region in area.regions:
                if area.type == "VIEW_3D" and region.type == "UI":
                    region.tag_redraw()
