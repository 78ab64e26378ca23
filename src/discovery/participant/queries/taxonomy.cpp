// `query taxonomy`: the tree of classes node by node, with what is offered and asked below each.
#include <algorithm>
#include <map>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/queries.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::participant {
namespace {

using vocabulary::ClassNumber;
using vocabulary::Vocabulary;

constexpr std::string_view nothing_iri = "http://www.w3.org/2002/07/owl#Nothing";

/// Names that are looked at cost so much less than an entry of the registry.
constexpr std::size_t names_per_entry = 64;

/// The most names of one list in a line.
constexpr std::size_t max_listed = 64;

/// A node of the tree, with the services that are it or below it.
struct Node {
  std::size_t offered = 0;
  std::size_t asked = 0;
};

/// The part of an IRI that a reader takes for the name.
std::string_view local_name(std::string_view iri) { return iri.substr(iri.find_last_of("#/") + 1); }

bool contains(std::string_view name, std::string_view text) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return !std::ranges::search(name, text, {}, lower, lower).empty();
}

/// The classes that are equivalent to this one, without itself.
std::vector<ClassNumber> equivalents(const Vocabulary& vocabulary, ClassNumber number) {
  auto found = vocabulary.subsumers(number);
  std::erase_if(found, [&](ClassNumber one) { return one == number || !vocabulary.is_subsumed(one, number); });
  return found;
}

std::string names(const Vocabulary& vocabulary, const std::vector<ClassNumber>& numbers) {
  std::vector<std::string> words;
  for (const ClassNumber number : numbers | std::views::take(max_listed))
    words.push_back(vocabulary.short_name(number));
  return base::joined(words, ",");
}

/// Walks the names, where a text is looked for, then services and requests, and tells the classes that were chosen.
class Telling {
 public:
  /// Of the classes that a text occurs in.
  Telling(const Listed& by, const gcnp::QueryTaxonomy& query) : by_(by), query_(query) {}
  /// Of the classes below `top`.
  Telling(const Listed& by, const gcnp::QueryTaxonomy& query, ClassNumber top)
      : by_(by), query_(query), top_(top), names_seen_(vocabulary().class_count()) {
    if (vocabulary().iri(top) == nothing_iri) {
      for (std::uint32_t at = 0; at < vocabulary().class_count(); ++at) {
        if (ClassNumber{at} != top && !vocabulary().is_satisfiable(ClassNumber{at})) take(ClassNumber{at});
      }
    } else {
      for (const ClassNumber child : vocabulary().children(top)) {
        if (vocabulary().is_satisfiable(child)) take(child);
      }
    }
  }

  bool proceed(Piece& piece) {
    while (names_seen_ < vocabulary().class_count()) {
      if (piece.is_full()) return false;
      look_at_name(piece);
    }
    const bool is_walked =
        by_.matcher.publications().visit_after(last_publication_,
                                               [&](const registry::StoredPublication& stored) {
                                                 last_publication_ = stored.entry.key;
                                                 count(stored.entry.publication.identity, &Node::offered);
                                                 piece.look_at_one();
                                                 return !piece.is_full();
                                               }) &&
        by_.matcher.subscriptions().visit_after(last_subscription_, [&](const registry::StoredSubscription& stored) {
          last_subscription_ = stored.entry.key;
          count(stored.entry.subscription.identity, &Node::asked);
          piece.look_at_one();
          return !piece.is_full();
        });
    if (!is_walked) return false;
    for (; told_ < order_.size(); ++told_) {
      if (piece.is_full()) return false;
      piece.tell(line_of(order_[told_]));
    }
    piece.conclude(end());
    return true;
  }

 private:
  [[nodiscard]] const Vocabulary& vocabulary() const { return by_.matcher.editions().vocabulary(); }

  void take(ClassNumber number) {
    if (total_++ < query_.skip || order_.size() == query_.limit) return;
    order_.push_back(number);
    nodes_.emplace(number, Node());
  }

