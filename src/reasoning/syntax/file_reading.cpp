// A text that is too long in what was read comes before an error of the system behind it, as if one thread did both.
#include "reasoning/syntax/file_reading.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "base/parallel/crew.hpp"
#include "base/parallel/room.hpp"
#include "base/text.hpp"

namespace geminga::syntax {

FileReading::FileReading(const std::string& path, int file, char* memory, std::size_t size, const FileLimits& limits)
    : path_(path),
      file_(file),
      memory_(memory),
      size_(size),
      is_watched_(size > limits.watched_bytes),
      watch_(path, size, limits) {}

std::optional<LoadError> FileReading::run(unsigned threads) {
  if (threads > 1 && is_watched_ && parallel::has_room_for(1)) {
    run_at_once();
  } else {
    run_in_turn();
  }
  return text_error_ ? std::move(text_error_) : std::move(reading_error_);
}

void FileReading::run_in_turn() {
  while (read_ < size_ && !reading_error_ && !text_error_) {
    const std::size_t begin = std::exchange(read_, read_block(read_));
    look_at(begin, read_);
  }
}

void FileReading::run_at_once() {
  parallel::Crew crew(2);
  if (crew.size() == 1) return run_in_turn();
  const auto stop = [&] {
    const std::lock_guard lock(mutex_);
    has_read_ = true;
    has_looked_ = true;
    changed_.notify_all();
  };
  crew.run([&](unsigned me) { me == 0 ? read_on() : look_on(); }, stop);
}

void FileReading::read_on() {
  for (std::size_t begin = 0; begin < size_ && !reading_error_;) {
    const std::size_t end = read_block(begin);
    std::unique_lock lock(mutex_);
    read_ = begin = end;
    changed_.notify_all();
    changed_.wait(lock, [&] { return has_looked_ || read_ - looked_at_ < ahead_bytes; });
    if (has_looked_) break;
  }
  const std::lock_guard lock(mutex_);
  has_read_ = true;
  changed_.notify_all();
}

void FileReading::look_on() {
  for (std::size_t begin = 0;;) {
    std::size_t end = 0;
    {
      std::unique_lock lock(mutex_);
      looked_at_ = begin;
      changed_.notify_all();
      changed_.wait(lock, [&] { return has_read_ || read_ > begin; });
      end = read_;
      has_looked_ = end == begin;
      if (has_looked_) return;
    }
    look_at(begin, end);
    begin = end;
    if (!text_error_) continue;
    const std::lock_guard lock(mutex_);
    has_looked_ = true;
    changed_.notify_all();
    return;
  }
}

std::size_t FileReading::read_block(std::size_t from) {
  const auto refuse = [&](std::string text) {
    reading_error_ = LoadError{base::printable(path_, 4096), 0, std::move(text), true};
    return from;
  };
  for (;;) {
    const ssize_t count = ::read(file_, memory_ + from, std::min(size_ - from, block_bytes));
    if (count > 0) return from + static_cast<std::size_t>(count);
    if (count == 0) return refuse("became shorter while it was read: try again");
    if (errno != EINTR) return refuse("cannot be read: " + std::generic_category().message(errno));
  }
}

void FileReading::look_at(std::size_t begin, std::size_t end) {
  if (begin == end) return;
  const std::string_view block(memory_ + begin, end - begin);
  hash_.add(block);
  text_error_ = watch_.look_at(block);
}

}  // namespace geminga::syntax
