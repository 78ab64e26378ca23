// What check finds: how complete the answers are, what was left out, which classes are empty, which names collide.
#ifndef GEMINGA_ONTOLOGY_FINDINGS_HPP
#define GEMINGA_ONTOLOGY_FINDINGS_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collisions.hpp"
#include "knowledge.hpp"
#include "names.hpp"
#include "reasoning/explanation/explain.hpp"

namespace geminga::ontology {

/// One axiom that may have more to say than was understood.
struct LeftOutAxiom {
  std::string axiom;  ///< in readable syntax
  std::string file;
  std::uint32_t line = 0;
};

/// Everything that was left out because of one construct, by the reader or by the reasoner.
struct LeftOutGroup {
  owl::LeftOut summary;
  std::vector<LeftOutAxiom> axioms;  ///< by file and line; none of what the reader could not even make an axiom of
};

struct Unsatisfiable {
  std::string name;
  std::vector<explanation::ExplainedAxiom> reason;  ///< a minimal set; empty: nobody looked for it, or none was found
};

/// Reasons are looked for of so many classes; whoever wants others asks `explain`.
inline constexpr std::size_t max_explained_classes = 100;

/// What was not decided; see reasoner::Undecided.
struct Open {
  std::vector<std::string> classes;
  bool consistency = false;
  std::optional<std::string> held_up_by;
};

/// What was looked at.
struct Sources {
  std::vector<owl::LoadedFile> files;
  std::optional<std::size_t> triples;  ///< nothing: a compiled ontology does not keep how many there were
  std::size_t classes = 0;
  std::size_t axioms = 0;
  std::size_t units = 0;                     ///< that can stand behind a number in a condition
  std::vector<owl::LeftOut> units_left_out;  ///< why others cannot; they are nothing of the taxonomy
  std::vector<rdf::UnresolvedImport> unresolved;
  std::vector<rdf::PrefixConflict> conflicts;
  /// Of a compiled ontology: which file has changed since, in one line.
  std::optional<std::string> outgrown;
};

struct Findings {
  Sources sources;
  std::vector<LeftOutGroup> left_out;  ///< by construct
  std::vector<std::string> gaps;       ///< why something may be missing although every axiom was used
  Open open;                           ///< of sources; a compiled ontology has it among its gaps
  bool is_consistent = true;
  std::vector<explanation::ExplainedAxiom>
      contradiction;  ///< a minimal set that contradicts itself, where there is one
  /// Where there is a contradiction, those that can have no instance even if all facts are left aside.
  std::vector<Unsatisfiable> unsatisfiable;
  Collisions collisions;
  NameFindings names;  ///< of sources; a compiled ontology does not keep what was declared

  [[nodiscard]] bool is_complete() const { return left_out.empty() && gaps.empty(); }
  [[nodiscard]] bool has_problem() const {
    return !unsatisfiable.empty() || !collisions.found.empty() || !is_consistent || sources.outgrown ||
           names.has_problem();
  }
};

/// Where the budget is spent, no more reasons are looked for.
[[nodiscard]] Findings find(const Knowledge& knowledge, const compiled::Ontology& ontology, base::Budget& budget);
/// The same of a compiled ontology, whose axioms have been verified.
[[nodiscard]] Findings find(const compiled::Ontology& ontology, base::Budget& budget);

/// One line: whether every answer is there, and why not.
[[nodiscard]] std::string verdict(const Findings& findings);

/// FILE:LINE, or FILE where the line is not known.
[[nodiscard]] std::string place(const std::string& file, std::uint32_t line);
/// The imports that no given file answers, in lines; nothing where there are none.
[[nodiscard]] std::string unresolved_as_text(const std::vector<rdf::UnresolvedImport>& unresolved);

/// One JSON document.
[[nodiscard]] std::string as_json(const Findings& findings);

}  // namespace geminga::ontology

#endif
