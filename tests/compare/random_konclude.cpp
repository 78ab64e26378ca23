// compare_random: random ontologies by seed through the whole reasoner and through Konclude. The program behind
// tools/dev/compare-konclude.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "compare/functional_syntax.hpp"
#include "compare/konclude.hpp"
#include "compare/opinions.hpp"
#include "compare/random_ontology.hpp"

namespace {

using namespace geminga;
using namespace geminga::compare;

constexpr unsigned seconds = 20;

/// True where both agree, or Konclude has no answer. What it lacks is no fault of ours unless our tableau lacks it too.
bool is_agreed(Profile profile, std::uint64_t seed) {
  const el::OntologySource source = random_ontology(profile, seed, 4 + seed % 16);
  const auto file = std::filesystem::temp_directory_path() / ("random-" + std::to_string(::getpid()) + ".ofn");
  std::ofstream(file) << functional_syntax(source);
  const auto expected = konclude_closure(file, seconds);
  const Opinion ours = of_the_reasoner(source);
  if (!expected) {
    std::printf("%s, seed %llu: %s\n", std::string(to_string(profile)).c_str(), static_cast<unsigned long long>(seed),
                expected.error().c_str());
    std::filesystem::remove(file);
    return true;
  }
  const auto found = contradictions(ours, {*expected, true, {}});
  for (const std::string& line : found)
    std::printf("%s, seed %llu: of us and Konclude %s\n", std::string(to_string(profile)).c_str(),
                static_cast<unsigned long long>(seed), line.c_str());
  if (!found.empty()) {
    for (const std::string& line : contradictions(ours, of_the_tableau(source)))
      std::printf("    of us and our tableau %s\n", line.c_str());
    const std::string kept = "difference-" + std::string(to_string(profile)) + "-" + std::to_string(seed) + ".ofn";
    std::filesystem::copy_file(file, kept, std::filesystem::copy_options::overwrite_existing);
  }
  std::filesystem::remove(file);
  return found.empty();
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
  std::uint64_t differences = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    for (const Profile profile : profiles) differences += is_agreed(profile, seed) ? 0U : 1U;
  }
  std::printf("%llu ontologies, %llu with differences\n", static_cast<unsigned long long>(count * std::size(profiles)),
              static_cast<unsigned long long>(differences));
  return differences == 0 ? 0 : 1;
}
