#pragma once

#include <cmath>

#include "AnimationData.h"
#include "FAPFrame.h"
#include "FaceAnimator.h"
#include "FaceFiles.h"

inline mien::FaceAnimator genericAnimator() {
  mien::AnimationTable table;
  mien::readAnimationTable("", table);
  mien::FaceAnimator animator;
  animator.bind(genericFace(), table);
  return animator;
}

/// The frames of a long movement: a few FAPs of every region, never the same twice.
inline mien::FAPFrame movingFrame(int index) {
  mien::FAPFrame frame;
  for (const int fap : {19, 20, 31, 32, 33, 34, 41, 42, 51, 52, 53, 54, 59, 60})
    frame.setValue(fap, 120.0 * std::sin(0.1 * index + fap));
  return frame;
}
