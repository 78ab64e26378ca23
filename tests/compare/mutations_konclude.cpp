// compare_mutations: variations of real ontologies by seed, through the whole reasoner and through Konclude, with the
// time and memory of both. The program behind tools/dev/compare-mutations.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "compare/functional_syntax.hpp"
#include "compare/konclude.hpp"
#include "compare/mutation.hpp"
#include "compare/opinions.hpp"
#include "compare/timed_run.hpp"
#include "ontology/loading/readers.hpp"
#include "reasoning/realization/realization.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/syntax/owlxml/writer.hpp"
#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::compare {
namespace {

namespace fs = std::filesystem;

struct Request {
  std::uint64_t seeds = 20;
  std::uint64_t first = 1;
  unsigned seconds = 20;
  std::size_t axioms = 10'000;  ///< files with more are left out
  bool shows_all = false;
  bool asks_engines = false;  ///< our engines one by one, and not Konclude
  bool asks_types = false;    ///< the types of individuals instead of the subsumers of classes
  bool only_writes = false;   ///< keeps each variation and asks nobody
  std::vector<std::string> files;
};

/// Slower than this times Konclude, and by as many seconds of user time, is worth a line.
constexpr double slower_times = 1.5;
constexpr double slower_seconds = 0.3;
/// Fewer facts than this are added where the types of individuals are compared.
constexpr std::size_t most_facts = 12;

/// The words about what an answer leaves open; empty where that is nothing.
std::string open_words(const std::vector<std::string>& gaps, const taxonomy::Classification& classification) {
  const auto& unused = classification.unused;
  if (gaps.empty() && unused.empty()) return {};
  const std::string first = gaps.empty() ? std::string(unused.front().construct) : gaps.front();
  return first + " (" + std::to_string(gaps.size()) + " gaps, " + std::to_string(unused.size()) + " axioms not used)";
}

/// The types of named individuals as konclude_types() gives them.
cases::Closure types_of(const owl::Ontology& source, const taxonomy::Classification& classification,
                        const realization::Realization& found) {
  if (!found.is_consistent) return {"inconsistent"};
  const auto thing = classification.representative[static_cast<std::size_t>(classification.thing)];
  cases::Closure lines;
  for (std::size_t at = 0; at < found.individuals.size(); ++at) {
    const std::string begin = std::string(source.name_of(found.individuals[at])) + " < ";
    const auto& types = found.type_sets[found.types[at]];
    for (std::size_t number = 0; number < classification.class_count(); ++number) {
      const taxonomy::ClassNumber representative = classification.representative[number];
      const bool is_of_all = representative == thing && number != static_cast<std::size_t>(classification.thing);
      if (is_of_all || std::ranges::binary_search(types, representative))
        lines.push_back(begin + std::string(source.name(classification.classes[number])));
    }
  }
  std::ranges::sort(lines);
  return lines;
}

/// Answers about one file, in a process of its own, so that a crash is one answer of many. The first word is
/// `complete`, `undecided` or `refused`.
int answer(const char* file, bool asks_types) {
  ontology::Readers readers;
  auto loaded = rdf::load(std::vector{std::string(file)}, {}, &readers);
  if (!loaded) {
    std::printf("refused %s\n", syntax::to_string(loaded.error()).c_str());
    return 0;
  }
  const auto classification = reasoner::classify(loaded->source);
  if (!classification) {
    std::printf("refused %s\n", classification.error().text.c_str());
    return 0;
  }
  std::vector<std::string> gaps = classification->gaps;
  cases::Closure lines;
  if (!asks_types || !classification->is_consistent) {
    lines = cases::closure_of(loaded->source, *classification, false);
  } else {
    const realization::Realization found = realization::realize(loaded->source, *classification);
    gaps.insert(gaps.end(), found.gaps.begin(), found.gaps.end());
    lines = types_of(loaded->source, *classification, found);
  }
  const std::string open = open_words(gaps, *classification);
  std::puts(open.empty() ? "complete" : ("undecided " + open).c_str());
  for (const std::string& line : lines) std::puts(line.c_str());
  return 0;
}

/// How single engines of ours contradict all of them together about one file, one line each; in a process of its own.
int engines(const char* file) {
  ontology::Readers readers;
  const auto loaded = rdf::load(std::vector{std::string(file)}, {}, &readers);
  if (!loaded) return 2;
  const Opinion whole = of_the_reasoner(loaded->source);
  const auto tell = [&](const char* name, const Opinion& opinion) {
    for (const std::string& line : contradictions(whole, opinion))
      std::printf("of all engines and %s %s\n", name, line.c_str());
  };
  tell("models", of_models(loaded->source));
  tell("el", of_el(loaded->source));
  tell("consequence", of_consequence(loaded->source));
  return 0;
}

struct Answer {
  Opinion opinion;
  std::string words;  ///< empty: complete
  Effort effort;
};

std::string own_path() { return fs::read_symlink("/proc/self/exe").string(); }

/// The words of answer() about a file.
Answer ours(const Request& request, const fs::path& file) {
  const fs::path output = file.string() + ".answer";
  const char* const question = request.asks_types ? "--answer-types" : "--answer";
  const TimedRun ran = run_timed({own_path(), question, file.string()}, request.seconds, output);
  Answer given{{{}, false, {}}, {}, ran.effort};
  std::ifstream stream(output);
  std::string line;
  std::getline(stream, line);
  given.words = ran.status == 124 ? "late" : ran.status != 0 ? "crashed with " + std::to_string(ran.status) : line;
  if (ran.status == 0 && line == "complete") {
    given.words.clear();
    given.opinion.is_complete = true;
  }
  while (std::getline(stream, line)) given.opinion.closure.push_back(line);
  fs::remove(output);
  return given;
}

/// The originals, each read when it is first wanted.
class Originals {
 public:
  explicit Originals(const Request& request) : request_(request) {}

