// Any octets as a file in Turtle.
#include "fuzz/rdf_target.hpp"

/// Raptor 2.0.15 forgets what it has read of the statement in which a syntax error ends the file.
// NOLINTNEXTLINE(bugprone-reserved-identifier)
extern "C" const char* __lsan_default_suppressions() { return "leak:libraptor2.so"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size) {
  geminga::fuzz::read_as(".ttl", octets, size);
  return 0;
}
