// One line of text for a clause.
#include "reasoning/dl/clauses/print.hpp"

namespace geminga::clauses {
namespace {

class Printer {
 public:
  Printer(const owl::Ontology& source, const ClauseSet& set, const owl::ShortName& short_name)
      : source_(source), set_(set), short_name_(short_name) {}

  [[nodiscard]] std::string concept_of(ConceptId id) const {
    const Concept& entry = set_.concepts[number(id)];
    if (entry.kind == ConceptKind::auxiliary) return "Q" + std::to_string(number(id));
    const std::string name = entry.term == no_term ? "?" : owl::print(source_, entry.term, short_name_);
    if (entry.kind == ConceptKind::mark) return "mark of " + name;
    return entry.kind == ConceptKind::nominal ? "{" + name + "}" : name;
  }

  [[nodiscard]] std::string atoms(const std::vector<Atom>& atoms, std::string_view between,
                                  std::string_view none) const {
    if (atoms.empty()) return std::string(none);
    std::string text;
    for (const Atom& one : atoms) {
      if (!text.empty()) text += between;
      text += atom(one);
    }
    return text;
  }

 private:
  [[nodiscard]] static std::string variable(Variable at) {
    return at == centre ? "x" : "y" + std::to_string(static_cast<unsigned>(at));
  }
  [[nodiscard]] std::string role(Role role) const {
    return owl::print(source_, set_.properties[number(role.property)], short_name_) + (role.is_inverse ? "-" : "");
  }
  [[nodiscard]] std::string data_property(DataPropertyId id) const {
    return owl::print(source_, set_.data_properties[number(id)], short_name_);
  }
  [[nodiscard]] std::string range(DataRangeId id) const {
    if (number(id) < 2) return number(id) == 0 ? "any" : "none";
    const DataRange& range = set_.data_ranges[number(id)];
    return (range.is_complement ? "not " : "") + owl::print(source_, range.term, short_name_);
  }
  [[nodiscard]] std::string number_restriction(std::string_view sign, std::uint32_t count, const std::string& property,
                                               const std::string& filler, Variable at) const {
    return std::string(sign) + std::to_string(count) + " " + property + "." + filler + "(" + variable(at) + ")";
  }
  [[nodiscard]] std::string atom(const Atom& atom) const {
    const std::uint32_t at = atom.predicate;
    const std::string both = "(" + variable(atom.first) + "," + variable(atom.second) + ")";
    switch (atom.kind) {
      case AtomKind::concept_of:
        return concept_of(ConceptId{at}) + "(" + variable(atom.first) + ")";
      case AtomKind::role:
        return role({PropertyId{at}, false}) + both;
      case AtomKind::equal:
      case AtomKind::data_equal:
        return variable(atom.first) + "=" + variable(atom.second);
      case AtomKind::at_least: {
        const AtLeast& one = set_.at_leasts[at];
        return number_restriction(">=", one.count, role(one.role), concept_of(one.filler), atom.first);
      }
      case AtomKind::data_role:
        return data_property(DataPropertyId{at}) + both;
      case AtomKind::data_range:
        return range(DataRangeId{at}) + "(" + variable(atom.first) + ")";
      case AtomKind::data_at_least: {
        const DataAtLeast& one = set_.data_at_leasts[at];
        return number_restriction(">=", one.count, data_property(one.property), range(one.range), atom.first);
      }
      case AtomKind::at_most: {
        const AtMost& one = set_.at_mosts[at];
        return number_restriction("<=", one.count, role(one.role), concept_of(one.filler), atom.first);
      }
      case AtomKind::data_at_most: {
        const DataAtMost& one = set_.data_at_mosts[at];
        return number_restriction("<=", one.count, data_property(one.property), range(one.range), atom.first);
      }
    }
    return {};
  }

  const owl::Ontology& source_;
  const ClauseSet& set_;
  const owl::ShortName& short_name_;
};

}  // namespace

std::string print(const owl::Ontology& source, const ClauseSet& set, ConceptId id, const owl::ShortName& short_name) {
  return Printer(source, set, short_name).concept_of(id);
}

std::string print(const owl::Ontology& source, const ClauseSet& set, const Clause& clause,
                  const owl::ShortName& short_name) {
  const Printer printer(source, set, short_name);
  return printer.atoms(clause.body, ", ", "true") + " -> " + printer.atoms(clause.head, " or ", "false");
}

}  // namespace geminga::clauses
