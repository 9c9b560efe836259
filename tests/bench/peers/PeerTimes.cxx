#include "PeerTimes.h"

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace {

/// Processor time, which other programs on the machine do not disturb, or where threads share the work the clock's.
enum class Clock { Processor, Wall };

struct Known {
  const char* benchmark;
  const char* words;
  bool own;
  double target = 0.0;  ///< ms
  Clock clock = Clock::Processor;
};

struct KnownGroup {
  const char* heading;
  const char* reference;  ///< a benchmark
  const char* referenceWords;
  std::vector<Known> members;
};

const std::vector<KnownGroup> knownGroups = {
    {"One frame of 56 × 40 points",
     "frameToSurface/fourCurve",
     "Mien's frame",
     {{"frameToSurface/fourCurve", "Mien, four-curve, core: points and normals", true, 0.045},
      {"frameToSurface/spline", "Mien, spline, core: points and normals", true, 0.15},
      {"frameThroughPipeline/fourCurve", "Mien, four-curve, VTK pipeline", true, 0.25},
      {"frameThroughPipeline/spline", "Mien, spline, VTK pipeline", true, 0.25},
      {"memcpyOfOutput", "memcpy of points and normals", false},
      {"peer/blendshapes/points", "53 blendshapes: points", false},
      {"peer/blendshapes/normals", "53 blendshapes: points and normals of polygons", false},
      {"peer/VTK/parametricSource", "VTK's parametric ellipsoid: points and normals", false},
      {"peer/VTK/polyDataNormals", "vtkPolyDataNormals of the face: normals", false},
      {"peer/thinPlate/still", "VTK's thin-plate spline, 68 points kept: points", false},
      {"peer/thinPlate/moving", "VTK's thin-plate spline, 68 points set: points", false},
      {"peer/finiteDifferences/solution", "Finite differences, one patch: solution", false},
      {"peer/finiteDifferences/factorisation", "Finite differences, one patch: LU factors", false}}},
    {"One surface of 1,000 × 1,000 points with normals",
     "memcpyOfOutput/1000/1000/real_time",
     "memcpy",
     {{"memcpyOfOutput/1000/1000/real_time", "memcpy of points and normals", false},
      {"coreSurface/fourCurve/1000/1000/real_time", "Mien, four-curve, core", true},
      {"pipelineSurface/rows:1000/columns:1000/threads:1/real_time", "Mien, four-curve, VTK pipeline, one thread", true,
       0.0, Clock::Wall},
      {"pipelineSurface/rows:1000/columns:1000/threads:2/real_time", "Mien, four-curve, VTK pipeline, two threads",
       true, 0.0, Clock::Wall}}},
    {"A point of four-curve surfaces of ever more points: time of 1,000,000",
     "peer/pointCount/1000/min_time:2.000",
     "1,000 × 1,000",
     {{"peer/pointCount/125/min_time:2.000", "125 × 125", true},
      {"peer/pointCount/250/min_time:2.000", "250 × 250", true},
      {"peer/pointCount/500/min_time:2.000", "500 × 500", true},
      {"peer/pointCount/1000/min_time:2.000", "1,000 × 1,000", true},
      {"peer/pointCount/2000/min_time:2.000", "2,000 × 2,000", true},
      {"peer/pointCount/4000/min_time:2.000", "4,000 × 4,000", true},
      {"peer/pointCount/8000/min_time:2.000", "8,000 × 8,000", true}}},
    {"Whole tasks, one thread",
     "",
     "",
     {{"thousandFrames/fourCurve", "1,000 frames of .fap, four-curve, 56 × 40", true, 100.0},
      {"thousandFrames/spline", "1,000 frames of .fap, spline, 56 × 40", true, 100.0},
      {"sweep/fourCurve/real_time", "Sweep of 50 a, four-curve, 112 × 80", true, 500.0},
      {"sweep/curvature/real_time", "Sweep of 50 a, curvature, 112 × 80", true, 500.0},
      {"sweep/spline/real_time", "Sweep of 50 a, spline, 112 × 80", true, 500.0},
      {"smoothTable", "Smooth deformation table, 100,000 points", true, 4.0}}}};

using Medians = std::map<std::string, nlohmann::json>;

Medians mediansOf(const std::string& fileName) {
  std::ifstream file(fileName);
  const nlohmann::json all = nlohmann::json::parse(file, nullptr, false);
  if (!all.contains("benchmarks"))
    throw std::runtime_error("'" + fileName + "' is no file of peers_bench's; './dev bench --peers' writes one");
  Medians medians;
  for (const nlohmann::json& one : all["benchmarks"])
    if (one.value("aggregate_name", "") == "median") medians[one.value("run_name", "")] = one;
  return medians;
}

/// Of one run; where points are counted, of a million of them.
double millisecondsOf(const nlohmann::json& median, Clock clock) {
  if (const double rate = median.value("items_per_second", 0.0); rate > 0.0) return 1e9 / rate;
  const std::string unit = median.value("time_unit", "ns");
  return median.value(clock == Clock::Wall ? "real_time" : "cpu_time", 0.0) * (unit == "ns"   ? 1e-6
                                                                               : unit == "us" ? 1e-3
                                                                                              : 1.0);
}

}  // namespace

std::vector<PeerGroup> readPeerTimes(const std::string& fileName) {
  const Medians medians = mediansOf(fileName);
  std::vector<PeerGroup> groups;
  for (const KnownGroup& known : knownGroups) {
    PeerGroup group{known.heading, known.referenceWords, {}};
    const auto reference = medians.find(known.reference);
    for (const Known& member : known.members) {
      const auto found = medians.find(member.benchmark);
      if (found == medians.end()) continue;
      const double time = millisecondsOf(found->second, member.clock);
      // Against the clock that measured the member.
      const double unit = reference == medians.end() ? 0.0 : millisecondsOf(reference->second, member.clock);
      group.times.push_back({member.words, member.own, time, unit > 0.0 ? time / unit : 0.0, member.target});
    }
    if (!group.times.empty()) groups.push_back(group);
  }
  return groups;
}
