#!/usr/bin/env python3
"""Counts the prose of README.md, CONTRIBUTING.md and docs/, and fails where it is too long.

usage: prose.py ROOT [--table]    (--table: a line for each page)
Code, headings and pictures are no prose. A cell of a table may hold sentences, of the same length.
"""
import pathlib
import re
import signal
import statistics
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
        longest = max((n for n, _ in self.sentences + self.cells), default=0)
        paragraph = max((n for n, _ in self.paragraphs), default=0)
        return (f"{self.words:6d} {len(self.sentences):5d} {self.median:6.1f} {longest:7d} "
                f"{len(self.too_long()):8d} {paragraph:9d}")


def check_itself():
    """It sees what it is for: a long sentence, a long paragraph, a long cell; and nothing in code."""
    def complaints(text):
        return len(list(Page("Short here. Short there.\n\n" + text).complaints()))
    words = "word " * 39
    assert complaints(f"{words}end.") == 0 and complaints(f"One {words}end, cf. `a b c`.") == 1
    assert complaints("Nine words are in here, seven more than two. " * 14) == 1
    assert complaints(f"| a | {words} more words |\n") == 1
    assert complaints(f"    {words} in code\n\n```\n{words} in code\n```\n") == 0


def main(root, table):
    check_itself()
    pages = [root / "README.md", root / "CONTRIBUTING.md", *sorted(root.glob("docs/**/*.md"))]
    assert len(pages) > 10, f"{root} holds no documentation"
    if table:
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)
        print(" words sents median longest above-40 paragraph")
    bad, total, long_ones = 0, 0, 0
    for path in pages:
        page = Page(path.read_text(encoding="utf8"))
        total += page.words
        long_ones += len(page.too_long())
        if table:
            print(page.row(), path.relative_to(root))
            continue
        for complaint in page.complaints():
            print(f"{path.relative_to(root)}: {complaint}")
            bad += 1
    if table:
        print(f"{total:6d} words, {long_ones} sentences above {MOST_WORDS}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), "--table" in sys.argv))
