"""Structural similarity of pictures (Wang, Bovik, Sheikh and Simoncelli 2004), means over blocks of 8 x 8 pixels."""

import numpy
from PySide import QtGui


def grey(path):
    """A picture as brightness in [0, 1] at half its size, (height, width)."""
    image = QtGui.QImage(str(path)).convertToFormat(QtGui.QImage.Format_Grayscale8)
    if image.isNull():
        raise ValueError(f"{path} is no picture")
    data = numpy.frombuffer(image.constBits(), numpy.uint8, image.bytesPerLine() * image.height())
    whole = data.reshape(image.height(), image.bytesPerLine())[:, : image.width()] / 255.0
    height, width = (n // 2 * 2 for n in whole.shape)
    # Half the size: single strokes may lie elsewhere, tones and shapes not.
    return whole[:height, :width].reshape(height // 2, 2, width // 2, 2).mean(axis=(1, 3))


def blocks(picture, size=8):
    """The squares of a picture, one a row."""
    height, width = (n // size * size for n in picture.shape)
    cut = picture[:height, :width].reshape(height // size, size, width // size, size)
    return cut.transpose(0, 2, 1, 3).reshape(-1, size * size)


def similarity(a, b):
    """1 = the same; pictures of other sizes are not similar (0)."""
    first, second = grey(a), grey(b)
    if first.shape != second.shape:
        return 0.0
    x, y = blocks(first), blocks(second)
    mx, my = x.mean(1), y.mean(1)
    vx, vy, cov = x.var(1), y.var(1), ((x - mx[:, None]) * (y - my[:, None])).mean(1)
    c1, c2 = 0.01**2, 0.03**2
    return float((((2 * mx * my + c1) * (2 * cov + c2)) / ((mx**2 + my**2 + c1) * (vx + vy + c2))).mean())
