"""run.py FILE: runs the tests of a file; 77, which ctest takes for skipped, without NumPy."""

import importlib.util
import sys
import unittest
from pathlib import Path


def main() -> None:
    if importlib.util.find_spec("numpy") is None:
        print("skipped: no NumPy (apt: python3-numpy)")
        sys.exit(77)
    sys.dont_write_bytecode = True
    file = Path(sys.argv[1]).resolve()
    sys.path.insert(0, str(file.parent))
    unittest.main(module=file.stem, argv=[str(file)], verbosity=2)


if __name__ == "__main__":  # the processes that dask starts import this file too
    main()
