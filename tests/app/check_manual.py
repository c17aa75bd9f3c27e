#!/usr/bin/env python3
"""The pages for man, the completion scripts and the reference say what --help says.

    check_manual.py COMMAND FOLDER

FOLDER is what hodt_manual wrote. man, zsh and fish take part where they are installed."""

import os
import pathlib
import pty
import re
import select
import shutil
import subprocess
import sys
import tempfile
import time

COMMAND, FOLDER = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
failures = []


def expect(holds, message):
    if not holds:
        failures.append(message)


def expect_equal(found, wanted, what):
    expect(found == wanted, f"{what}:\n  found  {found}\n  wanted {wanted}")


def run(*words, **options):
    return subprocess.run(words, capture_output=True, text=True, **options)


# --- what --help says ---


class Help:
    """The parts of a help text: usage, options by their names, subcommands, what stands below."""

    def __init__(self, command=None):
        text = run(COMMAND, *([command] if command else []), "--help").stdout
        self.summary = text.split("\n")[0]
        self.usage = re.search(r"^Usage: (.*)", text, re.M).group(1).strip()
        body, self.below = self.split_footer(text)
        self.entries = [self.entry(item) for item in re.split(r"\n(?=  \S)", body)]
        self.commands = [entry for entry in self.entries if entry["section"] == "Subcommands"]

    def split_footer(self, text):
        start = re.search(r"\n(?=(Positionals|Options|Subcommands):)", text).end()
        lines = text[start:].split("\n")
        section, body = "", []
        while lines and (
            not lines[0]
            or lines[0].startswith("  ")
            or re.match(r"(Positionals|Options|Subcommands):$", lines[0])
        ):
            line = lines.pop(0)
            if line.endswith(":") and not line.startswith(" "):
                section = line[:-1]
            elif line:
                body.append(f"  {section}|{line[2:]}" if re.match(r"  \S", line) else line)
        return "\n".join(body), " ".join("\n".join(lines).split())

    def entry(self, item):
        section, rest = item.strip().split("|", 1)
        if section == "Subcommands":
            name, text = rest.split(None, 1)
            return {"section": section, "names": [name], "text": " ".join(text.split())}
        parts = re.match(r"(\S+)((?: [A-Z]+(?=\s|$)| \.\.\.)*)\s*(.*)", rest, re.S)
        words = [word for word in parts[2].split() if word not in ("TEXT", "...")]
        value = (
            parts[1] if section == "Positionals" else next((word for word in words if word != "REQUIRED"), "")
        )
        return {
            "section": section,
            "names": parts[1].split(",") if section == "Options" else [],
            "value": value,
            "required": "REQUIRED" in words,
            "text": " ".join(parts[3].split()),
        }

    def options(self):
        return [entry for entry in self.entries if entry["section"] == "Options"]

    def arguments(self):
        return [entry for entry in self.entries if entry["section"] == "Positionals"]

    def names(self):
        return {name for entry in self.options() for name in entry["names"]}


main = Help()
commands = {entry["names"][0]: Help(entry["names"][0]) for entry in main.commands}


# --- the pages for man ---


def plain(roff):
    """A line of roff as it is printed."""
    for escape, text in {
        r"\\f[BIR]": "",
        r"\\-": "-",
        r"\\&": "",
        r"\\\(aq": "'",
        r"\\\(ga": "`",
        r"\\\(ha": "^",
        r"\\\(ti": "~",
        r"\\\(rs": r"\\",
    }.items():
        roff = re.sub(escape, text, roff)
    return roff


def sections(page):
    parts = {}
    for part in page.split("\n.SH ")[1:]:
        title, _, body = part.partition("\n")
        parts[title] = body
    return parts


def paged_entries(body):
    found = []
    for item in body.split(".TP\n")[1:]:
        head, *text = plain(item).strip().split("\n")
        words = head.replace(",", " ").split()
        found.append(
            {
                "names": [word for word in words if word.startswith("-")],
                "value": next((word for word in words if word.isupper()), ""),
                "required": "(required)" in words,
                "text": " ".join(" ".join(text).split()),
            }
        )
    return found


def without_section(entries):
    return [{key: entry[key] for key in ("names", "value", "required", "text")} for entry in entries]


def check_page(name, help_):
    page = (FOLDER / "man1" / f"{name}.1").read_text()
    parts = sections(page)
    expect_equal(plain(parts["NAME"]).strip(), f"{name} - {help_.summary}", f"{name}.1, NAME")
    expect_equal(plain(parts["SYNOPSIS"]).strip(), help_.usage, f"{name}.1, SYNOPSIS")
    expect_equal(
        paged_entries(parts.get("OPTIONS", "")), without_section(help_.options()), f"{name}.1, OPTIONS"
    )
    expect_equal(
        paged_entries(parts.get("ARGUMENTS", "")), without_section(help_.arguments()), f"{name}.1, ARGUMENTS"
    )
    notes, examples = plain(parts.get("NOTES", "")), plain(parts.get("EXAMPLES", "")).replace(
        ".nf", ""
    ).replace(".fi", "")
    below = notes + (" Examples: " if examples else "") + examples
    expect_equal(" ".join(below.split()), help_.below, f"{name}.1, NOTES and EXAMPLES")
    if shutil.which("man") and shutil.which("groff"):
        shown = run(
            "man",
            "--warnings",
            "-E",
            "UTF-8",
            "-l",
            str(FOLDER / "man1" / f"{name}.1"),
            env={**os.environ, "MANWIDTH": "200"},
        )
        expect_equal((shown.returncode, shown.stderr), (0, ""), f"man {name}")
        for option in help_.names():
            expect(option in shown.stdout, f"man {name} does not show {option}")


