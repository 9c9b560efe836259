"""Measures every case of a study; the processes share the work. The table is that of `mien ensemble`, to the byte.

usage: mpirun -np 8 pvbatch --sym study.py STUDY.json TABLE.csv
After Ctrl-C, a kill or a power cut the same command, with as many processes or others, goes on from there.
The plugin is that of the build tree, or the file that MIEN_PLUGIN names.
"""
import os
import sys

from paraview import simple
from paraview.servermanager import vtkProcessModule
from vtkmodules.vtkParallelCore import vtkMultiProcessController

root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")
plugin = os.environ.get("MIEN_PLUGIN", os.path.join(root, "build/paraview/plugin/lib/paraview-5.11/plugins/Mien/Mien.so"))
simple.LoadPlugin(plugin, remote=False, ns=globals())

if len(sys.argv) != 3:
    sys.exit(__doc__)
study, table = sys.argv[1:]
processes = vtkMultiProcessController.GetGlobalController()
if processes.GetNumberOfProcesses() > 1 and not vtkProcessModule.GetProcessModule().GetSymmetricMPIMode():
    sys.exit("study.py runs in every process: give pvbatch the option --sym")


def version(name):
    """What changes whenever a file is written anew."""
    return os.stat(name).st_ino if os.path.exists(name) else None


before = version(table)
source = MienFaceStudy(StudyFileName=study, TableFileName=table)
source.UpdatePipeline()
print("process %d of %d: %d rows" % (processes.GetLocalProcessId(), processes.GetNumberOfProcesses(),
                                     source.GetClientSideObject().GetOutputDataObject(0).GetNumberOfRows()), flush=True)

processes.Barrier()  # all rows are written
source.InvokeCommand("WriteTable")  # by the first process
processes.Barrier()
if version(table) == before:
    sys.exit(1)  # its error says why
