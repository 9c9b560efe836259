#!/bin/sh
# Mien Studio asked for a picture that cannot be: one sentence, its exit code, no file. picture_faults.sh MIEN-STUDIO
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
expect() {
  code=$1 part=$2
  shift 2
  said=$("$@" 2>&1)
  [ $? -eq "$code" ] || { echo "not exit code $code: $said"; exit 1; }
  case $said in *"$part"*) ;; *) echo "without '$part': $said"; exit 1 ;; esac
  [ "$(printf '%s\n' "$said" | wc -l)" -eq 1 ] || { echo "not one line: $said"; exit 1; }
  [ -z "$(ls "$folder")" ] || { echo "written: $(ls "$folder")"; exit 1; }
}
expect 2 "s.gif: pictures of the window are .png" "$1" --picture "$folder/s.gif"
expect 1 "no_such.fap" "$1" --picture "$folder/s.png" no_such.fap
expect 1 "no_such.json" "$1" --picture "$folder/s.png" --fat no_such.json
