// ontology_generator: writes a made-up ontology to standard output, for the benchmark and for other tests of size.
//
//   ontology_generator --classes 350000 --seed 1 --syntax rdf-xml > large.rdf
#include <charconv>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "bench/reasoner/synthetic.hpp"

namespace {

bool read_number(const char* text, auto& number) {
  const char* end = text + std::strlen(text);
  const auto [last, error] = std::from_chars(text, end, number);
  return error == std::errc() && last == end;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace geminga::bench;
  std::uint32_t classes = 350'000;
  std::uint64_t seed = 1;
  std::string_view syntax = "functional";
  for (int at = 1; at < argc; at += 2) {
    const std::string_view name = argv[at];
    const bool has_value = at + 1 < argc;
    const bool is_read = has_value && ((name == "--classes" && read_number(argv[at + 1], classes)) ||
                                       (name == "--seed" && read_number(argv[at + 1], seed)) ||
                                       (name == "--syntax" && !(syntax = argv[at + 1]).empty()));
    if (is_read && (syntax == "functional" || syntax == "rdf-xml")) continue;
    std::fprintf(stderr, "usage: %s [--classes N] [--seed S] [--syntax functional|rdf-xml]\n", argv[0]);
    return 2;
  }
  const Synthetic ontology = make_synthetic(classes, seed);
  if (syntax == "functional") {
    write_functional(ontology, stdout);
  } else {
    write_rdf_xml(ontology, stdout);
  }
  std::fprintf(stderr, "%zu classes, %zu axioms\n", ontology.classes.size(), axiom_count(ontology));
  return std::fflush(stdout) == 0 ? 0 : 1;
}
