#include "FAPLiveInput.h"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "FAPStream.h"

namespace mien {

namespace {

constexpr std::size_t blockSize = 65536;

}  // namespace

struct FAPLiveInput::Internals {
  int descriptor = 0;
  State state = State::Open;
  FAPStream stream;
  std::string fault;

  void fail(const std::optional<FAPParseError>& error) {
    if (!error) return;
    state = State::Failed;
    fault = "standard input:" + std::to_string(error->line) + ": " + error->message;
  }

  void read() {
    char block[blockSize];
    const ssize_t count = ::read(descriptor, block, sizeof block);
    if (count > 0) return fail(stream.feed({block, static_cast<std::size_t>(count)}));
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) return;
    if (count < 0) {
      state = State::Failed;
      fault = std::string("standard input: it cannot be read (") + std::strerror(errno) + ")";
      return;
    }
    state = State::Ended;
    fail(stream.end());
  }
};

FAPLiveInput::FAPLiveInput(int descriptor) : Impl(std::make_unique<Internals>()) {
  this->Impl->descriptor = descriptor;
}

FAPLiveInput::~FAPLiveInput() = default;

FAPLiveInput::State FAPLiveInput::wait(int milliseconds, std::vector<FAPFrame>& frames) {
  pollfd input{this->Impl->descriptor, POLLIN, 0};
  if (this->Impl->state == State::Open && poll(&input, 1, milliseconds) > 0) this->Impl->read();
  for (const FAPFrame& frame : this->Impl->stream.takeFrames()) frames.push_back(frame);
  return this->Impl->state;
}

const FAPSequence& FAPLiveInput::sequence() const {
  return this->Impl->stream.sequence();
}

const std::string& FAPLiveInput::fault() const {
  return this->Impl->fault;
}

}  // namespace mien
