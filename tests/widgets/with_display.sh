#!/bin/sh
# Runs a program on a private virtual display: with_display.sh PROGRAM [ARGUMENT...]
# Leaves with 77 (skipped) when there is no Xvfb. xvfb-run would need the package xauth as well.
command -v Xvfb >/dev/null || { echo "skipped: there is no Xvfb (package xvfb)"; exit 77; }
folder=$(mktemp -d) || exit 1
mkfifo "$folder/display"
Xvfb -displayfd 3 -screen 0 1920x1200x24 -nolisten tcp 3>"$folder/display" 2>"$folder/log" &
server=$!
trap 'kill $server 2>/dev/null; wait $server 2>/dev/null; rm -rf "$folder"' EXIT
read -r number <"$folder/display" || { cat "$folder/log"; exit 1; }
chmod 700 "$folder"
DISPLAY=":$number" QT_QPA_PLATFORM=xcb XDG_RUNTIME_DIR="$folder" "$@"