  /// Nothing if it cannot be read or is too large.
  const owl::Ontology* at(std::size_t place) {
    const auto [known, is_new] = loaded_.try_emplace(place);
    if (!is_new) return known->second.get();
    ontology::Readers readers;
    auto loaded = rdf::load(std::vector{request_.files[place]}, {}, &readers);
    if (loaded && loaded->source.axiom_count() > 0 && loaded->source.axiom_count() <= request_.axioms)
      known->second = std::make_unique<owl::Ontology>(std::move(loaded->source));
    return known->second.get();
  }

 private:
  const Request& request_;
  std::map<std::size_t, std::unique_ptr<owl::Ontology>> loaded_;
};

struct Tally {
  std::uint64_t compared = 0;
  std::uint64_t different = 0;
  std::uint64_t slower = 0;
  std::uint64_t undecided = 0;
  std::uint64_t contradictory = 0;
  std::uint64_t without_konclude = 0;
  double our_seconds = 0;
  double konclude_seconds = 0;
};

/// A variation with its name, of one, two or three files.
std::optional<Mutation> vary(const Request& request, Originals& originals, std::uint64_t seed) {
  base::Random random(seed);
  const std::uint64_t draw = random.below(10);
  const std::size_t wanted = draw < 6 ? 1 : draw < 9 ? 2 : 3;
  std::vector<const owl::Ontology*> chosen;
  std::string names;
  for (std::size_t tries = 0; tries < 50 && chosen.size() < wanted; ++tries) {
    const std::size_t place = random.below(request.files.size());
    const owl::Ontology* original = originals.at(place);
    if (original == nullptr) continue;
    chosen.push_back(original);
    names += fs::path(request.files[place]).filename().string() + ' ';
  }
  if (chosen.empty()) return {};
  const std::size_t facts = request.asks_types ? random.below(most_facts) : 0;
  Mutation made = mutation(chosen, seed, facts);
  made.words = names + made.words;
  return made;
}

std::string cost(const Effort& effort) {
  char text[60];
  std::snprintf(text, sizeof text, "%.2f s %llu MB", effort.user_seconds,
                static_cast<unsigned long long>(effort.peak_kilobytes / 1024));
  return text;
}

void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

/// Konclude's own test of the consistency of an instance of A that is no instance of B, for `... A < B`: its
/// classification misses or invents pairs about which that test is right. For a type, A is the individual.
std::string second_thought(const Request& request, const owl::Ontology& source, const std::string& line,
                           const fs::path& folder) {
  const std::size_t middle = line.find(" < ");
  const std::size_t begin = line.rfind(' ', middle - 1) + 1;
  if (middle == std::string::npos) return {};
  owl::Ontology asked = source;
  const auto class_of = [&](const std::string& name) {
    return name == "Thing" ? owl::thing_term : name == "Nothing" ? owl::nothing_term : asked.named_class(name);
  };
  const owl::FileId file = asked.add_file("asked");
  const std::string first = line.substr(begin, middle - begin);
  const owl::TermId instance = asked.individual(request.asks_types ? first : "http://asked.example/#instance");
  const owl::TermId super = class_of(line.substr(middle + 3));
  if (!request.asks_types) asked.add(owl::AxiomKind::class_assertion, {class_of(first), instance}, file, 0);
  const owl::TermId others = asked.term(owl::TermKind::object_complement_of, {super});
  asked.add(owl::AxiomKind::class_assertion, {others, instance}, file, 0);
  const fs::path document = folder / "asked.ofn";
  write(document, functional_syntax(asked));
  const auto has_model = konclude_consistency(document, request.seconds);
  if (!has_model) return has_model.error();
  return *has_model ? "Konclude finds an instance that shows that it does not follow"
                    : "Konclude finds no instance of the first that is none of the second: it follows";
}

/// Compares one variation, tells what is worth a line, and keeps its file.
void compare(const Request& request, const Mutation& made, std::uint64_t seed, bool has_konclude, Tally& tally) {
  const fs::path folder = fs::temp_directory_path() / ("mutation-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const fs::path functional = folder / ("mutation-" + std::to_string(seed) + ".ofn");
  const fs::path xml = folder / ("mutation-" + std::to_string(seed) + ".owx");
  write(functional, functional_syntax(made.source));
  write(xml, owlxml::owl_xml(made.source));
  const bool is_xml = seed % 2 == 0;
  const fs::path& file = is_xml ? xml : functional;
  const Answer we = ours(request, file);
  const Answer again = we.effort.user_seconds < 1 ? ours(request, is_xml ? functional : xml) : we;
  std::vector<std::string> lines;
  if (!we.words.empty()) lines.push_back(we.words);
  if (we.words != again.words || we.opinion.closure != again.opinion.closure) {
    lines.push_back("DIFFERENT in functional-style syntax and OWL/XML: " + again.words);
    ++tally.different;
  }
  Effort effort;
  std::string verdict = "NOT COMPARED";
  if (has_konclude) {
    const auto closure = (request.asks_types ? konclude_types : konclude_closure)(file, request.seconds, &effort);
    verdict = closure ? "answered" : closure.error();
    if (!closure) ++tally.without_konclude;
    const auto found = closure ? contradictions(we.opinion, {*closure, true, {}}) : std::vector<std::string>();
    if (!found.empty()) ++tally.different;
    for (std::size_t at = 0; at < found.size() && at < 5; ++at) lines.push_back("DIFFERENT: " + found[at]);
    if (!found.empty()) {
      const std::string thought = second_thought(request, made.source, found.front(), folder);
      if (!thought.empty()) lines.push_back("about the first pair " + thought);
    }
    if (found.size() > 5) lines.push_back("DIFFERENT: and " + std::to_string(found.size() - 5) + " more");
    const double beyond = we.effort.user_seconds - effort.user_seconds;
    if (closure && beyond > slower_seconds && we.effort.user_seconds > slower_times * effort.user_seconds) {
      lines.emplace_back("slower");
      ++tally.slower;
    }
  }
  ++tally.compared;
  tally.undecided += we.words.empty() ? 0U : 1U;
  tally.contradictory += we.opinion.closure == cases::Closure{"inconsistent"} ? 1U : 0U;
  tally.our_seconds += we.effort.user_seconds;
  tally.konclude_seconds += effort.user_seconds;
  if (!lines.empty() || request.shows_all) {
    std::printf("seed %llu: %s: we %s, Konclude %s %s\n", static_cast<unsigned long long>(seed), made.words.c_str(),
                cost(we.effort).c_str(), verdict.c_str(), cost(effort).c_str());
    for (const std::string& line : lines) std::printf("    %s\n", line.c_str());
    std::fflush(stdout);
    if (!lines.empty()) fs::copy_file(file, file.filename(), fs::copy_options::overwrite_existing);
  }
  fs::remove_all(folder);
}

/// The same for our engines one by one.
void compare_engines(const Request& request, const Mutation& made, std::uint64_t seed, Tally& tally) {
  const fs::path file = "mutation-" + std::to_string(seed) + ".ofn";
  const fs::path output = file.string() + ".answer";
  write(file, functional_syntax(made.source));
  const TimedRun ran = run_timed({own_path(), "--engines", file.string()}, request.seconds, output);
  std::ifstream stream(output);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line) && lines.size() < 5;) lines.push_back("DIFFERENT: " + line);
  ++tally.compared;
  if (!lines.empty()) ++tally.different;
  if (ran.status == 124) ++tally.undecided;
  if (ran.status != 0 && ran.status != 124) lines.push_back("crashed with " + std::to_string(ran.status));
  tally.our_seconds += ran.effort.user_seconds;
  if (!lines.empty() || request.shows_all) {
    std::printf("seed %llu: %s: %s\n", static_cast<unsigned long long>(seed), made.words.c_str(),
                cost(ran.effort).c_str());
    for (const std::string& line : lines) std::printf("    %s\n", line.c_str());
    std::fflush(stdout);
  }
  fs::remove(output);
  if (lines.empty()) fs::remove(file);
}

