#include "gcnp/line_reader.hpp"

namespace geminga::gcnp {

void LineReader::feed(std::string_view bytes) {
  buffer_.erase(0, begin_);
  scanned_ -= begin_;
  begin_ = 0;
  buffer_ += bytes;
}

std::optional<LineReader::Line> LineReader::next() {
  while (true) {
    const std::size_t end = buffer_.find('\n', scanned_);
    const bool is_complete = end != std::string::npos;
    scanned_ = is_complete ? end : buffer_.size();
    std::string_view line = std::string_view(buffer_).substr(begin_, scanned_ - begin_);
    const bool was_skipping = is_skipping_;
    // An unfinished line may still end in the CR of its CR LF, which does not count.
    const std::size_t counted = line.ends_with('\r') ? line.size() - 1 : line.size();
    const bool is_too_long = !was_skipping && counted > max_bytes_;
    if (!is_complete && !is_too_long && !was_skipping) return std::nullopt;
    if (is_complete) ++scanned_;
    begin_ = scanned_;
    is_skipping_ = !is_complete;
    if (is_too_long) return Line{line.substr(0, beginning_bytes), true};
    if (was_skipping) {
      if (!is_complete) return std::nullopt;
      continue;
    }
    return Line{line.substr(0, counted), false};
  }
}

}  // namespace geminga::gcnp
