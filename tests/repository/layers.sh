#!/bin/sh
# Checks that every arrow points down: no VTK or Qt in filters/core, no Qt in filters, OpenMesh in acquisition only.
# usage: layers.sh SOURCE_FOLDER
cd "${1:?the source folder is missing}" || exit 1
status=0

# forbid RULE PATTERN FOLDER [grep options]: prints every #include in FOLDER that matches PATTERN.
forbid() {
  rule=$1; pattern=$2; folder=$3; shift 3
  [ -d "$folder" ] || return 0
  if grep -rnE --include='*.h' --include='*.cxx' "$@" "^ *# *include *[<\"]$pattern" "$folder"; then
    echo "layers: $rule" >&2
    status=1
  fi
}

forbid "filters/core includes VTK; the mathematics must not know it" 'vtk' filters/core
forbid "filters/core reads files; parse from strings" '(fstream|cstdio|filesystem)[>"]' filters/core
forbid "filters include Qt; it belongs into widgets and app" '(Q[A-Z]|Qt|qwt)' filters
forbid "OpenMesh belongs into filters/acquisition" 'OpenMesh' filters --exclude-dir=acquisition
forbid "OpenMesh belongs into filters/acquisition" 'OpenMesh' widgets
forbid "OpenMesh belongs into filters/acquisition" 'OpenMesh' app

# headers FOLDER: a pattern for including a header of FOLDER, by its name or with folders before it. Names that
# filters have too are left out: they need a folder before them, which the last pattern sees.
headers() {
  find "$1" -name '*.h' | sed 's|.*/||' | sort -u | while read -r name; do
    [ -n "$(find filters -name "$name")" ] || echo "$name"
  done | sed 's/[.]/[.]/g' | paste -sd '|' -
}
above() { echo "(([^\">]*/)?($(headers "$1"))|[^\">]*$1/[^\">]*)[\">]"; }

forbid "filters include a program's headers" "$(above app)" filters
forbid "filters include headers of widgets" "$(above widgets)" filters
forbid "widgets include a program's headers" "$(above app)" widgets

# The rooms of filters/core, lowest first, as its CMakeLists.txt lists them: a room knows only those before it.
rooms=$(sed -n 's/^set(rooms \(.*\))$/\1/p' filters/core/CMakeLists.txt)
[ -n "$rooms" ] || { echo "layers: filters/core/CMakeLists.txt names no rooms" >&2; status=1; }
lower=
for room in $rooms; do
  for other in $rooms; do
    case " $lower $room " in *" $other "*) continue ;; esac
    names=$(find "filters/core/$other" -name '*.h' | sed 's|.*/||; s|[.]|[.]|' | paste -sd '|' -)
    forbid "filters/core/$room must not know filters/core/$other" "($names)\"" "filters/core/$room"
  done
  lower="$lower $room"
done
exit $status
