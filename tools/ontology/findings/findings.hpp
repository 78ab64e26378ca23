// The findings of check: completeness, omissions, classes that can have no instance, names that collide or are
// doubtful.
#ifndef GEMINGA_ONTOLOGY_FINDINGS_FINDINGS_HPP
#define GEMINGA_ONTOLOGY_FINDINGS_FINDINGS_HPP

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ontology/findings/collisions.hpp"
#include "ontology/findings/doubtful_names.hpp"
#include "ontology/loading/classified_files.hpp"
#include "reasoning/explanation/explain.hpp"
#include "reasoning/owl/left_out.hpp"
#include "reasoning/owl/loaded_file.hpp"

namespace geminga::ontology {

/// A line of a file; 0: unknown.
struct Place {
  std::string file;
  std::uint32_t line = 0;
  auto operator<=>(const Place&) const = default;
};

/// Omissions of the reader or of the reasoner because of one construct, or remarks of the reader.
struct LeftOutGroup {
  owl::LeftOut summary;
  std::vector<Place> places;  ///< of what the reader left out, ascending, each line once, the first ones of each file
  std::vector<explanation::ExplainedAxiom> axioms;  ///< by file and line; omissions of the reader are no axioms
};

/// A class that can have no instance; see explanation::Unsatisfiable. `explain` gives the reasons that are not here.
struct Unsatisfiable {
  std::string name;
  std::optional<std::string> root;  ///< the class because of which it can have none; nothing: it is a root itself
  std::vector<explanation::ExplainedAxiom> reason;
};

/// Questions that were not decided; see reasoner::Undecided. That of consistency is also open because of what was left
/// out.
struct Open {
  std::vector<std::string> classes;
  bool consistency = false;
  std::optional<std::string> held_up_by;
};

/// The files that were checked.
struct Sources {
  std::vector<owl::LoadedFile> files;
  std::optional<std::size_t> triples;  ///< nothing: a compiled ontology does not keep their number
  std::size_t classes = 0;
  std::size_t axioms = 0;
  std::size_t units = 0;                     ///< units that can stand behind a number in a condition
  std::vector<owl::LeftOut> units_left_out;  ///< why other units cannot; the taxonomy is complete without them
  std::vector<rdf::UnresolvedImport> unresolved;
  std::vector<rdf::PrefixConflict> conflicts;
  std::vector<syntax::LoadError> refused;  ///< files of folders that could not be read and were left out
  /// Of a compiled ontology: the file that has changed since, in one line.
  std::optional<std::string> outgrown;
};

struct Findings {
  Sources sources;
  std::vector<LeftOutGroup> left_out;  ///< by construct
  std::vector<LeftOutGroup> remarks;   ///< of the readers: what was used, but is not quite what the files say
  std::vector<std::string> gaps;       ///< why something may be missing although every axiom was used
  /// Classes of which superclasses may be missing because of what was left out: find_touched_classes(). Nothing: it may
  /// be any, as something that was left out is no axiom, or there are gaps or refused files, or the ontology is too
  /// large to look.
  std::optional<std::vector<std::string>> touched;
  Open open;                     ///< of sources; a compiled ontology has it among its gaps
  bool is_consistent = true;     ///< false: there is a contradiction
  reasoner::Answer consistency;  ///< whether there is none, with unknown; `unknown` in `open`, too
  /// A minimal set of axioms that contradict each other; empty where there is no contradiction or none was found.
  std::vector<explanation::ExplainedAxiom> contradiction;
  /// Roots first. Where there is a contradiction, the classes that can have no instance even if all facts are left
  /// aside.
  std::vector<Unsatisfiable> unsatisfiable;
  /// False: there is a contradiction, and more classes may have no instance even if all facts are left aside.
  bool is_searched_without_facts = true;
  Collisions collisions;
  NameFindings names;  ///< of sources; a compiled ontology does not keep declarations

  [[nodiscard]] bool is_complete() const { return left_out.empty() && gaps.empty() && sources.refused.empty(); }
  [[nodiscard]] bool has_problem() const {
    return !sources.refused.empty() || !unsatisfiable.empty() || !collisions.found.empty() || !is_consistent ||
           sources.outgrown || names.has_problem();
  }
};

/// Gathers the findings. Where the budget is spent, no more reasons are looked for. Adds the repairs of ill-typed
/// literals to the source.
[[nodiscard]] Findings find(ClassifiedFiles& classified, const compiled::Ontology& ontology, base::Budget& budget);
/// Gathers the findings of a compiled ontology, whose axioms have been verified.
[[nodiscard]] Findings find(const compiled::Ontology& ontology, base::Budget& budget);

/// One line: whether every answer is there, and why not.
[[nodiscard]] std::string verdict(const Findings& findings);

/// The imports that no given file answers, a line each; nothing where there are none.
[[nodiscard]] std::string unresolved_as_text(const std::vector<rdf::UnresolvedImport>& unresolved);

/// One JSON document.
[[nodiscard]] std::string as_json(const Findings& findings);

}  // namespace geminga::ontology

#endif
