"""The zip, outside Blender: test_names.py ZIP. Names of bpy that a Blender from 3.4 to 5.1 does not
have are used where the add-on asks for them first, and nowhere else. The lists are of the release notes
and change logs of 3.5 … 5.1 (docs.blender.org/api/VERSION/change_log.html,
developer.blender.org/docs/release_notes/VERSION/python_api)."""

import ast
import sys
import unittest
import zipfile
from pathlib import Path

ZIP = Path(sys.argv[1])

# Attributes that are gone in some version: what a function that uses one asks hasattr() or getattr()
# for; None: it is not used at all.
GONE = {
    # 4.0
    "bevel_weight": None, "crease": None, "face_maps": None, "sculpt_vertex_colors": None,
    "vertex_creases": "vertex_creases", "vertex_layers_float": None, "polygon_layers_int": None,
    "asset_file_handle": None, "asset_library_ref": None, "calc_normals": None,
    "override_template_create": None,
    # 4.1
    "use_auto_smooth": "use_auto_smooth", "auto_smooth_angle": "use_auto_smooth",
    "calc_normals_split": "corner_normals", "create_normals_split": None,
    "free_normals_split": None, "vertex_paint_masks": None, "displacement_method": None,
    # 4.2
    "blend_method": None, "shadow_method": None, "use_screen_refraction": None,
    "show_transparent_back": None, "use_sss_translucency": None,
    # 4.4, 5.0
    "sequences": None, "fcurves": "fcurves", "id_root": None, "vertex_colors": None,
    "use_nodes": "use_nodes", "sculpt_tool": None, "use_bloom": None, "use_ssr": None,
}  # fmt: skip
# Of a node group, 4.0; nodes go on having them.
OF_TREES = {"inputs", "outputs"}
# Sockets of the Principled BSDF before 4.0; all of those that it has now are free.
SOCKETS = {
    "Subsurface", "Subsurface Color", "Specular", "Transmission", "Transmission Roughness",
    "Clearcoat", "Clearcoat Roughness", "Clearcoat Normal", "Sheen", "Emission",
}  # fmt: skip
WORDS = {
    "ShaderNodeMixRGB", "ShaderNodeTexMusgrave", "ShaderNodeSeparateRGB", "ShaderNodeCombineRGB",
    "BLENDER_EEVEE", "BLENDER_EEVEE_NEXT", "3D_UNIFORM_COLOR", "2D_UNIFORM_COLOR",
}  # fmt: skip
# Modules that are gone by Python 3.13, and those of Blender.
MODULES = {
    "bgl", "imp", "distutils", "asyncore", "asynchat", "smtpd", "cgi", "cgitb", "crypt", "imghdr",
    "pipes", "telnetlib", "uu", "xdrlib", "pkg_resources",
}  # fmt: skip


def troubles(name, text):
    """What a source says that some Blender does not understand."""
    found = []
    tree = ast.parse(text, name)
    functions = [n for n in ast.walk(tree) if isinstance(n, (ast.FunctionDef, ast.Lambda))]
    asked = {id(n): _asked(f) for f in functions for n in ast.walk(f)}
    for node in ast.walk(tree):
        known = asked.get(id(node), set())
        if isinstance(node, ast.Attribute):
            if node.attr in GONE and GONE[node.attr] not in known:
                found.append(f"{name}:{node.lineno}: .{node.attr}")
            of = getattr(node.value, "attr", getattr(node.value, "id", ""))
            if node.attr in OF_TREES and of in {"tree", "node_tree", "node_group"}:
                if "interface" not in known:
                    found.append(f"{name}:{node.lineno}: .{of}.{node.attr}")
        elif isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Constant):
            if getattr(node.value, "attr", "") == "inputs" and node.slice.value in SOCKETS:
                found.append(f"{name}:{node.lineno}: socket {node.slice.value}")
        elif isinstance(node, ast.Constant) and node.value in WORDS:
            found.append(f"{name}:{node.lineno}: {node.value}")
        elif isinstance(node, (ast.Import, ast.ImportFrom)):
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else [node.module]
            found += [f"{name}:{node.lineno}: {m}" for m in names if (m or "").split(".")[0] in MODULES]
        elif isinstance(node, ast.Call) and ast.unparse(node.func).startswith("bpy.ops."):
            # A context as a dict went in 4.0: temp_override() is in all.
            if any(not isinstance(a, ast.Constant) for a in node.args):
                found.append(f"{name}:{node.lineno}: an operator's context by argument")
    return found


def _asked(function):
    """What a function asks hasattr() or getattr() for."""
    return {
        call.args[1].value
        for call in ast.walk(function)
        if isinstance(call, ast.Call)
        and getattr(call.func, "id", "") in {"hasattr", "getattr"}
        and isinstance(call.args[1], ast.Constant)
    }


class Names(unittest.TestCase):
    def test_the_add_on_uses_no_name_that_some_blender_does_not_have(self):
        with zipfile.ZipFile(ZIP) as archive:
            sources = {n: archive.read(n).decode() for n in archive.namelist() if n.endswith(".py")}
        self.assertGreater(len(sources), 20)
        self.assertEqual([t for n, s in sources.items() for t in troubles(n, s)], [])

    def test_such_names_are_found(self):
        for text in (
            "mesh.use_auto_smooth = True",
            "def f(m):\n    hasattr(m, 'corner_normals')\n\ndef g(m):\n    m.calc_normals_split()",
            "shader.inputs['Specular'].default_value = 1",
            "group = tree.inputs.new('NodeSocketFloat', 'a')",
            "bpy.ops.object.delete({'active_object': thing})",
            "bpy.ops.object.delete(override)",
            "from bgl import glEnable",
            "tree.nodes.new('ShaderNodeMixRGB')",
            "for curve in action.fcurves: pass",
        ):
            self.assertEqual(len(troubles("some.py", text)), 1, text)

    def test_and_those_that_are_asked_for_are_not(self):
        for text in (
            "def f(m):\n    if hasattr(m, 'use_auto_smooth'):\n        m.auto_smooth_angle = 1",
            "def f(m):\n    if hasattr(m, 'corner_normals'):\n        return\n    m.calc_normals_split()",
            "shader.inputs['Specular IOR Level'].default_value = 1",
            "group.inputs['Mask']",
            "bpy.ops.craze.crack('INVOKE_DEFAULT', True, seed=seed)",
        ):
            self.assertEqual(troubles("some.py", text), [], text)


unittest.main(argv=sys.argv[:1], verbosity=2)
