"""Units of columns. Their names hold them, as docs/database.md promises."""

from __future__ import annotations

from collections.abc import Iterable

# Longer endings first: cm/s is not s, and not m/s.
_ENDINGS = {
    "_kg_per_m3": "kg/m^3",
    "_cm_per_s": "cm/s",
    "_m_per_s": "m/s",
    "_deg": "deg",
    "_kg": "kg",
    "_Pa": "Pa",
    "_J": "J",
    "_m": "m",
    "_s": "s",
    "_h": "h",
}

# Columns that are 0 or 1 in SQLite, which has no truth values.
FLAGS = {
    "results": ("eer", "settled", "stale"),
    "remnants": ("eer", "bound_to_largest"),
    "maps": (),
}


def unit_of(column: str) -> str:
    """The unit in a column's name; empty for numbers without unit and for words."""
    return next((unit for ending, unit in _ENDINGS.items() if column.endswith(ending)), "")


def units_of(columns: Iterable[str]) -> dict[str, str]:
    return {column: unit_of(column) for column in columns}
