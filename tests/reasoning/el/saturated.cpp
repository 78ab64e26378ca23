// A check for each rule of saturation.hpp that its conclusion is there.
#include "saturated.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "reasoning/el/index/index_builder.hpp"

namespace geminga::el {
namespace {

class Validator {
 public:
  Validator(const IndexedOntology& index, const Saturation& saturation) : index_(index), saturation_(saturation) {
    for (std::uint32_t at = 0; at < saturation.contexts().size(); ++at) {
      const Context& context = saturation.contexts()[at];
      above_.emplace_back(context.subsumers.items().begin(), context.subsumers.items().end());
      for (const Link link : context.backward.items()) {
        links_.insert({link.context, static_cast<std::uint32_t>(link.role), at});
      }
    }
  }

  std::string run() {
    for (std::uint32_t at = 0; at < above_.size() && problem_.empty(); ++at) {
      if (context(at).is_unsatisfiable) {
        if (context(at).is_nonempty) expect(!saturation_.is_consistent(), "inconsistency", at, 0);
        continue;
      }
      check_init(at);
      for (const std::uint32_t subsumer : above_[at]) {
        if (subsumer < index_.size()) check_subsumer(at, ExprId{subsumer});
      }
      check_selfs(at);
      check_functional(at);
      check_nominals(at);
    }
    for (const auto& [from, role, to] : links_) {
      if (!problem_.empty()) break;
      check_link(from, RoleId{role}, to);
    }
    return problem_;
  }

 private:
  using Entry = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

  [[nodiscard]] const Context& context(std::uint32_t at) const { return saturation_.contexts()[at]; }
  [[nodiscard]] bool has(std::uint32_t at, ExprId id) const { return above_[at].contains(number(id)); }
  [[nodiscard]] bool has_link(std::uint32_t from, RoleId role, std::uint32_t to) const {
    return links_.contains({from, static_cast<std::uint32_t>(role), to});
  }
  [[nodiscard]] bool is_sub(RoleId sub, RoleId super) const { return index_.roles().is_sub_role(sub, super); }
  void expect(bool holds, const char* rule, std::uint32_t at, std::uint32_t about) {
    if (!holds && problem_.empty()) {
      problem_ = std::string(rule) + " of context " + std::to_string(at) + " about " + std::to_string(about);
    }
  }
  [[nodiscard]] std::set<ExprId> atoms(std::uint32_t at) const {
    if (context(at).together.empty()) return {context(at).root};
    return {context(at).together.begin(), context(at).together.end()};
  }

  /// True if the atom, or all atoms with rules above it, are subsumers of the context.
  void expect_atom(std::uint32_t at, ExprId atom, const char* rule) {
    if (index_.is_active(atom)) return expect(has(at, atom), rule, at, number(atom));
    for (const ExprId above : index_.frontier(atom)) expect(has(at, above), rule, at, number(above));
  }

  void check_init(std::uint32_t at) {
    for (const ExprId atom : atoms(at)) expect_atom(at, atom, "init");
    expect_atom(at, top_expr, "init");
    for (const ExprId atom : context(at).derived) expect_atom(at, atom, "derived atom");
  }

  void check_subsumer(std::uint32_t at, ExprId id) {
    expect(!index_.is_told_bottom(id), "told bottom", at, number(id));
    for (const ExprId told : index_.told_atoms(id)) expect_atom(at, told, "told");
    for (const LinkRule& link : index_.links(id)) {
      const Context* target = saturation_.find(link.root);
      expect(target != nullptr && has_link(at, link.role, saturation_.number_of(link.root)), "link", at, number(id));
    }
    for (const RoleId role : index_.selfs(id)) {
      expect(std::ranges::find(context(at).selfs.get(), role) != context(at).selfs.end(), "self", at, number(id));
    }
    for (const ConjunctionRule& rule : index_.conjunctions(id)) {
      expect(!has(at, rule.partner) || has(at, rule.conjunction), "conjunction", at, number(rule.conjunction));
    }
    for (const std::uint32_t axiom : index_.disjointness(id)) {
      for (const std::uint32_t other : above_[at]) {
        if (other >= index_.size() || ExprId{other} == id) continue;
        const auto axioms = index_.disjointness(ExprId{other});
        expect(std::ranges::find(axioms, axiom) == axioms.end(), "disjointness", at, axiom);
      }
    }
  }

