"""A campaign of small real impacts that tests of one process share, and what tests share."""

import atexit
import functools
import json
import os
import pathlib
import subprocess
import tempfile

import eerie

SOURCE = pathlib.Path(__file__).resolve().parents[3]
PACKAGE = SOURCE / "analysis/python"

# Large enough for remnants of 100 particles, short enough for a second each.
SWEEP = {
    "name": "small",
    "scene": {
        "numerics": {"particles_per_target": 100},
        "end": {"time_s": 2000},
        "output": {"snapshot_interval_s": 500, "history_interval_s": 200},
    },
    "grid": {"v_imp_cm_per_s": [15, 20], "theta_imp_deg": [10, 15]},
}


@functools.lru_cache(maxsize=None)
def folder():
    """A folder that goes with the process."""
    kept = tempfile.TemporaryDirectory(prefix="eerie python ")  # with a blank, as users have them
    atexit.register(kept.cleanup)
    return pathlib.Path(kept.name)


@functools.lru_cache(maxsize=None)
def campaign():
    return eerie.run(SWEEP, db=folder() / "small.sqlite", workers=2)


def program(*words):
    """What the program prints."""
    return subprocess.run(
        [os.environ["EERIE"], *map(str, words)], check=True, capture_output=True, text=True
    ).stdout


def rows(*words):
    """What the program itself says of the campaign, with units: a Tabular Data Resource."""
    return json.loads(
        program("query", "--db", campaign().path, *words, "--format", "json-table")
    )
