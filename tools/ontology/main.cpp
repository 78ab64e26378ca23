// geminga-ontology: checks, classifies, explains, draws and compiles ontologies; only serve and fetch need a daemon.
#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "manual/describe.hpp"
#include "manual/mistake.hpp"
#include "ontology/cage.hpp"
#include "ontology/command/limits.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "reasoning/compiled/container.hpp"

namespace {

using namespace geminga::ontology;

constexpr const char* examples = R"(
Examples:
  geminga-ontology check team/                      every ontology file in the folder, together
  geminga-ontology classify robot-soccer.ttl core.ttl
  geminga-ontology classify --closure team/         one SUB<TAB>SUPER line for each entailed subsumption
  geminga-ontology subsumes team/ --sub soccer:SharedBallInfo --super soccer:BallInfo
  geminga-ontology explain team/ --sub soccer:SharedBallInfo --super soccer:BallInfo
  geminga-ontology report team/                     missing labels, cycles, unused names: what authors may mend
  geminga-ontology repair team/                     which axioms to take out, if classes can have no instance
  geminga-ontology diff old/ team/                  what changed, and what follows from it
  geminga-ontology entails team/ expected.ttl       does every axiom of expected.ttl follow?
  geminga-ontology consistent team/
  geminga-ontology id soccer:BallInfo soccer:CartesianFieldFrame
  geminga-ontology compile team/ -o team.geminga
  geminga-ontology draw team/ --root soccer:BallInfo --format svg > ball.svg
  geminga-ontology infer team/ -o inferred.owl      with what follows, for Protégé or ROBOT
  geminga-ontology convert oeo.omn -o oeo.ttl
  geminga-ontology merge team/ -o team.owl
  geminga-ontology extract team/ soccer:BallInfo --kind bottom -o ball.ttl
  geminga-ontology query team/ 'SELECT ?class WHERE { ?class rdfs:subClassOf soccer:BallInfo }'
  geminga-ontology realize team/                    the most specific types of each individual
  geminga-ontology instances team/ 'soccer:BallInfo'
  geminga-ontology rank --services services/ --requests queries/ --ontologies ontology/
  geminga-ontology serve team/ --version 7          offer it to the team
  geminga-ontology fetch --from base -o theirs/     take it

FILES are RDF/XML, Turtle, N-Triples, OWL functional syntax, OWL Manchester syntax or OWL/XML, also packed by gzip
(.gz), or folders of them, with all below. Nothing is fetched from a network: owl:imports are looked for among the
files that are named. Names are prefix:Name, <IRI>, a label, or, where it is unique, Name alone.
Exit status: 0 yes or done, 1 no or a problem found, 2 wrong usage or a file that cannot be loaded, 3 no daemon
(serve, fetch), 4 a limit was reached.)";

int run(int argc, char** argv) {
  CLI::App program("Checks, classifies, explains, draws and compiles ontologies.", "geminga-ontology");
  program.set_version_flag("--version",
                           "geminga-ontology " GEMINGA_VERSION " (compiled ontologies " +
                               std::to_string(geminga::compiled::compiled_version) + ")",
                           "Print the version and exit");
  program.footer(examples);
  program.require_subcommand(1);
  Choice choice;
  for (const auto add :
       {add_check,     add_classify, add_subsumes, add_entails, add_consistent, add_explain, add_id,
        add_compile,   add_describe, add_draw,     add_infer,   add_convert,    add_merge,   add_realize,
        add_instances, add_query,    add_rank,     add_repair,  add_diff,       add_extract, add_report,
        add_align,     add_serve,    add_fetch,    add_adopt,   add_task})
    add(program, choice);
  if (const auto description = geminga::manual::described(program, argc, argv)) {
    return std::fputs(description->c_str(), stdout) >= 0 && std::fflush(stdout) == 0 ? 0
                                                                                     : static_cast<int>(Exit::usage);
  }
  try {
    program.parse(argc, argv);
    if (const auto empty = geminga::manual::empty_text(program)) return static_cast<int>(say_error(*empty));
  } catch (const CLI::Success& wanted) {  // --help and --version
    return program.exit(wanted);
  } catch (const CLI::ParseError& error) {
    return static_cast<int>(say_error(geminga::manual::mistake(program, error)));
  }
  limit_memory(choice.memory_limit_mib);
  choice.limits.memory_mib = choice.memory_limit_mib;
  limit_time(choice.limits.seconds);
  if (choice.prepare) {
    if (const Exit prepared = choice.prepare(); prepared != Exit::yes) return static_cast<int>(prepared);
  }
  if (const auto closed = close_cage(*program.get_subcommands().front(), choice); !closed)
    return static_cast<int>(say_error(closed.error()));
  return static_cast<int>(choice.run());
}

}  // namespace

#ifdef __SANITIZE_ADDRESS__
// The search for leaks at the end traces the process itself, which the cage forbids. The tests of the modules search
// for leaks.
extern "C" int __lsan_is_turned_off() { return 1; }  // NOLINT(bugprone-reserved-identifier)
#endif

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the limit of a file then fails as on a full disk, with a message
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("geminga-ontology: there is not enough memory: raise --memory-limit, or split the ontology\n", stderr);
    return static_cast<int>(Exit::timed_out);
  } catch (const std::exception& error) {
    say_error("something unexpected went wrong: " + std::string(error.what()));
  }
  return static_cast<int>(Exit::usage);
}
