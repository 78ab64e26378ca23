#include "recording/reader.hpp"

#include <algorithm>
#include <utility>

namespace geminga::recording {

std::string to_string(const Finding& finding) {
  return "line " + std::to_string(finding.line) + ", octet " + std::to_string(finding.octet) + ": " + finding.text;
}

Reader::Cut Reader::cut() {
  line_.clear();
  line_begin_ = read_;
  std::streambuf& buffer = *in_.rdbuf();
  bool is_too_long = false;
  while (true) {
    const int octet = buffer.sbumpc();
    if (octet == std::char_traits<char>::eof()) break;
    ++read_;
    if (octet == '\n') {
      ++line_number_;
      if (line_.ends_with('\r')) line_.pop_back();
      return is_too_long ? Cut::too_long : Cut::whole;
    }
    if (line_.size() < max_line_bytes) {
      line_ += static_cast<char>(octet);
    } else {
      is_too_long = true;
    }
  }
  if (read_ == line_begin_) return Cut::none;
  ++line_number_;
  return is_too_long ? Cut::too_long : Cut::unended;
}

void Reader::mend_time(Entry& entry) {
  entry.at += shift_;
  if (entry.at < last_) {
    report(here("time runs backwards by " + std::to_string((last_ - entry.at).count()) +
                " ms: from here on it is counted from the line before"));
    shift_ += last_ - entry.at;
    entry.at = last_;
  }
  last_ = entry.at;
}

std::expected<std::optional<Entry>, Finding> Reader::next() {
  while (true) {
    const Cut cut_line = cut();
    if (cut_line == Cut::none) {
      if (has_begun_) return std::nullopt;
      return std::unexpected(here(left_out_ == 0 ? "is no recording: it has no line that geminga-query record writes"
                                                 : "has no snapshot, which a recording begins with"));
    }
    if (cut_line == Cut::too_long) {
      report(here("has over " + std::to_string(max_line_bytes) + " octets: left out"));
      continue;
    }
    auto entry = read_line(line_);
    if (!entry && entry.error().is_other_version) return std::unexpected(here(std::move(entry.error().text)));
    if (!entry) {
      report(here(cut_line == Cut::unended ? "the recording was cut within this line: " + entry.error().text
                                           : entry.error().text + ": left out"));
      continue;
    }
    if (std::holds_alternative<Unknown>(entry->event)) continue;
    if (std::holds_alternative<Snapshot>(entry->event)) has_begun_ = true;
    if (!has_begun_) {
      if (left_out_++ == 0) report(here("the beginning is missing: lines before the first snapshot are left out"));
      continue;
    }
    mend_time(*entry);
    return std::optional<Entry>(std::move(*entry));
  }
}

void Reader::report(const Finding& finding) {
  if (finding.line > read_before_) report_(finding);
}

bool Reader::rewind() {
  in_.clear();
  if (!in_.seekg(0)) return false;
  read_before_ = std::max(read_before_, std::exchange(line_number_, 0));
  line_begin_ = read_ = 0;
  left_out_ = 0;
  has_begun_ = false;
  last_ = shift_ = {};
  return true;
}

}  // namespace geminga::recording
