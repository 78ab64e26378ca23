// Tasks that a file describes in the words of ontology/capability.ttl.
#ifndef GEMINGA_ONTOLOGY_TASKS_TASKS_HPP
#define GEMINGA_ONTOLOGY_TASKS_TASKS_HPP

#include <cstdint>
#include <expected>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/owl/print.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::ontology {

/// The namespace of the words for tasks.
inline constexpr std::string_view task_words = "https://geminga.example/capability#";

struct Role {
  std::string iri;   ///< empty: it has no name
  std::string name;  ///< empty: it has no IRI
  /// The class that a holder is known to be in: canonical where it is stated as a class (manchester/canonical.hpp),
  /// else as written.
  std::string expression;
  std::string condition;  ///< over attributes; empty: none
  std::uint64_t count = 1;
  bool is_shared = false;
  std::uint32_t line = 0;  ///< where it is described
};

struct Task {
  std::string iri;     ///< empty: it has no name
  std::string name;    ///< as that of a role
  std::string prefer;  ///< `KEY asc|desc`; empty: none
  std::vector<Role> roles;
  std::uint32_t line = 0;
};

/// Something that makes a file no task.
struct TaskFault {
  std::uint32_t line = 0;  ///< 0: unknown
  std::string text;
};

/// The individuals of class Task of the file, and their roles, in the order of the file. What is said of a role may
/// stand in any file. A role without a word on its holder, one that is described twice, numbers and truth values that
/// are none, and what the reader could not use of the file are faults: a team must not be chosen by half a task.
/// `name_of_iri` names tasks and roles. Adds terms to the source.
[[nodiscard]] std::expected<std::vector<Task>, TaskFault> read_tasks(owl::Ontology& source, owl::FileId file,
                                                                     const owl::ShortName& name_of_iri);

}  // namespace geminga::ontology

#endif
