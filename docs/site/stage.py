#!/usr/bin/env python3
"""Puts together what the site is made of: the pages of docs/, the README and its neighbours, examples,
notebooks, and the references that were generated. Links between files of the repository become links
between pages; a link to a file that is no page becomes its name; a link to nothing is an error.

    stage.py COMMAND_REFERENCE FOLDER"""

import html
import json
import os
import pathlib
import re
import shutil
import sys

import python_reference

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMAND, SITE = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])

# What the pages in the sidebar are, in order; a page of docs/ that is not here comes last in its part.
GUIDES = ["tutorial", "how-to", "which-objective", "python", "points", "lines", "formats", "crs"]
BACKGROUND = ["definitions", "drainage", "experiments", "benchmarks"]
REFERENCE = ["command", "python-reference", "cpp"]
PROJECT = ["ARCHITECTURE", "CONTRIBUTING", "CHANGELOG"]

PAGES = {"README.md": "index.md", "examples": "examples.md", "python/notebooks": "notebooks.md"}
PAGES |= {f"{name}.md": f"{name.lower()}.md" for name in PROJECT}
PAGES |= {f"docs/{folder}": f"{folder}/index.md" for folder in ("design", "decisions")}
PAGES |= {
    str(path.relative_to(ROOT)): str(path.relative_to(ROOT / "docs"))
    for path in (ROOT / "docs").rglob("*.md")
}


def link(page, text, target):
    """A link of a page of the repository as one of the site."""
    path, _, anchor = target.partition("#")
    if not path or ":" in path:
        return None
    wanted = os.path.normpath(os.path.join(os.path.dirname(page), path))
    if not (ROOT / wanted).exists():
        sys.exit(f"{page} links to {target}, which is not there")
    if wanted in PAGES:
        if text == path or text == os.path.basename(path):  # a name of a file tells less than a title
            text = title(wanted)
        here = os.path.dirname(PAGES[page])
        return f"[{text}]({os.path.relpath(PAGES[wanted], here or '.')}{'#' + anchor if anchor else ''})"
    if wanted.startswith("docs/"):  # a picture
        here = os.path.dirname(PAGES[page])
        return f"[{text}]({os.path.relpath(wanted[len('docs/'):], here or '.')})"
    return f"`{wanted}`"


def title(page):
    """Of a page of the repository, or of one that is made for a folder."""
    path = ROOT / page
    return path.read_text().split("\n")[0].lstrip("# ") if path.is_file() else path.name


def page_text(page):
    text = (ROOT / page).read_text()
    parts = re.split(r"(^```.*?^```$)", text, flags=re.M | re.S)  # code has no links
    for i in range(0, len(parts), 2):
        parts[i] = re.sub(
            r"\[([^\]]*)\]\(([^)\s]+)\)", lambda m: link(page, *m.groups()) or m.group(0), parts[i]
        )
    return "".join(parts)


def write(name, text):
    path = SITE / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def toctree(caption, names):
    return f"\n```{{toctree}}\n:hidden:\n:caption: {caption}\n\n" + "\n".join(names) + "\n```\n"


def examples():
    text = "# Examples\n\nPrograms with the library, one for each kind of user.\n"
    for path in sorted((ROOT / "examples").glob("*.cpp")):
        text += f"\n## {path.name}\n\n```cpp\n{path.read_text()}```\n"
    return text


def notebooks():
    text = "# Notebooks\n\nWhat is in `python/notebooks`, without the pictures.\n"
    for path in sorted((ROOT / "python/notebooks").glob("*.ipynb")):
        for cell in json.loads(path.read_text())["cells"]:
            source = "".join(cell["source"])
            if cell["cell_type"] == "code":
                text += f"\n```python\n{source}\n```\n"
            else:
                text += "\n" + re.sub(r"^#", "##", source, flags=re.M) + "\n"
    return text


def folder_page(title, folder):
    pages = sorted(path.stem for path in (ROOT / "docs" / folder).glob("*.md"))
    return f"# {title}\n\n```{{toctree}}\n:maxdepth: 1\n\n" + "\n".join(pages) + "\n```\n"


def index():
    there = [path.stem for path in (ROOT / "docs").glob("*.md")]
    known = [name for name in GUIDES if name in there]
    known += sorted(set(there) - set(GUIDES) - set(BACKGROUND))
    return (
        page_text("README.md")
        + toctree("Guides", [*known, "examples", "notebooks"])
        + toctree("Reference", REFERENCE)
        + toctree(
            "Background", [*[name for name in BACKGROUND if name in there], "design/index", "decisions/index"]
        )
        + toctree("Project", [name.lower() for name in PROJECT])
    )


LIBRARY = """# The library

The reference of the C++ library is a part of its own, made from its headers by doxygen:
<a href="cpp/files.html">files</a>, <a href="cpp/annotated.html">classes</a>,
<a href="cpp/namespacemembers.html">functions</a>. [Architecture](architecture.md) says how the layers go together,
and [Examples](examples.md) show programs. What follows are the headers to begin with, those that lie in no room of
their layer.
"""


def library():
    """The headers that lie in no room, by layers, with what each begins with."""
    text = LIBRARY
    layers = re.findall(r"^ *hodt_layer\((\w+)", (ROOT / "src/hodt/CMakeLists.txt").read_text(), re.M)
    for layer in layers:
        text += f"\n## {layer}\n"
        for path in sorted(
            [*(ROOT / "src/hodt").glob(f"{layer}.h"), *(ROOT / "src/hodt" / layer).glob("*.h")]
        ):
            comment = path.read_text().split("#pragma once")[0].split("// Tested by")[0]
            said = html.escape(" ".join(comment.replace("//", " ").split()))
            name = path.relative_to(ROOT / "src")
            page = path.name.replace("_", "__").replace(".", "_8") + ".html"  # as doxygen calls it
            text += f'\n<a href="cpp/{page}"><code>{name}</code></a>\n:   {said}\n'
    return text


def main():
    for path in (path for kind in ("svg", "png") for path in (ROOT / "docs").rglob(f"*.{kind}")):
        target = SITE / path.relative_to(ROOT / "docs")
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, target)
    for page, name in PAGES.items():
        if page.endswith(".md") and page != "README.md":
            write(name, page_text(page))
    write("design/index.md", folder_page("Design", "design"))
    write("decisions/index.md", folder_page("Decisions", "decisions"))
    write("examples.md", examples())
    write("notebooks.md", notebooks())
    write("cpp.md", library())
    write("command.md", COMMAND.read_text())
    write("python-reference.rst", python_reference.reference(ROOT / "python/hodt"))
    write("index.md", index())


main()
