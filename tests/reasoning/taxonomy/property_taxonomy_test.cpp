// The hierarchy of properties: every case with exactly what follows.
#include "reasoning/taxonomy/property_taxonomy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "reasoning/el/classify.hpp"
#include "support/written.hpp"

namespace geminga::taxonomy {
namespace {

std::string name_of(const owl::Ontology& source, owl::NameId id) {
  const std::string_view iri = source.name(id);
  if (iri == owl::owl_top_object_property || iri == owl::owl_top_data_property) return "top";
  if (iri == owl::owl_bottom_object_property || iri == owl::owl_bottom_data_property) return "bottom";
  return std::string(iri.substr(iri.find('#') + 1));
}

/// Lines `p < q` for direct super-properties but the top, and `p = q` for equivalents.
std::vector<std::string> lines_of(const owl::Ontology& source, const PropertyTaxonomy& taxonomy) {
  std::vector<std::string> lines;
  const auto name = [&](PropertyNumber number) {
    return name_of(source, taxonomy.properties[static_cast<std::size_t>(number)]);
  };
  for (std::uint32_t at = 0; at < taxonomy.properties.size(); ++at) {
    const PropertyNumber node = taxonomy.representative[at];
    if (node != PropertyNumber{at}) lines.push_back(name(node) + " = " + name(PropertyNumber{at}));
    for (const PropertyNumber parent : taxonomy.parents_of(PropertyNumber{at})) {
      if (parent != taxonomy.representative[static_cast<std::size_t>(taxonomy.top)]) {
        lines.push_back(name(PropertyNumber{at}) + " < " + name(parent));
      }
    }
  }
  std::ranges::sort(lines);
  return lines;
}

struct Hierarchy {
  const char* name;
  const char* axioms;
  std::vector<std::string> lines;
  PropertyKind kind = PropertyKind::object;
};
void PrintTo(const Hierarchy& one, std::ostream* out) { *out << one.name; }

class Properties : public testing::TestWithParam<Hierarchy> {};

TEST_P(Properties, AreReducedToWhatFollows) {
  const owl::Ontology source = owl::written(GetParam().axioms);
  EXPECT_EQ(lines_of(source, classify_properties(source, GetParam().kind)), GetParam().lines) << GetParam().axioms;
}

const Hierarchy hierarchies[] = {
    {"Told", "SubObjectPropertyOf(p q)\nSubObjectPropertyOf(q r)\nSubObjectPropertyOf(p r)", {"p < q", "q < r"}},
    {"Equivalent", "EquivalentObjectProperties(p q r)\nSubObjectPropertyOf(r s)", {"p < s", "p = q", "p = r"}},
    {"Cycle", "SubObjectPropertyOf(p q)\nSubObjectPropertyOf(q p)", {"p = q"}},
    {"Inverses", "InverseObjectProperties(p q)\nInverseObjectProperties(q r)", {"p = r"}},
    {"InverseOfSuper",
     "SubObjectPropertyOf(p q)\nInverseObjectProperties(p pi)\nInverseObjectProperties(q qi)",
     {"p < q", "pi < qi"}},
    {"ThroughAnUnnamedInverse",
     "SubObjectPropertyOf(p ObjectInverseOf(q))\nSubObjectPropertyOf(ObjectInverseOf(q) r)",
     {"p < r"}},
    {"SymmetricSuper",
     "SymmetricObjectProperty(q)\nSubObjectPropertyOf(p q)\nInverseObjectProperties(p pi)",
     {"p < q", "pi < q"}},
    {"NotOfTheInverse", "SubObjectPropertyOf(p ObjectInverseOf(q))", {}},
    {"ChainSaysNothing", "SubObjectPropertyOf(ObjectPropertyChain(p q) r)\nTransitiveObjectProperty(p)", {}},
    {"ChainWithReflexive",
     "SubObjectPropertyOf(ObjectPropertyChain(p q s) r)\nReflexiveObjectProperty(p)\nSubObjectPropertyOf(p s)",
     {"p < s", "q < r"}},
    {"ChainOfReflexives",
     "SubObjectPropertyOf(ObjectPropertyChain(p ObjectInverseOf(p)) r)\nReflexiveObjectProperty(p)\n"
     "SubObjectPropertyOf(ObjectPropertyChain(q r) s)",
     {"p < r", "q < s"}},
    {"Top", "SubObjectPropertyOf(owl:topObjectProperty p)\nSubObjectPropertyOf(q p)", {"top = p"}},
    {"Bottom",
     "SubObjectPropertyOf(p owl:bottomObjectProperty)\nSubObjectPropertyOf(q p)",
     {"bottom = p", "bottom = q"}},
    {"Disjoint",
     "DisjointObjectProperties(p q)\nSubObjectPropertyOf(r p)\nSubObjectPropertyOf(r q)\nSubObjectPropertyOf(s r)\n"
     "SubObjectPropertyOf(t p)",
     {"bottom = r", "bottom = s", "t < p"}},
    {"AsymmetricAndSymmetric",
     "AsymmetricObjectProperty(p)\nSubObjectPropertyOf(q p)\nSymmetricObjectProperty(q)",
     {"bottom = q"}},
    {"DomainNothing", "ObjectPropertyDomain(p Nothing)\nInverseObjectProperties(p q)", {"bottom = p", "bottom = q"}},
    {"Declared", "SubClassOf(A ObjectSomeValuesFrom(p B))", {}},
    {"Data",
     "SubDataPropertyOf(d:p d:q)\nEquivalentDataProperties(d:q d:r)\nSubObjectPropertyOf(p q)",
     {"p < q", "q = r"},
     PropertyKind::data},
    {"DataDisjoint",
     "SubDataPropertyOf(d:p d:q)\nSubDataPropertyOf(d:p d:r)\nDisjointDataProperties(d:q d:r)",
     {"bottom = p"},
     PropertyKind::data},
};
INSTANTIATE_TEST_SUITE_P(Each, Properties, testing::ValuesIn(hierarchies),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(PropertyTaxonomy, HasTopAndBottomWhereNothingIsSaid) {
  const owl::Ontology source = owl::written("SubClassOf(A B)");
  const Classification classification = owl::classified(source);
  EXPECT_EQ(classification.object_properties.properties.size(), 2U);
  EXPECT_EQ(classification.data_properties.properties.size(), 2U);
}

TEST(PropertyTaxonomy, IsOneNodeWhereTheOntologyIsInconsistent) {
  const owl::Ontology source = owl::written("SubClassOf(Thing Nothing)\nSubObjectPropertyOf(p q)");
  EXPECT_EQ(lines_of(source, owl::classified(source).object_properties),
            (std::vector<std::string>{"bottom = p", "bottom = q", "bottom = top"}));
}

/// Every inclusion between p0 .. p5 and their inverses by naive closure.
bool follows(const std::vector<std::pair<int, int>>& told, int from, int to) {
  std::vector<bool> seen(12, false);
  seen[static_cast<std::size_t>(from)] = true;
  for (bool grown = true; grown;) {
    grown = false;
    for (const auto& [sub, super] : told) {
      if (!seen[static_cast<std::size_t>(sub)] || seen[static_cast<std::size_t>(super)]) continue;
      seen[static_cast<std::size_t>(super)] = grown = true;
    }
  }
  return seen[static_cast<std::size_t>(to)];
}

TEST(PropertyTaxonomy, IsTheNaiveClosureOfRandomAxioms) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    base::Random random(seed);
    std::string text;
    std::vector<std::pair<int, int>> told;
    const auto include = [&](int sub, int super) {
      told.emplace_back(sub, super);
      told.emplace_back(sub ^ 1, super ^ 1);
    };
    const auto write = [](int node) {
      const std::string name = "p" + std::to_string(node / 2);
      return node % 2 == 0 ? name : "ObjectInverseOf(" + name + ")";
    };
    for (std::uint64_t axioms = 1 + random.below(7); axioms > 0; --axioms) {
      const int one = static_cast<int>(random.below(12));
      const int other = static_cast<int>(random.below(12));
      if (random.chance(0.7)) {
        text += "SubObjectPropertyOf(" + write(one) + " " + write(other) + ")\n";
        include(one, other);
      } else if (random.chance(0.5)) {
        text += "InverseObjectProperties(" + write(one) + " " + write(other) + ")\n";
        include(one, other ^ 1);
        include(other ^ 1, one);
      } else {
        text += "SymmetricObjectProperty(" + write(one) + ")\n";
        include(one, one ^ 1);
      }
    }
    const owl::Ontology source = owl::written(text);
    const PropertyTaxonomy taxonomy = classify_properties(source, PropertyKind::object);
    for (std::uint32_t sub = 0; sub < taxonomy.properties.size(); ++sub) {
      std::vector<PropertyNumber> above = {taxonomy.representative[sub]};
      for (std::size_t at = 0; at < above.size(); ++at) {
        const auto parents = taxonomy.parents_of(above[at]);
        above.insert(above.end(), parents.begin(), parents.end());
      }
      const auto node_of = [&](std::uint32_t number) {
        return 2 * std::stoi(name_of(source, taxonomy.properties[number]).substr(1));
      };
      for (std::uint32_t super = 0; super < taxonomy.properties.size(); ++super) {
        const PropertyNumber one{sub};
        const PropertyNumber other{super};
        if (one == taxonomy.top || one == taxonomy.bottom || other == taxonomy.top || other == taxonomy.bottom)
          continue;
        const bool found = std::ranges::find(above, taxonomy.representative[super]) != above.end();
        ASSERT_EQ(found, follows(told, node_of(sub), node_of(super))) << "seed " << seed << "\n" << text;
      }
    }
  }
}

}  // namespace
}  // namespace geminga::taxonomy
