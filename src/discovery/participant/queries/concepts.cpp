// `query concepts`: the names of classes that begin with a text, for those who type one.
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/queries.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::participant {

Answer answer_concepts(const vocabulary::Vocabulary& vocabulary, const gcnp::QueryConcepts& query) {
  Answer answer{.kind = "concepts", .lines = {}, .end = {}};
  for (std::string& name : vocabulary.short_names_with(query.begin, query.limit)) {
    Line line;
    append(line, "concept", std::move(name));
    answer.lines.push_back(std::move(line));
  }
  answer.looked_through = answer.lines.size();
  return answer;
}

}  // namespace geminga::participant
