"""What was measured, in a CSV file: a row for each TIN, added as soon as it is known, so that an
experiment goes on where it was left."""

import csv

KEY = ("terrain", "kind", "share", "seed", "objective", "k")
COLUMNS = KEY + (
    "points", "seconds", "minima", "rmse", "largest_error", "slope_error", "fill_volume", "fill_depth", "fill_cells",
    "f1_50_1", "f1_50_2", "f1_200_1", "f1_200_2", "basins")


def number(text):
    return float(text) if text else None


def read(path):
    """Key -> row; numbers but for names."""
    if not path.exists():
        return {}
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    names = ("terrain", "kind", "share", "objective")
    rows = [{name: text if name in names else number(text) for name, text in row.items()} for row in rows]
    return {key_of(row): row for row in rows}


def key_of(row):
    return tuple(str(row[name]) if name not in ("seed", "k") else int(row[name]) for name in KEY)


class Records:
    """Rows already there, and room for more."""

    def __init__(self, path):
        self.path, self.rows = path, read(path)

    def __contains__(self, row):
        return key_of(row) in self.rows

    def add(self, row):
        is_new = not self.path.exists()
        with open(self.path, "a", newline="") as file:
            writer = csv.DictWriter(file, COLUMNS, restval="")
            if is_new:
                writer.writeheader()
            writer.writerow(row)
        self.rows[key_of(row)] = row
