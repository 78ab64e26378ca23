// The program that ctest calls: `extract FOLDER` writes the documents of the published cases and the list of tests,
// `ask` runs one, `table` checks OUTSIDE.tsv, `absent` says that there are no published cases here.
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "owl2/judgement.hpp"
#include "owl2/published_cases.hpp"
#include "owl2/question.hpp"
#include "support/process.hpp"

namespace geminga::owl2 {
namespace {

/// The exit status that ctest counts as a test that was skipped.
constexpr int skipped = 77;

/// As often system::patience; ctest has less with its time limit.
constexpr int most_waits = 20;

Outside outside() {
  std::ifstream file(std::string(GEMINGA_SOURCE_DIR) + "/tests/owl2/OUTSIDE.tsv", std::ios::binary);
  auto read = read_outside(std::string(std::istreambuf_iterator<char>(file), {}));
  if (!read) throw std::runtime_error("OUTSIDE.tsv: " + read.error());
  return std::move(*read);
}

/// The list of tests goes to standard output.
int extract(const std::string& runner, const std::string& folder) {
  const auto published = find_published_cases();
  if (!published) {
    std::cout << "add_test(owl2.published-cases [==[" << runner << "]==] absent)\n"
              << "set_tests_properties(owl2.published-cases PROPERTIES SKIP_RETURN_CODE " << skipped << ")\n";
    return 0;
  }
  const auto cases = read_published_cases(*published);
  if (!cases) throw std::runtime_error(cases.error());
  const auto questions = write_questions(*cases, folder);
  std::cout << ctest_script(questions, runner) << "add_test(owl2.table-of-those-outside [==[" << runner
            << "]==] table [==[" << folder << "]==])\n";
  return 0;
}

/// Every row is about a question that is asked.
int check_table(const std::string& folder) {
  const auto published = find_published_cases();
  const auto cases =
      published ? read_published_cases(*published) : std::unexpected<std::string>("the published cases are gone");
  if (!cases) throw std::runtime_error(cases.error());
  Outside rows = outside();
  const std::size_t count = rows.size();
  const auto questions = write_questions(*cases, folder);
  for (const Question& question : questions) rows.erase(question.name);
  for (const auto& [name, reason] : rows) std::cout << "nothing is asked by the name of " << name << '\n';
  std::cout << cases->size() << " cases, " << questions.size() << " questions, " << count << " of them outside\n";
  return rows.empty() ? 0 : 1;
}

int absent() {
  std::cout << "skipped: no owl2-testcases/all.rdf in $GEMINGA_TEST_DATA or ../shared/data; tests/cases still holds "
               "every construct\n";
  return skipped;
}

int ask(const std::vector<std::string>& words) {
  const std::string& name = words[0];
  std::vector<std::string> command{system::program("geminga-ontology")};
  command.insert(command.end(), words.begin() + 2, words.end());
  system::Process process({command, {}, {}});
  std::optional<int> status;
  for (int waits = 0; waits < most_waits && !status; ++waits) status = process.wait();
  const Judgement judgement = judge(name, words[1] == "yes", status.value_or(-1), outside());
  for (const std::string& word : command) std::cout << word << ' ';
  std::cout << '\n' << process.said() << "exit status " << status.value_or(-1) << ": " << judgement.words << '\n';
  return judgement.is_passed ? 0 : 1;
}

int run(const std::vector<std::string>& words) {
  if (words.size() == 3 && words[1] == "extract") return extract(words[0], words[2]);
  if (words.size() == 3 && words[1] == "table") return check_table(words[2]);
  if (words.size() == 2 && words[1] == "absent") return absent();
  if (words.size() >= 6 && words[1] == "ask") return ask({words.begin() + 2, words.end()});
  std::cerr << "usage: " << words[0] << " extract FOLDER | table FOLDER | absent | ask NAME yes|no COMMAND FILE...\n";
  return 2;
}

}  // namespace
}  // namespace geminga::owl2

int main(int argc, char** argv) {
  try {
    return geminga::owl2::run({argv, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << argv[0] << ": " << error.what() << '\n';
    return 1;
  }
}
