// From the team's ontology files to an ontology that the participant can use: compiled by a child, mapped here.
#ifndef GEMINGA_DAEMON_ONTOLOGY_LOADER_HPP
#define GEMINGA_DAEMON_ONTOLOGY_LOADER_HPP

#include <expected>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "daemon/child.hpp"
#include "reasoning/compiled/ontology.hpp"

namespace geminga::daemon {

/// What loading has given.
struct LoadedOntology {
  std::unique_ptr<compiled::Ontology> ontology;  ///< null: there are no files
  std::vector<std::string> remarks;              ///< what the compiler said although it succeeded, a line each
};

/// Why nobody can match by this ontology of these files, where it contradicts itself: every class is empty then.
/// Nothing where it does not, where that was not decided within the limits, and where there is none.
[[nodiscard]] std::optional<std::string> contradiction_in(const LoadedOntology& loaded,
                                                          const std::vector<std::string>& files);

/// Names for the beginnings of IRIs; both as Turtle can write them.
using Prefixes = std::map<std::string, std::string>;

/// Where geminga-ontology is: beside this program, else on PATH; the plain name where it is nowhere.
[[nodiscard]] std::string find_compiler();

/// Runs `geminga-ontology compile` with bounds, and maps what it wrote. The daemon itself reads no RDF: a hostile file
/// can hurt only the child. What it wrote, or the user has compiled, is copied and verified on a thread, so that the
/// event loop serves meanwhile, however large it is.
class OntologyLoader {
 public:
  /// The errors are lines, with file and line where the compiler gave them; never empty.
  using Done = std::function<void(std::expected<LoadedOntology, std::vector<std::string>>)>;

  OntologyLoader(boost::asio::io_context& context, std::string compiler, ChildLimits limits = {});
  ~OntologyLoader();
  OntologyLoader(const OntologyLoader&) = delete;
  OntologyLoader& operator=(const OntologyLoader&) = delete;

  /// Loads these files and folders, and calls `done` once from the event loop. `prefixes` may be used in names beside
  /// those of the files. A load that is under way is given up, and its `done` never called. A single file that ends in
  /// `.geminga` is taken as compiled already, and knows no prefixes but its own. At first only what matching needs of
  /// it is verified; where an ontology was loaded before, all of it is.
  void load(const std::vector<std::string>& files, const Prefixes& prefixes, Done done);
  [[nodiscard]] bool is_loading() const;
  /// Whether the thread is at work, even for a load that was given up. Until it is done, the process must not destroy
  /// what the thread uses.
  [[nodiscard]] bool is_at_work() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace geminga::daemon

#endif
