#include "reasoning/reasoner/ill_typed_values.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <optional>
#include <ranges>

#include "base/sorted.hpp"
#include "base/text.hpp"
#include "reasoning/owl/literal_value.hpp"

namespace geminga::reasoner {
namespace {

using owl::DataFamily;
using owl::Datatype;
using owl::DataValue;
using owl::TermId;

constexpr std::string_view xsd = "http://www.w3.org/2001/XMLSchema#";
const std::string unknown_classes = "it is not known what tells its values apart";

/// Numbers in ten-thousandths. Bounds and literals have at most three digits behind the point, so that there is room
/// between any two.
using Number = std::int64_t;
constexpr Number one = 10'000;
constexpr Number most = Number{100'000'000'000} * one;
constexpr std::size_t max_candidates = 1'000'000;

std::optional<Number> number_of(const DataValue& value) {
  std::string_view text = value.canonical;
  const bool is_negative = text.starts_with('-');
  if (is_negative) text.remove_prefix(1);
  const std::size_t point = text.find('.');
  std::string digits(text.substr(0, point));
  std::string fraction(point == std::string_view::npos ? "" : text.substr(point + 1));
  if (fraction.size() > 3) return std::nullopt;
  fraction.resize(4, '0');
  const auto parsed = base::parse_number<std::uint64_t>(digits + fraction);
  if (!parsed || *parsed > static_cast<std::uint64_t>(most)) return std::nullopt;
  return is_negative ? -static_cast<Number>(*parsed) : static_cast<Number>(*parsed);
}

bool is_whole(Number number) { return number % one == 0; }

std::string text_of(Number number) {
  std::string text = std::to_string(std::abs(number) / one);
  if (!is_whole(number)) {
    const std::string digits = std::to_string(std::abs(number) % one);
    text += '.' + std::string(4 - digits.size(), '0') + digits;
  }
  return number < 0 ? '-' + text : text;
}

/// The values of one datatype, one equivalence class after the other.
class Values {
 public:
  Values(owl::Ontology& source, Datatype type, std::string_view iri, std::size_t alike)
      : source_(source), type_(type), iri_(iri), alike_(alike) {}

  std::expected<std::vector<TermId>, std::string> run(const Distinctions& distinctions, const std::set<TermId>& taken) {
    if (!take_datatypes(distinctions) || !take_literals(distinctions.literals, given_) ||
        !take_literals(taken, taken_) || !take_facets(distinctions))
      return std::unexpected(unknown_classes);
    if (type_.family() == DataFamily::number) return numbers();
    if (!splitting_.empty() || !bounds_.empty()) return std::unexpected(unknown_classes);
    return others();
  }

 private:
  using Literals = std::map<std::string, TermId>;  ///< by canonical form

  bool take_datatypes(const Distinctions& distinctions) {
    for (const TermId id : distinctions.datatypes) {
      if (source_.name_of(id) == "http://www.w3.org/2000/01/rdf-schema#Literal") continue;
      const auto other = Datatype::find(source_.name_of(id));
      if (!other) return false;
      if (type_.is_within(*other) || type_.is_disjoint(*other)) continue;
      // The bounds of these types are beyond `most`.
      if (*other == xsd_type("long") || *other == xsd_type("unsignedLong")) return false;
      splitting_.push_back(*other);
    }
    // Values that are no decimals are not among the candidates.
    return type_.family() != DataFamily::number || splitting_.empty() || type_.is_within(xsd_type("decimal"));
  }

  /// Takes the literals that are values of the type.
  bool take_literals(const std::set<TermId>& literals, Literals& into) {
    for (const TermId id : literals) {
      if (!source_.is_well_typed(id)) continue;
      const auto value = owl::value_of(source_, source_.term(id));
      if (!value || !value->is_exact) return false;
      if (value->family == type_.family() && value->is_in(type_)) into.emplace(value->canonical, id);
    }
    return true;
  }

  bool take_facets(const Distinctions& distinctions) {
    static constexpr std::array bounding{"minInclusive", "maxInclusive", "minExclusive", "maxExclusive"};
    for (const TermId id : distinctions.facets) {
      const owl::Term facet = source_.term(id);
      const std::string_view iri = source_.name(facet.name);
      const bool is_bound =
          iri.starts_with(xsd) && std::ranges::find(bounding, iri.substr(xsd.size())) != bounding.end();
      // Other facets of this family, such as a length or a pattern, are possible.
      if (!is_bound) return false;
      const auto value = owl::value_of(source_, source_.term(facet.arguments[0]));
      if (!value) return false;
      if (value->family != type_.family()) continue;
      const auto number = value->family == DataFamily::number ? number_of(*value) : std::nullopt;
      if (!number) return false;
      bounds_.push_back(*number);
    }
    return true;
  }

  [[nodiscard]] static Datatype xsd_type(std::string_view name) {
    return Datatype::find(std::string(xsd).append(name)).value();
  }
  [[nodiscard]] static bool is_bounded(Datatype type) {
    return type.is_within(xsd_type("integer")) && type != xsd_type("integer");
  }

  // For numbers: the points that distinguish values, and what lies between two of them.
  std::expected<std::vector<TermId>, std::string> numbers() {
    std::set<Number> points(bounds_.begin(), bounds_.end());
    std::set<Number> taken;
    for (const Literals* literals : {&given_, &taken_}) {
      for (const auto& [canonical, id] : *literals) {
        const auto number = number_of(*owl::value_of(source_, source_.term(id)));
        if (!number) return std::unexpected(unknown_classes);
        (literals == &given_ ? points : taken).insert(*number);
      }
    }
    const std::set<Number> told(points);
    if (is_bounded(type_) || std::ranges::any_of(splitting_, is_bounded)) add_bounds_of_types(points);
    if (points.size() * (taken.size() + alike_) > max_candidates) return std::unexpected(unknown_classes);
    struct Class {
      std::vector<TermId> fresh;
      std::vector<TermId> taken;
    };
    std::map<std::vector<int>, Class> classes;
    for (const Number number : candidates(points, taken.size())) {
      const TermId literal = source_.literal(text_of(number), name_of_number(number));
      const auto value = owl::value_of(source_, source_.term(literal));
      if (!value || !value->is_in(type_)) continue;
      std::vector<int> key;
      key.reserve(splitting_.size() + told.size());
      for (const Datatype type : splitting_) key.push_back(value->is_in(type) ? 1 : 0);
      for (const Number point : told) key.push_back(number < point ? -1 : number > point ? 1 : 0);
      Class& its = classes[key];
      (taken.contains(number) ? its.taken : its.fresh).push_back(literal);
    }
    std::vector<TermId> found;
    for (Class& its : classes | std::views::values) {
      // If a class has no further values, it is represented by all values that it has.
      if (its.fresh.size() < alike_) {
        its.fresh.insert(its.fresh.end(), its.taken.begin(), its.taken.end());
      } else {
        its.fresh.resize(alike_);
      }
      found.insert(found.end(), its.fresh.begin(), its.fresh.end());
    }
    if (found.empty()) return std::unexpected(unknown_classes);
    return found;
  }

  [[nodiscard]] static std::string name_of_number(Number number) {
    return std::string(xsd) + (is_whole(number) ? "integer" : "decimal");
  }

  /// The bounds of the types derived from xsd:integer. Those of the wide types are beyond `most`.
  static void add_bounds_of_types(std::set<Number>& points) {
    for (const Number bound :
         {-2147483648LL, -32768LL, -128LL, 0LL, 127LL, 255LL, 32767LL, 65535LL, 2147483647LL, 4294967295LL}) {
      for (const Number near : {-1, 0, 1}) points.insert((bound + near) * one);
    }
  }

  /// The points, and between and around them more whole numbers than are taken, and some other numbers.
  [[nodiscard]] std::vector<Number> candidates(const std::set<Number>& points, std::size_t taken) const {
    std::vector<Number> found(points.begin(), points.end());
    const auto wanted = static_cast<Number>(alike_ + taken);
    const auto fill = [&](Number low, Number high) {
      const Number floor = low - (((low % one) + one) % one);
      for (Number step = 1; step <= wanted && floor + step * one < high; ++step) found.push_back(floor + step * one);
      // The literals that are taken have three digits behind the point, and these have four.
      for (Number step = 1; step <= static_cast<Number>(alike_); ++step) found.push_back(low + step);
    };
    const Number first = points.empty() ? 0 : *points.begin();
    fill(first - (wanted + 2) * one, first);
    for (auto at = points.begin(); at != points.end(); ++at) {
      const auto next = std::next(at);
      fill(*at, next == points.end() ? 2 * most : *next);
    }
    if (points.empty()) fill(0, most);
    base::sort_unique(found);
    return found;
  }

  /// For texts, times and other values that can only be compared for equality.
  std::expected<std::vector<TermId>, std::string> others() {
    std::vector<TermId> found;
    if (type_.family() == DataFamily::boolean) {
      for (const char* value : {"true", "false"}) found.push_back(source_.literal(value, iri_));
      return found;
    }
    for (const auto& [canonical, literal] : given_) found.push_back(literal);
    std::size_t added = 0;
    for (std::size_t number = 1; added < alike_; ++number) {
      const TermId literal = source_.literal(example(number), iri_);
      const auto value = owl::value_of(source_, source_.term(literal));
      if (!source_.is_well_typed(literal) || !value || !value->is_exact) return std::unexpected(unknown_classes);
      if (given_.contains(value->canonical) || taken_.contains(value->canonical)) continue;
      found.push_back(literal);
      ++added;
    }
    return found;
  }

  /// A different value for each number, or an empty text if the type has none.
  [[nodiscard]] std::string example(std::size_t number) const {
    const std::string digits = std::to_string(number);
    switch (type_.family()) {
      case DataFamily::text:
        return "geminga-" + digits;
      case DataFamily::double_:
      case DataFamily::float_:
        return digits + "e7";
      case DataFamily::hex:
        return (digits.size() % 2 == 0 ? "AB" : "AB0") + digits;
      case DataFamily::uri:
        return "urn:geminga:" + digits;
      case DataFamily::time:
        return digits.size() > 4 ? "" : std::string(4 - digits.size(), '0') + digits + "-02-03T04:05:06.789Z";
      default:
        return "";
    }
  }

  owl::Ontology& source_;
  const Datatype type_;
  const std::string iri_;
  const std::size_t alike_;
  std::vector<Datatype> splitting_;  ///< of which some values of the type are, and others are not
  Literals given_;
  Literals taken_;
  std::vector<Number> bounds_;
};

}  // namespace

std::expected<std::vector<TermId>, std::string> values_of(owl::Ontology& source, std::string_view datatype,
                                                          const Distinctions& distinctions,
                                                          const std::set<TermId>& taken, std::size_t alike) {
  const auto type = Datatype::find(datatype);
  if (!type) return std::unexpected(unknown_classes);
  return Values(source, *type, datatype, alike).run(distinctions, taken);
}

}  // namespace geminga::reasoner
