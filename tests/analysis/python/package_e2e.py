"""The package installs without a network, is typed, and has the program's version."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
import unittest

import small_campaign
import yaml


class Package(unittest.TestCase):
    def test_pip_installs_it_with_debians_packages_and_no_network(self):
        with tempfile.TemporaryDirectory() as folder:
            source, home = pathlib.Path(folder, "python"), pathlib.Path(folder, "home")
            shutil.copytree(small_campaign.PACKAGE, source)
            for words in (
                [sys.executable, "-m", "venv", "--system-site-packages", home],
                [home / "bin/pip", "install", "--no-index", "--no-build-isolation",
                 "--no-deps", source],
            ):
                subprocess.run(words, check=True, capture_output=True)
            script = (
                "import eerie, importlib.metadata, pathlib\n"
                "print(pathlib.Path(eerie.__file__).with_name('py.typed').exists(),"
                " importlib.metadata.version('eerie'), eerie.__file__)"
            )
            said = subprocess.run(
                [home / "bin/python", "-c", script], check=True, capture_output=True, text=True,
                env={}, cwd=folder,
            ).stdout.split()  # fmt: skip
        self.assertEqual(said[:2], ["True", self.version()])
        self.assertTrue(said[2].startswith(str(home)), said[2])

    def test_its_version_is_that_of_the_program(self):
        words = small_campaign.program("--version").split()
        self.assertEqual(
            self.version(), words[1].replace("-rc", "rc"), "analysis/python/pyproject.toml lags behind"
        )

    def test_the_citation_names_this_version_and_the_paper(self):
        citation = yaml.safe_load((small_campaign.SOURCE / "CITATION.cff").read_text())
        self.assertEqual(citation["version"].replace("-rc", "rc"), self.version())
        self.assertEqual(citation["type"], "software")
        paper = citation["references"][0]
        self.assertEqual([author["family-names"] for author in paper["authors"]],
                         ["Sugiura", "Kobayashi", "Inutsuka"])  # fmt: skip
        self.assertEqual((paper["year"], paper["volume"], paper["start"]), (2019, 328, 14))

    def test_types_are_whole(self):
        checked = subprocess.run(
            ["/usr/bin/mypy", "--cache-dir=/dev/null", "eerie"],
            cwd=small_campaign.PACKAGE, capture_output=True, text=True, check=False,
        )  # fmt: skip
        self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)

    def test_the_documented_lines_run(self):
        page = (small_campaign.SOURCE / "docs/how-to/python.md").read_text()
        blocks = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
        self.assertGreaterEqual(len(blocks), 3)
        for block in blocks:
            # The page speaks of a campaign of the paper's; here is a small one.
            for theirs, ours in (
                ('"fig2b.sqlite"', repr(str(small_campaign.campaign().path))),
                ('"sweeps/table2-fig2b.json", fidelity="survey"', repr(small_campaign.SWEEP)),
                ('"3f9a20c1"', repr(small_campaign.campaign().job(1).hash[:8])),
            ):
                block = block.replace(theirs, ours)
            subprocess.run(
                [sys.executable, "-c", block], check=True, cwd=small_campaign.folder()
            )

    @staticmethod
    def version():
        with open(small_campaign.PACKAGE / "pyproject.toml", "rb") as file:
            return tomllib.load(file)["project"]["version"]


if __name__ == "__main__":
    unittest.main()
