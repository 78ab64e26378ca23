#include "ontology/loading/refused.hpp"

#include "ontology/command/words.hpp"
#include "reasoning/syntax/error.hpp"

namespace geminga::ontology {

std::optional<std::string> describe_refused(const rdf::Loaded& loaded) {
  if (loaded.refused.empty()) return std::nullopt;
  return "a file cannot be read: " + syntax::to_string(loaded.refused.front());
}

Exit exit_of_list(const rdf::Loaded& loaded, Exit exit) {
  return exit == Exit::yes && !loaded.refused.empty() ? Exit::no : exit;
}

Exit exit_of_answer(const rdf::Loaded& loaded, Exit exit) {
  if (exit != Exit::no || loaded.refused.empty()) return exit;
  return say_error("there may be an answer in the files that were left out: mend them, or give the others alone");
}

}  // namespace geminga::ontology
