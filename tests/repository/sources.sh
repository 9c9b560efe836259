# shellcheck shell=sh disable=SC2120
# Sourced by the checks of this folder: lists the project's own files, leaving out build trees and output.
project_files() {
  find . \( -path ./build -o -path ./out -o -path ./.git -o -name '.git' \) -prune -o -type f "$@" -print
}
