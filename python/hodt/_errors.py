"""What hodt raises on purpose. Every message says what is wrong, where, and what to do about it."""


class Error(Exception):
    """The root of all errors that hodt raises on purpose."""


class InputError(Error, ValueError):
    """Input that cannot be used: NaN, too few points, all points on a line, a mesh that is none."""


class ParameterError(Error, ValueError):
    """An argument out of its range, of the wrong shape, or a name that there is none of."""


class FileError(Error, OSError):
    """The operating system refused: a file that is not there, a full disk. errno and filename say
    what and where, if it told; a missing file is a FileNotFoundError, too, one that may not be read
    or written a PermissionError, and a directory an IsADirectoryError."""

    def __str__(self):
        return self.strerror or super().__str__()  # names the file already


class MissingFileError(FileError, FileNotFoundError):
    """There is no such file."""


class ForbiddenFileError(FileError, PermissionError):
    """The file may not be read or written."""


class DirectoryError(FileError, IsADirectoryError):
    """A directory is no file."""


def file_error(text, number, filename):
    """What the system said by its number, errno, of a file."""
    kinds = {FileNotFoundError: MissingFileError, PermissionError: ForbiddenFileError,
             IsADirectoryError: DirectoryError}
    return kinds.get(type(OSError(number, text)), FileError)(number, text, filename)
