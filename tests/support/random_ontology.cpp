#include "support/random_ontology.hpp"

#include <array>
#include <string>

#include "base/random.hpp"

namespace geminga::compare {
namespace {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

constexpr std::string_view name_space = "http://random.example/#";
constexpr std::string_view xsd = "http://www.w3.org/2001/XMLSchema#";

/// Properties s0.. are simple: no chain or transitivity is below them. t0.. are not. The result of a chain comes later
/// in the order than its links, which makes it regular.
constexpr std::uint64_t simple_count = 3;
constexpr std::uint64_t other_count = 3;

class Maker {
 public:
  Maker(Profile profile, std::uint64_t seed, std::size_t axioms)
      : random_(seed * 8 + static_cast<std::uint64_t>(profile)), profile_(profile), class_count_(3 + axioms / 2) {
    has_facts_ = is_el() && random_.chance(0.4);
    file_ = source_.add_file("random " + std::string(to_string(profile)) + " seed " + std::to_string(seed));
    for (std::size_t at = 0; at < axioms; ++at) {
      line_ = static_cast<std::uint32_t>(at + 1);
      axiom();
    }
  }

  owl::Ontology take() { return std::move(source_); }

 private:
  [[nodiscard]] bool is_el() const { return profile_ == Profile::ranges; }
  [[nodiscard]] bool has(Profile profile) const { return !is_el() && profile_ >= profile; }
  std::uint64_t below(std::uint64_t bound) { return random_.below(bound); }
  static std::string iri(char kind, std::uint64_t number) {
    return std::string(name_space) + kind + std::to_string(number);
  }

  TermId named() {
    if (random_.chance(0.02)) return random_.chance(0.7) ? owl::thing_term : owl::nothing_term;
    return source_.named_class(iri('C', below(class_count_)));
  }
  TermId individual() { return source_.individual(iri('i', below(4))); }
  TermId data_property() { return source_.data_property(iri('d', below(2))); }
  TermId simple_name() { return source_.object_property(iri('s', below(simple_count))); }
  TermId other_name(std::uint64_t number) { return source_.object_property(iri('t', number)); }

  TermId maybe_inverse(TermId property) {
    return !is_el() && random_.chance(0.25) ? source_.term(TermKind::object_inverse_of, {property}) : property;
  }
  TermId simple() { return maybe_inverse(simple_name()); }
  TermId property() {
    if (!(has(Profile::chains) || is_el()) || random_.chance(0.5)) return simple();
    return maybe_inverse(other_name(below(other_count)));
  }

  TermId literal() {
    static constexpr std::array<std::string_view, 4> types{"integer", "decimal", "string", "boolean"};
    const std::string_view type = types[below(types.size())];
    const std::string lexical = type == "boolean" ? (random_.chance(0.5) ? "true" : "false") : std::to_string(below(3));
    return source_.literal(lexical, std::string(xsd) + std::string(type));
  }
  TermId datatype() {
    static constexpr std::array<std::string_view, 5> types{"integer", "decimal", "string", "boolean",
                                                           "nonNegativeInteger"};
    return source_.datatype(std::string(xsd) + std::string(types[below(types.size())]));
  }

  /// A class that may stand on the left in a Horn ontology: no universals, no complements.
  TermId left(int depth) {
    const std::uint64_t choice = below(depth == 0 ? 4 : 8);
    if (choice < 4) return named();
    if (choice < 6) return source_.term(TermKind::object_intersection_of, {left(depth - 1), left(depth - 1)});
    return source_.term(TermKind::object_some_values_from, {property(), left(depth - 1)});
  }

  TermId right(int depth) {
    const std::uint64_t choice = below(depth == 0 ? 4 : 10);
    if (choice < 4) return named();
    if (choice < 5) return source_.term(TermKind::object_intersection_of, {right(depth - 1), right(depth - 1)});
    if (choice < 8) return source_.term(TermKind::object_some_values_from, {property(), right(depth - 1)});
    if (choice < 9) return source_.term(TermKind::object_all_values_from, {property(), right(depth - 1)});
    if (is_el()) return random_.chance(0.3) ? source_.term(TermKind::object_has_self, {simple()}) : named();
    return source_.term(TermKind::object_max_cardinality, {simple(), named()}, 1);
  }

