"""Pictures and masks of a folder. Layouts that are understood:

- ours: images/NAME.* and masks/NAME.png, or coverage/NAME.png (0 … 255, half and more is crack);
- DeepCrack: train_img/ and train_lab/, test_img/ and test_lab/ (or images and masks in those);
- CFD: cfd_image/NAME.jpg and seg_gt/NAME.png, or groundTruth/NAME.mat (needs SciPy).

Needs NumPy, and Pillow to read and write pictures.
"""

from pathlib import Path

import numpy as np

PICTURES = (".jpg", ".jpeg", ".png", ".bmp", ".tif", ".tiff")
MASKS = (".png", ".bmp", ".tif", ".tiff", ".jpg", ".mat")
LAYOUTS = [
    ("images", "masks"),
    ("images", "coverage"),
    ("{part}_img", "{part}_lab"),
    ("{part}/images", "{part}/masks"),
    ("cfd_image", "seg_gt"),
    ("cfd_image", "groundTruth"),
    ("image", "groundTruth"),
]
QUALITY = 92  # of the JPEG that all arms' pictures are packed as


def pairs(folder, part="test", split=False):
    """(picture, mask) paths of a data set, in the order of their names. `part` is train or test, for
    layouts that have them; with `split`, of others every fourth pair is for the test. ValueError
    where the layout is none of these or a picture has no mask."""
    for pictures, masks in LAYOUTS:
        at, of = Path(folder, pictures.format(part=part)), Path(folder, masks.format(part=part))
        if not at.is_dir() or not of.is_dir():
            continue
        labels = {p.stem: p for p in sorted(of.iterdir()) if p.suffix.lower() in MASKS}
        found = [p for p in sorted(at.iterdir()) if p.suffix.lower() in PICTURES]
        alone = [p.name for p in found if p.stem not in labels]
        if alone:
            raise ValueError(f"{of}: no mask for {', '.join(alone[:3])}")
        whole = [(p, labels[p.stem]) for p in found]
        if not split or "{part}" in pictures:
            return whole
        return [pair for k, pair in enumerate(whole) if (k % 4 == 3) == (part == "test")]
    known = "; ".join(f"{a} + {b}".format(part=part) for a, b in LAYOUTS)
    raise ValueError(f"{folder}: none of the layouts that are known: {known}")


def read_picture(path):
    """(height, width, 3) uint8."""
    from PIL import Image

    return np.array(Image.open(path).convert("RGB"))


def read_mask(path):
    """(height, width) bool."""
    if path.suffix == ".mat":
        from scipy.io import loadmat

        return loadmat(path)["groundTruth"]["Segmentation"][0, 0] > 1  # 1: no crack
    from PIL import Image

    return np.array(Image.open(path).convert("L")) >= 128


def write_pair(folder, name, picture, mask):
    """A picture as JPEG, its mask as PNG, in our layout."""
    from PIL import Image

    for kind in ("images", "masks"):
        (folder / kind).mkdir(parents=True, exist_ok=True)
    Image.fromarray(picture).save(folder / "images" / f"{name}.jpg", quality=QUALITY)
    Image.fromarray(np.uint8(255) * mask, "L").save(folder / "masks" / f"{name}.png", optimize=True)


def tiles(picture, mask, size):
    """Squares of a picture, as many as cover it with the least overlap; smaller pictures are
    continued by their mirror image."""
    short = [max(0, size - n) for n in mask.shape]
    picture = np.pad(picture, ((0, short[0]), (0, short[1]), (0, 0)), mode="symmetric")
    mask = np.pad(mask, ((0, short[0]), (0, short[1])), mode="symmetric")
    for top in _starts(mask.shape[0], size):
        for left in _starts(mask.shape[1], size):
            at = np.s_[top : top + size, left : left + size]
            yield picture[at], mask[at]


def _starts(length, size):
    count = -(-length // size)
    return [round(k * (length - size) / max(1, count - 1)) for k in range(count)]


def load(folder, part="test", size=256, most=None, split=False):
    """Squares of the first `most` pictures of a set (see `pairs`): (n, size, size, 3) uint8, (n, size,
    size) bool."""
    squares = [
        square
        for picture, mask in pairs(folder, part, split)[:most]
        for square in tiles(read_picture(picture), read_mask(mask), size)
    ]
    if not squares:
        raise ValueError(f"{folder}: no pictures")
    return np.stack([p for p, _ in squares]), np.stack([m for _, m in squares])
