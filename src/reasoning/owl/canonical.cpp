// Hashes contents from the arguments upwards and sorts by these hashes.
#include "reasoning/owl/canonical.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <tuple>

#include "base/hash.hpp"
#include "base/sorted.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/owl/unit.hpp"

namespace geminga::owl {
namespace {

using Hash = ContentHashes::Hash;

Hash hash_words(std::span<const std::uint64_t> words) { return base::hash128(base::octets_of(words)); }

/// One for each conversion, ascending: hosts that convert differently do not match alike.
std::vector<std::uint64_t> words_of_conversions(const Ontology& source) {
  std::vector<std::uint64_t> words;
  for (const Ontology::Conversion& one : source.conversions()) {
    std::string text(source.name(one.from));
    text.append(" ").append(source.name(one.to)).append(" ").append(std::to_string(one.cost));
    words.push_back(base::hash64(text));
  }
  std::ranges::sort(words);
  return words;
}

/// One for each name of a unit: hosts that read a condition differently do not match alike.
std::vector<std::uint64_t> words_of_units(const Ontology& source) {
  std::vector<std::uint64_t> words;
  const DeclaredUnits declared = units_of(source);
  for (const UnitName& name : declared.names) {
    const DeclaredUnit& unit = declared.units[name.unit];
    std::string text = name.text + ' ' + (unit.alone ? declared.units[*unit.alone].iri : std::string());
    for (const std::int8_t exponent : unit.dimension)
      text.append(" ").append(std::to_string(static_cast<int>(exponent)));
    const std::array<std::uint64_t, 3> whole{base::hash64(text), std::bit_cast<std::uint64_t>(unit.factor),
                                             std::bit_cast<std::uint64_t>(unit.offset)};
    words.push_back(base::hash64(base::octets_of(std::span(whole))));
  }
  return words;
}

}  // namespace

std::size_t set_begin(TermKind kind, std::size_t count) {
  switch (kind) {
    case TermKind::object_intersection_of:
    case TermKind::object_union_of:
    case TermKind::object_one_of:
    case TermKind::data_intersection_of:
    case TermKind::data_union_of:
    case TermKind::data_one_of:
    case TermKind::same_individual_atom:
    case TermKind::different_individuals_atom:
    case TermKind::atom_list:
      return 0;
    case TermKind::datatype_restriction:
      return 1;
    default:
      return count;
  }
}

std::size_t set_begin(AxiomKind kind, std::size_t count) {
  switch (kind) {
    case AxiomKind::equivalent_classes:
    case AxiomKind::disjoint_classes:
    case AxiomKind::equivalent_object_properties:
    case AxiomKind::disjoint_object_properties:
    case AxiomKind::inverse_object_properties:
    case AxiomKind::equivalent_data_properties:
    case AxiomKind::disjoint_data_properties:
    case AxiomKind::same_individual:
    case AxiomKind::different_individuals:
      return 0;
    case AxiomKind::disjoint_union:
    case AxiomKind::has_key:
      return 1;
    default:
      return count;
  }
}

ContentHashes::ContentHashes(const Ontology& source, BlankNodes blank_nodes) : source_(source) {
  terms_.reserve(source.term_count());
  std::vector<std::uint64_t> words;
  for (std::uint32_t id = 0; id < source.term_count(); ++id) {
    const Term term = source.term(TermId{id});
    const bool is_forgotten = term.kind == TermKind::anonymous_individual && blank_nodes == BlankNodes::all_alike;
    const std::string_view name = is_forgotten ? std::string_view() : source.name(term.name);
    const auto [high, low] = base::hash128(name);
    words = {static_cast<std::uint64_t>(term.kind), term.number, high, low};
    for (const TermId argument : sorted(term.arguments, set_begin(term.kind, term.arguments.size()))) {
      words.push_back(hash_of(argument).first);
      words.push_back(hash_of(argument).second);
    }
    terms_.push_back(hash_words(words));
  }
}

std::vector<TermId> ContentHashes::sorted(std::span<const TermId> arguments, std::size_t set_from) const {
  std::vector<TermId> result(arguments.begin(), arguments.end());
  if (set_from >= result.size()) return result;
  const auto key = [&](TermId id) {
    const Term term = source_.term(id);
    const bool is_name = term.arguments.empty();
    return std::tuple(!is_name, is_name ? source_.name(term.name) : std::string_view(), hash_of(id));
  };
  std::sort(result.begin() + static_cast<std::ptrdiff_t>(set_from), result.end(),
            [&](TermId a, TermId b) { return a != b && key(a) < key(b); });
  return result;
}

ContentHashes::Hash ContentHashes::hash_of(const Axiom& axiom) const {
  std::vector<std::uint64_t> words = {static_cast<std::uint64_t>(axiom.kind)};
  for (const TermId argument : sorted(axiom.arguments, set_begin(axiom.kind, axiom.arguments.size()))) {
    words.push_back(hash_of(argument).first);
    words.push_back(hash_of(argument).second);
  }
  return hash_words(words);
}

namespace {

void order_files(const Ontology& source, CanonicalOrder& order, std::vector<std::uint32_t>& number_of_file) {
  for (std::uint32_t file = 0; file < source.files().size(); ++file) order.files.push_back(FileId{file});
  std::ranges::sort(order.files, {}, [&](FileId id) {
    const LoadedFile& file = source.files()[static_cast<std::size_t>(id)];
    return std::tuple<std::string_view, std::string_view, FileId>(file.path, file.ontology_iri, id);
  });
  number_of_file.resize(order.files.size());
  for (std::uint32_t at = 0; at < order.files.size(); ++at) {
    number_of_file[static_cast<std::size_t>(order.files[at])] = at;
  }
}

void order_axioms(const Ontology& source, const ContentHashes& hashes, const std::vector<std::uint32_t>& number_of_file,
                  CanonicalOrder& order) {
  struct Entry {
    AxiomKind kind;
    Hash hash;
    std::uint32_t file;
    std::uint32_t line;
    std::uint32_t axiom;
  };
  std::vector<Entry> entries;
  entries.reserve(source.axiom_count());
  for (std::uint32_t number = 0; number < source.axiom_count(); ++number) {
    const Axiom axiom = source.axiom(number);
    entries.push_back(
        {axiom.kind, hashes.hash_of(axiom), number_of_file[static_cast<std::size_t>(axiom.file)], axiom.line, number});
  }
  std::ranges::sort(entries, {}, [](const Entry& e) { return std::tuple(e.kind, e.hash, e.file, e.line); });
  order.number_of_axiom.resize(source.axiom_count());
  const Entry* last = nullptr;
  for (const Entry& entry : entries) {
    const bool is_repeated = last != nullptr && last->kind == entry.kind && last->hash == entry.hash;
    order.number_of_axiom[entry.axiom] = static_cast<std::uint32_t>(order.axioms.size()) - (is_repeated ? 1U : 0U);
    last = &entry;
    if (is_repeated) continue;
    const Axiom axiom = source.axiom(entry.axiom);
    order.axioms.push_back({entry.axiom, entry.file, entry.line,
                            hashes.sorted(axiom.arguments, set_begin(axiom.kind, axiom.arguments.size()))});
  }
}

}  // namespace

CanonicalOrder canonical_order(const Ontology& source, const ContentHashes& hashes) {
  CanonicalOrder order;
  std::vector<std::uint32_t> number_of_file;
  order_files(source, order, number_of_file);
  order_axioms(source, hashes, number_of_file, order);

  std::vector<bool> is_used(source.term_count(), false);
  for (const auto& axiom : order.axioms) {
    for (const TermId argument : axiom.arguments) is_used[static_cast<std::size_t>(argument)] = true;
  }
  for (std::uint32_t id = static_cast<std::uint32_t>(source.term_count()); id-- > 0;) {
    if (!is_used[id]) continue;
    for (const TermId argument : source.term(TermId{id}).arguments) is_used[static_cast<std::size_t>(argument)] = true;
    order.terms.push_back(TermId{id});
  }
  std::ranges::sort(order.terms, [&](TermId a, TermId b) {
    return std::pair(source.depth(a), hashes.hash_of(a)) < std::pair(source.depth(b), hashes.hash_of(b));
  });
  // Terms that differ only in the order of a set are one.
  order.number_of_term.assign(source.term_count(), base::NumberTable::none);
  std::vector<TermId> distinct;
  for (const TermId term : order.terms) {
    if (distinct.empty() || hashes.hash_of(distinct.back()) != hashes.hash_of(term)) distinct.push_back(term);
    order.number_of_term[static_cast<std::size_t>(term)] = static_cast<std::uint32_t>(distinct.size() - 1);
  }
  order.terms = std::move(distinct);
  return order;
}

std::uint64_t digest(const Ontology& source) {
  const ContentHashes hashes(source, BlankNodes::all_alike);
  std::vector<Hash> contents;
  std::vector<bool> is_used(source.term_count(), false);
  for (std::uint32_t number = 0; number < source.axiom_count(); ++number) {
    const Axiom axiom = source.axiom(number);
    for (const TermId argument : axiom.arguments) is_used[static_cast<std::size_t>(argument)] = true;
    // A declaration does not change what follows from the axioms. That the entity is there does.
    if (axiom.kind != AxiomKind::declaration) contents.push_back(hashes.hash_of(axiom));
  }
  for (std::uint32_t id = static_cast<std::uint32_t>(source.term_count()); id-- > 0;) {
    if (!is_used[id]) continue;
    const Term term = source.term(TermId{id});
    for (const TermId argument : term.arguments) is_used[static_cast<std::size_t>(argument)] = true;
    if (term.kind == TermKind::named_class) contents.push_back(hashes.hash_of(TermId{id}));
  }
  base::sort_unique(contents);
  std::vector<std::uint64_t> words;
  words.reserve(contents.size() * 2);
  for (const auto& [high, low] : contents) {
    words.push_back(high);
    words.push_back(low);
  }
  for (const std::uint64_t word : words_of_conversions(source)) words.push_back(word);
  for (const std::uint64_t word : words_of_units(source)) words.push_back(word);
  return base::hash64(base::octets_of(std::span(words)));
}

}  // namespace geminga::owl
