// Axioms are taken apart, a minimal set of the parts is found, and each part is weakened while the conclusion follows.
#include "reasoning/explanation/laconic.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "reasoning/explanation/weaker.hpp"

namespace geminga::explanation {
namespace {

/// One search. Parts are axioms of the module's source with the file and the line of their whole.
class Weakening {
 public:
  explicit Weakening(Explainer& explainer) : explainer_(explainer) {}

  Laconic run(const AxiomSet& set) {
    Laconic result;
    AxiomSet parts;
    for (const std::uint32_t whole : set) {
      const std::vector<Part> some = parts_of(source(), source().axiom(whole));
      if (some.size() == 1 && some.front() == part(whole)) {
        whole_[whole] = whole;
        parts.push_back(whole);
        continue;
      }
      for (const Part& one : some) {
        const auto number = add(one, whole);
        if (number) parts.push_back(*number);
      }
    }
    // An engine may fail on the parts although it did not on the wholes.
    if (!holds(parts)) return whole_set(set, result);
    AxiomSet needed = find_minimal(parts, [this](std::span<const std::uint32_t> some) { return holds(some); });
    if (!holds(needed)) return whole_set(set, result);
    for (std::size_t at = 0; at < needed.size(); ++at) weaken(needed, at);
    result.is_laconic = !is_over();
    result.parts = parts_in_order(set, needed);
    return result;
  }

 private:
  owl::Ontology& source() { return explainer_.module().source(); }

  Part part(std::uint32_t number) {
    const owl::Axiom axiom = source().axiom(number);
    return {axiom.kind, {axiom.arguments.begin(), axiom.arguments.end()}};
  }

  std::optional<std::uint32_t> add(const Part& one, std::uint32_t whole) {
    const owl::Axiom axiom = source().axiom(whole);
    const auto number = static_cast<std::uint32_t>(source().axiom_count());
    source().add(one.kind, one.arguments, axiom.file, axiom.line);
    if (source().axiom_count() == number) return std::nullopt;  // it nests too deep
    whole_[number] = whole;
    return number;
  }

  [[nodiscard]] bool is_over() const { return questions_ >= max_laconic_questions || explainer_.oracle().is_spent(); }

  bool holds(std::span<const std::uint32_t> axioms) {
    if (is_over()) return false;
    ++questions_;
    return explainer_.oracle().holds(axioms, explainer_.sub(), explainer_.super());
  }

  /// Replaces one part by weaker forms until none of them is enough.
  void weaken(AxiomSet& needed, std::size_t at) {
    bool is_weaker = true;
    while (is_weaker && !is_over()) {
      is_weaker = false;
      for (const Part& form : weaker_forms(source(), part(needed[at]))) {
        const auto number = add(form, whole_[needed[at]]);
        if (!number) continue;
        const std::uint32_t stronger = std::exchange(needed[at], *number);
        if (holds(needed)) {
          is_weaker = true;
          break;
        }
        needed[at] = stronger;
      }
    }
  }

  Laconic whole_set(const AxiomSet& set, Laconic& result) {
    for (const std::uint32_t whole : set) whole_[whole] = whole;
    result.is_laconic = false;
    result.parts = parts_in_order(set, set);
    return result;
  }

  /// A whole of which all parts are needed as they are stands for them.
  std::vector<Laconic::PartOf> parts_in_order(const AxiomSet& set, const AxiomSet& needed) {
    std::map<std::uint32_t, std::vector<Part>> kept;
    for (const std::uint32_t number : needed) kept[whole_[number]].push_back(part(number));
    AxiomSet shown;
    std::map<std::uint32_t, bool> is_whole;
    for (const std::uint32_t whole : set) {
      const std::vector<Part> all = parts_of(source(), source().axiom(whole));
      const auto& some = kept[whole];
      is_whole[whole] =
          std::ranges::all_of(all, [&](const Part& one) { return std::ranges::find(some, one) != some.end(); });
      if (is_whole[whole]) shown.push_back(whole);
    }
    for (const std::uint32_t number : needed) {
      if (!is_whole[whole_[number]]) shown.push_back(number);
    }
    std::vector<Laconic::PartOf> parts;
    for (const std::uint32_t number : explainer_.module().in_order_of_argument(shown, explainer_.sub())) {
      const bool is_all = set.end() != std::ranges::find(set, number);
      const std::uint32_t whole = is_all ? number : whole_[number];
      parts.push_back({number, whole, is_all});
    }
    return parts;
  }

  Explainer& explainer_;
  std::map<std::uint32_t, std::uint32_t> whole_;  ///< of each part
  std::size_t questions_ = 0;
};

}  // namespace

Laconic find_laconic(Explainer& explainer, const AxiomSet& set) {
  if (set.empty()) return {};
  return Weakening(explainer).run(set);
}

}  // namespace geminga::explanation
