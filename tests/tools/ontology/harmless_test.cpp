// Names and labels of a file reach no terminal in a form that it could obey, and JSON says all of them.
#include "base/harmless.hpp"

#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utf8.h>

#include <array>
#include <boost/json.hpp>
#include <string>
#include <vector>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

/// The harmful characters of a text, but for line ends and tabs.
std::string harmful_in(const std::string& text) {
  std::string found;
  for (auto at = text.begin(); at != text.end();) {
    const char32_t character = utf8::next(at, text.end());
    if (character != '\n' && character != '\t' && base::is_harmful(character))
      found += std::to_string(static_cast<unsigned>(character)) + ' ';
  }
  return found;
}

/// Names and labels that turn a terminal's colour, its direction of writing, and its line.
const std::string hostile =
    "<http://e/A\u009b31m> a owl:Class ; rdfs:label \"red \u009b31m, turned \u202e, broken \u2028 \u0085\" ; "
    "rdfs:subClassOf <http://e/B\u202e> .\n<http://e/B\u202e> a owl:Class ; rdfs:label \"red \u009b31m, turned \u202e, "
    "broken \u2028 \u0085\" .\n"
    "<http://e/C\u2066> rdfs:subClassOf <http://e/A\u009b31m> , <http://e/N> .\n"
    "<http://e/N> a owl:Class ; owl:disjointWith <http://e/A\u009b31m> .\n"
    "<http://e/i\u202e> a <http://e/A\u009b31m> .\n";

TEST(Harmless, NoCommandPrintsWhatATerminalObeys) {
  const Program program;
  program.turtle("a.ttl", hostile);
  program.turtle("b\u202e.ttl", "<http://e/A\u009b31m> rdfs:subClassOf <http://e/B\u202e> .\n");
  program.turtle("broken\u202e.ttl", "\u009b31m is no statement");
  const std::string a = "<http://e/A\u009b31m>";
  const std::string b = "<http://e/B\u202e>";
  const std::string all = "SELECT * WHERE { ?s ?p ?o }";
  const std::vector<std::vector<std::string>> runs{
      {"check", "a.ttl"},
      {"check", "a.ttl", "--json"},
      {"check", "broken\u202e.ttl"},
      {"check", "broken\u202e.ttl", "--json"},
      {"check", "missing\u202e.ttl"},
      {"classify", "a.ttl"},
      {"classify", "a.ttl", "--json"},
      {"classify", "a.ttl", "--closure"},
      {"subsumes", "a.ttl", "--sub", a, "--super", b},
      {"subsumes", "a.ttl", "--sub", a, "--super", b, "--json"},
      {"subsumes", "a.ttl", "--sub", "no\u202ebody", "--super", b},
      {"explain", "a.ttl", "--sub", a, "--super", b},
      {"explain", "a.ttl", "--sub", a, "--super", b, "--json"},
      {"entails", "a.ttl", "b\u202e.ttl"},
      {"entails", "a.ttl", "b\u202e.ttl", "--json"},
      {"consistent", "a.ttl", "--json"},
      {"id", "a.ttl", a},
      {"id", a},
      {"id", a, "--json"},
      {"draw", "a.ttl"},
      {"draw", "a.ttl", "--format", "mermaid"},
      {"draw", "a.ttl", "--root", a},
      {"query", "a.ttl", all},
      {"query", "a.ttl", all, "--json"},
      {"query", "a.ttl", all, "--format", "tsv"},
      {"query", "a.ttl", "\u009b31m"},
      {"compile", "b\u202e.ttl", "-o", "missing\u202e/x"},
      {"no\u202ecommand"},
      {"check", "--no\u202eflag"},
  };
  for (const auto& run : runs) {
    const Outcome outcome = program.run(run);
    std::string words;
    for (const std::string& word : run) words += word + ' ';
    EXPECT_EQ(harmful_in(outcome.out), "") << words;
    EXPECT_EQ(harmful_in(outcome.err), "") << words;
    EXPECT_NE(outcome.status, -1) << words;
    if (run.back() != "--json") continue;
    boost::system::error_code error;
    (void)boost::json::parse(outcome.out, error);
    EXPECT_FALSE(error) << words << outcome.out;
  }
}

TEST(Harmless, JsonSaysTheNameAsItIs) {
  const Program program;
  program.turtle("a.ttl", hostile);
  const auto document = boost::json::parse(program.run({"classify", "a.ttl", "--json"}).out);
  EXPECT_NE(boost::json::serialize(document).find("http://e/A\u009b31m"), std::string::npos);
}

/// The output of the program on a terminal.
std::string on_terminal(const Program& program, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), std::string(GEMINGA_BINARY_DIR) + "/bin/geminga-ontology");
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  const std::string folder = (program.folder() / "in").string();
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    if (chdir(folder.c_str()) == 0) execv(pointers.front(), pointers.data());
    _exit(127);
  }
  std::string output;
  std::array<char, 4096> bytes{};
  for (ssize_t count = 0; (count = read(terminal, bytes.data(), bytes.size())) > 0;)
    output.append(bytes.data(), static_cast<std::size_t>(count));
  close(terminal);
  int status = 0;
  waitpid(child, &status, 0);
  std::erase(output, '\r');  // the terminal's own
  return output;
}

TEST(Harmless, DataGoesWholeToAFileAndHarmlessToATerminal) {
  const Program program;
  program.turtle("a.ttl", hostile);
  const std::vector<std::vector<std::string>> runs{
      {"query", "a.ttl", "SELECT ?o WHERE { ?s rdfs:label ?o }", "--format", "csv"},
      {"query", "a.ttl", "CONSTRUCT { ?s rdfs:label ?o } WHERE { ?s rdfs:label ?o }"},
      {"convert", "a.ttl", "-o", "-"}};
  for (const auto& run : runs) {
    const std::string shown = on_terminal(program, run);
    EXPECT_NE(shown.find("turned \ufffd"), std::string::npos) << shown;
    EXPECT_EQ(harmful_in(shown), "") << run.front();
  }
  EXPECT_NE(program.run(runs[0]).out.find("turned \u202e"), std::string::npos);
  EXPECT_NE(program.run(runs[2]).out.find("turned"), std::string::npos);
}

}  // namespace
}  // namespace geminga::ontology
