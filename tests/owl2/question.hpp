// One question that a test case asks of geminga-ontology, under the name that ctest knows it by.
#ifndef GEMINGA_TESTS_OWL2_QUESTION_HPP
#define GEMINGA_TESTS_OWL2_QUESTION_HPP

#include <filesystem>
#include <string>
#include <vector>

#include "owl2/published_cases.hpp"

namespace geminga::owl2 {

struct Question {
  std::string name;  ///< e.g. `WebOnt-I4.6-003.consistency`, with `.functional` where that is the syntax
  bool is_yes = false;
  std::string command;             ///< of geminga-ontology
  std::vector<std::string> files;  ///< its arguments
};

/// Writes the documents of the cases below the folder and says what to ask about them: of each case its consistency or
/// inconsistency and its entailment or non-entailment, in each syntax. Files that are there with the same text are left
/// alone. Two cases of one name are an error.
[[nodiscard]] std::vector<Question> write_questions(const std::vector<PublishedCase>& cases,
                                                    const std::filesystem::path& folder);

/// The script for ctest: an add_test() for each question, which calls `runner ask NAME yes|no COMMAND FILE...`.
[[nodiscard]] std::string ctest_script(const std::vector<Question>& questions, const std::string& runner);

}  // namespace geminga::owl2

#endif
