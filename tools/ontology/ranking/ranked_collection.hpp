// The services and requests of a collection, and the ranking of all services for one request.
#ifndef GEMINGA_ONTOLOGY_RANKING_RANKED_COLLECTION_HPP
#define GEMINGA_ONTOLOGY_RANKING_RANKED_COLLECTION_HPP

#include <cstddef>
#include <expected>
#include <optional>
#include <string>
#include <vector>

#include "ontology/command/limits.hpp"
#include "ontology/ranking/concept_names.hpp"
#include "reasoning/signature/score.hpp"
#include "reasoning/syntax/owls/profile.hpp"

namespace geminga::ontology {

/// A service, or a request.
struct Described {
  /// The file's name, with its folders where several files have that name; `#` and the profile if the file has many.
  std::string name;
  std::string path;
  owls::Profile profile;
  signature::Signature signature;
};

/// The files and folders of a collection.
struct CollectionPaths {
  std::vector<std::string> services;
  std::vector<std::string> requests;
  std::vector<std::string> ontologies;  ///< given by the user
  std::vector<std::string> guessed;     ///< found by guess_ontologies()
};

/// Finds folders called `ontology` or `ontologies` in the folders of services and requests, or up to three levels
/// above, where published collections have them.
[[nodiscard]] std::vector<std::string> guess_ontologies(const CollectionPaths& paths);

class RankedCollection {
 public:
  /// Reads the collection. Files that cannot be read are problems(), and all others count; a folder that cannot be
  /// listed is an error.
  [[nodiscard]] static std::expected<RankedCollection, std::string> read(const CollectionPaths& paths,
                                                                         const WorkLimits& limits);

  [[nodiscard]] const std::vector<Described>& services() const { return services_; }
  [[nodiscard]] const std::vector<Described>& requests() const { return requests_; }
  [[nodiscard]] const ConceptNames& names() const { return *names_; }
  [[nodiscard]] signature::Hierarchy hierarchy() const { return names_->hierarchy(); }
  /// Lines that name broken files.
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

/// A service in a ranking.
struct Ranked {
  std::size_t service = 0;  ///< in services()
  signature::Score score;
};

/// Ranks all services for one request, best first; equal ones in the order of their names.
[[nodiscard]] std::vector<Ranked> rank_services(signature::Scorer& scorer, const Described& request,
                                                const std::vector<Described>& services);

}  // namespace geminga::ontology

#endif
