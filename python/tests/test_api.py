"""The public names: documented, and typed by a stub that says the same."""

import ast
import inspect
import pathlib

import hodt


def test_everything_is_documented():
    for name in hodt.__all__:
        thing = getattr(hodt, name)
        if name != "__version__":
            assert inspect.getdoc(thing), name
        if inspect.isclass(thing):
            for attribute, value in vars(thing).items():
                if not attribute.startswith("_") and (callable(value) or isinstance(value, property)):
                    assert inspect.getdoc(value), f"{name}.{attribute}"


def stub():
    path = pathlib.Path(hodt.__file__).with_name("__init__.pyi")
    return {node.name: node for node in ast.parse(path.read_text()).body
            if isinstance(node, (ast.FunctionDef, ast.ClassDef))}


def parameters(node):
    a = node.args
    return [arg.arg for arg in (*a.posonlyargs, *a.args, *a.kwonlyargs)], len(a.args)


def check(node, function, where):
    names = list(inspect.signature(function).parameters.values())
    mine = [p.name for p in names if p.kind not in (p.VAR_KEYWORD, p.VAR_POSITIONAL)]
    stubbed, positional = parameters(node)
    assert stubbed == mine, where
    assert positional == sum(p.kind == p.POSITIONAL_OR_KEYWORD for p in names), where


def test_the_stub_has_all_names_with_their_parameters():
    stubs = stub()
    assert set(stubs) == set(hodt.__all__) - {"__version__"}
    for name, node in stubs.items():
        thing = getattr(hodt, name)
        if isinstance(node, ast.FunctionDef):
            check(node, thing, name)
            continue
        stubbed = {n.name for n in node.body if isinstance(n, ast.FunctionDef)}
        for method in node.body:
            if isinstance(method, ast.FunctionDef) and not method.decorator_list:
                check(method, getattr(thing, method.name), f"{name}.{method.name}")
        public = {a for a, value in vars(thing).items()
                  if not a.startswith("_") and callable(value)}
        assert public <= stubbed, name
    assert pathlib.Path(hodt.__file__).with_name("py.typed").exists()


def test_errors_are_a_small_hierarchy():
    assert issubclass(hodt.Error, Exception)
    for error, other in ((hodt.InputError, ValueError), (hodt.ParameterError, ValueError),
                         (hodt.FileError, OSError)):
        assert issubclass(error, hodt.Error) and issubclass(error, other)


def test_the_version_is_the_command_s(command):
    import subprocess
    told = subprocess.run([command, "--version"], capture_output=True, text=True, check=True)
    assert hodt.__version__ in told.stdout
