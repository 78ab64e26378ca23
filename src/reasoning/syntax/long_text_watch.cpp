#include "reasoning/syntax/long_text_watch.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "reasoning/syntax/syntax.hpp"

namespace geminga::syntax {

std::optional<LoadError> LongTextWatch::look_at(std::string_view stretch) {
  if (!is_needed_) return std::nullopt;
  if (!text_) {
    const auto syntax = detect_syntax(path_, stretch);
    is_needed_ = syntax.has_value();
    if (!is_needed_) return std::nullopt;  // whoever asked for the bytes says why
    is_xml_ = is_xml(*syntax);
    // A text may be half escapes, and in XML stand in a tag with others.
    text_.emplace(*syntax, LongTextLimits{.text = is_xml_ ? std::max(limits_.tag_bytes, limits_.literal_bytes)
                                                          : 2 * limits_.literal_bytes,
                                          .blank = limits_.blank_bytes,
                                          .name = 2 * limits_.iri_bytes});
  }
  const auto line = text_->look_at(stretch);
  if (!line) return std::nullopt;
  const auto [what, most] = beyond();
  return LoadError{base::printable(path_, 4096), *line,
                   "has " + std::string(what) + " of more than " + std::to_string(most) + " bytes"};
}

std::pair<std::string_view, std::size_t> LongTextWatch::beyond() const {
  switch (text_->kind()) {
    case LongText::Kind::blank:
      return {"white space and comments", limits_.blank_bytes};
    case LongText::Kind::name:
      return {"a name", limits_.iri_bytes};
    case LongText::Kind::xml_comment:
      return {"a comment", LongTextLimits{}.xml_comment};
    case LongText::Kind::text:
      break;
  }
  return {is_xml_ ? "a text" : "a literal", limits_.literal_bytes};
}

}  // namespace geminga::syntax
