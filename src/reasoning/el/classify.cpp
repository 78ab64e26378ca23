// The way from axioms to the taxonomy: normalise, saturate, reduce.
#include "reasoning/el/classify.hpp"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "base/parallel/both.hpp"
#include "base/sorted.hpp"
#include "reasoning/el/closure/finished.hpp"
#include "reasoning/el/closure/inheritance.hpp"
#include "reasoning/el/closure/saturation.hpp"
#include "reasoning/el/index/index_builder.hpp"
#include "reasoning/el/index/indexed_ontology.hpp"
#include "reasoning/el/model/inverse_conclusions.hpp"
#include "reasoning/el/model/model_check.hpp"
#include "reasoning/el/normaliser/rule_normaliser.hpp"
#include "reasoning/el/subsumption_graph.hpp"
#include "reasoning/el/union_superclasses.hpp"
#include "reasoning/el/worlds.hpp"

namespace geminga::el {
namespace {

constexpr std::size_t max_closure_pairs = std::size_t{1} << 28;  // of one closure before saturation

/// Limits of conclusions. They grow with the axioms, so that a small file that means much takes the memory of a small
/// one (a conclusion is about ten octets). Published ontologies have tens of conclusions an axiom.
constexpr std::size_t always_concluded = 8'000'000;
constexpr std::size_t concluded_per_axiom = 300;

/// The work of one classification, step by step.
class Classifier {
 public:
  /// `told` are further inclusions that follow, between expressions of a classifier of the same source. Universals that
  /// are tested save most of the work if they need no rules; if they do, run() fails and needs_rules() is true.
  using Inclusions = std::vector<std::pair<ExprId, ExprId>>;
  Classifier(const owl::Ontology& source, const ClassifyOptions& options, Inclusions told, Universals universals)
      : source_(source),
        options_(options),
        limits_{.conclusions =
                    options.limits.conclusions.value_or(always_concluded + concluded_per_axiom * source.axiom_count()),
                .merged_atoms = options.limits.merged_atoms,
                .budget = options.budget},
        told_(std::move(told)),
        universals_(universals),
        normaliser_(source, builder_) {}

  /// Superclasses of unions that the run found, for another classifier of the same source.
  [[nodiscard]] const Inclusions& shared() const { return shared_; }
  /// True if another classifier must use the universals.
  [[nodiscard]] bool needs_rules() const { return needs_rules_; }

  std::expected<taxonomy::Classification, ClassifyError> run() {
    if (source_.problem()) return std::unexpected(ClassifyError{*source_.problem()});
    // A small source takes less time than a thread that begins.
    constexpr std::size_t worth_a_thread = 10'000;
    parallel::do_both(
        source_.axiom_count() < worth_a_thread ? 1 : options_.threads, [this] { add_axioms(); },
        [this] { find_classes(); });
    finish_axioms();
    auto index = builder_.finish(max_closure_pairs);
    if (!index) {
      return std::unexpected(ClassifyError{"the closure of the properties has more than " +
                                           std::to_string(max_role_pairs) + " pairs, or that of the told classes " +
                                           std::to_string(max_closure_pairs)});
    }
    index_ = std::move(*index);
    find_roots();
    if (options_.inherits && !may_settle_ && Inheritance::is_for(index_)) {
      if (!inherit()) return std::unexpected(too_large());
      if (needs_rules_) return std::unexpected(ClassifyError{"some ranges need rules"});
      classify_all_properties();
      return std::move(result_);
    }
    needs_rules_ = !normaliser_.open().ranges.empty();
    if (needs_rules_) return std::unexpected(ClassifyError{"some ranges need rules"});
    auto saturation = saturate();
    if (saturation->is_over_merged()) {
      leave_out_merging();
      saturation.reset();  // before there are two
      saturation = saturate();
    }
    if (is_too_large(*saturation)) return std::unexpected(too_large());
    if (may_settle_) use_inverses(*saturation);
    if (is_too_large(*saturation)) return std::unexpected(too_large());
    if (saturation->is_consistent() && !result_.is_cut_off)
      shared_ = find_union_superclasses(index_, *saturation, normaliser_.open());
    count(*saturation);
    reduce(*saturation);
    if (may_settle_ && model_check_ && result_.is_consistent && !result_.is_cut_off) settle();
    classify_all_properties();
    return std::move(result_);
  }

