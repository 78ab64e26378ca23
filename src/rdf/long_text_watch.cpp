#include "rdf/long_text_watch.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "rdf/syntax.hpp"

namespace geminga::rdf {

std::optional<LoadError> LongTextWatch::look_at(std::string_view stretch) {
  if (!is_needed_) return std::nullopt;
  if (!text_) {
    const auto syntax = detect_syntax(path_, stretch);
    is_needed_ = syntax.has_value();
    if (!is_needed_) return std::nullopt;  // whoever asked for the bytes says why
    is_xml_ = is_xml(*syntax);
    // A text may be half escapes, and in XML stand in a tag with others.
    text_.emplace(*syntax, is_xml_ ? std::max(limits_.tag_bytes, limits_.literal_bytes) : 2 * limits_.literal_bytes,
                  limits_.blank_bytes);
  }
  const auto line = text_->look_at(stretch);
  if (!line) return std::nullopt;
  const bool is_blank = text_->is_blank();
  const std::string_view what = is_blank ? "white space and comments" : is_xml_ ? "a text" : "a literal";
  return LoadError{base::printable(path_, 4096), *line,
                   "has " + std::string(what) + " of more than " +
                       std::to_string(is_blank ? limits_.blank_bytes : limits_.literal_bytes) + " bytes"};
}

}  // namespace geminga::rdf