  void look_at_name(Piece& piece) {
    const ClassNumber number{names_seen_++};
    if (names_seen_ % names_per_entry == 0) piece.look_at_one();
    const bool is_named = number != vocabulary().thing() && vocabulary().iri(number) != nothing_iri;
    if (is_named && contains(local_name(vocabulary().iri(number)), query_.contains)) take(number);
  }

  void count(const Identity& identity, std::size_t Node::* kind) {
    const auto* semantic = std::get_if<SemanticIdentity>(&identity);
    if (semantic == nullptr) return;
    for (const ClassNumber above : classes_above(*semantic)) {
      if (const auto node = nodes_.find(above); node != nodes_.end()) ++(node->second.*kind);
    }
  }

  /// The classes that a concept is or is below; of an expression those above its place, where it has been placed.
  [[nodiscard]] std::vector<ClassNumber> classes_above(const SemanticIdentity& identity) const {
    if (has_expression(identity)) {
      const auto place = by_.resolver.known_place(identity.concept_iri);
      return place ? vocabulary().subsumers(*place) : std::vector<ClassNumber>();
    }
    const auto number = vocabulary().find_iri(identity.concept_iri);
    return number ? vocabulary().subsumers(*number) : std::vector<ClassNumber>();
  }

  [[nodiscard]] Line line_of(ClassNumber number) const {
    Line line;
    append(line, "class", vocabulary().short_name(number));
    if (vocabulary().is_satisfiable(number)) {
      append(line, "children", vocabulary().children(number).size());
      append_stated(line, "equivalents", names(vocabulary(), equivalents(vocabulary(), number)));
    } else {
      append_flag(line, "unsatisfiable", true);
    }
    append(line, "offers", nodes_.at(number).offered);
    append(line, "requests", nodes_.at(number).asked);
    return line;
  }

  [[nodiscard]] Line end() const {
    Line line;
    if (top_) append(line, "class", vocabulary().short_name(*top_));
    append(line, "total", total_);
    if (!top_ || *top_ == vocabulary().thing() || !vocabulary().is_satisfiable(*top_)) return line;
    auto parents = vocabulary().parents(*top_);
    std::erase(parents, vocabulary().thing());
    append_stated(line, "parents", names(vocabulary(), parents));
    append_stated(line, "equivalents", names(vocabulary(), equivalents(vocabulary(), *top_)));
    return line;
  }

  Listed by_;
  gcnp::QueryTaxonomy query_;
  std::optional<ClassNumber> top_;
  std::uint32_t names_seen_ = 0;
  std::size_t total_ = 0;
  std::vector<ClassNumber> order_;
  std::map<ClassNumber, Node> nodes_;
  std::optional<ServiceKey> last_publication_;
  std::optional<ServiceKey> last_subscription_;
  std::size_t told_ = 0;
};

}  // namespace

std::expected<Answering, Error> begin_taxonomy(const Listed& by, const gcnp::QueryTaxonomy& query) {
  const Vocabulary& vocabulary = by.matcher.editions().vocabulary();
  if (!vocabulary.is_loaded()) return std::unexpected(by.resolver.no_ontology());
  Answering answering{.kind = "taxonomy", .proceed = {}};
  if (!query.contains.empty()) {
    answering.proceed = [telling = Telling(by, query)](Piece& piece) mutable { return telling.proceed(piece); };
    return answering;
  }
  auto top = vocabulary.thing();
  if (!query.class_name.empty()) {
    const auto found = vocabulary.find(query.class_name);
    if (!found) {
      return std::unexpected(
          Error{ErrorCode::impossible, "class=" + base::printable(query.class_name) + ": " + found.error()});
    }
    top = *found;
  }
  answering.looked_at = vocabulary.class_count() / names_per_entry;
  answering.proceed = [telling = Telling(by, query, top)](Piece& piece) mutable { return telling.proceed(piece); };
  return answering;
}

}  // namespace geminga::participant
