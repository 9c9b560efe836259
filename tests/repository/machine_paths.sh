#!/bin/sh
# Checks that no file of the project names a folder of one particular machine.
# usage: machine_paths.sh SOURCE_FOLDER
cd "${1:?the source folder is missing}" || exit 1
# shellcheck source=tests/repository/sources.sh
. ./tests/repository/sources.sh
found=$(project_files | tr '\n' '\0' |
  xargs -0 grep -InE '(^|[^A-Za-z0-9_.~>$})/-])/(home|root|work|Users|srv|mnt)/' -- 2>/dev/null)
[ -z "$found" ] && exit 0
echo "$found"
echo "machine_paths: name files relative to the project, not by one machine's folders" >&2
exit 1
