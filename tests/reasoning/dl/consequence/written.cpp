#include "reasoning/dl/consequence/written.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/syntax/functional/read.hpp"

namespace geminga::consequence {
namespace {

constexpr std::string_view prefix = "https://t.example/#";

[[nodiscard]] std::string short_name(const owl::Ontology& source, const clauses::ClauseSet& clauses,
                                     clauses::ConceptId id) {
  if (id == clauses::nothing) return "Nothing";
  const std::string_view iri = source.name_of(clauses.concepts[number(id)].term);
  return std::string(iri.starts_with(prefix) ? iri.substr(prefix.size()) : iri);
}

}  // namespace

owl::Ontology written(std::string_view axioms) {
  const std::string text = "Prefix(:=<" + std::string(prefix) +
                           ">)\nPrefix(owl:=<http://www.w3.org/2002/07/owl#>)\n"
                           "Prefix(rdfs:=<http://www.w3.org/2000/01/rdf-schema#>)\n"
                           "Prefix(xsd:=<http://www.w3.org/2001/XMLSchema#>)\nOntology(<https://t.example/>\n" +
                           std::string(axioms) + "\n)\n";
  owl::Ontology source;
  const owl::FileId file = source.add_file("test.ofn");
  const auto document = functional::read(text, file, source, {.wrong_axioms = 0});
  EXPECT_TRUE(document.has_value()) << text << (document ? "" : document.error().text);
  return source;
}

clauses::ClauseSet clauses_of(const owl::Ontology& source, std::span<const owl::TermId> queries) {
  auto clauses = clauses::clausify(source, {}, queries);
  EXPECT_TRUE(clauses.has_value());
  return clauses ? std::move(*clauses) : clauses::ClauseSet();
}

std::vector<clauses::ConceptId> named_classes(const clauses::ClauseSet& clauses) {
  std::vector<clauses::ConceptId> classes;
  for (std::uint32_t i = 0; i < clauses.concepts.size(); ++i) {
    if (clauses.concepts[i].kind == clauses::ConceptKind::named) classes.push_back(clauses::ConceptId{i});
  }
  return classes;
}

std::vector<std::string> lines_of(const owl::Ontology& source, const clauses::ClauseSet& clauses,
                                  const Closure& closure) {
  if (!closure.is_consistent) return {"inconsistent"};
  std::vector<std::string> lines;
  const auto classes = named_classes(clauses);
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if (classes[i] == clauses::nothing) continue;
    for (const clauses::ConceptId above : closure.subsumers[i]) {
      if (above == classes[i] || above == clauses::thing) continue;
      if (clauses.concepts[number(above)].kind != clauses::ConceptKind::named) continue;
      const std::string below = classes[i] == clauses::thing ? "Thing" : short_name(source, clauses, classes[i]);
      lines.push_back(below + ' ' + short_name(source, clauses, above));
    }
  }
  std::ranges::sort(lines);
  return lines;
}

std::vector<std::string> closure_of(std::string_view axioms) {
  const owl::Ontology source = written(axioms);
  const clauses::ClauseSet clauses = clauses_of(source);
  return lines_of(source, clauses, saturate(source, clauses, named_classes(clauses)));
}

