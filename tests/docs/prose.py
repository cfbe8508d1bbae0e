#!/usr/bin/env python3
"""Counts the prose of README.md, CONTRIBUTING.md and docs/, and fails where it is too long.

usage: prose.py ROOT [--table | --since COMMIT]
  --table         a line for each page
  --since COMMIT  the same beside the page of that commit, which is the one of the same name
Code, headings and pictures are no prose. A cell of a table may hold sentences, of the same length.
"""
import pathlib
import re
import signal
import statistics
import subprocess
import sys

MOST_WORDS, MEDIAN, MOST_IN_PARAGRAPH = 40, 20, 120
# A full stop behind these ends no sentence.
SHORT = r"(?:\b(?:al|Fig|Figs|Eq|Eqs|vs|No|e\.g|i\.e|cf|approx|St|[A-Z])\.)$"


def plain(text):
    """Without marks; what stands in code or is the target of a link counts as one word."""
    text = re.sub(r"<!--.*?-->", "", text, flags=re.S)
    text = re.sub(r"!\[[^\]]*\]\([^)]*\)", "", text)
    text = re.sub(r"`[^`]*`", "Code", text)
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    return re.sub(r"[*_]{1,2}(\S)|(\S)[*_]{1,2}", r"\1\2", text)


def blocks(markdown):
    """(kind, text): paragraphs (items of lists are such) and cells of tables."""
    markdown = re.sub(r"^```.*?^```[ \t]*$", "", markdown, flags=re.S | re.M)
    markdown = re.sub(r"<!--.*?-->", "", markdown, flags=re.S)
    paragraph, after_blank, in_list = [], True, False
    for line in markdown.split("\n") + [""]:
        item = re.match(r"\s*(?:[-*]|\d+\.|:)\s+(.*)", line)
        code = after_blank and re.match(r"(?: {4}|\t)", line) and not in_list
        if paragraph and (not line.strip() or item or line.startswith(("|", "#"))):
            yield "paragraph", " ".join(paragraph)
            paragraph = []
        if line.lstrip().startswith("|"):
            for cell in line.strip().strip("|").split("|"):
                yield "cell", cell.strip()
        elif item and not code:
            paragraph, in_list = [item.group(1)], True
        elif line.strip() and not line.startswith("#") and not code:
            paragraph.append(line.strip())
            in_list = in_list and line.startswith(" ")
        after_blank = not line.strip() or (after_blank and bool(code))


def sentences(text):
    found = [""]
    for part in re.split(r"(?<=[.!?])(?<!\.\.)[\"')]?\s+(?=[\"'(\[A-Z0-9])", plain(text)):
        if found[-1] and re.search(SHORT, found[-1]):
            found[-1] += " " + part
        else:
            found.append(part)
    return [s for s in found if re.search(r"[A-Za-z]{2}", s)]


def count(text):
    return len(re.findall(r"\S*\w\S*", text))


class Page:
    def __init__(self, text):
        self.words = count(text)
        self.sentences, self.paragraphs, self.cells = [], [], []
        for kind, block in blocks(text):
            of_block = [(count(s), s) for s in sentences(block)]
            if kind == "cell":
                self.cells += of_block
            elif of_block:
                self.sentences += of_block
                self.paragraphs.append((sum(n for n, _ in of_block), block))
        self.median = statistics.median([n for n, _ in self.sentences] or [0])
        self.prose = sum(n for n, _ in self.sentences)
        self.in_tables = sum(n for n, _ in self.cells)
        self.longest = max((n for n, _ in self.sentences + self.cells), default=0)
        self.paragraph = max((n for n, _ in self.paragraphs), default=0)

    def too_long(self):
        return [(n, s) for n, s in self.sentences + self.cells if n > MOST_WORDS]

    def complaints(self):
        for n, text in self.too_long():
            yield f"a sentence of {n} words ({MOST_WORDS} at most): {text[:90]}..."
        for n, text in self.paragraphs:
            if n > MOST_IN_PARAGRAPH:
                yield f"a paragraph of {n} words ({MOST_IN_PARAGRAPH} at most): {text[:70]}..."
        if self.median >= MEDIAN:
            yield f"half of its sentences have {self.median:g} words or more (below {MEDIAN})"

    def row(self):
        return (f"{self.words:6d} {len(self.sentences):5d} {self.median:6.1f} {self.longest:7d} "
                f"{len(self.too_long()):8d} {self.paragraph:9d}")


