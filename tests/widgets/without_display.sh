#!/bin/sh
# Mien Studio without a display: one sentence and exit code 1. without_display.sh MIEN-STUDIO
said=$(env -u DISPLAY -u WAYLAND_DISPLAY QT_QPA_PLATFORM=xcb "$1" 2>&1)
code=$?
[ $code -eq 1 ] || { echo "exit code $code, not 1"; exit 1; }
[ "$(printf '%s\n' "$said" | wc -l)" -eq 1 ] || { echo "not one line: $said"; exit 1; }
case $said in "mien-studio: there is no display"*) ;; *) echo "unexpected: $said"; exit 1 ;; esac
env -u DISPLAY -u WAYLAND_DISPLAY "$1" --help | grep -q '\.fap' || { echo "no help without a display"; exit 1; }
