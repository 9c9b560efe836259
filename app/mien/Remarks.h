#pragma once

namespace mien {

class FacePipeline;

/// Says on stderr, once at the end of a command, what was accepted or left out on the way: oddities of the animation
/// file and FAPs that the face has no part for.
void printRemarks(const FacePipeline& pipeline);

}  // namespace mien