def check_pages():
    check_page("hodt", main)
    for name, help_ in commands.items():
        check_page(f"hodt-{name}", help_)
    expect_equal(
        {path.stem for path in (FOLDER / "man1").iterdir()},
        {"hodt", *(f"hodt-{name}" for name in commands)},
        "pages",
    )
    listed = re.findall(
        r"hodt-(\w+)\(1\)\n(.*)", plain(sections((FOLDER / "man1/hodt.1").read_text())["SUBCOMMANDS"])
    )
    expect_equal(
        listed, [(entry["names"][0], entry["text"]) for entry in main.commands], "hodt.1, SUBCOMMANDS"
    )


# --- the reference ---


def check_reference():
    text = (FOLDER / "command.md").read_text()
    for name, help_ in commands.items():
        part = re.search(rf"^## hodt {name}\n(.*?)(?=^## |\Z)", text, re.M | re.S).group(1)
        unescaped = re.sub(r"\\([\\`*_{}\[\]<>#|])", r"\1", part)
        entries = re.findall(r"^(.+)\n:   (.*)$", unescaped, re.M)
        expect_equal(
            [entry[1] for entry in entries],
            [entry["text"] for entry in help_.arguments() + help_.options()],
            f"reference, {name}",
        )
        expect_equal(
            set(re.findall(r"`(-[^`]*)`", " ".join(entry[0] for entry in entries))),
            help_.names(),
            f"reference, {name}",
        )
        expect(f"\n{help_.usage}\n" in part, f"reference, {name}: no usage")


# --- completion ---


def words_accepted():
    """What the command itself says, when it is given a word that it does not know."""
    with tempfile.TemporaryDirectory() as folder:
        run(COMMAND, "sample", "valley", "-n", "20", "-o", "p.csv", cwd=folder)

        def complaint(*words):
            return run(COMMAND, *words, cwd=folder).stderr.split("'nonsense'")

        def listed(text):
            return set(re.findall(r"[a-z][a-z-]*", text)) - {"and", "or"}

        points = ("p.csv", "-o", "t.ply")
        kinds, measures = complaint("triangulate", *points, "--objective", "nonsense")[1].split(
            "where MEASURE is one of"
        )
        objectives = listed(kinds.split("there are")[1].split("<")[0])
        objectives |= {
            f"{d}-{a}-{m}" for d in ("min", "max") for a in ("sum", "max", "min") for m in listed(measures)
        }
        found = {
            ("triangulate", "--objective"): objectives,
            ("compare", "--objective"): objectives | {"all"},
            ("triangulate", "--method"): listed(
                complaint("triangulate", *points, "--method", "nonsense")[1].split("there are")[1]
            ),
            ("sample", ""): set(re.findall(r"^(\w+)", run(COMMAND, "sample").stdout, re.M)),
        }
        for command, option in (
            ("info", "--duplicates"),
            ("info", "--las-return"),
            ("edges", "--class"),
            ("triangles", "--class"),
        ):
            output = () if command == "info" else ("-o", "e.csv")
            before = complaint(command, "p.csv", *output, option, "nonsense")[0]
            found[command, option] = listed(
                re.search(r"(?:must be|takes) (.*), (?:not|and) ", before).group(1)
            )
        for (command, option), words in found.items():
            expect(len(words) > 1, f"{command} {option} nonsense does not list what there is")
        return found


class Bash:
    def __init__(self):
        self.script = FOLDER / "bash/hodt"

    def complete(self, *words):
        """The words that are offered, or "files"."""
        line = " ".join(f"'{word}'" for word in words)
        code = (
            f"source '{self.script}'; complete -p hodt >&2; compopt() {{ [[ $* == '-o default' ]] && echo files; }};"
            f"COMP_WORDS=({line}); COMP_CWORD={len(words) - 1}; _hodt; printf '%s\\n' \"${{COMPREPLY[@]}}\""
        )
        result = run("bash", "--norc", "--noprofile", "-c", code)
        expect_equal(result.stderr, "complete -F _hodt hodt\n", "bash")
        return set(result.stdout.split())


class Fish:
    def __init__(self, folder):
        self.folder = folder
        (folder / "only-file.csv").touch()

    def complete(self, *words):
        result = run(
            "fish",
            "--no-config",
            "-c",
            f"source {FOLDER / 'fish/hodt.fish'}; complete -C '{' '.join(words)}'",
            cwd=self.folder,
            env={**os.environ, "HOME": str(self.folder)},
        )
        expect_equal(result.stderr, "", "fish")
        found = {line.split("\t")[0] for line in result.stdout.splitlines()}
        return {"files"} if "only-file.csv" in found else found


