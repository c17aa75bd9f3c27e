"""Packages that only some functions need."""

import importlib

def optional(module, extra):
    """The module, or an ImportError that says how to get it."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        package = module.split(".")[0]
        raise ImportError(
            f"this needs {package}, which is not installed: pip install {package} "
            f"(or hodt with it: hodt[{extra}])"
        ) from error