int run(const Request& request) {
  const bool wants_konclude = !request.asks_engines && !request.only_writes;
  const bool has_konclude = wants_konclude && is_konclude_installed();
  if (!has_konclude && wants_konclude)
    std::printf("NOT COMPARED with Konclude, which is not installed (Debian: apt-get install konclude)\n");
  Originals originals(request);
  Tally tally;
  for (std::uint64_t seed = request.first; seed < request.first + request.seeds; ++seed) {
    const std::optional<Mutation> made = vary(request, originals, seed);
    if (made && request.only_writes) {
      write("mutation-" + std::to_string(seed) + ".ofn", functional_syntax(made->source));
      continue;
    }
    if (made && request.asks_engines) compare_engines(request, *made, seed, tally);
    if (made && !request.asks_engines) compare(request, *made, seed, has_konclude, tally);
  }
  std::printf(
      "%llu variations, %llu different, %llu slower, %llu undecided, %llu contradictory, %llu without an answer of "
      "Konclude; "
      "we took %.1f s, Konclude %.1f s\n",
      static_cast<unsigned long long>(tally.compared), static_cast<unsigned long long>(tally.different),
      static_cast<unsigned long long>(tally.slower), static_cast<unsigned long long>(tally.undecided),
      static_cast<unsigned long long>(tally.contradictory), static_cast<unsigned long long>(tally.without_konclude),
      tally.our_seconds, tally.konclude_seconds);
  return tally.different == 0 ? 0 : 1;
}

}  // namespace
}  // namespace geminga::compare

