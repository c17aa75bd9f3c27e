"""The reference of the Python package, from its stubs (signatures and types) and its docstrings."""

import ast
import re
import textwrap


def reference(package):
    """The page, in reStructuredText. Whatever the package exports has to have both, or it is an error."""
    stubs = definitions(ast.parse((package / "__init__.pyi").read_text()))
    sources = {}
    for path in sorted(package.glob("_*.py")):
        sources |= definitions(ast.parse(path.read_text()))
    init = ast.parse((package / "__init__.py").read_text())
    names = [name for name in exported(init) if not name.startswith("_")]
    text = "The Python package\n==================\n\n.. py:module:: hodt\n\n"
    text += docstring(ast.get_docstring(init)) + "\n\n"
    for title, kind in (("Functions", ast.FunctionDef), ("Classes", ast.ClassDef)):
        text += f"{title}\n{'-' * len(title)}\n\n"
        for name in names:
            if isinstance(sources[name], kind):
                text += entry(name, stubs[name], sources[name])
    return text


def definitions(tree):
    """Functions and classes by their names."""
    return {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef | ast.ClassDef)}


def exported(tree):
    for node in tree.body:
        if isinstance(node, ast.Assign) and node.targets[0].id == "__all__":
            return ast.literal_eval(node.value)
    raise ValueError("no __all__")


def entry(name, stub, source):
    return (
        function("function", name, stub, source)
        if isinstance(stub, ast.FunctionDef)
        else class_(name, stub, source)
    )


# What the stubs call their types.
TYPES = {
    "_Doubles": "NDArray[float64]",
    "_Integers": "NDArray[int32]",
    "_Path": "str | PathLike",
    "_Progress": "Callable[[str, float | None], object]",
    "_Method": "str",
}


def readable(text):
    for name, type_ in TYPES.items():
        text = text.replace(name, type_)
    return text


def signature(stub, is_method):
    arguments = ast.unparse(stub.args)
    if is_method:
        arguments = re.sub(r"^(self|cls)(, )?", "", arguments)
    returned = f" -> {ast.unparse(stub.returns)}" if stub.returns else ""
    return readable(f"({arguments}){returned}")


def function(kind, name, stub, source):
    decorators = [ast.unparse(decorator) for decorator in stub.decorator_list]
    text = ast.get_docstring(source) or ""
    if "property" in decorators:
        returned = signature(stub, True).partition(" -> ")[2]
        return f".. py:property:: {name}\n   :type: {returned}\n\n{indented(docstring(text))}\n\n"
    option = "   :classmethod:\n" if "classmethod" in decorators else ""
    return (
        f".. py:{kind}:: {name}{signature(stub, kind == 'method')}\n{option}\n{indented(docstring(text))}\n\n"
    )


def class_(name, stub, source):
    members, documented = definitions(stub), definitions(source)
    bases = ", ".join(ast.unparse(base) for base in stub.bases)
    heading = name + (
        signature(members["__init__"], True).partition(" -> ")[0] if "__init__" in members else ""
    )
    text = docstring(ast.get_docstring(source) or "")
    if bases:
        text = f"Bases: {bases}.\n\n" + text
    text += "\n\n"
    for node in stub.body:
        if isinstance(node, ast.AnnAssign) and not node.target.id.startswith("_"):
            text += (
                f".. py:attribute:: {node.target.id}\n   :type: {readable(ast.unparse(node.annotation))}\n\n"
            )
    for method, node in members.items():
        if not method.startswith("_") and method in documented:
            text += function("method", method, node, documented[method])
    return f".. py:class:: {heading}\n\n{indented(text)}\n\n"


def indented(text):
    return textwrap.indent(text, "   ")


def docstring(text):
    """Paragraphs; code that is indented; and what a line "k: ..." says of a parameter."""
    text = re.sub(r"`[^`]*`", lambda match: " ".join(match.group(0).split()), text)
    out, in_code, in_parameter = [], False, False
    for line in text.splitlines():
        parameter = re.match(r"([a-z_]+(?:, [a-z_]+)*): (.*)", line)
        is_indented = line.startswith("    ")
        if parameter:
            if not in_parameter:
                out.append("")
            names = parameter.group(1).replace(", ", ",")  # with a space it would be a type and a name
            out.append(f":param {names}: {escaped(parameter.group(2))}")
        elif is_indented and not in_parameter:
            if not in_code:
                out += ["", "::", ""]
            out.append(line)
        else:
            if in_code or (in_parameter and line and not is_indented):
                out.append("")
            out.append(("    " if is_indented else "") + escaped(line.strip()))
        in_code = is_indented and not in_parameter and not parameter
        in_parameter = bool(parameter) or (in_parameter and is_indented)
    return "\n".join(out)


def escaped(text):
    """Words in backquotes are code; nothing else is markup."""
    parts = re.split(r"`([^`]*)`", text)
    parts[::2] = [re.sub(r"([*|\\]|_(?=\W|$))", r"\\\1", part) for part in parts[::2]]
    parts[1::2] = [f"``{part}``" for part in parts[1::2]]
    return "".join(parts)
