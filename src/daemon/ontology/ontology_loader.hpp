// From the team's ontology files to an ontology that the participant can use: compiled by a child, mapped here.
#ifndef GEMINGA_DAEMON_ONTOLOGY_ONTOLOGY_LOADER_HPP
#define GEMINGA_DAEMON_ONTOLOGY_ONTOLOGY_LOADER_HPP

#include <cstdint>
#include <expected>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "daemon/child/child.hpp"
#include "daemon/ontology/background.hpp"
#include "reasoning/compiled/ontology.hpp"

namespace geminga::base {
class PrivateFile;
}

namespace geminga::daemon {

struct LoadedOntology {
  std::unique_ptr<compiled::Ontology> ontology;  ///< null: there are no files
  std::vector<std::string> remarks;              ///< lines that the compiler wrote although it succeeded
  std::vector<std::string> left_out;             ///< lines of those about files that it left out
};

/// An error where the ontology of these files contradicts itself: every class is empty then, and no pair matches.
/// Nothing where there is no contradiction, no decision within the limits, or no ontology.
[[nodiscard]] std::optional<std::string> contradiction_in(const LoadedOntology& loaded,
                                                          const std::vector<std::string>& files);

/// The ending of compiled ontologies.
inline constexpr std::string_view compiled_suffix = ".geminga";

/// IRIs by prefix, both as Turtle can write them.
using Prefixes = std::map<std::string, std::string>;

/// The path of geminga-ontology: beside this program, else on PATH; the plain name where neither has it.
[[nodiscard]] std::string find_compiler();

/// The lines that the program wrote to standard error, without its name, harmless for a terminal, at most 40.
[[nodiscard]] std::vector<std::string> compiler_lines(std::string_view words);

/// Runs `geminga-ontology compile` with bounds, and maps its output. The daemon itself reads no RDF: a hostile file can
/// hurt the child only. A compiled ontology is copied and verified on a thread, while the event loop serves.
class OntologyLoader {
 public:
  /// The errors are lines, with file and line where the compiler gave them; never empty.
  using Loaded = std::expected<LoadedOntology, std::vector<std::string>>;
  using Done = std::function<void(Loaded)>;

  /// Borrows the context for its life.
  OntologyLoader(boost::asio::io_context& context, std::string compiler, ChildLimits limits = {});
  ~OntologyLoader();
  OntologyLoader(const OntologyLoader&) = delete;
  OntologyLoader& operator=(const OntologyLoader&) = delete;

  /// Loads these files and folders, and calls `done` once from the event loop. Names may use `prefixes` beside those of
  /// the files. A load that is under way is given up, and its `done` never called. A single file that ends in
  /// `.geminga` is taken as compiled already, and knows no prefixes but its own. The first load verifies only what
  /// matching needs; once an ontology was loaded, all of it is verified. `leaves_out_refused`: files of folders that
  /// cannot be read are left out (rdf/load.hpp).
  void load(const std::vector<std::string>& files, const Prefixes& prefixes, Done done,
            bool leaves_out_refused = false);
  [[nodiscard]] bool is_loading() const { return static_cast<bool>(done_); }
  /// Whether the thread is at work, even for a load that was given up. Until it is done, the process must not destroy
  /// what the thread uses.
  [[nodiscard]] bool is_at_work() const { return background_.is_at_work(); }

 private:
  void finish(const ChildEnd& end);
  void answer_with(std::function<Loaded()> find);
  void answer_later(Loaded result);
  void answer(Loaded result);

  boost::asio::io_context& context_;
  Background background_;
  std::string compiler_;
  ChildLimits limits_;
  Done done_;                                  ///< empty: nothing is being loaded
  std::shared_ptr<base::PrivateFile> output_;  ///< of the child: the compiled form; shared with the thread
  std::unique_ptr<Child> child_;
  std::uint64_t generation_ = 0;  ///< the number of the last load
  bool has_loaded_ = false;       ///< an ontology was loaded
  std::shared_ptr<int> alive_;    ///< expires with this object, for answers that are on their way
};

}  // namespace geminga::daemon

#endif
