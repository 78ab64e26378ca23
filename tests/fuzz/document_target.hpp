// The promises of a reader for any bytes: axioms with lines that exist, or an error of one line.
#ifndef GEMINGA_TESTS_FUZZ_DOCUMENT_TARGET_HPP
#define GEMINGA_TESTS_FUZZ_DOCUMENT_TARGET_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::fuzz {

/// Ends the program where `document`, which a reader of OWL's own syntaxes made of `bytes` for `source`, breaks its
/// promises. `first_line` is the least line of an error: 0 where an error may be about the whole file.
template <class Document>
void check_document(std::string_view bytes, const Document& document, const owl::Ontology& source,
                    std::uint32_t first_line = 1) {
  const auto last_line = static_cast<std::uint64_t>(std::ranges::count(bytes, '\n')) + 1;
  if (document) {
    GEMINGA_ASSERT(document->axioms == source.axiom_count());
    for (std::size_t number = 0; number < source.axiom_count(); ++number) {
      const std::uint32_t line = source.axiom(number).line;
      GEMINGA_ASSERT(line >= 1 && line <= last_line);
    }
    return;
  }
  const auto& error = document.error();
  GEMINGA_ASSERT(error.line >= first_line && error.line <= last_line);
  GEMINGA_ASSERT(!error.text.empty() && error.text.size() < 600);
  GEMINGA_ASSERT(base::is_valid_utf8(error.text) && !base::has_control_character(error.text));
}

}  // namespace geminga::fuzz

#endif
