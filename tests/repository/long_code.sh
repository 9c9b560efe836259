#!/bin/sh
# Lists files of 400 lines and more and functions of more than 40 lines.
# A function starts at a line in column one that ends with `{` and ends at the next `}` in column one.
# usage: long_code.sh SOURCE_FOLDER
cd "${1:?the source folder is missing}" || exit 1
# shellcheck source=tests/repository/sources.sh
. ./tests/repository/sources.sh
found=$(project_files \( -name '*.h' -o -name '*.cxx' \) | sort | tr '\n' '\0' | xargs -0 awk '
  FNR == 1 { start = 0 }
  FNR == 400 { printf "%s: 400 lines or more\n", FILENAME }
  /^[A-Za-z:~].*\)[^=]*\{$/ && !/ = / { start = FNR; name = $0 }
  /^\}/ && start { if (FNR - start > 40) printf "%s:%d: %d lines: %s\n", FILENAME, start, FNR - start + 1, name; start = 0 }')
[ -z "$found" ] && exit 0
echo "$found"
echo "long_code: split these" >&2
exit 1
