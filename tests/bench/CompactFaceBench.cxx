/// Storing and reading a compact face, beside zlib on the same curves in single precision and a plain copy of them.
#include <benchmark/benchmark.h>

#include <cstring>
#include <vector>

#include "CompactFace.h"
#include "FaceFiles.h"
#include "vtkNew.h"
#include "vtkZLibDataCompressor.h"

using namespace mien;

namespace {

std::vector<float> singlePrecision() {
  const FaceCurves face = genericFace();
  std::vector<float> values(face.curves.points.size());
  Eigen::Map<Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>>(values.data(), face.curves.points.rows(), 3) =
      face.curves.points.cast<float>();
  return values;
}

void encodeFace(benchmark::State& state) {
  const FaceCurves face = genericFace();
  std::string bytes;
  for (auto _ : state) benchmark::DoNotOptimize(encodeCompactFace(face, "", 0.1, bytes));
  state.counters["bytes"] = static_cast<double>(bytes.size());
}

void decodeFace(benchmark::State& state) {
  std::string bytes;
  encodeCompactFace(genericFace(), "", 0.1, bytes);
  CompactFace compact;
  for (auto _ : state) benchmark::DoNotOptimize(decodeCompactFace(bytes, compact));
}

std::vector<unsigned char> zipped(const std::vector<float>& values) {
  vtkNew<vtkZLibDataCompressor> zlib;
  zlib->SetCompressionLevel(9);
  const std::size_t size = values.size() * sizeof(float);
  std::vector<unsigned char> packed(zlib->GetMaximumCompressionSpace(size));
  packed.resize(
      zlib->Compress(reinterpret_cast<const unsigned char*>(values.data()), size, packed.data(), packed.size()));
  return packed;
}

void zlibPack(benchmark::State& state) {
  const std::vector<float> values = singlePrecision();
  for (auto _ : state) benchmark::DoNotOptimize(zipped(values).data());
  state.counters["bytes"] = static_cast<double>(zipped(values).size());
}

void zlibUnpack(benchmark::State& state) {
  std::vector<float> values = singlePrecision();
  const std::vector<unsigned char> packed = zipped(values);
  vtkNew<vtkZLibDataCompressor> zlib;
  for (auto _ : state)
    benchmark::DoNotOptimize(zlib->Uncompress(
        packed.data(), packed.size(), reinterpret_cast<unsigned char*>(values.data()), values.size() * sizeof(float)));
}

void copyCurves(benchmark::State& state) {
  const std::vector<float> values = singlePrecision();
  std::vector<float> copy(values.size());
  for (auto _ : state) {
    std::memcpy(copy.data(), values.data(), values.size() * sizeof(float));
    benchmark::DoNotOptimize(copy.data());
    benchmark::ClobberMemory();
  }
}

}  // namespace

BENCHMARK(encodeFace)->Unit(benchmark::kMicrosecond);
BENCHMARK(zlibPack)->Unit(benchmark::kMicrosecond);
BENCHMARK(decodeFace)->Unit(benchmark::kMicrosecond);
BENCHMARK(zlibUnpack)->Unit(benchmark::kMicrosecond);
BENCHMARK(copyCurves)->Unit(benchmark::kMicrosecond);