  void check_link(std::uint32_t from, RoleId role, std::uint32_t to) {
    if (context(from).is_unsatisfiable) return;
    expect(!context(to).is_unsatisfiable, "bottom", from, to);
    for (const std::uint32_t filler : above_[to]) {
      if (filler >= index_.size()) continue;
      for (const ExistentialRule& rule : index_.existentials(ExprId{filler})) {
        expect(!is_sub(role, rule.role) || has(from, rule.existential), "existential", from, number(rule.existential));
      }
    }
    for (const Composition& rule : index_.roles().compositions(role)) {
      for (auto next = links_.lower_bound({to, 0, 0}); next != links_.end() && std::get<0>(*next) == to; ++next) {
        if (RoleId{std::get<1>(*next)} != rule.second) continue;
        expect(has_link(from, rule.result, std::get<2>(*next)), "chain", from, std::get<2>(*next));
      }
    }
  }

  void check_selfs(std::uint32_t at) {
    for (const RoleId role : context(at).selfs) {
      expect(has_link(at, role, at), "link of self", at, static_cast<std::uint32_t>(role));
      for (const RoleId super : index_.roles().supers(role)) {
        const ExprId negative = index_.negative_self(super);
        expect(negative == bottom_expr || has(at, negative), "super self", at, number(negative));
      }
      if (index_.range_of(role) != top_expr) {
        expect_atom(at, index_.representative(index_.range_of(role)), "range of self");
      }
      for (const Composition& rule : index_.roles().compositions(role)) {
        const auto& selfs = context(at).selfs.get();
        if (std::ranges::find(selfs, rule.second) == selfs.end()) continue;
        expect(std::ranges::find(selfs, rule.result) != selfs.end(), "chain of selfs", at, 0);
      }
    }
  }

  void check_functional(std::uint32_t at) {
    std::vector<std::pair<RoleId, std::uint32_t>> links;
    for (auto next = links_.lower_bound({at, 0, 0}); next != links_.end() && std::get<0>(*next) == at; ++next) {
      links.emplace_back(RoleId{std::get<1>(*next)}, std::get<2>(*next));
    }
    for (std::uint32_t role = 0; role < index_.roles().count(); ++role) {
      const RoleId functional{role};
      const auto holds_here = [&](ExprId id) { return has(at, id); };
      if (!index_.is_functional(functional) && std::ranges::none_of(index_.functional_in(functional), holds_here)) {
        continue;
      }
      for (const auto& [first, one] : links) {
        for (const auto& [second, other] : links) {
          if (!is_sub(first, functional) || !is_sub(second, functional)) continue;
          std::set<ExprId> all = atoms(one);
          all.merge(atoms(other));
          const bool is_merged = std::ranges::any_of(links, [&](const auto& link) {
            const std::set<ExprId> merged = atoms(link.second);
            return link.first == first && std::ranges::includes(merged, all);
          });
          expect(is_merged, "functional", at, role);
        }
      }
    }
  }

  void check_nominals(std::uint32_t at) {
    if (!index_.has_nominals()) return;
    for (const std::uint32_t subsumer : above_[at]) {
      if (subsumer >= index_.size() || !index_.is_nominal(ExprId{subsumer})) continue;
      const std::uint32_t nominal = saturation_.number_of(ExprId{subsumer});
      if (nominal == at) continue;
      for (const std::uint32_t above : above_[nominal]) {
        if (above < index_.size()) expect(has(at, ExprId{above}), "nominal", at, above);
      }
      if (!context(at).is_nonempty) continue;
      for (const std::uint32_t above : above_[at]) {
        if (above < index_.size()) expect(has(nominal, ExprId{above}), "instance of nominal", at, above);
      }
    }
  }

  const IndexedOntology& index_;
  const Saturation& saturation_;
  std::vector<std::set<std::uint32_t>> above_;
  std::set<Entry> links_;
  std::string problem_;
};

}  // namespace

Saturated::Saturated(const owl::Ontology& source, unsigned threads, const SaturationLimits& limits) {
  IndexBuilder builder;
  RuleNormaliser normaliser(source, builder);
  for (std::uint32_t axiom = 0; axiom < source.axiom_count(); ++axiom) (void)normaliser.add(axiom);
  std::vector<ExprId> roots;
  for (std::uint32_t id = 0; id < source.term_count(); ++id) {
    if (source.kind(owl::TermId{id}) == owl::TermKind::named_class)
      roots.push_back(normaliser.expression(owl::TermId{id}));
  }
  (void)normaliser.finish();
  index = *builder.finish(1 << 20);
  saturation = std::make_unique<Saturation>(index, limits);
  for (const ExprId root : roots) saturation->require(index.representative(root));
  for (const ExprId root : normaliser.individuals()) saturation->require(index.representative(root));
  saturation->run(threads);
}

std::string rule_left_to_fire(const IndexedOntology& index, const Saturation& saturation) {
  return Validator(index, saturation).run();
}

}  // namespace geminga::el
