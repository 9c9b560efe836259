#include "Remarks.h"

#include <algorithm>
#include <cmath>
#include <iostream>

#include "AnimationTextFile.h"
#include "Counted.h"
#include "FAPList.h"
#include "FacePipeline.h"
#include "vtkFAPAnimationFilter.h"
#include "vtkFAPReader.h"

namespace mien {

namespace {

constexpr double visibleContact = 0.05;  ///< mm; less is lips and lids that just touch
constexpr double visiblePush = 0.5;      ///< mm; less is what curves near a moving lip or lid do in any lively face
constexpr double visibleShare = 0.99;    ///< of the movement; more is not seen

double oneDecimal(double mm) {
  return std::round(mm * 10.0) / 10.0;
}

/// Says how far curves gave way to each other, and what the face kept of its movement where that was not enough.
void printRoom(const FacePipeline& pipeline, const std::string& lead) {
  const double pushed = pipeline.animation()->GetLargestPushed();
  if (pushed >= visiblePush)
    std::cerr << lead << "curves without room for these FAPs gave way by up to " << oneDecimal(pushed)
              << " mm; smaller values leave every curve its way\n";
  const double kept = pipeline.animation()->GetSmallestKeptShare();
  if (kept <= visibleShare)
    std::cerr << lead << "curves would cross, so the whole face keeps only " << std::lround(100.0 * kept)
              << " % of its movement; smaller values, or contacts in the animation table, make room\n";
}

}  // namespace

void ContactCount::add(const FacePipeline& pipeline) {
  const double depth = pipeline.animation()->GetContactClamped();
  ++frames;
  clamped += depth >= visibleContact;
  largest = std::max(largest, depth);
}

void printRemarks(const FacePipeline& pipeline) {
  ContactCount contact;
  contact.add(pipeline);
  printRemarks(pipeline, contact);
}

void printRemarks(const FacePipeline& pipeline, const ContactCount& contact) {
  const std::string file = shownAnimationName(pipeline.state().fapFile);
  if (!file.empty())
    for (const std::string& warning : pipeline.frames()->GetWarnings()) std::cerr << "mien: " << warning << "\n";
  const std::string lead = "mien: " + (file.empty() ? "" : file + ": ");
  const std::vector<int> ignored = pipeline.animation()->GetIgnoredFAPs();
  if (!ignored.empty()) std::cerr << lead << "these FAPs move nothing on this face: " << listOfFAPs(ignored) << "\n";
  if (contact.clamped > 0)
    std::cerr << lead << "lips or lids are pressed together"
              << (contact.frames > 1
                      ? " in " + std::to_string(contact.clamped) + " of " + counted(contact.frames, "frame")
                      : "")
              << "; crossings of up to " << oneDecimal(contact.largest) << " mm were undone\n";
  printRoom(pipeline, lead);
}

}  // namespace mien
