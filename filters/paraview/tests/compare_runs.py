"""Compares what measure_faces.py found with different numbers of ranks; exit code 1 when it differs.

usage: compare_runs.py ONE.json OTHER.json ...
"""
import json
import sys

tolerance = 1e-12  # of the largest number of an output: sums over parts are rounded in another order


def read(name):
    with open(name, encoding="utf-8") as file:
        return json.load(file)


def differences(one, other):
    for name, output in one.items():
        a, b = output["totals"], other[name]["totals"]
        scale = max(abs(x) for x in a)
        if len(a) != len(b) or any(not abs(x - y) <= tolerance * scale for x, y in zip(a, b)):
            yield "%s: %s with one rank, %s with %s" % (name, a, b, other[name]["parts"])


def faults_of_parts(run, ranks):
    """Surfaces are shared out: every rank has cells, and no two the same extent."""
    for name, output in run.items():
        if not output["extents"] or name == "mode 2" and ranks == 1:
            continue
        extents = [tuple(extent) for extent in output["extents"]]
        if len(extents) != ranks or min(output["parts"]) == 0:
            yield "%s: parts of %s cells" % (name, output["parts"])
        if len(set(extents)) != ranks:
            yield "%s: ranks share an extent: %s" % (name, extents)


def faults_of_motion(run):
    """The clock moves the face."""
    area = [run[name]["totals"][2] for name in ("frame 0", "frame 60", "frame 150")]
    if len(set(area)) != 3:
        yield "the surface does not change with time: areas %s" % area


def main(names):
    runs = [read(name) for name in names]
    faults = list(faults_of_motion(runs[0]))
    for run in runs:
        ranks = len(run["fine face"]["parts"])
        found = list(faults_of_parts(run, ranks)) + list(differences(runs[0], run))
        print("%d rank%s: %d outputs, parts of the fine face %s cells%s" % (
            ranks, "s"[:ranks > 1], len(run), [int(x) for x in run["fine face"]["parts"]], ", equal" if not found else ""))
        faults += found
    for fault in faults:
        print("compare_runs: " + fault, file=sys.stderr)
    return 1 if faults else 0


sys.exit(main(sys.argv[1:]))
