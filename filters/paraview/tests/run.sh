#!/usr/bin/env bash
# Tests the plugin in ParaView: its proxies, and its numbers in one, two and four processes.
# usage: run.sh PARAVIEW_PREFIX PLUGIN.so
set -euo pipefail
prefix="$(cd "${1:?the folder of ParaView is missing}" && pwd)"
plugin="$(realpath "${2:?the plugin is missing}")"
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
readonly scripts=filters/paraview/tests data="$PWD/data" limit=300
results="$(mktemp -d)"; trap 'rm -rf "$results"' EXIT

export PYTHONPATH="$prefix/lib/python3/dist-packages" PYTHONDONTWRITEBYTECODE=1
export OMP_NUM_THREADS=1 OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_btl_base_warn_component_unused=0
readonly pvbatch="$prefix/bin/pvbatch"

run() { timeout "$limit" "$@"; }
in_ranks() {
  local as_root=(); [[ $EUID -ne 0 ]] || as_root=(--allow-run-as-root)
  run mpirun "${as_root[@]}" --oversubscribe -np "$@"
}
failed() { echo "test-paraview: $*" >&2; exit 1; }

head -c 300 "$data/animation/demo.fap" >"$results/broken.fap"
run "$pvbatch" "$scripts/check_proxies.py" "$plugin" "$data/animation/demo.fap" "$data/faces/generic.vtp" \
  "$results/broken.fap" >"$results/proxies.log" 2>&1 || { cat "$results/proxies.log"; failed "proxies and files: see above"; }
grep ' proxies, ' "$results/proxies.log"

for ranks in 1 2 4; do
  in_ranks "$ranks" "$pvbatch" --sym "$scripts/measure_faces.py" "$plugin" "$data/animation/demo.fap" \
    "$results/$ranks.json" >"$results/$ranks.log" 2>&1 || { cat "$results/$ranks.log"; failed "$ranks ranks: see above"; }
  if grep -E 'ERR|Warning' "$results/$ranks.log"; then failed "$ranks ranks: errors were reported, see above"; fi
done
python3 "$scripts/compare_runs.py" "$results"/{1,2,4}.json || failed "ranks differ: see above"

# A study: the table of one, two and four processes, and after kills, is that of one.
study() {  # study RANKS TABLE
  MIEN_PLUGIN="$plugin" in_ranks "$1" "$pvbatch" --sym doc/examples/paraview/study.py "$scripts/study.json" "$2" \
    >"$results/study.log" 2>&1
}
for ranks in 1 2 4; do
  study "$ranks" "$results/table$ranks.csv" || { cat "$results/study.log"; failed "study in $ranks ranks: see above"; }
  cmp "$results/table1.csv" "$results/table$ranks.csv" || failed "study in $ranks ranks: another table"
done

rows_kept() { cat "$1".rank*.part 2>/dev/null | grep -c '^[0-9].*,$' || true; }

# Killed at random moments of its work; no row may be lost, and none computed twice.
table="$results/killed.csv" kept=0 kills=0
while ((kills < 3)) && [[ ! -e "$table" ]]; do
  study 2 "$table" & program=$!
  until (($(rows_kept "$table") > kept)) || ! kill -0 "$program" 2>/dev/null; do sleep 0.1; done
  sleep "0.$((RANDOM % 10))"
  if pkill -KILL -f "pvbatch.*$table"; then kills=$((kills + 1)); fi
  wait "$program" || true
  [[ ! -e "$table" ]] || break
  now="$(rows_kept "$table")"
  ((now >= kept)) || failed "a killed study lost rows: $kept, then $now"
  kept=$now
done
twice="$(cat "$table".rank*.part 2>/dev/null | grep -o '^[0-9]*,' | sort | uniq -d | head -n 1)"
[[ -z "$twice" ]] || failed "a killed study computed case $twice twice"
study 2 "$table" || { cat "$results/study.log"; failed "a killed study: see above"; }
cmp "$results/table1.csv" "$table" || failed "a killed study: another table"
echo "study: $(grep -c '^[0-9]' "$table") cases, the same table in 1, 2 and 4 ranks and after $kills kills"
