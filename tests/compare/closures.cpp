// compare_closures: the closure of ontology files as this project derives it against Konclude's, pair by pair. The
// program behind tools/dev/compare-closures and tools/dev/compare-cases.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "cases/taxonomy.hpp"
#include "compare/functional_syntax.hpp"
#include "compare/konclude.hpp"
#include "ontology/loading/readers.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::compare {
namespace {

namespace fs = std::filesystem;

struct Request {
  bool is_direct = false;    ///< Konclude reads the file itself instead of what our reader made of it
  bool is_together = false;  ///< all files are one ontology
  bool is_case = false;      ///< Name.ttl is compared with Name.taxonomy, not with what we derive
  unsigned seconds = 60;
  std::size_t shown = 10;
  std::vector<std::string> files;
};

void show(const char* what, const cases::Closure& lines, std::size_t most) {
  for (std::size_t at = 0; at < std::min(lines.size(), most); ++at)
    std::printf("    %s  %s\n", what, lines[at].c_str());
  if (lines.size() > most) std::printf("    %s  and %zu more\n", what, lines.size() - most);
}

std::expected<cases::Closure, std::string> ours(const Request& request, const std::string& name,
                                                const owl::Ontology& source, std::string& words) {
  if (request.is_case) {
    std::ifstream file(fs::path(name).replace_extension(".taxonomy"));
    return cases::read_tree(std::string(std::istreambuf_iterator<char>(file), {}));
  }
  const auto began = std::chrono::steady_clock::now();
  const auto classification = reasoner::classify(source);
  if (!classification) return std::unexpected(classification.error().text);
  const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began).count();
  char text[200];
  std::snprintf(text, sizeof text, ", %.0f ms, left out %zu axioms, %zu by the reader, %zu gaps", ms,
                classification->unused.size(), source.omissions().size(), classification->gaps.size());
  words += text;
  return cases::closure_of(source, *classification, false);
}

/// Short names in the one because the other has them.
cases::Closure shortened(cases::Closure lines) {
  for (std::string& line : lines) {
    const std::size_t middle = line.find(" < ");
    if (middle == std::string::npos) continue;
    const auto last = [](const std::string& iri) { return iri.substr(iri.find_last_of("#/") + 1); };
    line = last(line.substr(0, middle)) + " < " + last(line.substr(middle + 3));
  }
  std::ranges::sort(lines);
  return lines;
}

/// True where both agree.
bool compare(const Request& request, const std::vector<std::string>& files) {
  const std::string& name = files.front();
  ontology::Readers readers;
  const auto loaded = rdf::load(files, {}, &readers);
  if (!loaded) {
    std::printf("%s: cannot be read: %s\n", name.c_str(), syntax::to_string(loaded.error()).c_str());
    return false;
  }
  std::string words;
  const auto found = ours(request, name, loaded->source, words);
  if (!found) {
    std::printf("%s: we cannot classify it: %s\n", name.c_str(), found.error().c_str());
    return false;
  }
  const fs::path document = fs::temp_directory_path() / ("compare-" + std::to_string(::getpid()) + ".ofn");
  std::ofstream(document) << functional_syntax(loaded->source);
  auto expected = konclude_closure(request.is_direct ? fs::path(name) : document, request.seconds);
  fs::remove(document);
  if (!expected) {
    std::printf("%s: %zu pairs%s; %s\n", name.c_str(), found->size(), words.c_str(), expected.error().c_str());
    return false;
  }
  if (request.is_case) *expected = shortened(*expected);
  const cases::Closure beyond = cases::unsound(*found, *expected);
  const cases::Closure missing = cases::unsound(*expected, *found);
  std::printf("%s: %zu pairs, Konclude %zu: %zu too much, %zu missing%s\n", name.c_str(), found->size(),
              expected->size(), beyond.size(), missing.size(), words.c_str());
  show("too much", beyond, request.shown);
  show("missing ", missing, request.shown);
  return beyond.empty() && missing.empty();
}

int run(const Request& request) {
  if (!is_konclude_installed()) {
    std::printf("NOT COMPARED: Konclude is not installed (Debian: apt-get install konclude)\n");
    return 0;
  }
  bool is_same = true;
  if (request.is_together) return compare(request, request.files) ? 0 : 1;
  for (const std::string& file : request.files) {
    is_same &= compare(request, {file});
    std::fflush(stdout);
  }
  return is_same ? 0 : 1;
}

}  // namespace
}  // namespace geminga::compare

int main(int argc, char** argv) {
  geminga::compare::Request request;
  for (int at = 1; at < argc; ++at) {
    const std::string word = argv[at];
    if (word == "--direct") {
      request.is_direct = true;
    } else if (word == "--together") {
      request.is_together = true;
    } else if (word == "--case") {
      request.is_case = true;
    } else if (word == "--seconds" && at + 1 < argc) {
      request.seconds = static_cast<unsigned>(std::stoul(argv[++at]));
    } else if (word == "--show" && at + 1 < argc) {
      request.shown = std::stoul(argv[++at]);
    } else {
      request.files.push_back(word);
    }
  }
  if (request.files.empty()) {
    std::fprintf(stderr, "usage: %s [--direct] [--together] [--case] [--seconds N] [--show N] FILE...\n", argv[0]);
    return 2;
  }
  try {
    return geminga::compare::run(request);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 2;
  }
}