  TermId cardinality(int depth) {
    const auto number = static_cast<std::uint32_t>(below(3));
    static constexpr std::array kinds{TermKind::object_min_cardinality, TermKind::object_max_cardinality,
                                      TermKind::object_exact_cardinality};
    return source_.term(kinds[below(3)], {simple(), any(depth - 1)}, number);
  }

  TermId with_individual() {
    if (random_.chance(0.4)) return source_.term(TermKind::object_one_of, {individual()});
    if (random_.chance(0.3)) return source_.term(TermKind::object_one_of, {individual(), individual()});
    return source_.term(TermKind::object_has_value, {property(), individual()});
  }

  TermId with_value() {
    switch (below(4)) {
      case 0:
        return source_.term(TermKind::data_has_value, {data_property(), literal()});
      case 1:
        return source_.term(TermKind::data_all_values_from, {data_property(), datatype()});
      default:
        return source_.term(TermKind::data_some_values_from, {data_property(), datatype()});
    }
  }

  /// Any class of the profile, on either side.
  TermId any(int depth) {
    if (depth == 0) return named();
    const std::uint64_t choice = below(16);
    if (choice < 5) return named();
    if (choice < 7) return source_.term(TermKind::object_intersection_of, {any(depth - 1), any(depth - 1)});
    if (choice < 8) return source_.term(TermKind::object_union_of, {any(depth - 1), any(depth - 1)});
    if (choice < 9) return source_.term(TermKind::object_complement_of, {any(depth - 1)});
    if (choice < 11) return source_.term(TermKind::object_some_values_from, {property(), any(depth - 1)});
    if (choice < 13) return source_.term(TermKind::object_all_values_from, {property(), any(depth - 1)});
    if (choice < 14 && has(Profile::values)) return with_value();
    if (choice < 15 && has(Profile::nominals)) return with_individual();
    if (choice < 15 && has(Profile::chains) && random_.chance(0.3))
      return source_.term(TermKind::object_has_self, {simple()});
    return cardinality(depth);
  }

  void add(AxiomKind kind, std::initializer_list<TermId> arguments) { source_.add(kind, arguments, file_, line_); }

  void property_axiom_of_el() {
    switch (below(10)) {
      case 0:
        return add(AxiomKind::sub_object_property_of, {simple(), simple()});
      case 1:
        return add(AxiomKind::object_property_domain, {property(), named()});
      case 2:
        return add(AxiomKind::transitive_object_property, {other_name(below(other_count))});
      case 3:
        return add(AxiomKind::sub_object_property_of, {simple(), other_name(below(other_count))});
      case 4:
        return random_.chance(0.3) ? add(AxiomKind::reflexive_object_property, {other_name(below(other_count))})
                                   : add(AxiomKind::functional_object_property, {simple()});
      case 5:
      case 6:
      case 7:
        return chain();
      default:
        return add(AxiomKind::object_property_range, {other_name(below(other_count)), right(1)});
    }
  }

  void property_axiom() {
    switch (below(has(Profile::chains) ? 11 : 5)) {
      case 0:
        return add(AxiomKind::functional_object_property, {simple()});
      case 1:
        return add(AxiomKind::sub_object_property_of, {simple(), simple()});
      case 2:
        return add(AxiomKind::object_property_domain, {property(), named()});
      case 3:
        return add(AxiomKind::object_property_range, {property(), named()});
      case 4:
        return add(AxiomKind::inverse_object_properties, {simple_name(), simple_name()});
      case 5:
        return add(AxiomKind::transitive_object_property, {other_name(below(other_count))});
      case 6:
        return chain();
      case 7:
        return add(AxiomKind::sub_object_property_of, {simple(), other_name(below(other_count))});
      case 8:
        return add(AxiomKind::reflexive_object_property, {other_name(below(other_count))});
      case 9:
        return add(AxiomKind::disjoint_object_properties, {simple(), simple()});
      default:
        return add(AxiomKind::symmetric_object_property, {simple()});
    }
  }

