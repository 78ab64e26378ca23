// All units of an ontology, and the names that they may be called by.
#include "reasoning/owl/unit.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "reasoning/owl/unit_facts.hpp"

namespace geminga::owl {
namespace {

/// Units that are left out, by reason.
class Reasons {
 public:
  void add(std::string_view reason, const UnitSubject& subject, std::string_view what = {}) {
    One& one = known_[reason];
    if (one.count++ == 0 || std::pair(subject.place, subject.iri) < std::pair(one.place, one.iri)) {
      one.place = subject.place;
      one.iri = subject.iri;
      one.what = what;
    }
  }
  [[nodiscard]] std::vector<LeftOut> take() const {
    std::vector<LeftOut> all;
    for (const auto& [reason, one] : known_) {
      std::string construct(reason);
      if (!one.what.empty()) construct.append(", like ").append(one.what);
      all.push_back({std::move(construct), one.count,
                     std::string(one.place.path) + ":" + std::to_string(one.place.line),
                     static_cast<std::uint32_t>(one.place.file), one.place.line});
    }
    return all;
  }

 private:
  struct One {
    std::uint32_t count = 0;
    UnitPlace place;
    std::string_view iri;
    std::string_view what;
  };
  std::map<std::string_view, One> known_;
};

bool is_symbol_octet(char octet) {
  const bool is_letter = (octet >= 'a' && octet <= 'z') || (octet >= 'A' && octet <= 'Z');
  return is_letter || (octet >= '0' && octet <= '9') || std::string_view("_.-/+^%").contains(octet) ||
         static_cast<unsigned char>(octet) >= 0x80;
}

/// Whether a symbol can stand behind a number in a condition.
bool is_writable(std::string_view symbol) {
  if (symbol.empty() || symbol.size() > max_unit_symbol_octets) return false;
  const char first = symbol.front();
  const bool is_of_number = (first >= '0' && first <= '9') || std::string_view(".-+").contains(first);
  return !is_of_number && std::ranges::all_of(symbol, is_symbol_octet);
}

bool is_same(const DeclaredUnit& a, const DeclaredUnit& b) {
  constexpr double rounding = 1e-12;
  return a.dimension == b.dimension && a.alone == b.alone && a.offset == b.offset &&
         std::abs(a.factor - b.factor) <= rounding * std::max(a.factor, b.factor);
}

constexpr UnitWord words_of_symbols[] = {UnitWord::qudt_symbol, UnitWord::om_symbol, UnitWord::om_other_symbol,
                                         UnitWord::qudt_ucum};

/// The names of the units, whose subjects are given in the same order.
std::vector<UnitName> names_of(const std::vector<DeclaredUnit>& units, const std::vector<const UnitSubject*>& subjects,
                               Reasons& reasons) {
  std::vector<std::pair<std::string_view, std::uint32_t>> all;
  for (std::uint32_t number = 0; number < units.size(); ++number) {
    all.emplace_back(units[number].iri, number);
    for (const UnitWord word : words_of_symbols) {
      for (const UnitFact& fact : subjects[number]->all(word)) {
        if (is_writable(fact.value)) all.emplace_back(fact.value, number);
      }
    }
  }
  std::ranges::sort(all);
  std::vector<UnitName> names;
  for (std::size_t begin = 0; begin < all.size();) {
    std::size_t end = begin + 1;
    bool is_clear = true;
    for (; end < all.size() && all[end].first == all[begin].first; ++end) {
      is_clear = is_clear && is_same(units[all[begin].second], units[all[end].second]);
    }
    if (is_clear) {
      names.push_back({std::string(all[begin].first), all[begin].second});
    } else {
      reasons.add("a symbol of units that differ", *subjects[all[begin].second], all[begin].first);
    }
    begin = end;
  }
  return names;
}

DeclaredUnits nothing_but(std::string reason) {
  DeclaredUnits none;
  none.left_out.push_back({std::move(reason), 1, {}});
  return none;
}

}  // namespace

DeclaredUnits units_of(const Ontology& source) {
  const auto subjects = unit_subjects(source);
  if (!subjects) {
    return nothing_but("all units: there are more than " + std::to_string(max_unit_statements) + " statements of them");
  }
  std::vector<std::optional<UnitReading>> readings(subjects->size());
  for (std::size_t number = 0; number < subjects->size(); ++number) {
    if (is_qudt_unit((*subjects)[number])) readings[number] = qudt_measure((*subjects)[number]);
  }
  measure_om_units(*subjects, readings);
  DeclaredUnits result;
  Reasons reasons;
  std::vector<const UnitSubject*> kept;
  std::map<std::string_view, std::uint32_t> places;
  for (std::size_t number = 0; number < subjects->size(); ++number) {
    const UnitSubject& subject = (*subjects)[number];
    for ([[maybe_unused]] const UnitFact& fact : subject.all(UnitWord::too_long)) {
      reasons.add("a name or value of more than 512 octets", subject);
    }
    if (!readings[number]) continue;
    if (!*readings[number]) {
      reasons.add(readings[number]->error(), subject, subject.iri);
      continue;
    }
    places.emplace(subject.iri, static_cast<std::uint32_t>(kept.size()));
    kept.push_back(&subject);
    const UnitMeasure& measure = **readings[number];
    result.units.push_back({std::string(subject.iri), measure.factor, measure.offset, measure.dimension, {}, {}});
    for (const UnitWord word : words_of_symbols) {
      const auto symbol =
          std::ranges::find_if(subject.all(word), [](const UnitFact& fact) { return is_writable(fact.value); });
      if (result.units.back().symbol.empty() && symbol != subject.all(word).end()) {
        result.units.back().symbol = symbol->value;
      }
    }
  }
  if (kept.size() > max_units) return nothing_but("all units: there are more than " + std::to_string(max_units));
  for (std::size_t at = 0; at < kept.size(); ++at) {
    const auto number = static_cast<std::size_t>(kept[at] - subjects->data());
    const std::string_view alone = (*readings[number])->alone;
    // The unit that others are multiples of is declared itself, and nothing of it can be left out.
    if (!alone.empty()) result.units[at].alone = places.at(alone);
  }
  result.names = names_of(result.units, kept, reasons);
  result.left_out = reasons.take();
  return result;
}

}  // namespace geminga::owl
