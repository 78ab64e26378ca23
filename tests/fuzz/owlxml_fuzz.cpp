// Any bytes as OWL/XML: read, or refused in one line with a line number that exists.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/document_target.hpp"
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
  fuzz::check_document(bytes, document, source, 0);
  return 0;
}
