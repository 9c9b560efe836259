#pragma once

namespace mien {

class FacePipeline;

/// In how many frames lips or lids met and were kept from crossing, and by how much at most.
struct ContactCount {
  int frames = 0, clamped = 0;  ///< looked at, and with contact
  double largest = 0.0;         ///< mm

  /// Counts the frame that the pipeline shows.
  void add(const FacePipeline& pipeline);
};

/// Says on stderr, once at the end of a command, what was accepted or left out on the way: oddities of the animation
/// file and FAPs that the face has no part for.
/// @param contact  of the frames shown; without it that of the last one
void printRemarks(const FacePipeline& pipeline);
void printRemarks(const FacePipeline& pipeline, const ContactCount& contact);

}  // namespace mien
