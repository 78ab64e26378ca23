// Any octets as a file of triples in one syntax: read within small limits, or refused in one line of valid text.
#ifndef GEMINGA_TESTS_FUZZ_RDF_TARGET_HPP
#define GEMINGA_TESTS_FUZZ_RDF_TARGET_HPP

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::fuzz {

/// `extension` chooses the syntax.
inline void read_as(const char* extension, const std::uint8_t* octets, std::size_t size) {
  syntax::FileLimits limits;
  limits.triples = 2'000;
  limits.literal_bytes = 300;
  limits.iri_bytes = 200;
  limits.nesting = 20;
  limits.statement_triples = 100;
  limits.prefixes = 20;
  limits.attributes = 20;
  limits.tag_bytes = 2'000;
  limits.entities = 10;
  limits.entity_bytes = 100;
  limits.expansion_bytes = 1'000;
  static const std::string path =
      (std::filesystem::temp_directory_path() / ("geminga-fuzz-" + std::to_string(::getpid()))).string() + extension;
  std::ofstream(path, std::ios::binary | std::ios::trunc)
      .write(reinterpret_cast<const char*>(octets), static_cast<std::streamsize>(size));
  const auto loaded = rdf::load(std::vector{path}, limits);
  std::filesystem::remove(path);
  if (loaded) {
    GEMINGA_ASSERT(!loaded->source.problem());
    GEMINGA_ASSERT(loaded->triples <= limits.triples);
    for (std::size_t number = 0; number < loaded->source.axiom_count(); ++number)
      GEMINGA_ASSERT(loaded->source.axiom(number).line <= size + 1);
  } else {
    const std::string text = to_string(loaded.error());
    GEMINGA_ASSERT(!loaded.error().text.empty());
    GEMINGA_ASSERT(base::is_valid_utf8(text) && !base::has_control_character(text));
  }
}

}  // namespace geminga::fuzz

#endif
