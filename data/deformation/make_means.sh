#!/bin/sh
# Makes the mean tables of this folder from recordings subjectNN_EXPRESSION.csv.
# usage: make_means.sh PROGRAM RECORDINGS_FOLDER    (PROGRAM: build/release/bin/mean_table)
set -eu
program=$1 recordings=$2
for expression in anger disgust fear joy sadness surprise; do
  "$program" "Mean $expression of 12 subjects with standard deviations, pupil units; regions as in regions.json.
From synthetic recordings derived from ICT-FaceKit (MIT, data/licences/ICT-FaceKit.txt)." \
    "$recordings"/subject*_$expression.csv >"$(dirname "$0")/$expression.csv.part"
  mv "$(dirname "$0")/$expression.csv.part" "$(dirname "$0")/$expression.csv"
done
