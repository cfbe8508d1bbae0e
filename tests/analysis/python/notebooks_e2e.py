"""The notebooks run from the first cell to the last, and show what the database holds."""

import contextlib
import io
import json
import os
import pathlib
import unittest

import matplotlib
import numpy as np
import small_campaign
from small_campaign import campaign

matplotlib.use("agg")
from matplotlib import pyplot  # noqa: E402

NOTEBOOKS = small_campaign.SOURCE / "docs/how-to/notebooks"


def executed(name, parameters):
    """Names after all cells of a notebook, with these in place of its parameters."""
    cells = json.loads((NOTEBOOKS / name).read_text())["cells"]
    names = {}
    before = pathlib.Path.cwd()
    os.chdir(small_campaign.folder())
    try:
        for number, cell in enumerate(cells):
            if cell["cell_type"] != "code":
                continue
            if "parameters" in cell["metadata"].get("tags", []):
                names.update(parameters)
                continue
            with contextlib.redirect_stdout(io.StringIO()):
                exec(compile("".join(cell["source"]), f"{name}, cell {number}", "exec"), names)
    finally:
        os.chdir(before)
        pyplot.close("all")
    return names


class Notebooks(unittest.TestCase):
    def test_each_notebook_is_tried_here_and_committed_without_output(self):
        names = sorted(file.name for file in NOTEBOOKS.glob("*.ipynb"))
        self.assertEqual(names, ["fig2b.ipynb", "particles.ipynb"])
        for name in names:
            for cell in json.loads((NOTEBOOKS / name).read_text())["cells"]:
                self.assertFalse(cell.get("outputs"), name)

    def test_from_a_sweep_to_fig_2b(self):
        parameters = {"sweep": small_campaign.SWEEP, "fidelity": None,
                      "database": str(campaign().path)}  # fmt: skip
        names = executed("fig2b.ipynb", parameters)
        rows = small_campaign.rows()["data"]
        drawn = np.ma.getdata(names["mesh"].get_array()).ravel()
        self.assertEqual(sorted(drawn), sorted(row["b_over_a"] for row in rows))
        for row in rows:  # each value in the cell that its impact lies in
            column = np.searchsorted(names["edges"](names["speeds"]), row["v_imp_cm_per_s"]) - 1
            line = np.searchsorted(names["edges"](names["angles"]), row["theta_imp_deg"]) - 1
            self.assertEqual(drawn.reshape(names["table"].shape)[line, column], row["b_over_a"])
        self.assertEqual(names["elongated"].to_numpy().sum(), sum(row["eer"] for row in rows))
        self.assertEqual(names["paper"], 5.1)
        self.assertGreater((small_campaign.folder() / "fig2b.png").stat().st_size, 10_000)

    def test_one_impact_particle_by_particle(self):
        names = executed("particles.ipynb", {"database": str(campaign().path)})
        rows = small_campaign.rows()["data"]
        least = min(rows, key=lambda row: row["b_over_a"])
        self.assertEqual(names["job"].hash, least["hash"])
        # The particles have the angular momentum that the run says they have.
        np.testing.assert_allclose(names["change"], least["dL_over_L"], rtol=1e-6)
        # Before the impact matter lies within its body.
        self.assertLess(names["from_middle"].max(), 1.2 * names["job"].scene["target"]["radius_m"])
        for picture in ("particles.png", "origins.png", "history.png"):
            self.assertGreater((small_campaign.folder() / picture).stat().st_size, 5_000)


if __name__ == "__main__":
    unittest.main()
