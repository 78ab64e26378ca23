// libxml2's events as calls with plain texts. In this folder only elements.cpp names libxml2.
#ifndef GEMINGA_REASONING_SYNTAX_OWLXML_ELEMENTS_HPP
#define GEMINGA_REASONING_SYNTAX_OWLXML_ELEMENTS_HPP

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "reasoning/syntax/owlxml/limits.hpp"

namespace geminga::owlxml {

struct Attribute {
  std::string_view space;  ///< the IRI of its namespace; empty: it has no prefix
  std::string_view name;
  std::string_view value;
};

/// An error in a file, and its line.
struct Problem {
  std::uint32_t line = 0;
  std::string text;
};

/// Receives the content of a file in its order, with the lines, but no white space outside of elements that have a
/// text. Values of attributes and texts are valid during the call, and all names until finish() returns. A call that
/// returns a text refuses the file with it, and is the last one but finish().
class Listener {
 public:
  virtual ~Listener() = default;
  using Refusal = std::optional<std::string>;
  virtual Refusal begin(std::string_view space, std::string_view name, std::span<const Attribute> attributes,
                        std::uint32_t line) = 0;
  virtual Refusal text(std::string_view part, std::uint32_t line) = 0;
  virtual Refusal end(std::uint32_t line) = 0;
  /// The walk is over, whatever ended it.
  virtual void finish() {}
};

/// Walks over a file. Returns what is wrong with it as XML, or what the listener returned.
[[nodiscard]] std::optional<Problem> walk(std::string_view bytes, const XmlLimits& limits, Listener& listener);

}  // namespace geminga::owlxml

#endif
