"""The package calls the program, and says what it said."""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from unittest import mock

import eerie
import small_campaign
from small_campaign import campaign


class Program(unittest.TestCase):
    def test_a_sweep_runs_and_goes_on_where_it_was(self):
        results = campaign().results()
        self.assertEqual(len(results), 4)
        again = eerie.run(small_campaign.SWEEP, db=campaign().path)
        self.assertEqual(list(again.results()["finished"]), list(results["finished"]))

    def test_overrides_and_fidelity_reach_the_program(self):
        path = small_campaign.folder() / "overrides.sqlite"
        database = eerie.run(
            {"name": "one", "grid": {"v_imp_cm_per_s": [15]}},
            db=path,
            fidelity="sketch",
            overrides={"numerics.particles_per_target": 100, "end.time_s": 200,
                       "end.latest_s": 200, "numerics.scheme": "dual"},
        )  # fmt: skip
        scene = database.job(1).scene
        self.assertEqual(scene["numerics"]["particles_per_target"], 100)
        self.assertEqual(scene["numerics"]["scheme"], "dual")

    def test_a_refusal_is_an_error_with_the_programs_words(self):
        sweep = {"name": "bad", "grid": {"theta_imp_deg": [95]}}
        with self.assertRaisesRegex(eerie.ProgramError, "theta_imp_deg") as caught:
            eerie.run(sweep, db=small_campaign.folder() / "bad.sqlite")
        self.assertEqual(caught.exception.code, 2)

    def test_any_command_can_be_asked(self):
        answer = campaign().ask("threshold")
        self.assertEqual(answer["ridges"][0]["impacts"], 4)
        self.assertEqual(eerie.ask("expand", self.sweep_file())["jobs"], 1)

    def sweep_file(self):
        file = small_campaign.folder() / "one.json"
        file.write_text('{"name": "one", "grid": {"v_imp_cm_per_s": [15]}}')
        return str(file)

    def test_a_missing_program_is_named(self):
        with mock.patch.dict(os.environ, {"EERIE": "/none/eerie"}):
            self.assertRaisesRegex(eerie.Error, "/none/eerie.*EERIE=", eerie.ask, "disk")
        with mock.patch.dict(os.environ, {"PATH": ""}):
            del os.environ["EERIE"]
            self.assertRaisesRegex(eerie.Error, "not on the PATH", eerie.ask, "disk")

    def test_ctrl_c_leaves_checkpoints_and_no_process(self):
        folder = pathlib.Path(tempfile.mkdtemp(dir=small_campaign.folder()))
        script = (
            "import eerie\n"
            "eerie.run({'name': 'long', 'grid': {'v_imp_cm_per_s': [15]}}, db='long.sqlite',"
            " overrides={'numerics.particles_per_target': 300, 'end.time_s': 1e5}, workers=1)\n"
        )
        running = subprocess.Popen(
            [sys.executable, "-c", script], cwd=folder, start_new_session=True,
            stderr=subprocess.DEVNULL,
        )  # fmt: skip
        self.addCleanup(running.kill)
        while not list(folder.glob("long.sqlite.jobs/*/snapshot_0000.hdf5")):
            self.assertIsNone(running.poll())
            time.sleep(0.01)
        os.killpg(running.pid, signal.SIGINT)  # as a terminal does
        self.assertNotEqual(running.wait(), 0)
        self.assertEqual(len(list(folder.glob("long.sqlite.jobs/*/checkpoint.hdf5"))), 1)
        self.assertEqual(list(eerie.open(folder / "long.sqlite").jobs()["state"]), ["pending"])


if __name__ == "__main__":
    unittest.main()
