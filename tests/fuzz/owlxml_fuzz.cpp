// Any bytes as OWL/XML: read, or refused in one line with a line number that exists.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "reasoning/syntax/owlxml/read.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size) {
  using namespace geminga;
  const std::string_view bytes(reinterpret_cast<const char*>(octets), size);
  owlxml::XmlLimits limits;
  limits.nesting = 20;
  limits.operands = 50;
  limits.iri_bytes = 200;
  limits.literal_bytes = 300;
  owl::Ontology source;
  const auto document = owlxml::read(bytes, source.add_file("fuzz.owx"), source, limits);
  const auto last_line = static_cast<std::uint64_t>(std::ranges::count(bytes, '\n')) + 1;
  if (document) {
    GEMINGA_ASSERT(document->axioms == source.axiom_count());
    for (std::size_t number = 0; number < source.axiom_count(); ++number)
      GEMINGA_ASSERT(source.axiom(number).line >= 1 && source.axiom(number).line <= last_line);
  } else {
    const owlxml::ReadError& error = document.error();
    GEMINGA_ASSERT(error.line <= last_line);
    GEMINGA_ASSERT(!error.text.empty() && error.text.size() < 600);
    GEMINGA_ASSERT(base::is_valid_utf8(error.text) && !base::has_control_character(error.text));
  }
  return 0;
}
