"""What hodt raises on purpose. Every message says what is wrong, where, and what to do about it."""


class Error(Exception):
    """The root of all errors that hodt raises on purpose."""


class InputError(Error, ValueError):
    """Input that cannot be used: NaN, too few points, all points on a line, a mesh that is none."""


class ParameterError(Error, ValueError):
    """An argument out of its range, of the wrong shape, or a name that there is none of."""


class FileError(Error, OSError):
    """The operating system refused: a file that is not there, a full disk."""
