// Asks reasoning/explanation/abduction, with the rules of placement and, where these leave gaps, a model as its
// reasoner.
#include "reasoning/explanation/abduction/near_misses.hpp"

#include <string>
#include <utility>

#include "reasoning/explanation/overlap.hpp"
#include "reasoning/owl/print.hpp"
#include "reasoning/vocabulary/expression.hpp"
#include "reasoning/vocabulary/expression_reader.hpp"
#include "reasoning/vocabulary/near_miss.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::vocabulary {
namespace {

using abduction::Answer;
using abduction::Conjuncts;
using abduction::Members;

using owl::TermId;

/// Whether something can be an instance of the expression.
Answer possibility(const compiled::Ontology& ontology, const owl::Ontology& source, TermId expression) {
  const explanation::WrittenClass written{source, expression};
  const auto thing = ClassNumber{ontology.view().thing};
  switch (explanation::find_overlap(ontology, thing, written, explanation::Patience::of_a_daemon).common) {
    case explanation::Common::possible:
      return Answer::yes;
    case explanation::Common::impossible:
      return Answer::no;
    case explanation::Common::undecided:
      break;
  }
  return Answer::unknown;
}

/// All of one are of the other if nothing is one without being the other.
Answer subsumption(const compiled::Ontology& ontology, const placement::ExpressionClassifier& classifier,
                   const owl::Ontology& source, TermId sub, TermId super) {
  const auto found = classifier.is_subsumed(source, sub, super);
  if (found.holds) return Answer::yes;
  if (found.gaps.empty()) return Answer::no;
  owl::Ontology query;
  const TermId below = query.copy(source, sub);
  const TermId outside = query.term(owl::TermKind::object_complement_of, {query.copy(source, super)});
  const TermId both = query.term(owl::TermKind::object_intersection_of, {below, outside});
  switch (possibility(ontology, query, both)) {
    case Answer::no:
      return Answer::yes;
    case Answer::yes:
      return Answer::no;
    case Answer::unknown:
      break;
  }
  return Answer::unknown;
}

/// Writes what was found with short names.
class Writing {
 public:
  Writing(const Vocabulary& vocabulary, owl::Ontology& source, const Conjuncts& request)
      : vocabulary_(vocabulary), source_(source), request_(request) {}

  NearMiss write(const abduction::NearMiss& found) {
    NearMiss written;
    const Members left = request_.all() & ~found.retracted;
    written.lacking = conjuncts(found.lacking, found.known | found.lacking);
    written.contradicting = conjuncts(found.retracted, request_.all());
    written.lacking_count = request_.count(found.lacking);
    written.contradicting_count = request_.count(found.retracted);
    if (found.lacking != 0) written.added = text(abduction::added(source_, request_, found));
    written.request = text(request_.term(source_, left));
    written.is_possible = found.is_possible;
    return written;
  }

 private:
  /// The outermost of these, as far as they are among the shown ones.
  std::vector<std::string> conjuncts(Members members, Members shown) {
    std::vector<std::string> texts;
    for (const std::size_t at : abduction::numbers_of(request_.outermost(members))) {
      std::string one = text(request_.term(source_, at, shown));
      const std::size_t top = request_.top_of(at);
      if (top != at) one += " within " + text(request_.term(source_, top, shown));
      texts.push_back(std::move(one));
    }
    return texts;
  }

  std::string text(TermId term) {
    const auto short_name = [&](std::string_view iri) { return vocabulary_.short_name(iri); };
    return owl::print(source_, term, short_name, owl::PrintStyle::parsing);
  }

  const Vocabulary& vocabulary_;
  owl::Ontology& source_;
  const Conjuncts& request_;
};

}  // namespace

NearMisses Vocabulary::near_misses(const Expression& request, const Expression& candidate,
                                   std::size_t questions) const {
  const auto& classifier = reader_->parts->classifier;
  owl::Ontology source;
  const TermId asked = source.copy(request.parsed_.source, request.parsed_.term);
  const TermId offered = source.copy(candidate.parsed_.source, candidate.parsed_.term);
  abduction::Reasoner reasoner;
  reasoner.is_subsumed = [&](const owl::Ontology& terms, TermId sub, TermId super) {
    return subsumption(*ontology_, classifier, terms, sub, super);
  };
  reasoner.is_satisfiable = [&](const owl::Ontology& terms, TermId expression) {
    return possibility(*ontology_, terms, expression);
  };
  // A class that the candidate is known to be is not taken apart.
  const auto definition = [&](owl::Ontology& terms, TermId named) -> std::optional<TermId> {
    if (classifier.is_subsumed(terms, offered, named).holds) return std::nullopt;
    return classifier.definition(terms, named);
  };
  const Conjuncts conjuncts(source, asked, definition);
  const auto found = abduction::find_near_misses(source, conjuncts, offered, reasoner, {.questions = questions});
  NearMisses result{.ranked = {}, .reservation = found.reservation};
  Writing writing(*this, source, conjuncts);
  for (const auto& one : found.ranked) result.ranked.push_back(writing.write(one));
  return result;
}

}  // namespace geminga::vocabulary
