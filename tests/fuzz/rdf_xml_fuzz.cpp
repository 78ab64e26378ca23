// Any octets as a file in RDF/XML.
#include "fuzz/rdf_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size) {
  geminga::fuzz::read_as(".rdf", octets, size);
  return 0;
}
