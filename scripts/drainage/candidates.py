"""Measures across edges that hodt does not have, to be tried before they are built in: names for the
experiment that begin with "own:"."""

import numpy as np

import hodt


def area(a, b, c):
    """Of triangles with corners (m, 3), counter-clockwise. A little where rounding leaves none."""
    u, v = b - a, c - a
    twice = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    return np.where(twice == 0, 1e-9, twice) / 2


def gradient(a, b, c):
    """Of the planes through them."""
    u, v = b - a, c - a
    return (np.column_stack([u[:, 2] * v[:, 1] - v[:, 2] * u[:, 1], v[:, 2] * u[:, 0] - u[:, 2] * v[:, 0]])
            / (2 * area(a, b, c)[:, None]))


def length(a, b):
    return np.hypot(*(b - a)[:, :2].T)


def jump(a, b, left, right):
    """How much the gradient differs across the edge."""
    return np.hypot(*(gradient(a, b, left) - gradient(b, a, right)).T)


def angle(a, b, left, right):
    """Between the normals, in radians."""
    f, g = gradient(a, b, left), gradient(b, a, right)
    cross = f[:, 0] * g[:, 1] - f[:, 1] * g[:, 0]
    return np.arctan2(np.hypot(np.hypot(*(f - g).T), cross), (f * g).sum(axis=1) + 1)


def squared_bend(a, b, left, right):
    return angle(a, b, left, right) ** 2


def root_bend(a, b, left, right):
    return angle(a, b, left, right) ** 0.5


def plate_energy(a, b, left, right):
    """Of a thin plate that bends along the edge only: squared jump, spread over both triangles."""
    return (jump(a, b, left, right) * length(a, b)) ** 2 / (area(a, b, left) + area(b, a, right))


def total_jump(a, b, left, right):
    """The total variation of the gradient."""
    return jump(a, b, left, right) * length(a, b)


def relative_bend(a, b, left, right):
    """The jump against the slope of both sides."""
    slope = np.hypot(*gradient(a, b, left).T) + np.hypot(*gradient(b, a, right).T)
    both = jump(a, b, left, right)
    return np.divide(both, slope, out=np.zeros_like(both), where=slope > 0)


CANDIDATES = {function.__name__: function for function in
              (squared_bend, root_bend, plate_energy, total_jump, relative_bend)}


def objective_of(name):
    """What hodt.triangulate understands: its own names, and ours."""
    if not name.startswith("own:"):
        return name
    return hodt.Measure(CANDIDATES[name.removeprefix("own:")], "sum", "min", across_edges=True, needs_heights=True)
