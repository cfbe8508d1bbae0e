"""What goes wrong, said so that it can be mended."""

from __future__ import annotations

import difflib
from collections.abc import Iterable


class Error(Exception):
    """Something that the user can mend; the message says how."""


class UnknownNameError(Error):
    """A name that is none of those there are."""

    def __init__(self, what: str, name: str, names: Iterable[str]) -> None:
        known = list(names)
        near = difflib.get_close_matches(name, known, n=3, cutoff=0.4)
        near += [other for other in known if name and name in other and other not in near]
        hint = f"the closest are {', '.join(near[:5])}" if near else f"there are {', '.join(known)}"
        super().__init__(f"there is no {what} {name!r}; {hint}")


class ProgramError(Error):
    """The program ended with another exit code than 0: 1 some job failed, 2 bad input,
    3 environment, 130 stopped by Ctrl-C."""

    def __init__(self, words: list[str], code: int, complaint: str) -> None:
        self.code = code
        said = complaint.strip() or "it said nothing"
        super().__init__(f"`{' '.join(words)}` ended with exit code {code}: {said}")
