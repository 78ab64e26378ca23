// Any octets as a file in N-Triples.
#include "fuzz/rdf_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size) {
  geminga::fuzz::read_as(".nt", octets, size);
  return 0;
}
