#include "compare/shapes.hpp"

#include <array>
#include <map>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "compare/shape_writer.hpp"

namespace geminga::compare {
namespace {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

void cover(ShapeWriter& writer, Covering covering, TermId whole, const std::vector<TermId>& parts) {
  if (parts.size() == 1) return writer.add(AxiomKind::sub_class_of, {parts[0], whole});
  if (covering == Covering::disjoint_union) {
    std::vector<TermId> all{whole};
    all.insert(all.end(), parts.begin(), parts.end());
    return writer.add(AxiomKind::disjoint_union, all);
  }
  writer.add(AxiomKind::equivalent_classes, {whole, writer.term(TermKind::object_union_of, parts)});
  if (covering == Covering::all_disjoint) return writer.add(AxiomKind::disjoint_classes, parts);
  for (std::size_t first = 0; first < parts.size(); ++first) {
    for (std::size_t second = first + 1; second < parts.size(); ++second)
      writer.add(AxiomKind::disjoint_classes, {parts[first], parts[second]});
  }
}

/// Says that an instance of `whole` puts each of `pigeons` pigeons into one of `holes` holes, no two into the same.
void put_pigeons(ShapeWriter& writer, const std::string& whole, std::size_t pigeons, std::size_t holes) {
  const auto place = [&](std::size_t pigeon, std::size_t hole) {
    return writer.named(whole + std::to_string(pigeon) + "in" + std::to_string(hole));
  };
  for (std::size_t pigeon = 0; pigeon < pigeons; ++pigeon) {
    std::vector<TermId> places;
    for (std::size_t hole = 0; hole < holes; ++hole) {
      places.push_back(place(pigeon, hole));
      for (std::size_t other = 0; other < pigeon; ++other)
        writer.add(AxiomKind::disjoint_classes, {place(pigeon, hole), place(other, hole)});
    }
    writer.add(AxiomKind::sub_class_of, {writer.named(whole), writer.term(TermKind::object_union_of, places)});
  }
}

}  // namespace

owl::Ontology covering_tree(Covering covering, std::size_t classes, std::size_t width) {
  ShapeWriter writer;
  std::map<std::size_t, std::vector<TermId>> children;
  for (std::size_t at = 1; at < classes; ++at)
    children[(at - 1) / width].push_back(writer.named("C" + std::to_string(at)));
  for (const auto& [parent, parts] : children)
    cover(writer, covering, writer.named("C" + std::to_string(parent)), parts);
  return writer.take();
}

owl::Ontology pigeonhole(std::size_t holes) {
  ShapeWriter writer;
  put_pigeons(writer, "A", holes + 1, holes);
  put_pigeons(writer, "B", holes + 1, holes + 1);
  return writer.take();
}

owl::Ontology enumeration(std::uint64_t seed, std::size_t individuals) {
  base::Random random(seed);
  ShapeWriter writer;
  std::vector<TermId> members;
  for (std::size_t at = 0; at < individuals; ++at) {
    members.push_back(writer.individual("i" + std::to_string(at)));
    writer.add(AxiomKind::class_assertion, {writer.named("Kind" + std::to_string(random.below(3))), members.back()});
  }
  for (const char* kind : {"Kind0", "Kind1"})
    writer.add(AxiomKind::sub_class_of, {writer.named(kind), writer.named("Measure")});
  writer.add(AxiomKind::equivalent_classes, {writer.named("Unit"), writer.term(TermKind::object_one_of, members)});
  if (random.chance(0.5)) writer.add(AxiomKind::sub_class_of, {writer.named("Kind2"), writer.named("Measure")});
  return writer.take();
}

owl::Ontology qualified_numbers(std::uint64_t seed) {
  base::Random random(seed);
  ShapeWriter writer;
  const TermId has = writer.property("has");
  const auto any = [&] { return writer.named("C" + std::to_string(random.below(7))); };
  cover(writer, Covering::disjoint_union, writer.named("C0"), {writer.named("C1"), writer.named("C2")});
  cover(writer, Covering::all_disjoint, writer.named("C1"), {writer.named("C3"), writer.named("C4")});
  constexpr std::array kinds{TermKind::object_min_cardinality, TermKind::object_max_cardinality,
                             TermKind::object_exact_cardinality};
  for (int at = 0; at < 6; ++at) {
    const TermId number =
        writer.term(kinds[random.below(kinds.size())], {has, any()}, static_cast<std::uint32_t>(random.below(4)));
    writer.add(random.chance(0.2) ? AxiomKind::equivalent_classes : AxiomKind::sub_class_of, {any(), number});
  }
  return writer.take();
}

owl::Ontology large_numbers(std::uint64_t seed, std::uint32_t greatest) {
  base::Random random(seed);
  ShapeWriter writer;
  const auto property = [&]() -> TermId {
    const TermId named = writer.property("p" + std::to_string(random.below(3)));
    return random.chance(0.15) ? writer.term(TermKind::object_inverse_of, {named}) : named;
  };
  const auto kind = [&] { return writer.named("K" + std::to_string(random.below(4))); };
  const auto filler = [&]() -> TermId {
    if (random.chance(0.2)) return owl::thing_term;
    if (random.chance(0.2)) return writer.term(TermKind::object_union_of, {kind(), kind()});
    return random.chance(0.1) ? writer.term(TermKind::object_complement_of, {kind()}) : kind();
  };
  const auto number = [&] {
    constexpr std::array kinds{TermKind::object_min_cardinality, TermKind::object_max_cardinality,
                               TermKind::object_exact_cardinality};
    const auto count = static_cast<std::uint32_t>(1 + random.below(greatest));
    return writer.term(kinds[random.below(kinds.size())], {property(), filler()}, count);
  };
  const auto whole = [&] { return writer.named("C" + std::to_string(random.below(4))); };
  writer.add(AxiomKind::sub_object_property_of, {writer.property("p1"), writer.property("p0")});
  if (random.chance(0.5)) writer.add(AxiomKind::disjoint_classes, {writer.named("K0"), writer.named("K1")});
  if (random.chance(0.5)) writer.add(AxiomKind::sub_class_of, {writer.named("K2"), writer.named("K0")});
  if (random.chance(0.3)) writer.add(AxiomKind::functional_object_property, {property()});
  if (random.chance(0.3)) {
    const std::vector<TermId> parts{writer.named("K0"), writer.named("K1"), writer.named("K3")};
    writer.add(AxiomKind::object_property_range,
               {writer.property("p0"), writer.term(TermKind::object_union_of, parts)});
  }
  for (int at = 0; at < 7; ++at) {
    if (random.chance(0.3)) {
      writer.add(AxiomKind::equivalent_classes,
                 {whole(), writer.term(TermKind::object_intersection_of, {whole(), number()})});
    } else if (random.chance(0.2)) {
      writer.add(AxiomKind::sub_class_of, {kind(), number()});
    } else if (random.chance(0.2)) {
      writer.add(AxiomKind::sub_class_of,
                 {whole(), writer.term(TermKind::object_all_values_from, {property(), filler()})});
    } else {
      writer.add(AxiomKind::sub_class_of, {whole(), number()});
    }
  }
  return writer.take();
}

owl::Ontology family(std::uint64_t seed, std::size_t individuals) {
  base::Random random(seed);
  ShapeWriter writer;
  const TermId person = writer.named("Person");
  const TermId child = writer.property("hasChild");
  const TermId parent = writer.property("hasParent");
  const std::vector<TermId> sexes{writer.named("Man"), writer.named("Woman")};
  const std::vector<TermId> generations{writer.named("Old"), writer.named("Grown"), writer.named("Young")};
  cover(writer, Covering::all_disjoint, person, sexes);
  cover(writer, Covering::disjoint_union, person, generations);
  writer.add(AxiomKind::inverse_object_properties, {child, parent});
  writer.add(AxiomKind::object_property_domain, {child, person});
  writer.add(AxiomKind::object_property_range, {child, person});
  writer.add(AxiomKind::sub_class_of, {person, writer.term(TermKind::object_max_cardinality, {parent, person}, 2)});
  for (const TermId sex : sexes) {
    writer.add(AxiomKind::sub_class_of, {person, writer.term(TermKind::object_max_cardinality, {parent, sex}, 1)});
  }
  writer.add(AxiomKind::sub_class_of,
             {generations[2], writer.term(TermKind::object_exact_cardinality, {parent, person}, 2)});
  writer.add(AxiomKind::sub_class_of, {generations[2], writer.term(TermKind::object_max_cardinality, {child}, 0)});
  for (const std::uint32_t count : {1U, 2U, 3U, 6U}) {
    const TermId number = writer.term(TermKind::object_min_cardinality, {child, person}, count);
    writer.add(AxiomKind::equivalent_classes, {writer.named("ParentOf" + std::to_string(count)),
                                               writer.term(TermKind::object_intersection_of, {person, number})});
  }
  writer.add(AxiomKind::equivalent_classes,
             {writer.named("Mother"),
              writer.term(TermKind::object_intersection_of,
                          {sexes[1], writer.term(TermKind::object_some_values_from, {child, person})})});
  std::vector<TermId> members;
  for (std::size_t at = 0; at < individuals; ++at) {
    members.push_back(writer.individual("i" + std::to_string(at)));
    writer.add(AxiomKind::class_assertion, {random.chance(0.5) ? person : sexes[random.below(2)], members.back()});
    for (std::size_t of = random.below(3); of > 0 && at > 0; --of) {
      writer.add(AxiomKind::object_property_assertion, {child, members[random.below(at)], members.back()});
    }
  }
  return writer.take();
}

owl::Ontology features(std::uint64_t seed, std::size_t kinds) {
  constexpr std::size_t properties = 5;
  constexpr std::size_t values = 3;
  base::Random random(seed);
  ShapeWriter writer;
  const auto has = [&](std::size_t of) { return writer.property("has" + std::to_string(of)); };
  const auto value = [&](std::size_t of, std::size_t at) {
    return writer.named("V" + std::to_string(of) + "_" + std::to_string(at));
  };
  for (std::size_t of = 0; of < properties; ++of) {
    const TermId whole = writer.named("V" + std::to_string(of));
    cover(writer, Covering::all_disjoint, whole, {value(of, 0), value(of, 1), value(of, 2)});
    writer.add(AxiomKind::functional_object_property, {has(of)});
    writer.add(AxiomKind::object_property_range, {has(of), whole});
    writer.add(AxiomKind::sub_class_of,
               {writer.named("A"), writer.term(TermKind::object_some_values_from, {has(of), whole})});
  }
  std::vector<TermId> parts;
  for (std::size_t at = 0; at < kinds; ++at) {
    parts.push_back(writer.named("A" + std::to_string(at)));
    for (std::size_t of = 0; of < properties; ++of) {
      if (random.chance(0.1)) continue;  // not all is told of all
      const TermId filler = value(of, random.below(values));
      writer.add(AxiomKind::sub_class_of,
                 {parts.back(), writer.term(TermKind::object_some_values_from, {has(of), filler})});
    }
  }
  cover(writer, Covering::all_disjoint, writer.named("A"), parts);
  for (std::size_t at = 0; at < kinds; ++at) {
    std::vector<TermId> definition = {writer.named("A")};
    for (int part = 0; part < 2; ++part) {
      const std::size_t of = random.below(properties);
      const std::size_t first = random.below(values);
      const std::vector<TermId> either = {value(of, first), value(of, (first + 1) % values)};
      const TermId filler = random.chance(0.5) ? either[0] : writer.term(TermKind::object_union_of, either);
      definition.push_back(
          writer.term(random.chance(0.5) ? TermKind::object_all_values_from : TermKind::object_some_values_from,
                      {has(of), filler}));
    }
    writer.add(AxiomKind::equivalent_classes,
               {writer.named("D" + std::to_string(at)), writer.term(TermKind::object_intersection_of, definition)});
  }
  return writer.take();
}

owl::Ontology anatomy(std::uint64_t seed, std::size_t organs) {
  base::Random random(seed);
  ShapeWriter writer;
  const TermId part_of = writer.property("part_of");
  const TermId has_part = writer.property("has_part");
  const TermId proper = writer.property("proper_part_of");
  const TermId located = writer.property("located_in");
  const auto organ = [&](std::size_t at) { return writer.named("O" + std::to_string(at)); };
  const auto some = [&](TermId property, TermId filler) {
    return writer.term(TermKind::object_some_values_from, {property, filler});
  };
  writer.add(AxiomKind::inverse_object_properties, {part_of, has_part});
  writer.add(AxiomKind::transitive_object_property, {part_of});
  if (random.chance(0.5)) writer.add(AxiomKind::transitive_object_property, {has_part});
  if (random.chance(0.5)) writer.add(AxiomKind::sub_object_property_of, {proper, part_of});
  if (random.chance(0.3)) {
    const TermId chain = writer.term(TermKind::object_property_chain, {located, part_of});
    writer.add(AxiomKind::sub_object_property_of, {chain, located});
  }
  const TermId material = writer.named("Material");
  if (random.chance(0.4)) writer.add(AxiomKind::object_property_range, {part_of, material});
  if (random.chance(0.2)) writer.add(AxiomKind::object_property_range, {has_part, material});
  if (random.chance(0.3)) writer.add(AxiomKind::object_property_domain, {part_of, material});
  for (std::size_t at = 1; at < organs; ++at) {
    const std::size_t whole = random.below(at);
    writer.add(AxiomKind::sub_class_of, {organ(at), some(random.chance(0.8) ? part_of : proper, organ(whole))});
    if (random.chance(0.5)) writer.add(AxiomKind::sub_class_of, {organ(whole), some(has_part, organ(at))});
    if (random.chance(0.3)) writer.add(AxiomKind::sub_class_of, {organ(at), organ(random.below(at))});
    if (random.chance(0.2)) writer.add(AxiomKind::sub_class_of, {organ(at), some(located, organ(random.below(at)))});
    if (random.chance(0.1)) writer.add(AxiomKind::disjoint_classes, {organ(at), organ(random.below(at))});
  }
  const std::array<TermId, 4> properties = {part_of, has_part, proper, located};
  for (std::size_t at = 0; at < organs / 2; ++at) {
    const TermId defined = writer.named("D" + std::to_string(at));
    const TermId relation = some(properties.at(random.below(properties.size())),
                                 random.chance(0.7) || at == 0 ? organ(random.below(organs))
                                                               : writer.named("D" + std::to_string(random.below(at))));
    const TermId meaning = random.chance(0.5)
                               ? relation
                               : writer.term(TermKind::object_intersection_of, {organ(random.below(organs)), relation});
    writer.add(AxiomKind::equivalent_classes, {defined, meaning});
    if (random.chance(0.3)) writer.add(AxiomKind::sub_class_of, {defined, organ(random.below(organs))});
  }
  return writer.take();
}

owl::Ontology pairings(std::uint64_t seed, std::size_t definitions) {
  base::Random random(seed);
  ShapeWriter writer;
  const TermId has_part = writer.property("has_part");
  const TermId pairs = writer.property("pairs");
  const std::array<TermId, 3> ways = {writer.property("pairs1"), writer.property("pairs2"), writer.property("pairs3")};
  const std::array<TermId, 3> bases = {writer.named("Base"), writer.named("A"), writer.named("B")};
  const auto base = [&] { return bases.at(random.below(bases.size())); };
  const auto some = [&](TermId property, TermId filler) {
    return writer.term(TermKind::object_some_values_from, {property, filler});
  };
  for (const std::size_t kind : {1U, 2U}) writer.add(AxiomKind::sub_class_of, {bases.at(kind), bases[0]});
  if (random.chance(0.5)) writer.add(AxiomKind::disjoint_classes, {bases[1], bases[2]});
  for (const TermId way : ways) {
    writer.add(AxiomKind::sub_object_property_of, {way, pairs});
    if (random.chance(0.3)) writer.add(AxiomKind::symmetric_object_property, {way});
  }
  if (random.chance(0.7)) writer.add(AxiomKind::functional_object_property, {pairs});
  if (random.chance(0.5)) writer.add(AxiomKind::disjoint_object_properties, {ways[0], ways[1]});
  if (random.chance(0.3)) writer.add(AxiomKind::inverse_object_properties, {ways[1], ways[2]});
  if (random.chance(0.2)) writer.add(AxiomKind::functional_object_property, {has_part});
  const bool has_individuals = random.chance(0.2);
  const TermId someone = writer.individual("someone");
  if (has_individuals) writer.add(AxiomKind::class_assertion, {base(), someone});
  std::vector<TermId> wholes = {writer.named("Whole")};
  for (std::size_t at = 0; at < definitions; ++at) {
    TermId beside = some(ways.at(random.below(ways.size())), base());
    if (random.chance(0.2)) {
      beside = some(writer.term(TermKind::object_inverse_of, {has_part}), wholes.at(random.below(wholes.size())));
    } else if (has_individuals && random.chance(0.3)) {
      beside = writer.term(TermKind::object_has_value, {ways.at(random.below(ways.size())), someone});
    }
    const TermId filler = writer.term(TermKind::object_intersection_of, {base(), beside});
    const TermKind kind = random.chance(0.7) ? TermKind::object_all_values_from : TermKind::object_some_values_from;
    wholes.push_back(writer.named("W" + std::to_string(at)));
    writer.add(AxiomKind::equivalent_classes, {wholes.back(), writer.term(kind, {has_part, filler})});
    if (random.chance(0.2))
      writer.add(AxiomKind::sub_class_of, {wholes.back(), wholes.at(random.below(wholes.size()))});
    if (random.chance(0.2)) writer.add(AxiomKind::sub_class_of, {base(), some(has_part, base())});
  }
  writer.add(AxiomKind::sub_class_of, {wholes[0], some(has_part, base())});
  return writer.take();
}

}  // namespace geminga::compare