 private:
  /// Finds every class in an axiom, and T and F, ascending by IRI.
  void find_classes() {
    std::vector<bool> is_used(source_.term_count(), false);
    is_used[static_cast<std::size_t>(owl::thing_term)] = true;
    is_used[static_cast<std::size_t>(owl::nothing_term)] = true;
    for (std::size_t number_of_axiom = 0; number_of_axiom < source_.axiom_count(); ++number_of_axiom) {
      for (const owl::TermId argument : source_.axiom(number_of_axiom).arguments) {
        is_used[static_cast<std::size_t>(argument)] = true;
      }
    }
    std::vector<std::pair<std::string_view, owl::TermId>> named;
    // The arguments of a term have smaller numbers than it, so that one pass downwards finds all that is used.
    for (std::uint32_t id = static_cast<std::uint32_t>(source_.term_count()); id-- > 0;) {
      if (!is_used[id]) continue;
      const owl::Term term = source_.term(owl::TermId{id});
      for (const owl::TermId argument : term.arguments) is_used[static_cast<std::size_t>(argument)] = true;
      if (term.kind == owl::TermKind::named_class) named.emplace_back(source_.name(term.name), owl::TermId{id});
    }
    std::ranges::sort(named);
    for (const auto& [iri, term] : named) classes_.push_back(term);
  }

  void add_axioms() {
    for (std::uint32_t axiom = 0; axiom < source_.axiom_count(); ++axiom) {
      const owl::Construct unused = normaliser_.add(axiom);
      if (unused != owl::Construct::none) result_.unused.push_back({axiom, to_string(unused)});
      if (source_.axiom(axiom).kind != owl::AxiomKind::declaration) ++result_.counts.axioms;
    }
  }

  /// Adds what needs all axioms and classes.
  void finish_axioms() {
    for (const owl::TermId term : classes_) exprs_.push_back(normaliser_.expression(term));
    for (const auto& [sub, super] : told_) builder_.add_told(sub, super);
    // Universals are left to another engine if that has to classify everything again.
    const bool is_more = normaliser_.open().is_more;
    const Universals universals = result_.unused.empty() ? universals_ : Universals::used;
    const UnusedAxioms late = normaliser_.finish(is_more ? Universals::left_out : universals);
    may_settle_ = !result_.unused.empty() && late.empty() && !is_more;
    for (const auto& [axiom, construct] : late) result_.unused.push_back({axiom, to_string(construct)});
    sort_unused();
  }

  void find_roots() {
    for (ExprId& expr : exprs_) {
      expr = index_.representative(expr);
      // A class with only one expression with rules above it has the subsumers of that one's context.
      if (!index_.needs_no_context(expr)) {
        asked_.push_back(expr);
      } else if (!index_.frontier(expr).empty()) {
        asked_.push_back(index_.frontier(expr).front());
      }
    }
    base::sort_unique(asked_);
  }

  [[nodiscard]] std::unique_ptr<Saturation> saturate() const {
    auto saturation = std::make_unique<Saturation>(index_, limits_);
    for (const ExprId root : asked_) saturation->require(root);
    for (const ExprId individual : normaliser_.individuals()) saturation->require(index_.representative(individual));
    saturation->run(options_.threads);
    return saturation;
  }

  /// Adds conclusions that need links against their direction, in few rounds, and checks the model.
  void use_inverses(Saturation& saturation) {
    const InverseRoles inverses(index_, normaliser_.open().inverses);
    SuccessorLimits limits = options_.limits.successors;
    limits.budget = options_.budget;
    for (unsigned round = 0; round < options_.limits.rounds_of_inverses; ++round) {
      if (!saturation.is_consistent() || saturation.is_over_limit()) return;
      SuccessorContexts successors(index_, saturation, inverses, limits);
      const InverseConclusions found = successors.conclude();
      result_.is_cut_off = successors.is_cut_off();
      if (result_.is_cut_off) return;
      if (found.empty()) break;
      for (const auto& [context, expr] : found) saturation.conclude(context, expr);
      saturation.run();
    }
    if (!saturation.is_consistent() || saturation.is_over_limit()) return;
    model_check_.emplace(index_, saturation, normaliser_.open(), inverses, exprs_);
  }

  /// True if a limit was passed that leaves no result. A spent budget leaves one: the conclusions by then.
  bool is_too_large(const Saturation& saturation) {
    if (!saturation.is_consistent()) return false;
    if (!saturation.is_cut_off()) return saturation.is_over_limit();
    result_.is_cut_off = true;
    return false;
  }

  [[nodiscard]] ClassifyError too_large() const {
    return {"more than " + std::to_string(limits_.conclusions) + " conclusions follow: the ontology is too large"};
  }

  void classify_all_properties() {
    result_.object_properties = classify_properties(source_, taxonomy::PropertyKind::object, result_.is_consistent);
    result_.data_properties = classify_properties(source_, taxonomy::PropertyKind::data, result_.is_consistent);
  }