std::vector<std::string> gaps_of(std::string_view axioms) {
  const owl::Ontology source = written(axioms);
  const clauses::ClauseSet clauses = clauses_of(source);
  return saturate(source, clauses, named_classes(clauses)).gaps;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

namespace {

/// Writes one random ontology.
class Writer {
 public:
  Writer(base::Random& random, const Vocabulary& vocabulary) : random_(random), vocabulary_(vocabulary) {
    for (std::uint64_t i = 0; i < 4 + random_.below(6); ++i) classes_.push_back(":C" + std::to_string(i));
    for (std::uint64_t i = 0; i < 1 + random_.below(4); ++i) properties_.push_back(":r" + std::to_string(i));
    simple_ = properties_;
  }

  std::vector<std::string> write() {
    write_properties();
    const std::uint64_t count = 4 + random_.below(11);
    for (std::uint64_t i = 0; i < count; ++i) write_axiom();
    if (vocabulary_.facts) write_facts();
    return std::move(axioms_);
  }

 private:
  [[nodiscard]] const std::string& one_of(const std::vector<std::string>& names) {
    return names[random_.below(names.size())];
  }
  [[nodiscard]] std::string role(const std::vector<std::string>& names) {
    const std::string& name = one_of(names);
    return random_.chance(0.3) ? "ObjectInverseOf(" + name + ")" : name;
  }

  void write_properties() {
    // Properties are below later ones only, and the last are transitive, so that the others are simple.
    for (std::size_t i = 0; i + 1 < properties_.size(); ++i) {
      if (random_.chance(0.4))
        axioms_.push_back("SubObjectPropertyOf(" + role({properties_[i]}) + ' ' + properties_[i + 1] + ")");
    }
    if (random_.chance(0.3)) {
      axioms_.push_back("TransitiveObjectProperty(" + properties_.back() + ")");
      simple_.pop_back();
    }
    for (const std::string& name : simple_) {
      if (random_.chance(0.25)) axioms_.push_back("FunctionalObjectProperty(" + name + ")");
      if (random_.chance(0.15)) axioms_.push_back("InverseFunctionalObjectProperty(" + name + ")");
      if (random_.chance(0.08)) axioms_.push_back("AsymmetricObjectProperty(" + name + ")");
      if (random_.chance(0.08)) axioms_.push_back("IrreflexiveObjectProperty(" + name + ")");
      if (random_.chance(0.05)) axioms_.push_back("ReflexiveObjectProperty(" + name + ")");
    }
    for (const std::string& name : properties_) {
      if (random_.chance(0.1)) axioms_.push_back("SymmetricObjectProperty(" + name + ")");
    }
    if (simple_.size() > 1 && random_.chance(0.1)) {
      axioms_.push_back("DisjointObjectProperties(" + simple_[0] + ' ' + simple_[1] + ")");
    }
  }

  [[nodiscard]] std::string expression(int depth, bool is_super) {
    const double kind = random_.unit();
    if (depth == 0 || kind < 0.4) return one_of(classes_);
    const auto inner = [&] { return expression(depth - 1, is_super); };
    if (kind < 0.52) return "ObjectIntersectionOf(" + inner() + ' ' + inner() + ")";
    if (kind < 0.60)
      return vocabulary_.disjunctions || !is_super ? "ObjectUnionOf(" + inner() + ' ' + inner() + ")" : inner();
    if (kind < 0.65)
      return vocabulary_.disjunctions ? "ObjectComplementOf(" + expression(depth - 1, !is_super) + ")" : inner();
    if (kind < 0.80) return "ObjectSomeValuesFrom(" + role(properties_) + ' ' + inner() + ")";
    if (!vocabulary_.disjunctions && !is_super) return inner();
    if (kind < 0.88) return "ObjectAllValuesFrom(" + role(properties_) + ' ' + inner() + ")";
    if (simple_.empty()) return inner();
    const std::string number = std::to_string(1 + random_.below(3));
    if (kind < 0.93) return "ObjectMinCardinality(" + number + ' ' + role(simple_) + ' ' + inner() + ")";
    if (kind < 0.98 && vocabulary_.disjunctions) {
      return "ObjectMaxCardinality(" + std::to_string(random_.below(3)) + ' ' + role(simple_) + ' ' +
             expression(depth - 1, !is_super) + ")";
    }
    return "ObjectHasSelf(" + one_of(simple_) + ")";
  }

  void write_axiom() {
    const double kind = random_.unit();
    if (kind < 0.75) {
      const std::string sub = random_.chance(0.6) ? one_of(classes_) : expression(1, false);
      axioms_.push_back("SubClassOf(" + sub + ' ' + expression(2, true) + ")");
    } else if (kind < 0.87 && vocabulary_.disjunctions) {
      axioms_.push_back("EquivalentClasses(" + one_of(classes_) + ' ' + expression(2, true) + ")");
    } else if (kind < 0.94) {
      axioms_.push_back("DisjointClasses(" + one_of(classes_) + ' ' + one_of(classes_) + ")");
    } else if (kind < 0.97) {
      axioms_.push_back("ObjectPropertyDomain(" + one_of(properties_) + ' ' + expression(1, true) + ")");
    } else {
      axioms_.push_back("ObjectPropertyRange(" + one_of(properties_) + ' ' + expression(1, true) + ")");
    }
  }

  void write_facts() {
    const auto individual = [this] { return ":i" + std::to_string(random_.below(4)); };
    for (std::uint64_t i = 0; i < 2 + random_.below(8); ++i) {
      const double kind = random_.unit();
      if (kind < 0.4) {
        axioms_.push_back("ClassAssertion(" + expression(1, true) + ' ' + individual() + ")");
      } else if (kind < 0.9) {
        axioms_.push_back("ObjectPropertyAssertion(" + one_of(properties_) + ' ' + individual() + ' ' + individual() +
                          ")");
      } else if (kind < 0.95) {
        axioms_.push_back("DifferentIndividuals(:i0 :i" + std::to_string(1 + random_.below(3)) + ")");
      } else {
        axioms_.push_back("SameIndividual(:i0 :i" + std::to_string(1 + random_.below(3)) + ")");
      }
    }
  }

  base::Random& random_;
  Vocabulary vocabulary_;
  std::vector<std::string> classes_;
  std::vector<std::string> properties_;
  std::vector<std::string> simple_;
  std::vector<std::string> axioms_;
};

}  // namespace

std::vector<std::string> random_axioms(base::Random& random, const Vocabulary& vocabulary) {
  return Writer(random, vocabulary).write();
}

}  // namespace geminga::consequence