int main(int argc, char** argv) {
  geminga::compare::Request request;
  try {
    if (argc == 3 && std::strcmp(argv[1], "--answer") == 0) return geminga::compare::answer(argv[2], false);
    if (argc == 3 && std::strcmp(argv[1], "--answer-types") == 0) return geminga::compare::answer(argv[2], true);
    if (argc == 3 && std::strcmp(argv[1], "--engines") == 0) return geminga::compare::engines(argv[2]);
    for (int at = 1; at < argc; ++at) {
      const std::string word = argv[at];
      const bool has_next = at + 1 < argc;
      if (word == "--seeds" && has_next) {
        request.seeds = std::stoull(argv[++at]);
      } else if (word == "--first" && has_next) {
        request.first = std::stoull(argv[++at]);
      } else if (word == "--seconds" && has_next) {
        request.seconds = static_cast<unsigned>(std::stoul(argv[++at]));
      } else if (word == "--axioms" && has_next) {
        request.axioms = std::stoul(argv[++at]);
      } else if (word == "--engines") {
        request.asks_engines = true;
      } else if (word == "--types") {
        request.asks_types = true;
      } else if (word == "--write") {
        request.only_writes = true;
      } else if (word == "--all") {
        request.shows_all = true;
      } else {
        request.files.push_back(word);
      }
    }
    if (!request.files.empty()) return geminga::compare::run(request);
    std::fprintf(stderr,
                 "usage: %s [--seeds N] [--first N] [--seconds N] [--axioms N] [--types] [--engines] [--write] [--all] "
                 "FILE...\n",
                 argv[0]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
  }
  return 2;
}
