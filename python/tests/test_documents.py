"""What documents show is run: the Python page, the README, the notebooks."""

import ast
import json
import re

import pytest
from conftest import ROOT

import hodt

NOTEBOOKS = sorted((ROOT / "python" / "notebooks").glob("*.ipynb"))


def blocks(path):
    return re.findall(r"^```python\n(.*?)^```", path.read_text(), re.MULTILINE | re.DOTALL)


def test_the_page_about_python(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    code = blocks(ROOT / "docs" / "python.md")
    assert len(code) >= 6
    scope = {}
    for block in code:
        exec(compile(block, "python.md", "exec"), scope)
    assert (tmp_path / "terrain.ply").exists()


def test_the_readme(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    points = hodt.sample("jacksboro", 500)
    (tmp_path / "points.csv").write_text("x,y,z\n" + "".join(f"{x},{y},{z}\n" for x, y, z in points))
    code = blocks(ROOT / "README.md")
    assert code
    for block in code:
        exec(compile(block, "README.md", "exec"), {})


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebooks(path, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    scope, shown = {}, 0
    for cell in json.loads(path.read_text())["cells"]:
        if cell["cell_type"] != "code":
            continue
        assert cell["outputs"] == [], "outputs are not kept in the repository"
        tree = ast.parse("".join(cell["source"]))
        last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, path.name, "exec"), scope)
        value = last and eval(compile(ast.Expression(last.value), path.name, "eval"), scope)
        if isinstance(value, hodt.Result):
            shown += 1
            assert "<table>" in value._repr_html_()
    assert shown >= 2


def test_there_are_two_notebooks():
    assert len(NOTEBOOKS) == 2
