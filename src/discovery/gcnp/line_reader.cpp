#include "discovery/gcnp/line_reader.hpp"

#include <utility>

namespace geminga::gcnp {

void LineReader::feed(std::string_view bytes) {
  const std::size_t done = found_ ? found_->begin : begin_;
  buffer_.erase(0, done);
  scanned_ -= done;
  begin_ -= done;
  if (found_) found_->begin = 0;
  buffer_ += bytes;
}

bool LineReader::has_line() {
  if (!found_) found_ = find();
  return found_.has_value();
}

std::optional<LineReader::Line> LineReader::next() {
  if (!has_line()) return std::nullopt;
  const Found line = *std::exchange(found_, std::nullopt);
  return Line{std::string_view(buffer_).substr(line.begin, line.size), line.is_too_long};
}

std::optional<LineReader::Found> LineReader::find() {
  while (true) {
    const std::size_t end = buffer_.find('\n', scanned_);
    const bool is_complete = end != std::string::npos;
    scanned_ = is_complete ? end : buffer_.size();
    const std::size_t begin = begin_;
    const std::string_view line = std::string_view(buffer_).substr(begin, scanned_ - begin);
    const bool was_skipping = is_skipping_;
    // An unfinished line may still end in the CR of its CR LF, which does not count.
    const std::size_t counted = line.ends_with('\r') ? line.size() - 1 : line.size();
    const bool is_too_long = !was_skipping && counted > max_bytes_;
    if (!is_complete && !is_too_long && !was_skipping) return std::nullopt;
    if (is_complete) ++scanned_;
    begin_ = scanned_;
    is_skipping_ = !is_complete;
    if (is_too_long) return Found{begin, beginning_bytes, true};
    if (was_skipping) {
      if (!is_complete) return std::nullopt;
      continue;
    }
    return Found{begin, counted, false};
  }
}

}  // namespace geminga::gcnp
