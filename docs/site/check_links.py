#!/usr/bin/env python3
"""Checks a built site: links between its pages lead somewhere, and reading it takes no network.

check_links.py FOLDER"""

import html.parser
import pathlib
import re
import sys
import urllib.parse

SITE = pathlib.Path(sys.argv[1]).resolve()
LOADED = {
    ("script", "src"),
    ("img", "src"),
    ("iframe", "src"),
    ("link", "href"),
    ("object", "data"),
    ("source", "src"),
}


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.loaded, self.anchors = [], [], {""}
        self.feed(path.read_text(errors="replace"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors |= {values[name] for name in ("id", "name") if values.get(name)}
        for name in ("href", "src", "data"):
            if values.get(name):
                self.links.append(values[name])
                if (tag, name) in LOADED:
                    self.loaded.append(values[name])


pages = {path: Page(path) for path in SITE.rglob("*.html")}
problems = []
count = 0
for path, page in pages.items():
    name = path.relative_to(SITE)
    problems += [f"{name} loads {url}" for url in page.loaded if re.match(r"(https?:)?//", url)]
    for url in page.links:
        parts = urllib.parse.urlsplit(url)
        if parts.scheme or parts.netloc:
            continue
        count += 1
        target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
        if target.is_dir():
            target /= "index.html"
        if not target.is_file():
            problems.append(f"{name} links to {url}, which is not there")
        elif path.parent.name == "cpp" and parts.fragment == "nested-classes":
            continue  # doxygen links to the list of a class's private classes, which it leaves out
        elif target in pages and urllib.parse.unquote(parts.fragment) not in pages[target].anchors:
            problems.append(f"{name} links to {url}, where there is no such place")
for path in [*SITE.rglob("*.css"), *SITE.rglob("*.js")]:
    found = re.findall(r"(?:url\(|@import )['\"]?((?:https?:)?//[^'\")]*)", path.read_text(errors="replace"))
    problems += [f"{path.relative_to(SITE)} loads {url}" for url in found]

print(
    "\n".join(sorted(set(problems)))
    or f"{len(pages)} pages; all {count} links between them lead somewhere, and nothing is loaded from elsewhere."
)
sys.exit(1 if problems else 0)
