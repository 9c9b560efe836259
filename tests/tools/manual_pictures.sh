#!/bin/sh
# Draws the pictures of Mien Studio that README.md and the manual show: manual_pictures.sh STUDIO_PICTURE FOLDER [SCAN.ply]
# SCAN is the head of the Curves and scan dock; without it that picture is left alone.
tool=$(realpath "$1") || exit 1
folder=$(realpath "$2") || exit 1
scan=$3
display=$(dirname "$(realpath "$0")")/../widgets/with_display.sh

draw() {
  name=$1 size=$2
  shift 2
  sh "$display" "$tool" "$folder/$name.png" "$size" scale=0.75 "$@" || exit 1
}

draw studio 1280x800 expression=joy
draw studio_compare 1280x800 "compare=Keep this state" expression=joy choose=compareArrows:2 wait=2000
draw dock_vectors 1280x800 expression=joy dock=vectorsDock wait=3000
draw dock_spectrum 1280x800 dock=spectrumDock choose=spectrumMode:2
draw dock_smoothing 1280x1060 dock=smoothingDock press=smoothingAllSchemes wait=9000 choose=smoothingMeasure:1
draw dock_continuity 1280x800 expression=joy dock=continuityDock choose=continuityFace:4 row=6
draw dock_deformation 1280x800 expression=joy dock=deformationDock press=deformationRegions cell=12:4 wait=1500
draw dock_texture 1280x800 expression=joy dock=textureDock press=texturePainted wait=2000
if [ -n "$scan" ]; then
  cd "$(dirname "$scan")" || exit 1 # the picture shows the file's name as it was given
  draw dock_curves 1280x800 dock=curvesDock "scan=$(basename "$scan")" choose=scanDistances:1 wait=6000
fi
