"""Results of eerie as pandas frames and numpy arrays.

    import eerie

    campaign = eerie.open("campaign.sqlite")
    campaign.results()                            # a row per finished job, units in .attrs["units"]
    campaign.map("b_over_a", q=1, phi_d=40)       # angles down, speeds across
    campaign.job("3f9a20c1").snapshots()          # particles, by the first digits of the job's hash
    eerie.run("sweep.json", db="campaign.sqlite") # calls the program

Nothing is computed here: numbers are those of the database's views and of the snapshots.
"""

from __future__ import annotations

import os

from .database import Database
from .errors import Error, ProgramError, UnknownNameError
from .job import Job
from .program import ask, run
from .snapshot import Snapshot

__all__ = [
    "Database",
    "Error",
    "Job",
    "ProgramError",
    "Snapshot",
    "UnknownNameError",
    "ask",
    "open",
    "run",
]


def open(path: str | os.PathLike[str]) -> Database:  # noqa: A001, as in gzip.open
    """A campaign's database, for reading. Raises Error where it cannot be read."""
    return Database(path)