  /// Links that come before the result in the order t0 < t1 < ..., or are simple; the last link may be the result.
  void chain() {
    const std::uint64_t result = below(other_count);
    const bool is_first_result = is_el() && random_.chance(0.3);
    const TermId first = is_first_result ? other_name(result) : link_of_chain(result);
    const TermId second = !is_first_result && random_.chance(0.2) ? other_name(result) : link_of_chain(result);
    add(AxiomKind::sub_object_property_of,
        {source_.term(TermKind::object_property_chain, {first, second}), other_name(result)});
  }

  void fact() {
    switch (below(has(Profile::values) ? 7 : 6)) {
      case 0:
        return add(AxiomKind::different_individuals, {individual(), individual()});
      case 1:
        if (random_.chance(0.4)) return add(AxiomKind::same_individual, {individual(), individual()});
        [[fallthrough]];
      case 2:
        return add(AxiomKind::object_property_assertion, {simple_name(), individual(), individual()});
      case 3:
        return add(AxiomKind::negative_object_property_assertion, {simple_name(), individual(), individual()});
      case 6:
        return add(AxiomKind::data_property_assertion, {data_property(), individual(), literal()});
      default:
        return add(AxiomKind::class_assertion, {any(1), individual()});
    }
  }

  TermId link_of_chain(std::uint64_t result) {
    return result == 0 || random_.chance(0.5) ? simple() : other_name(below(result));
  }

  void axiom_of_el(std::uint64_t choice) {
    if (choice < 8) return property_axiom_of_el();
    if (choice < 9) return add(AxiomKind::disjoint_classes, {named(), named()});
    if (choice < 10) return add(AxiomKind::equivalent_classes, {named(), left(2)});
    if (choice < 11 && has_facts_)
      return random_.chance(0.5) ? add(AxiomKind::class_assertion, {right(1), individual()})
                                 : add(AxiomKind::object_property_assertion, {property(), individual(), individual()});
    return add(AxiomKind::sub_class_of, {left(2), right(2)});
  }

  void axiom() {
    const std::uint64_t choice = below(20);
    if (is_el()) return axiom_of_el(choice);
    if (choice < 3) return property_axiom();
    if (choice < 5 && has(Profile::nominals)) return fact();
    if (choice < 6 && has(Profile::values) && random_.chance(0.3))
      return add(AxiomKind::functional_data_property, {data_property()});
    if (choice < 7) return add(AxiomKind::disjoint_classes, {named(), named()});
    if (has(Profile::choices)) {
      if (choice < 10) return add(AxiomKind::equivalent_classes, {named(), any(2)});
      return add(AxiomKind::sub_class_of, {random_.chance(0.6) ? named() : any(2), any(2)});
    }
    if (choice < 9) return add(AxiomKind::equivalent_classes, {named(), left(2)});
    return add(AxiomKind::sub_class_of, {left(2), right(2)});
  }

  base::Random random_;
  Profile profile_;
  std::uint64_t class_count_;
  bool has_facts_ = false;
  owl::Ontology source_;
  owl::FileId file_{};
  std::uint32_t line_ = 0;
};

}  // namespace

std::string_view to_string(Profile profile) {
  switch (profile) {
    case Profile::horn:
      return "horn";
    case Profile::choices:
      return "choices";
    case Profile::chains:
      return "chains";
    case Profile::nominals:
      return "nominals";
    case Profile::values:
      return "values";
    case Profile::ranges:
      return "ranges";
  }
  return "";
}

owl::Ontology random_ontology(Profile profile, std::uint64_t seed, std::size_t axioms) {
  return Maker(profile, seed, axioms).take();
}

}  // namespace geminga::compare
