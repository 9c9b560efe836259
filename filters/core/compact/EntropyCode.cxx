#include "EntropyCode.h"

#include <lzma.h>

#include <array>
#include <new>

namespace mien {

namespace {

/// The same for packing and unpacking, as nothing of it is in the bytes. Literals of a face have no alignment or
/// neighbour that would tell the next one: without contexts (lc, lp, pb) they are learnt soonest.
lzma_options_lzma coderOptions() {
  lzma_options_lzma options;
  lzma_lzma_preset(&options, LZMA_PRESET_EXTREME | 9u);
  options.dict_size = 1u << 16;
  options.lc = options.lp = options.pb = 0;
  return options;
}

const std::uint8_t* bytesOf(std::string_view text) {
  return reinterpret_cast<const std::uint8_t*>(text.data());
}

using Coder = lzma_ret (*)(lzma_stream*, const lzma_filter*);

/// Runs a coder over all of the input. The bytes grow with what comes out, never with what a file promises.
bool runCoder(Coder begin, std::string_view input, std::size_t limit, std::string& output) {
  lzma_options_lzma options = coderOptions();
  const lzma_filter filters[] = {{LZMA_FILTER_LZMA1, &options}, {LZMA_VLI_UNKNOWN, nullptr}};
  lzma_stream stream = LZMA_STREAM_INIT;
  if (begin(&stream, filters) != LZMA_OK) throw std::bad_alloc();
  stream.next_in = bytesOf(input);
  stream.avail_in = input.size();
  std::array<std::uint8_t, 4096> block;
  lzma_ret state = LZMA_OK;
  while (state == LZMA_OK && output.size() <= limit) {
    stream.next_out = block.data();
    stream.avail_out = block.size();
    state = lzma_code(&stream, LZMA_FINISH);
    output.append(reinterpret_cast<const char*>(block.data()), block.size() - stream.avail_out);
  }
  const bool whole = state == LZMA_STREAM_END && stream.avail_in == 0 && output.size() <= limit;
  lzma_end(&stream);
  if (state == LZMA_MEM_ERROR) throw std::bad_alloc();
  return whole;
}

}  // namespace

std::string packBytes(std::string_view bytes) {
  std::string packed;
  runCoder(lzma_raw_encoder, bytes, std::string::npos - 1, packed);
  return packed;
}

bool unpackBytes(std::string_view packed, std::size_t limit, std::string& bytes) {
  std::string unpacked;
  if (!runCoder(lzma_raw_decoder, packed, limit, unpacked)) return false;
  bytes = std::move(unpacked);
  return true;
}

}  // namespace mien
