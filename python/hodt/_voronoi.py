"""Order-m Voronoi diagrams."""


class Voronoi:
    """The regions of the plane by which m points are nearest, clipped to a box.

    members: (c, m) int32, of each cell its m nearest points, by rows, ascending.
    Iterating gives (members, polygon) of each cell, where polygon is float64 (p, 2),
    counter-clockwise and not closed, and has no corner if the cell has no area in the box.
    """

    def __init__(self, members, corners, first):
        self.members, self._corners, self._first = members, corners, first

    def __len__(self):
        return len(self.members)

    def polygon(self, cell):
        """The corners of a cell, float64 (p, 2)."""
        cell = range(len(self))[cell]
        return self._corners[self._first[cell]:self._first[cell + 1]]

    def __iter__(self):
        return ((self.members[i], self.polygon(i)) for i in range(len(self)))
