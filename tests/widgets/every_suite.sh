#!/bin/sh
# The suites of a GoogleTest program are exactly these: every_suite.sh PROGRAM SUITE...
program=$1
shift
known=$(printf '%s\n' "$@" | sort)
held=$("$program" --gtest_list_tests | sed -n 's/^\([A-Za-z]*\)\.$/\1/p' | sort)
[ "$known" = "$held" ] || { echo "named: $known"; echo "held: $held"; exit 1; }
