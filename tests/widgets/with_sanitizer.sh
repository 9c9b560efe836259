#!/bin/sh
# Runs a program with AddressSanitizer's memory in place of the C library's: with_sanitizer.sh PROGRAM [ARGUMENT...]
# Memory that is freed twice, damaged or used by the C library after it was freed ends the program; memory of ours that is
# never freed makes this one fail. Our code is as it is, not built anew: reads and writes within it are not checked. Without
# the library the program runs plain. Leaks of other libraries, such as Mesa's, are theirs.
library=$(c++ -print-file-name=libasan.so)
[ -e "$library" ] || { echo "no AddressSanitizer here: plain"; exec "$@"; }
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
LSAN_OPTIONS=exitcode=0 ASAN_OPTIONS=detect_leaks=1:log_path="$folder/log" env LD_PRELOAD="$library" "$@"
status=$?
cat "$folder"/log* 2>/dev/null
if grep -qE "libMien|/$(basename "$1")" "$folder"/log* 2>/dev/null; then echo "memory of ours: see above"; exit 1; fi
exit $status