  /// False over the limit of conclusions.
  bool inherit() {
    std::vector<ExprId> seeds = asked_;
    for (const ExprId individual : normaliser_.individuals()) seeds.push_back(index_.representative(individual));
    SubsumptionGraph graph(index_);
    {
      Inheritance inheritance(index_, limits_, seeds);
      if (!inheritance.run(options_.threads) && !inheritance.is_cut_off()) return false;
      result_.is_cut_off = inheritance.is_cut_off();
      result_.counts.expressions = index_.size();
      result_.counts.contexts = inheritance.nodes().size();
      result_.counts.subsumptions = inheritance.conclusion_count();
      result_.counts.links = inheritance.link_count();
      result_.is_consistent = inheritance.is_consistent();
      add_edges(inheritance.nodes(), graph);
      const std::vector<OpenRange>& ranges = normaliser_.open().ranges;
      if (result_.is_cut_off && result_.unused.empty() && ranges.empty())
        result_.is_settled = find_finished(index_, inheritance, exprs_);
      if (result_.is_consistent && !result_.is_cut_off && !ranges.empty() && !inheritance.has_ranges(ranges)) {
        result_.is_cut_off = inheritance.is_cut_off();
        needs_rules_ = !result_.is_cut_off;
        if (needs_rules_) return true;
      }
    }
    name_classes();
    std::move(graph).reduce(exprs_, result_);
    return true;
  }

  void add_edges(const NodeStore& nodes, SubsumptionGraph& graph) const {
    graph.add_nodes(nodes.size());
    const std::size_t size = index_.size();
    for (std::uint32_t at = 0; at < nodes.size(); ++at) {
      const Node& node = nodes[at];
      const ExprId own{node.is_existential() ? static_cast<std::uint32_t>(size) + at : node.root};
      if (node.is_unsatisfiable) graph.set_unsatisfiable(own);
      for (const std::uint32_t above : node.above) {
        // An existential with nothing above it adds no way up.
        if (above >= size && nodes[above - size].above.empty()) continue;
        graph.add_edge(own, ExprId{above});
      }
    }
  }

  void count(const Saturation& saturation) {
    result_.counts.expressions = index_.size();
    result_.counts.contexts = saturation.contexts().size();
    result_.counts.subsumptions = saturation.conclusion_count();
    result_.counts.links = saturation.link_count();
  }

  void reduce(const Saturation& saturation) {
    SubsumptionGraph graph(index_);
    result_.is_consistent = saturation.is_consistent();
    for (const Context& context : saturation.contexts()) {
      if (!context.together.empty()) continue;  // it is of several atoms
      if (context.is_unsatisfiable) graph.set_unsatisfiable(context.root);
      for (const ExprId above : context.derived) graph.add_edge(context.root, above);
    }
    if (!result_.is_cut_off) add_worlds(saturation, graph);
    name_classes();
    std::move(graph).reduce(exprs_, result_);
  }

  /// Adds what holds of a class because it has an instance. Over a limit the other classes are left as they are, and
  /// the axioms with nominals count as unused.
  void add_worlds(const Saturation& saturation, SubsumptionGraph& graph) {
    const std::vector<ExprId> conditional = find_conditional_roots(index_, saturation, asked_);
    bool is_left_out = conditional.size() > options_.limits.worlds;
    for (std::size_t at = 0; at < std::min(conditional.size(), options_.limits.worlds); ++at) {
      const auto world = find_world(index_, conditional[at], normaliser_.individuals(), limits_);
      result_.is_cut_off = options_.budget != nullptr && options_.budget->is_spent();
      if (result_.is_cut_off) return;
      if (!world) {
        is_left_out = true;
        continue;
      }
      if (!world->is_possible) graph.set_unsatisfiable(conditional[at]);
      for (const ExprId above : world->above) graph.add_edge(conditional[at], above);
    }
    if (is_left_out) leave_out_nominals();
  }

  /// Names the axioms of these kinds, and those in which a concerned term occurs, as not used.
  template <typename IsConcerned>
  void leave_out(owl::Construct construct, std::initializer_list<owl::AxiomKind> axioms, IsConcerned&& is_concerned) {
    std::vector<bool> has_it(source_.term_count(), false);
    for (std::uint32_t id = 0; id < source_.term_count(); ++id) {
      const owl::Term term = source_.term(owl::TermId{id});
      has_it[id] = is_concerned(term.kind) || std::ranges::any_of(term.arguments, [&](owl::TermId argument) {
                     return has_it[static_cast<std::size_t>(argument)];
                   });
    }
    for (std::uint32_t number = 0; number < source_.axiom_count(); ++number) {
      const owl::Axiom axiom = source_.axiom(number);
      const bool is_here = std::ranges::find(axioms, axiom.kind) != axioms.end() ||
                           std::ranges::any_of(axiom.arguments, [&](owl::TermId argument) {
                             return has_it[static_cast<std::size_t>(argument)];
                           });
      if (is_here) result_.unused.push_back({number, to_string(construct)});
    }
    sort_unused();
  }

