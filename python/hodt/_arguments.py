"""Arguments, looked at: whatever is not clear is refused here, and never guessed at."""

import math
import operator
import os

import numpy as np

from ._errors import InputError, ParameterError

LARGEST = 2**32 - 2  # an order of which nothing is more


def as_points(points, name="points"):
    """An array of float64, (n, 2) or (n, 3), that the extension can read in place."""
    array = _as_array(points, name)
    if array.ndim == 1 and array.size == 0:
        array = array.reshape(0, 2)
    if array.ndim != 2 or array.shape[1] not in (2, 3):
        raise ParameterError(
            f"{name}: an array of shape (n, 2) or (n, 3) is needed, not {array.shape}"
        )
    return _as_doubles(array, name)


def as_places(places, name="places"):
    """An array of float64, (n, 2), contiguous and finite."""
    array = as_points(places, name)
    if array.shape[1] != 2:
        raise ParameterError(f"{name}: an array of shape (n, 2) is needed, not {array.shape}")
    return finite(np.ascontiguousarray(array), name)


def as_grid_of_places(places, name):
    """(flat, shape): an array of float64, (n, 2), of places (..., 2), and the shape without the 2."""
    array = _as_array(places, name)
    if array.shape[-1:] != (2,):
        raise ParameterError(f"{name}: an array of shape (..., 2) is needed, not {array.shape}")
    return np.ascontiguousarray(as_points(array.reshape(-1, 2), name)), array.shape[:-1]


def finite(array, name):
    if not np.isfinite(array).all():
        row = int(np.argmin(np.isfinite(array).reshape(len(array), -1).all(axis=1)))
        raise InputError(f"{name}: row {row}, counted from 0, has a number that is not finite")
    return array


def frozen(array):
    """The array, as nobody can change it: whoever has it remembers what it knows of it."""
    if array.flags.writeable:
        array.flags.writeable = False
    return array


def _as_array(values, name):
    """As numpy has it, unless that hides something."""
    _refuse_disordered_columns(values, name)
    if np.ma.is_masked(values):
        raise InputError(f"{name}: some values are masked; leave their rows out")
    try:
        return np.asarray(values)
    except (TypeError, ValueError) as error:
        raise ParameterError(f"{name}: an array is needed, and this makes none: {error}") from error


def _refuse_disordered_columns(values, name):
    columns = getattr(values, "columns", None)  # of a data frame
    if columns is None:
        return
    names = [str(column).strip().lower() for column in columns]
    if sorted(names) in (["x", "y"], ["x", "y", "z"]) and names != sorted(names):
        raise ParameterError(
            f"{name}: the columns are {', '.join(names)}; hodt takes x, y, z by their order"
        )


def _as_doubles(array, name):
    if array.dtype.kind not in "fiu":
        raise ParameterError(
            f"{name}: numbers are needed, not {array.dtype}; convert them to float64"
        )
    doubles = array.astype(np.float64, copy=False)
    # Integers of 64 bits and long doubles can hold what doubles cannot.
    if array.dtype.itemsize > 8 or (array.dtype.kind in "iu" and array.dtype.itemsize == 8):
        if array.dtype.kind == "f":
            lost = (doubles.astype(array.dtype) != array) & ~np.isnan(doubles)
        else:
            beyond = doubles >= 2.0 ** (63 if array.dtype.kind == "i" else 64)
            lost = beyond | (np.where(beyond, 0, doubles).astype(array.dtype) != array)
        if lost.any():
            raise InputError(
                f"{name}: row {int(np.argmax(lost.any(axis=1)))}, counted from 0, has a number "
                "that float64 cannot hold; subtract an offset"
            )
    if not doubles.flags.aligned or any(step % 8 for step in doubles.strides):
        doubles = doubles.copy()
    return doubles


def as_rows(rows, columns, count, name):
    """An array of int32, (m, columns), of numbers in [0, count)."""
    array = _as_array(rows, name)
    if array.size == 0:
        array = np.empty((0, columns), np.int32)
    if array.ndim != 2 or array.shape[1] != columns or array.dtype.kind not in "iu":
        raise ParameterError(
            f"{name}: an array of integers of shape (m, {columns}) is needed, not {array.dtype} of "
            f"shape {array.shape}"
        )
    if array.size and (array.min() < 0 or array.max() >= count):
        raise ParameterError(
            f"{name}: numbers of {count} rows, from 0, are needed, not {array.min()} to {array.max()}"
        )
    return np.ascontiguousarray(array, dtype=np.int32)


def is_infinite(number):
    try:
        return bool(number == math.inf)
    except ValueError:  # an array
        return False


def as_order(k, name="k"):
    """A whole number that is not negative; math.inf is without limit."""
    if is_infinite(k):
        return LARGEST
    if isinstance(k, (bool, np.bool_)):
        raise ParameterError(f"{name} is to be a whole number, not {k!r}")
    try:
        order = operator.index(k)
    except TypeError:
        raise ParameterError(f"{name} is to be a whole number, not {k!r}") from None
    if order < 0:
        raise ParameterError(f"{name} is to be 0 or more, not {order}")
    return min(order, LARGEST)


def as_threads(threads):
    """0 for None: all cores."""
    if threads is None:
        return 0
    count = as_order(threads, "threads")
    if not 1 <= count <= 10_000:
        raise ParameterError(f"threads is to be from 1 to 10000, or None for all cores, not {threads}")
    return count


def as_amount(value, name):
    """A finite number that is not negative."""
    try:
        amount = float(value)
    except (TypeError, ValueError):
        raise ParameterError(f"{name} is to be a number, not {value!r}") from None
    if not 0 <= amount < math.inf:
        raise ParameterError(f"{name} is to be 0 or more, and finite, not {value!r}")
    return amount


def as_list(things, name):
    try:
        return list(things)
    except TypeError:
        raise ParameterError(f"{name}: a list is needed, not {things!r}") from None


def as_name(text, name):
    """A text that the extension can take."""
    if not isinstance(text, str):
        raise ParameterError(f"{name} is to be a name, not {text!r}")
    if "\0" in text or text.encode(errors="ignore").decode() != text:
        raise ParameterError(f"{name}: there are names of Unicode characters only, not {text!r}")
    return text


def as_path(path):
    """Of any bytes that a name of a file can have: os.fsdecode gives them as a text."""
    try:
        name = os.fspath(path)
        os.fsencode(name)
    except (TypeError, UnicodeEncodeError):
        raise ParameterError(f"a path is needed, not {path!r}") from None
    if (b"\0" if isinstance(name, bytes) else "\0") in name:
        raise ParameterError(f"a path has no null byte, but {path!r} has")
    return name


def as_crs(crs):
    """A text in one line, or None."""
    if crs is not None and as_name(crs, "crs").splitlines() != [crs]:
        raise ParameterError(f"crs is to be a text in one line, like EPSG:25832, or None, not {crs!r}")
    return crs


def as_progress(progress):
    if progress is not None and not callable(progress):
        raise ParameterError(f"progress is to be a function or None, not {progress!r}")
    return progress
