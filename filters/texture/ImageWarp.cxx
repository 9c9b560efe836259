#include "ImageWarp.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <type_traits>

#include "WarpLines.h"
#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

namespace mien {

namespace {

/// Values between two looks at the abort flag; about 0.05 s of work on one core.
constexpr vtkIdType valuesPerSlab = 1 << 22;
/// Columns that are taken out of the rows together: neighbours share cache lines.
constexpr int columnsPerTask = 16;

template <typename Scalar, typename Value>
Scalar rounded(Value value) {
  if constexpr (std::is_floating_point_v<Scalar>) {
    return static_cast<Scalar>(value);
  } else {
    constexpr Value low = static_cast<Value>(std::numeric_limits<Scalar>::lowest());
    constexpr Value high = static_cast<Value>(std::numeric_limits<Scalar>::max());
    if (!(value > low)) return std::numeric_limits<Scalar>::lowest();
    if (value >= high) return std::numeric_limits<Scalar>::max();
    return static_cast<Scalar>(std::floor(value + Value(0.5)));
  }
}

/// Both passes over one image. What float holds exactly is computed in float.
template <typename Scalar>
class Passes {
  using Value = std::conditional_t<(sizeof(Scalar) <= 2 || std::is_same_v<Scalar, float>), float, double>;

 public:
  Passes(const MeshWarp& warp, vtkImageData* image, bool closed, vtkAlgorithm* algorithm, vtkImageData* output)
      : warp_(warp),
        closed_(closed),
        algorithm_(algorithm),
        channels_(image->GetNumberOfScalarComponents()),
        source_(static_cast<const Scalar*>(image->GetScalarPointer())),
        output_(static_cast<Scalar*>(output->GetScalarPointer())) {
    const int* extent = output->GetExtent();
    columns_ = {extent[0], extent[1] - extent[0] + 1};
    // Rows count from the top, those of VTK from the bottom.
    rows_ = {warp.warpedSize().height - 1 - extent[3], extent[3] - extent[2] + 1};
  }

  bool run() {
    const int height = warp_.sourceSize().height;
    between_.reset(new Value[static_cast<std::size_t>(height) * rowLength()]);
    return inSlabs(height, static_cast<vtkIdType>(warp_.sourceSize().width + columns_.count) * channels_, 1, 0.0,
                   [this](int first, int last) { warpRows(first, last); }) &&
           inSlabs(columns_.count, static_cast<vtkIdType>(height + rows_.count) * channels_, columnsPerTask, 0.5,
                   [this](int first, int last) { warpColumns(first, last); });
  }

 private:
  std::size_t rowLength() const { return static_cast<std::size_t>(columns_.count) * channels_; }

  template <typename Work>
  bool inSlabs(int lines, vtkIdType valuesPerLine, int grain, double progress, const Work& work) const {
    const int perSlab =
        static_cast<int>(std::clamp<vtkIdType>(valuesPerSlab / valuesPerLine, 4 * grain, lines + grain));
    for (int begin = 0; begin < lines; begin += perSlab) {
      if (algorithm_->GetAbortExecute()) return false;
      const int end = std::min(lines, begin + perSlab);
      vtkSMPTools::For(begin, end, grain,
                       [&](vtkIdType first, vtkIdType last) { work(static_cast<int>(first), static_cast<int>(last)); });
      algorithm_->UpdateProgress(progress + 0.5 * end / lines);
    }
    return !algorithm_->GetAbortExecute();
  }

  void warpRows(int first, int last) const {
    const int width = warp_.sourceSize().width, height = warp_.sourceSize().height;
    const std::size_t length = static_cast<std::size_t>(width) * channels_;
    std::unique_ptr<Value[]> line(new Value[length]);
    for (int row = first; row < last; ++row) {
      const Scalar* from = source_ + (height - 1 - row) * length;
      for (std::size_t i = 0; i < length; ++i) line[i] = static_cast<Value>(from[i]);
      warpRow(warp_, row, line.get(), channels_, closed_, columns_, between_.get() + row * rowLength());
    }
  }

  void warpColumns(int first, int last) const {
    const std::size_t from = static_cast<std::size_t>(warp_.sourceSize().height) * channels_;
    const std::size_t to = static_cast<std::size_t>(rows_.count) * channels_;
    std::unique_ptr<Value[]> lines(new Value[columnsPerTask * (from + to)]);
    for (int begin = first; begin < last; begin += columnsPerTask) {
      const int count = std::min(columnsPerTask, last - begin);
      gather(begin, count, lines.get());
      for (int i = 0; i < count; ++i)
        warpColumn(warp_, columns_.first + begin + i, lines.get() + i * from, channels_, rows_,
                   lines.get() + columnsPerTask * from + i * to);
      scatter(begin, count, lines.get() + columnsPerTask * from);
    }
  }

  void gather(int begin, int count, Value* lines) const {
    const int height = warp_.sourceSize().height;
    for (int row = 0; row < height; ++row) {
      const Value* from = between_.get() + row * rowLength() + static_cast<std::size_t>(begin) * channels_;
      for (int i = 0; i < count; ++i)
        for (int c = 0; c < channels_; ++c)
          lines[(static_cast<std::size_t>(i) * height + row) * channels_ + c] = *from++;
    }
  }

  void scatter(int begin, int count, const Value* lines) const {
    for (int row = 0; row < rows_.count; ++row) {
      Scalar* to = output_ + (rows_.count - 1 - row) * rowLength() + static_cast<std::size_t>(begin) * channels_;
      for (int i = 0; i < count; ++i)
        for (int c = 0; c < channels_; ++c)
          *to++ = rounded<Scalar>(lines[(static_cast<std::size_t>(i) * rows_.count + row) * channels_ + c]);
    }
  }

  const MeshWarp& warp_;
  bool closed_;
  vtkAlgorithm* algorithm_;
  int channels_;
  const Scalar* source_;
  Scalar* output_;
  PixelRange columns_, rows_;
  std::unique_ptr<Value[]> between_;  ///< after the first pass: rows of the source, columns of the output
};

}  // namespace

bool warpImage(const MeshWarp& warp, vtkImageData* image, bool closed, vtkAlgorithm* algorithm, vtkImageData* output) {
  output->AllocateScalars(image->GetScalarType(), image->GetNumberOfScalarComponents());
  if (const char* name = image->GetPointData()->GetScalars()->GetName())
    output->GetPointData()->GetScalars()->SetName(name);
  switch (image->GetScalarType()) {
    vtkTemplateMacro(return Passes<VTK_TT>(warp, image, closed, algorithm, output).run());
    default:
      return false;
  }
}

}  // namespace mien