  /// Counts all axioms as used if the model check passes for every class.
  void settle() {
    for (const ExprId expr : exprs_) result_.is_settled.push_back(model_check_->is_settled(expr));
    if (!model_check_->is_world_settled() || !std::ranges::all_of(result_.is_settled, std::identity())) return;
    result_.unused.clear();
    result_.counts.used_axioms = result_.counts.axioms;
  }

  void leave_out_merging() {
    may_settle_ = false;
    index_.forget_merging();
    for (const auto& [axiom, construct] : normaliser_.uses_of_universals())
      result_.unused.push_back({axiom, to_string(construct)});
    leave_out(owl::Construct::too_many_merged,
              {owl::AxiomKind::functional_object_property, owl::AxiomKind::inverse_functional_object_property,
               owl::AxiomKind::functional_data_property},
              [](owl::TermKind kind) {
                return kind == owl::TermKind::object_max_cardinality ||
                       kind == owl::TermKind::object_exact_cardinality || kind == owl::TermKind::data_max_cardinality ||
                       kind == owl::TermKind::data_exact_cardinality;
              });
  }

  void leave_out_nominals() {
    may_settle_ = false;
    leave_out(owl::Construct::too_many_nominals, {}, [](owl::TermKind kind) {
      return kind == owl::TermKind::object_has_value || kind == owl::TermKind::object_one_of;
    });
  }

  /// Sorts the unused axioms, each with its first reason.
  void sort_unused() {
    std::map<std::uint32_t, std::string_view> reason_of;
    for (const taxonomy::UnusedAxiom& unused : result_.unused) reason_of.try_emplace(unused.axiom, unused.construct);
    result_.unused.clear();
    for (const auto& [axiom, construct] : reason_of) result_.unused.push_back({axiom, construct});
    result_.counts.used_axioms = result_.counts.axioms - result_.unused.size();
  }

  void name_classes() {
    for (const owl::TermId term : classes_) result_.classes.push_back(source_.term(term).name);
    const auto find = [&](std::string_view iri) {
      const auto found =
          std::ranges::lower_bound(result_.classes, iri, {}, [&](owl::NameId id) { return source_.name(id); });
      return taxonomy::ClassNumber{static_cast<std::uint32_t>(found - result_.classes.begin())};
    };
    result_.thing = find(owl::owl_thing);
    result_.nothing = find(owl::owl_nothing);
  }

  const owl::Ontology& source_;
  const ClassifyOptions& options_;
  SaturationLimits limits_;
  Inclusions told_;
  Inclusions shared_;
  Universals universals_;
  bool needs_rules_ = false;
  IndexBuilder builder_;
  RuleNormaliser normaliser_;
  IndexedOntology index_;
  std::vector<owl::TermId> classes_;
  std::vector<ExprId> exprs_;
  std::vector<ExprId> asked_;
  std::optional<ModelCheck> model_check_;
  bool may_settle_ = false;  ///< all that the rules do not use can be tested
  taxonomy::Classification result_;
};

}  // namespace

std::expected<taxonomy::Classification, ClassifyError> classify(const owl::Ontology& source,
                                                                const ClassifyOptions& options) {
  // A superclass of one union may lead to superclasses of others. Few ontologies need more than one round.
  std::vector<std::pair<ExprId, ExprId>> told;
  std::optional<taxonomy::Classification> before;
  Universals universals = options.inherits ? Universals::tested : Universals::used;
  for (unsigned round = 0;;) {
    Classifier classifier(source, options, told, universals);
    auto found = classifier.run();
    if (classifier.needs_rules()) {
      universals = Universals::used;
      continue;
    }
    if (found && found->is_cut_off && before) {
      // The last round was not cut off and knows more.
      before->is_cut_off = true;
      before->is_settled.clear();
      return std::move(*before);
    }
    if (!found || classifier.shared().empty() || round++ == options.limits.rounds_of_unions) return found;
    before = std::move(*found);
    told.insert(told.end(), classifier.shared().begin(), classifier.shared().end());
  }
}

}  // namespace geminga::el
