// The text of a document on its way out: collected in pieces, bounded, and refused as a whole where it cannot be
// written.
#ifndef GEMINGA_REASONING_SYNTAX_WRITING_OUTPUT_HPP
#define GEMINGA_REASONING_SYNTAX_WRITING_OUTPUT_HPP

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "reasoning/syntax/writing/limits.hpp"

namespace geminga::writing {

/// Takes the next piece of the text; false: it cannot, and the writer stops.
using Sink = std::function<bool(std::string_view)>;

class Output {
 public:
  Output(const Sink& sink, const WritingLimits& limits) : sink_(sink), limits_(limits) {}
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  void add(std::string_view text);
  void add(std::initializer_list<std::string_view> texts) {
    for (const std::string_view text : texts) add(text);
  }
  /// Says why there can be no document; the first reason counts. From then on nothing is written.
  void fail(std::string why);
  [[nodiscard]] bool has_failed() const { return problem_.has_value(); }
  /// Hands over what is left, and returns why there is no document.
  [[nodiscard]] std::optional<std::string> finish();

 private:
  void flush();

  const Sink& sink_;
  const WritingLimits& limits_;
  std::string waiting_;
  std::size_t octets_ = 0;
  std::optional<std::string> problem_;
};

}  // namespace geminga::writing

#endif