class Zsh:
    """Zsh completes only what is typed, so it is typed."""

    def __init__(self, folder):
        self.folder = folder
        (folder / "only-file.csv").touch()
        shutil.copy(FOLDER / "zsh/_hodt", folder)
        (folder / ".zshrc").write_text(
            f"fpath=({folder} $fpath); autoload -U compinit; compinit -u -D; PROMPT='ready>'; unsetopt zle_bracketed_paste\n"
            "LISTMAX=10000; KEYTIMEOUT=1; LINES=1000; COLUMNS=200; zstyle ':completion:*' verbose no\n"
            "bindkey '^X' list-choices\n"
        )
        self.pid, self.terminal = pty.fork()
        if self.pid == 0:
            os.chdir(folder)
            os.execvpe(
                "zsh",
                ["zsh", "-i"],
                {**os.environ, "ZDOTDIR": str(folder), "TERM": "dumb", "HOME": str(folder)},
            )
        self.read("ready>", 20)
        self.read("", 0.1)

    def read(self, until, seconds):
        """What it says until the text comes, or, without a text, for a moment."""
        text, end = "", time.monotonic() + seconds
        while (not until or until not in text) and time.monotonic() < end:
            if select.select([self.terminal], [], [], 0.05)[0]:
                text += os.read(self.terminal, 65536).decode(errors="replace")
        return text

    def complete(self, *words):
        os.write(self.terminal, (" ".join(words) + "\x18").encode())
        text = self.read("\nready>", 5).split(" ".join(words), 1)[-1].split("\nready>")[0]
        os.write(self.terminal, b"\x15")  # what was typed goes
        while self.read("", 0.1):
            pass
        found = set(text.replace("\r", " ").replace("\x07", " ").split())
        return {"files"} if "only-file.csv" in found else found

    def close(self):
        os.write(self.terminal, b"\x15exit\r")
        os.close(self.terminal)
        os.waitpid(self.pid, 0)


def check_shell(name, complete, accepted, whole_words):
    """`whole_words`: what the shell shows after a comma has what stands before, too, and may repeat it."""

    def check(words, wanted):
        found = complete("hodt", *words)
        expect(found == wanted, f"{name}, {words}:\n  found  {sorted(found)}\n  wanted {sorted(wanted)}")

    def after(words, others):
        first = ",".join(words) + ","
        return {first + word for word in others} if whole_words else others - set(words)

    check([""], set(commands))
    check(["tri"], {"triangulate", "triangles"})
    for command, help_ in commands.items():
        check([command, "--"], {option for option in help_.names() if option.startswith("--")})
        for entry in help_.options():
            words = accepted.get((command, entry["names"][-1]))
            if words:
                check([command, entry["names"][-1], ""], words)
                some = min(words)
                check(
                    [
                        command,
                        "--threads" if command != "info" else "--json",
                        "2",
                        entry["names"][-1],
                        some[:-1],
                    ],
                    {word for word in words if word.startswith(some[:-1])},
                )
        if help_.arguments():
            check([command, ""], accepted.get((command, ""), {"files"}))
    for command in ("triangulate", "compare"):  # several, with commas between
        objectives = accepted[command, "--objective"]
        for first in (["min-local-minima"], ["min-sum-abn", "none"]):
            start = ",".join(first) + ","
            check([command, "--objective", start], after(first, objectives))
            check([command, "--objective", start + "max-sum-sm"], after(first, {"max-sum-small-angle"}))
        check([command, "--objective", "nonsense,nonsense"], set())
    for spelled in ("-o", "--output"):
        check(["triangulate", "points.csv", spelled, ""], {"files"})
    check(["triangulate", "points.csv", "--json", ""], {"files"})
    check(["triangulate", "points.csv", "-k", ""], set())


def check_completion():
    accepted = words_accepted()
    check_shell("bash", Bash().complete, accepted, True)
    expect_equal(Bash().complete("hodt", "edges", "--class", "=", "ko"), {"kod"}, "bash, --class=ko")
    expect_equal(
        Bash().complete("hodt", "triangulate", "--objective", "=", "none,min-sum-ab"),
        {"none,min-sum-abn"},
        "bash, --objective=none,min-sum-ab",
    )
    expect_equal(
        Bash().complete("hodt", "edges", "--class", "="), accepted["edges", "--class"], "bash, --class="
    )
    if shutil.which("fish"):
        with tempfile.TemporaryDirectory() as folder:
            check_shell("fish", Fish(pathlib.Path(folder)).complete, accepted, True)
    if shutil.which("zsh"):
        with tempfile.TemporaryDirectory() as folder:
            zsh = Zsh(pathlib.Path(folder))
            check_shell("zsh", zsh.complete, accepted, False)
            zsh.close()


check_pages()
check_reference()
check_completion()
skipped = [name for name in ("man", "zsh", "fish") if not shutil.which(name)]
if skipped:
    print("Not installed, so not tried:", ", ".join(skipped))
print("\n".join(failures) or "The manual and the completions say what --help says.")
sys.exit(1 if failures else 0)
