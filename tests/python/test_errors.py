"""What is wrong is raised, with its sentence, and nothing goes to the console."""

import os
import subprocess
import sys
import tempfile
import unittest

import mien


class ErrorsTest(unittest.TestCase):
    def assert_refused(self, words, make):
        with self.assertRaises(mien.Error) as caught:
            make()
        self.assertIn(words, str(caught.exception))
        self.assertNotIn("0x", str(caught.exception), "no address of an object")

    def test_values_and_files_at_fault_are_named(self):
        face = mien.Face()
        self.assert_refused("there is no scheme 'round'", lambda: face.replace(scheme="round").surface())
        self.assert_refused("a = -1 is outside", lambda: face.replace(a=-1).surface())
        self.assert_refused("there is no expression 'joyful'", lambda: face.animate("joyful").surface())
        self.assert_refused("no property 'colour'", lambda: face.replace(colour="red"))
        self.assert_refused("/none.vtp: there is no such file", lambda: mien.Face("/none.vtp").surface())
        self.assert_refused("/none.fap", lambda: face.animate(fap="/none.fap").surface())
        self.assert_refused("not by frame and index", lambda: face.animate(fap="x.fap", frame=1, index=2))
        self.assert_refused("needs a file", lambda: face.animate(frame=1))
        self.assert_refused("wrong", lambda: mien.Face(state={"wrong": 1}))
        self.assert_refused("tolerate", lambda: face.sweep(schemes=["tolerate"]))

    def test_the_line_of_a_file_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "broken.fap")
            with open(file, "w", encoding="ascii") as text:
                text.write("2.1 broken 25 1\n0 0 1\n")
            self.assert_refused("broken.fap:", lambda: mien.Face().animate(fap=file).surface())

    def test_a_filter_of_ones_own_raises(self):
        face = mien.vtkPDEFaceFilter()
        reader = mien.vtkBoundaryCurveReader()
        reader.SetFileName("/none.vtp")
        face.SetInputConnection(reader.GetOutputPort())
        self.assert_refused("/none.vtp", lambda: mien.update(face))

    def test_a_face_can_be_used_again_after_an_error(self):
        face = mien.Face().animate("joyful")
        for _ in range(2):
            self.assert_refused("joyful", face.surface)
        self.assertEqual(len(mien.Face().surface().points), 2296)

    def test_nothing_is_printed(self):
        script = "import mien\ntry: mien.Face().animate('joyful').surface()\nexcept mien.Error: pass"
        run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
        self.assertEqual(run.stdout + run.stderr, "")


if __name__ == "__main__":
    unittest.main()
