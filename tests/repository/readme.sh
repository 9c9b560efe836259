#!/bin/sh
# README.md is read first: it stays short, and says a thing once. What explains belongs into doc/manual.
# usage: readme.sh SOURCE_FOLDER
cd "${1:?the source folder is missing}" || exit 1
status=0
lines=$(wc -l <README.md)
[ "$lines" -le 160 ] || { echo "readme: README.md has $lines lines; move what explains to doc/manual" >&2; status=1; }
doubled=$(grep -E '^## |^- \*\*' README.md | cut -c1-24 | sort | uniq -d)
[ -z "$doubled" ] || { echo "readme: README.md has this twice: $doubled" >&2; status=1; }
exit $status
