"""Checks that every proxy of the plugin can be made, is documented, and has the defaults of its class; that files open by
their ending; and that errors are reported with the file's name.

usage: pvbatch check_proxies.py PLUGIN.so ANIMATION.fap FACE.vtp BROKEN.fap
"""
import sys

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkObject

faults = []


def check(holds, sentence):
    if not holds:
        faults.append(sentence)


def described(instance):
    """What PrintSelf says of the class's own properties."""
    volatile = ("Debug", "Modified Time", "Reference Count", "Registered Events", "Executive", "Information", "Progress",
                "Error", "Abort", "Container", "Input", "Output", "Number Of")
    lines = [line.strip() for line in str(instance).splitlines()]
    lines = [line.replace(" (none)", "").replace(" (the generic face)", "") for line in lines]  # as an empty name is
    return [line for line in lines if ":" in line and not line.startswith(volatile) and "0x" not in line]


def bare(class_name):
    """An object of a class with the values that its constructor gives."""
    name = "Bare" + class_name
    manager = servermanager.ProxyManager().SMProxyManager
    manager.GetProxyDefinitionManager().LoadConfigurationXMLFromString(
        '<ServerManagerConfiguration><ProxyGroup name="bare"><SourceProxy name="%s" class="%s" /></ProxyGroup>'
        "</ServerManagerConfiguration>" % (name, class_name))
    proxy = manager.NewProxy("bare", name)
    proxy.UpdateVTKObjects()
    return proxy.GetClientSideObject(), proxy


def proxies_of(group):
    definitions = servermanager.ProxyManager().SMProxyManager.GetProxyDefinitionManager()
    iterator = definitions.NewSingleGroupIterator(group)
    while not iterator.IsDoneWithTraversal():
        if iterator.GetProxyName().startswith("Mien"):
            yield iterator.GetProxyName()
        iterator.GoToNextItem()


def check_documentation(name, proxy):
    check(proxy.GetDocumentation() and proxy.GetDocumentation().GetDescription().strip(), name + " has no documentation")
    iterator = proxy.NewPropertyIterator()
    iterator.Begin()
    while not iterator.IsAtEnd():
        text = iterator.GetProperty().GetDocumentation()
        own = iterator.GetKey() != "TimestepValues"
        check(not own or text and text.GetDescription().strip(), "%s.%s has no documentation" % (name, iterator.GetKey()))
        iterator.Next()


def check_proxy(group, name):
    manager = servermanager.ProxyManager().SMProxyManager
    proxy = manager.NewProxy(group, name)
    proxy.UpdateVTKObjects()
    check_documentation(name, proxy)
    instance = proxy.GetClientSideObject()
    check(instance is not None, name + " cannot be made")
    plain, keep = bare(proxy.GetVTKClassName())
    chosen = {"MienFDTSource": ["FileName: joy"], "MienFacePolygons": ["Reversed: on"]}.get(name, [])  # its purpose here
    differing = [line for line in described(instance) if line not in described(plain) and line not in chosen]
    check(not differing, "%s: %s, but the class says %s" % (
        name, differing, [line for line in described(plain) if line not in described(instance)]))
    return len(described(instance))


def check_files(animation, face):
    frames = simple.OpenDataFile(animation)
    check(frames.SMProxy.GetXMLName() == "MienFAPReader", "a .fap file opens as " + frames.SMProxy.GetXMLName())
    check(len(frames.TimestepValues) > 1, "an opened .fap file has no time steps")
    scene = simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    check(list(scene.TimeKeeper.TimestepValues) == list(frames.TimestepValues), "the time line is not the animation's")
    curves = simple.MienBoundaryCurveReader(FileName=face)
    curves.UpdatePipeline()
    check(curves.GetDataInformation().GetNumberOfCells() == 29, "a face has %d curves" % curves.GetDataInformation().GetNumberOfCells())


def first_error_of(proxy):
    messages = []

    def note(_, __, message):
        messages.append(message)
    note.CallDataType = "string0"
    proxy.GetClientSideObject().AddObserver("ErrorEvent", note)
    proxy.UpdatePipeline()
    return messages[0] if messages else ""


def check_errors(broken):
    message = first_error_of(simple.MienFAPReader(FileName=broken))
    check(broken + ":" in message, "a broken file is reported as: " + message)
    message = first_error_of(simple.MienBoundaryCurveReader(FileName=broken))
    check(broken + ":" in message, "a file that is no face is reported as: " + message)
    face = simple.MienPDEFace(Input=simple.MienGenericFace(), Scheme="four-curve", Smoothing=50.0)
    message = first_error_of(face)
    check("250" in message, "a(N + 1) past what the scheme bears is reported as: " + message)
    check(face.GetDataInformation().GetNumberOfCells() == 0, "a refused surface has cells")


def main(plugin, animation, face, broken):
    simple.LoadPlugin(plugin, remote=False, ns=simple.__dict__)
    lines = count = 0
    for group in ("sources", "filters"):
        for name in proxies_of(group):
            lines += check_proxy(group, name)
            count += 1
    check(count >= 20 and lines >= 80, "only %d proxies with %d lines were compared" % (count, lines))
    check_files(animation, face)
    vtkObject.GlobalWarningDisplayOff()
    check_errors(broken)
    print("%d proxies, %d values as their classes have them" % (count, lines))
    for fault in faults:
        print("check_proxies: " + fault, file=sys.stderr)
    sys.stderr.flush()
    sys.exit(1 if faults else 0)


main(*sys.argv[1:])
