#!/bin/sh
# Builds the reference of the public headers and the manual with Doxygen, and fails on any warning. Every class, free
# function and setter of a filter must be explained; members of the mathematics' own structures may speak by their
# names, and VTK explains its virtual functions.
# usage: reference.sh SOURCE_FOLDER OUTPUT_FOLDER
cd "${1:?the source folder is missing}" || exit 1
output=${2:?the output folder is missing}
command -v doxygen >/dev/null || { echo "reference: doxygen is not installed; ./dev reference installs it" >&2; exit 77; }
mkdir -p "$output" || exit 1

# What needs no comment of its own.
speaks_by_name='(variable|typedef|enumeration|function|enumvalue)\) of (struct|class|namespace) mien::'
constant='(variable|typedef)\) of namespace mien '
of_vtk='Member ((New|PrintSelf|GetMTime|ProcessRequest|CanReadFile|WriteData|Request[A-Za-z]*|Compute[A-Za-z]*'
of_vtk="$of_vtk|Fill(In|Out)put[A-Za-z]*|~?vtk[A-Za-z0-9]*)\\()"

{ cat doc/Doxyfile; echo "OUTPUT_DIRECTORY = \"$output\""; } | doxygen - >"$output/doxygen.log" 2>&1
[ -s "$output/index.html" ] || { cat "$output/doxygen.log"; echo "reference: doxygen made no pages" >&2; exit 1; }
warnings=$(grep 'warning:\|error:' "$output/doxygen.log" | grep -vE "$speaks_by_name|$constant|$of_vtk")
[ -z "$warnings" ] && exit 0
echo "$warnings"
echo "reference: Doxygen has something to say about these comments" >&2
exit 1
