// Rankings as lines, as one JSON document, and as a run for trec_eval.
#ifndef GEMINGA_ONTOLOGY_RANKING_RANK_WRITER_HPP
#define GEMINGA_ONTOLOGY_RANKING_RANK_WRITER_HPP

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/ranking/ranked_collection.hpp"

namespace geminga::ontology {

enum class RankFormat { text, json, trec };

[[nodiscard]] std::optional<RankFormat> find_rank_format(std::string_view name);

/// Writes request by request, so that a large collection needs no large text. Borrows the collection.
class RankWriter {
 public:
  RankWriter(const RankedCollection& collection, RankFormat format, bool has_reasons)
      : collection_(collection), format_(format), has_reasons_(has_reasons) {}

  [[nodiscard]] std::string begin() const;
  [[nodiscard]] std::string request(const Described& request, const std::vector<Ranked>& ranked);
  [[nodiscard]] std::string end() const;

 private:
  [[nodiscard]] std::string lines(const Described& request, const std::vector<Ranked>& ranked) const;
  [[nodiscard]] std::string document(const Described& request, const std::vector<Ranked>& ranked) const;

  const RankedCollection& collection_;
  RankFormat format_;
  bool has_reasons_;
  bool is_first_ = true;
};

}  // namespace geminga::ontology

#endif
