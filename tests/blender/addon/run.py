"""blender --python run.py -- TEST.py: the tests of a file, inside Blender. Tests that need a window
are generators, run a step at a time by a timer: what they yield is how long they wait, in seconds.
"""

import importlib
import os
import sys
import unittest
from pathlib import Path

import bpy

sys.dont_write_bytecode = True
file = Path(sys.argv[sys.argv.index("--") + 1])
sys.path[:0] = [str(file.parent), *os.environ["PYTHONPATH"].split(os.pathsep)]

import craze_blender  # noqa: E402

craze_blender.register()
module = importlib.import_module(file.stem)
if bpy.app.background:
    result = unittest.TextTestRunner(verbosity=2, stream=sys.stdout).run(
        unittest.defaultTestLoader.loadTestsFromModule(module)
    )
    craze_blender.unregister()
    sys.stdout.flush()
    if not result.wasSuccessful() or result.testsRun == 0:
        sys.exit(3)
else:
    import window

    window.run(module)
