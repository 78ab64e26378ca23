// Any bytes as a document in Manchester syntax: read, or refused in one line with a line number that exists.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/document_target.hpp"
#include "reasoning/syntax/frames/read.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size) {
  using namespace geminga;
  const std::string_view bytes(reinterpret_cast<const char*>(octets), size);
  frames::FrameLimits limits;
  limits.expression.nesting = 20;
  limits.expression.parts = 50;
  limits.annotation_levels = 5;
  limits.iri_bytes = 200;
  limits.literal_bytes = 300;
  frames::Declared declared;
  frames::look_ahead(bytes, declared, limits);
  owl::Ontology source;
  const auto document = frames::read(bytes, source.add_file("fuzz.omn"), source, declared, limits);
  fuzz::check_document(bytes, document, source);
  return 0;
}
