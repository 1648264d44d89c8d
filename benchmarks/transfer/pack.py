"""One folder with all that run.py reads: the arms and, as real/train and real/test, the renders, as
JPEG like the others.

    python3 pack.py arms proxy data
"""

import argparse
import shutil
from pathlib import Path

from data import pairs, read_mask, read_picture, write_pair


def main():
    parse = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parse.add_argument("arms", type=Path)
    parse.add_argument("proxy", type=Path)
    parse.add_argument("data", type=Path)
    given = parse.parse_args()
    for arm in given.arms.iterdir():
        shutil.copytree(arm, given.data / arm.name)
    for part in ("train", "test"):
        for picture, mask in pairs(given.proxy / part):
            to = given.data / "real" / part
            write_pair(to, picture.stem, read_picture(picture), read_mask(mask))


if __name__ == "__main__":
    main()
