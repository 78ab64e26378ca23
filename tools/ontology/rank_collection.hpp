// Services and requests of a collection, and how each service suits each request.
#ifndef GEMINGA_ONTOLOGY_RANK_COLLECTION_HPP
#define GEMINGA_ONTOLOGY_RANK_COLLECTION_HPP

#include <cstddef>
#include <expected>
#include <optional>
#include <string>
#include <vector>

#include "limits.hpp"
#include "rank_concepts.hpp"
#include "reasoning/signature/score.hpp"
#include "reasoning/syntax/owls/profile.hpp"

namespace geminga::ontology {

/// A service, or a request.
struct Described {
  std::string
      name;  ///< the file's name; below its folder where several have the same; `#` and the profile if it has many
  std::string path;
  owls::Profile profile;
  signature::Signature signature;
};

/// What is to be ranked, by files and folders.
struct CollectionPaths {
  std::vector<std::string> services;
  std::vector<std::string> requests;
  std::vector<std::string> ontologies;  ///< named by the user
  std::vector<std::string> guessed;     ///< found by guess_ontologies()
};

/// Folders called `ontology` or `ontologies` in the folders of services and requests, or up to three levels above: as
/// the collections in public have them.
[[nodiscard]] std::vector<std::string> guess_ontologies(const CollectionPaths& paths);

/// Everything that was read.
class RankedCollection {
 public:
  /// Files that cannot be read are problems, and the rest goes on; an error is a folder that cannot be listed.
  [[nodiscard]] static std::expected<RankedCollection, std::string> read(const CollectionPaths& paths,
                                                                         const WorkLimits& limits);

  [[nodiscard]] const std::vector<Described>& services() const { return services_; }
  [[nodiscard]] const std::vector<Described>& requests() const { return requests_; }
  [[nodiscard]] const ConceptNames& names() const { return *names_; }
  [[nodiscard]] signature::Hierarchy hierarchy() const { return names_->hierarchy(); }
  /// What is wrong with files, a line each.
  [[nodiscard]] const std::vector<std::string>& problems() const { return problems_; }
  [[nodiscard]] const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  std::optional<std::string> list(const std::vector<std::string>& arguments, std::vector<Described>& described,
                                  std::vector<std::string>& others);
  void read_file(const std::string& path, const std::string& below, std::vector<Described>& described,
                 std::vector<std::string>& others);
  void resolve();

  std::vector<Described> services_;
  std::vector<Described> requests_;
  std::vector<std::string> folders_;
  std::optional<ConceptNames> names_;
  std::vector<std::string> problems_;
  std::vector<std::string> remarks_;
};

/// One line of a ranking.
struct Ranked {
  std::size_t service = 0;  ///< in services()
  signature::Score score;
};

/// All services for one request, best first; equal ones in the order of their names.
[[nodiscard]] std::vector<Ranked> rank_services(signature::Scorer& scorer, const Described& request,
                                                const std::vector<Described>& services);

}  // namespace geminga::ontology

#endif
