// Any octets as a file in N-Triples.
#include "fuzz/rdf_target.hpp"

/// Raptor 2.0.15 keeps a reference to the URI of a literal's datatype for ever (raptor_ntriples.c, line 649): once for
/// each datatype, as URIs are shared.
// NOLINTNEXTLINE(bugprone-reserved-identifier)
extern "C" const char* __lsan_default_suppressions() { return "leak:libraptor2.so"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size) {
  geminga::fuzz::read_as(".nt", octets, size);
  return 0;
}
