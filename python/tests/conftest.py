import os
import pathlib
import shutil

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture
def command():
    """The command `hodt`: of the build, or of the environment."""
    path = os.environ.get("HODT_COMMAND") or shutil.which("hodt")
    if path is None:
        pytest.skip("no command hodt here")
    return path


@pytest.fixture
def rng():
    return np.random.default_rng(7)
