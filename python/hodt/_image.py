"""A small shaded picture of a TIN, without any package for drawing."""

import base64
import struct
import zlib

import numpy as np

# Heights from low to high: greens, ochres, and stone.
TINTS = np.array([[106, 153, 96], [160, 186, 112], [222, 211, 148], [196, 160, 110], [176, 160, 150],
                  [240, 238, 236]], float)


def relief(tin, width=280):
    """An array (h, w, 3) of uint8: the surface tinted by height and lit from the north-west. Without
    heights the triangles, light where their smallest angle is large."""
    (left, low), (right, high) = tin.xy.min(axis=0), tin.xy.max(axis=0)
    step = max(right - left, high - low) / width
    columns, rows = (max(1, int(size / step)) for size in (right - left, high - low))
    x = left + (np.arange(columns) + 0.5) * step
    y = high - (np.arange(rows) + 0.5) * step
    triangle = tin.find_triangle(np.stack(np.meshgrid(x, y), axis=-1))
    colours = _by_height(tin, triangle, x, y) if tin.has_heights else _by_shape(tin)[triangle]
    colours[triangle < 0] = 255
    return colours.astype(np.uint8)


def _by_height(tin, triangle, x, y):
    share = (tin.z - tin.z.min()) / (np.ptp(tin.z) or 1)
    corners = tin.triangles[triangle]
    heights = share[corners].mean(axis=-1) * (len(TINTS) - 1)
    below = np.minimum(heights.astype(int), len(TINTS) - 2)
    part = (heights - below)[..., None]
    tint = TINTS[below] * (1 - part) + TINTS[below + 1] * part
    slopes = np.nan_to_num(tin.gradient[triangle])
    usual = np.median(np.hypot(*np.nan_to_num(tin.gradient).T)) or 1
    gx, gy = np.moveaxis(slopes / usual, -1, 0)
    light = (1.4 + gx - gy) / np.sqrt(1 + gx**2 + gy**2) / 2
    return tint * np.clip(0.55 + 0.45 * light, 0.35, 1.05)[..., None].clip(max=1)


def _by_shape(tin):
    corners = tin.xy[tin.triangles]
    sides = [corners[:, (i + 1) % 3] - corners[:, i] for i in range(3)]
    lengths = np.sort([np.hypot(*side.T) for side in sides], axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        sine = 2 * tin.area() / (lengths[1] * lengths[2])  # of the angle across the shortest side
    share = np.degrees(np.arcsin(np.clip(np.nan_to_num(sine), 0, 1)))[:, None] / 60
    shade = np.linspace(0, 0.12, 7)[np.arange(len(corners)) % 7][:, None]  # tells neighbours apart
    return 255 * (np.array([[0.25, 0.4, 0.6]]) * (1 - share) + share * 0.95 - shade * 0.5).clip(0, 1)


def png(pixels):
    """An array (h, w, 3) of uint8 as the bytes of a PNG file."""
    height, width, _ = pixels.shape

    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    lines = np.concatenate([np.zeros((height, 1), np.uint8), pixels.reshape(height, -1)], axis=1)
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
            + chunk(b"IDAT", zlib.compress(lines.tobytes(), 9)) + chunk(b"IEND", b""))


def image_tag(tin):
    """The picture as HTML."""
    data = base64.b64encode(png(relief(tin))).decode()
    return f'<img alt="the triangulation from above" src="data:image/png;base64,{data}">'
