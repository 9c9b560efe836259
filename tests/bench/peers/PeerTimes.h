#pragma once

#include <string>
#include <vector>

/// One bar: what was measured.
struct PeerTime {
  std::string words;
  bool own = false;           ///< Mien's, or else a peer's
  double milliseconds = 0.0;  ///< median
  double ratio = 0.0;         ///< to the group's reference; 0: none
  double target = 0.0;        ///< ms; 0: none
};

/// What is compared with each other.
struct PeerGroup {
  std::string heading;
  std::string reference;  ///< what ratios are to; empty: none
  std::vector<PeerTime> times;
};

/// The groups in a file of peers_bench's, with what was measured; throws std::runtime_error with one sentence.
std::vector<PeerGroup> readPeerTimes(const std::string& fileName);
