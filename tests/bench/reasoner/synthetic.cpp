#include "bench/reasoner/synthetic.hpp"

#include <algorithm>

#include "base/random.hpp"

namespace geminga::bench {
namespace {

/// The number of axes, such as body structure, substance, finding, procedure. Fillers of a property come from one axis.
constexpr std::uint32_t axes = 12;
/// The axis whose classes are parts of each other.
constexpr std::uint32_t structures = 1;
constexpr std::uint32_t properties = 60;
/// The first axis whose classes have role groups; the axes below it have the fillers.
constexpr std::uint32_t first_with_groups = 5;
constexpr std::uint32_t most_groups = 3;

// Shares, so that 350 000 classes have about 722 000 axioms.
constexpr double in_axes_with_groups = 0.75;
constexpr double second_parent = 0.85;
constexpr double has_groups = 0.95;
constexpr double is_defined = 0.20;
constexpr double inherits_groups = 0.70;
constexpr double is_part = 0.60;

class Maker {
 public:
  Maker(std::uint32_t classes, std::uint64_t seed) : random_(seed), count_(std::max(classes, 50U)) {}

  Synthetic make() {
    make_properties();
    made_.classes.resize(count_);
    axis_of_.resize(count_);
    children_.resize(count_);
    members_.resize(axes);
    for (std::uint32_t number = 1; number <= axes; ++number) add_root(number);
    for (std::uint32_t number = axes + 1; number < count_; ++number) add(number);
    return std::move(made_);
  }

 private:
  /// Property 0 is partOf, 1 the role group; the others form a hierarchy about eight deep.
  void make_properties() {
    made_.property_count = properties;
    made_.part_of = 0;
    made_.role_group = 1;
    for (std::uint32_t sub = 3; sub < properties; ++sub)
      made_.sub_properties.emplace_back(sub, random_.chance(0.7) ? sub - 1 : 2 + below(sub - 2));
    made_.chains.push_back({properties - 1, made_.part_of, properties - 1});
    made_.chains.push_back({properties - 2, made_.part_of, properties - 3});
    made_.chains.push_back({properties / 2, made_.part_of, properties / 2});
  }

  std::uint32_t below(std::uint64_t bound) { return static_cast<std::uint32_t>(random_.below(bound)); }

  void place(std::uint32_t number, std::uint32_t axis) {
    axis_of_[number] = axis;
    members_[axis].push_back(number);
  }

  void add_root(std::uint32_t number) {
    made_.classes[number].parents.push_back(0);
    children_[0].push_back(number);
    place(number, number - 1);
  }

  void add(std::uint32_t number) {
    SyntheticClass& made = made_.classes[number];
    const std::uint32_t axis = random_.chance(in_axes_with_groups) ? first_with_groups + below(axes - first_with_groups)
                                                                   : below(first_with_groups);
    // Among the members so far with equal chances: a tree about as deep as twice the logarithm of its size.
    const std::uint32_t parent = members_[axis][below(members_[axis].size())];
    made.parents.push_back(parent);
    if (random_.chance(second_parent)) add_uncle(made, parent);
    place(number, axis);
    for (const std::uint32_t one : made.parents) children_[one].push_back(number);
    if (axis == structures && random_.chance(is_part)) made.part_of = filler(structures);
    if (axis < first_with_groups || !random_.chance(has_groups)) return;
    add_groups(made, parent);
    made.is_defined = random_.chance(is_defined);
  }

  /// A second parent near the first, so that ancestors stay few, as they are in ontologies that people write.
  void add_uncle(SyntheticClass& made, std::uint32_t parent) {
    if (made_.classes[parent].parents.empty() || made_.classes[parent].parents.front() == 0) return;
    const auto& uncles = children_[made_.classes[parent].parents.front()];
    const std::uint32_t uncle = uncles[below(uncles.size())];
    if (uncle != parent) made.parents.push_back(uncle);
  }

  /// Makes attributes: mostly those of the parent with one filler made more special, so that definitions find
  /// subclasses.
  void add_groups(SyntheticClass& made, std::uint32_t parent) {
    const auto& inherited = made_.classes[parent].groups;
    if (!inherited.empty() && random_.chance(inherits_groups)) {
      made.groups = inherited;
      for (auto& group : made.groups) {
        for (Attribute& attribute : group) {
          const auto& more_special = children_[attribute.filler];
          if (!more_special.empty() && random_.chance(0.5)) attribute.filler = more_special[below(more_special.size())];
        }
      }
      if (made.groups.size() < most_groups && random_.chance(0.2)) made.groups.push_back(fresh_group());
    } else {
      made.groups.push_back(fresh_group());
    }
    for (auto& group : made.groups) std::ranges::sort(group);
  }

  std::vector<Attribute> fresh_group() {
    std::vector<Attribute> group;
    for (std::uint32_t more = 1 + below(3); more > 0; --more) {
      const std::uint32_t property = 2 + below(properties - 2);
      group.push_back({property, filler(1 + property % (first_with_groups - 1))});
    }
    return group;
  }

  std::uint32_t filler(std::uint32_t axis) { return members_[axis][below(members_[axis].size())]; }

  base::Random random_;
  std::uint32_t count_;
  Synthetic made_;
  std::vector<std::uint32_t> axis_of_;
  std::vector<std::vector<std::uint32_t>> children_;
  std::vector<std::vector<std::uint32_t>> members_;
};

}  // namespace

Synthetic make_synthetic(std::uint32_t classes, std::uint64_t seed) { return Maker(classes, seed).make(); }

std::size_t axiom_count(const Synthetic& ontology) {
  std::size_t count = ontology.sub_properties.size() + ontology.chains.size() + 2;
  for (const SyntheticClass& one : ontology.classes)
    count += (one.is_defined ? 1 : one.parents.size() + (one.groups.empty() ? 0 : 1)) + (one.part_of != 0 ? 1 : 0);
  return count;
}

}  // namespace geminga::bench