def check_itself():
    """It sees what it is for: a long sentence, a long paragraph, a long cell; and nothing in code."""
    def complaints(text):
        return len(list(Page("Short here. Short there.\n\n" + text).complaints()))
    words = "word " * 39
    assert complaints(f"{words}end.") == 0 and complaints(f"One {words}end, cf. `a b c`.") == 1
    assert complaints("Nine words are in here, seven more than two. " * 14) == 1
    assert complaints(f"| a | {words} more words |\n") == 1
    assert complaints(f"    {words} in code\n\n```\n{words} in code\n```\n") == 0


# Pages that have other names since they have rooms.
RENAMED = {"campaign.md": "daemon.md", "command-line.md": "cli.md", "files.md": "job-directory.md", "film.md": "pictures.md",
           "remnants.md": "outcomes.md", "ridge.md": "threshold-and-check.md", "snapshots.md": "formats.md",
           "speed.md": "performance.md"}


def is_documentation(name):
    return name in ("README.md", "CONTRIBUTING.md") or name.startswith("docs/") and name.endswith(".md")


def pages_of(root):
    names = [p.relative_to(root).as_posix() for p in root.glob("**/*.md")]
    return {n: Page((root / n).read_text(encoding="utf8")) for n in sorted(names) if is_documentation(n)}


def pages_at(root, commit):
    def git(*words):
        return subprocess.run(["git", "-C", root, *words], check=True, capture_output=True, text=True).stdout
    names = git("ls-tree", "-r", "--name-only", commit).split("\n")
    return {n: Page(git("show", f"{commit}:{n}")) for n in names if is_documentation(n)}


def same_page(name, others):
    """Pages have moved between folders; a README is known by its folder."""
    def key(n):
        return n.split("/")[-2:] if n.endswith("README.md") else n.split("/")[-1:]
    wanted = key(name), [RENAMED.get(name.split("/")[-1])]
    return name if name in others else next((o for o in others if key(o) in wanted), None)


def summary(pages):
    sentences = [n for p in pages for n, _ in p.sentences]
    return (f"{len(pages)} pages, {sum(p.words for p in pages)} words: {sum(p.prose for p in pages)} in sentences, "
            f"{sum(p.in_tables for p in pages)} in tables; {len(sentences)} sentences, median "
            f"{statistics.median(sentences):g}, longest {max(p.longest for p in pages)}, "
            f"{sum(len(p.too_long()) for p in pages)} above {MOST_WORDS}, longest paragraph "
            f"{max(p.paragraph for p in pages)}")


def print_since(root, commit):
    before, after = pages_at(root, commit), pages_of(root)
    print("before and after:  words    sentences       median      longest    paragraph")
    def line(old, new, name):
        def pair(value):
            return "".join(f"{'' if p is None else format(value(p), 'g'):>7}" for p in (old, new))
        print(pair(lambda p: p.words), pair(lambda p: len(p.sentences)), pair(lambda p: p.median),
              pair(lambda p: p.longest), pair(lambda p: p.paragraph), name)
    left = dict(before)
    for name, page in after.items():
        there = same_page(name, left)
        line(left.pop(there) if there else None, page, name)
    for name, page in left.items():
        line(page, None, name)
    print("before:", summary(before.values()))
    print("after: ", summary(after.values()))


def main(root, table, since):
    check_itself()
    if since:
        return print_since(root, since)
    pages = pages_of(root)
    assert len(pages) > 10, f"{root} holds no documentation"
    if table:
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)
        print(" words sents median longest above-40 paragraph")
        for name, page in pages.items():
            print(page.row(), name)
        print(summary(pages.values()))
        return 0
    complaints = [f"{name}: {complaint}" for name, page in pages.items() for complaint in page.complaints()]
    print("\n".join(complaints))
    return 1 if complaints else 0


if __name__ == "__main__":
    said = sys.argv[2:]
    sys.exit(main(pathlib.Path(sys.argv[1]), said == ["--table"], said[1] if said[:1] == ["--since"] else None))
