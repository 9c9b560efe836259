#!/bin/sh
# Installs the build tree $1 into an empty prefix, moves it, builds the consumer against it, and runs it, the installed
# command and the installed Python package ($2: its interpreter, or nothing).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cmake --install "$1" --prefix "$folder/first" >"$folder/install.log"
mv "$folder/first" "$folder/prefix"
cmake -S "$here" -B "$folder/build" -DCMAKE_PREFIX_PATH="$folder/prefix" -DCMAKE_BUILD_TYPE=Debug >"$folder/configure.log" ||
  { cat "$folder/configure.log"; exit 1; }
cmake --build "$folder/build" >"$folder/build.log" || { cat "$folder/build.log"; exit 1; }
printed=$("$folder/build/face_consumer")
echo "consumer: $printed"
[ "${printed%% *}" = 2296 ]
"$folder/prefix/bin/mien" info >/dev/null
"$folder/prefix/bin/mien" animate --frames 1 -o "$folder/frames/" >/dev/null  # finds the animation beside it
if [ -n "${2:-}" ]; then
  moved=$(PYTHONPATH="$folder/prefix/lib/python3/dist-packages" "$2" -B -c \
    'import mien; print("%.6g" % mien.Face().animate("joy").motion().point_data["Magnitude"].max())')
  echo "python: $moved"
  [ "${printed##* }" = "$moved" ]
fi
