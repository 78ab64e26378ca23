// compare_random: random ontologies by seed, and the shapes of published ones, through the whole reasoner and through
// Konclude. The program behind tools/dev/compare-konclude.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "compare/disguises.hpp"
#include "compare/functional_syntax.hpp"
#include "compare/genealogies.hpp"
#include "compare/konclude.hpp"
#include "compare/opinions.hpp"
#include "compare/shapes.hpp"
#include "ontology/loading/readers.hpp"
#include "reasoning/syntax/rdf/load.hpp"
#include "support/random_ontology.hpp"

namespace {

using namespace geminga;
using namespace geminga::compare;

constexpr unsigned seconds = 20;

struct Subject {
  std::string name;
  owl::Ontology source;
};

/// One of each kind.
std::vector<Subject> subjects(std::uint64_t seed) {
  std::vector<Subject> all;
  for (const Profile profile : profiles)
    all.push_back({std::string(to_string(profile)), random_ontology(profile, seed, 4 + seed % 16)});
  all.push_back({"covering", covering_tree(static_cast<Covering>(seed % 3), 8 + seed % 41, 2 + seed % 5)});
  all.push_back({"pigeonhole", pigeonhole(2 + seed % 5)});
  all.push_back({"enumeration", enumeration(seed, 5 + seed % 30)});
  all.push_back({"numbers", qualified_numbers(seed)});
  all.push_back({"large numbers", large_numbers(seed, static_cast<std::uint32_t>(2 + seed % 40))});
  all.push_back({"family", family(seed, 2 + seed % 60)});
  all.push_back({"genealogy", genealogy(seed, 4 + seed % 60)});
  all.push_back({"features", features(seed, 5 + seed % 20)});
  all.push_back({"anatomy", anatomy(seed, 6 + seed % 30)});
  all.push_back({"pairings", pairings(seed, 2 + seed % 12)});
  return all;
}

/// The one that is written in disguise, of another kind with each seed.
Subject in_disguise(std::uint64_t seed) {
  std::vector<Subject> all = subjects(seed);
  return std::move(all[seed % all.size()]);
}

/// Where the document of one subject lies while it is compared.
std::filesystem::path place_of(const std::string& name) {
  return std::filesystem::temp_directory_path() / ("random-" + std::to_string(::getpid()) + '-' + name);
}

/// True where both agree, or Konclude has no answer. What it lacks is no fault of ours unless our tableau lacks it too.
bool is_agreed(const std::string& name, std::uint64_t seed, const owl::Ontology& source,
               const std::filesystem::path& file) {
  const auto expected = konclude_closure(file, seconds);
  const Opinion ours = of_the_reasoner(source);
  if (!expected) {
    std::printf("%s, seed %llu: %s\n", name.c_str(), static_cast<unsigned long long>(seed), expected.error().c_str());
    return true;
  }
  const auto found = contradictions(ours, {*expected, true, {}});
  for (const std::string& line : found)
    std::printf("%s, seed %llu: of us and Konclude %s\n", name.c_str(), static_cast<unsigned long long>(seed),
                line.c_str());
  if (found.empty()) return true;
  for (const std::string& line : contradictions(ours, of_the_tableau(source)))
    std::printf("    of us and our tableau %s\n", line.c_str());
  const std::string kept = "difference-" + name + "-" + std::to_string(seed) + file.extension().string();
  std::filesystem::copy_file(file, kept, std::filesystem::copy_options::overwrite_existing);
  return false;
}

bool is_agreed(const Subject& subject, std::uint64_t seed) {
  const std::filesystem::path file = place_of("t.ofn");
  std::ofstream(file) << functional_syntax(subject.source);
  const bool is_same = is_agreed(subject.name, seed, subject.source, file);
  std::filesystem::remove(file);
  return is_same;
}

/// The same for a document in disguise, which both read for themselves.
bool is_agreed(const Disguised& disguised, const std::string& name, std::uint64_t seed) {
  const std::filesystem::path file = place_of(disguised.file_name);
  std::ofstream(file, std::ios::binary) << disguised.document;
  ontology::Readers readers;
  const auto loaded = rdf::load(std::vector{file.string()}, {}, &readers);
  bool is_same = false;
  if (loaded) {
    is_same = is_agreed(name, seed, loaded->source, file);
  } else {
    std::printf("%s, seed %llu: %s\n", name.c_str(), static_cast<unsigned long long>(seed),
                syntax::to_string(loaded.error()).c_str());
  }
  std::filesystem::remove(file);
  return is_same;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fprintf(stderr, "usage: %s SEEDS [FIRST]\n", argv[0]);
    return 2;
  }
  const std::uint64_t count = std::strtoull(argv[1], nullptr, 10);
  const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  if (!is_konclude_installed()) {
    std::printf("NOT COMPARED: Konclude is not installed (Debian: apt-get install konclude)\n");
    return 0;
  }
  std::uint64_t compared = 0;
  std::uint64_t differences = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    for (const Subject& subject : subjects(seed)) {
      ++compared;
      differences += is_agreed(subject, seed) ? 0U : 1U;
    }
    const Subject disguised = in_disguise(seed);
    compared += 2;
    differences += is_agreed(in_owl_xml(disguised.source, seed, Disguise::as_others_read), "owlxml", seed) ? 0U : 1U;
    differences += is_agreed(in_rdf_xml(disguised.source, seed, Disguise::as_others_read), "rdfxml", seed) ? 0U : 1U;
  }
  std::printf("%llu ontologies, %llu with differences\n", static_cast<unsigned long long>(compared),
              static_cast<unsigned long long>(differences));
  return differences == 0 ? 0 : 1;
}
