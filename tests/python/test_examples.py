"""The example scripts run and write what they say."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

EXAMPLES = pathlib.Path(os.environ["MIEN_EXAMPLES"])


class ExamplesTest(unittest.TestCase):
    def test_each_runs_in_an_empty_folder(self):
        scripts = sorted(EXAMPLES.glob("*.py"))
        self.assertGreaterEqual(len(scripts), 4)
        for script in scripts:
            with self.subTest(script.name), tempfile.TemporaryDirectory() as folder:
                run = subprocess.run([sys.executable, str(script)], cwd=folder, capture_output=True, text=True)
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assertTrue(run.stdout)


if __name__ == "__main__":
    unittest.main()
