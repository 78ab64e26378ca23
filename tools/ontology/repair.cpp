// `geminga-ontology repair`: the least sets of axioms to take out so that nothing unwanted follows. Changes no file.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/json.hpp>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/findings/axioms.hpp"
#include "ontology/loading/class_names.hpp"
#include "ontology/loading/compiled_form.hpp"
#include "ontology/loading/consistency.hpp"
#include "ontology/loading/refused.hpp"
#include "ontology/repair/loss.hpp"
#include "ontology/repair/repairs.hpp"
#include "reasoning/explanation/unsatisfiable.hpp"
#include "reasoning/owl/canonical.hpp"
#include "reasoning/owl/loaded_file.hpp"

namespace geminga::ontology {
namespace {

using taxonomy::ClassNumber;

constexpr unsigned default_choices = 5;
constexpr unsigned max_choices = 100;
/// The most classes that a line of the text names, and lost subsumptions that it shows.
constexpr std::size_t max_named = 4;
constexpr std::size_t max_lost_shown = 3;
/// The most places of one choice that the text shows.
constexpr std::size_t max_places_shown = 6;

struct RepairRequest {
  std::vector<std::string> files;
  std::string sub;
  std::string super;
  unsigned limit = default_choices;
  bool as_json = false;
  bool is_lenient = false;
  bool is_strict = false;
};

/// The subsumptions that are to follow no more, which have one super.
struct Problem {
  std::vector<ClassNumber> subs;
  ClassNumber super{};
};

/// A set of axioms to take out, with every place where they stand and what would be lost.
struct Option {
  std::vector<explanation::ExplainedAxiom> axioms;
  std::optional<std::vector<Subsumption>> lost;  ///< nothing: not counted
  std::vector<Subsumption> telling;
};

struct Group {
  std::vector<ClassNumber> subs;
  std::vector<Option> choices;  ///< best first
  bool may_have_more = false;
};

struct Plan {
  std::vector<Group> groups;
  bool is_certain = true;
  std::string why_not;
};

/// The problem that is asked about, or the worst one that the ontology has: nothing where it has none.
std::optional<Problem> problem_of(const compiled::Ontology& ontology, std::optional<Subsumption> asked,
                                  base::Budget& budget) {
  if (asked) {
    if (!ontology.is_subsumed(asked->sub, asked->super)) return std::nullopt;
    return Problem{{asked->sub}, asked->super};
  }
  const auto nothing = ontology.find_iri(owl::owl_nothing);
  const auto thing = ontology.find_iri(owl::owl_thing);
  if (!nothing || !thing) return std::nullopt;
  if (!ontology.is_consistent()) return Problem{{*thing}, *nothing};
  Problem problem{{}, *nothing};
  // Roots come first, so that their reasons are found before those that hold them.
  for (const explanation::Unsatisfiable& one : explanation::find_unsatisfiable(ontology, &budget))
    problem.subs.push_back(one.number);
  if (problem.subs.empty()) return std::nullopt;
  return problem;
}

/// Leads from axioms of a module to those of the source, in which an axiom may stand several times.
class Places {
 public:
  Places(const owl::Ontology& source, const explanation::Module& module) : source_(source), module_(module) {
    const owl::CanonicalOrder order = owl::canonical_order(source, owl::ContentHashes(source));
    axioms_.resize(order.axioms.size());
    for (std::uint32_t axiom = 0; axiom < source.axiom_count(); ++axiom) {
      const std::uint32_t number = order.number_of_axiom[axiom];
      if (number < axioms_.size()) axioms_[number].push_back(axiom);
    }
  }

  /// Ascending.
  [[nodiscard]] std::vector<std::uint32_t> in_source(const explanation::AxiomSet& axioms) const {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t axiom : axioms) {
      const auto& same = axioms_[module_.original(axiom)];
      found.insert(found.end(), same.begin(), same.end());
    }
    std::ranges::sort(found);
    return found;
  }

  /// The axioms in readable syntax, each once for every place.
  [[nodiscard]] std::vector<explanation::ExplainedAxiom> explained(const explanation::AxiomSet& axioms) const {
    std::vector<explanation::ExplainedAxiom> list;
    for (const std::uint32_t axiom : axioms) {
      const explanation::ExplainedAxiom first = module_.explained(axiom);
      for (const std::uint32_t same : axioms_[module_.original(axiom)]) {
        const owl::Axiom place = source_.axiom(same);
        list.push_back({first.text, source_.files()[static_cast<std::size_t>(place.file)].path, place.line});
      }
    }
    return list;
  }

 private:
  const owl::Ontology& source_;
  const explanation::Module& module_;
  std::vector<std::vector<std::uint32_t>> axioms_;  ///< by number in the compiled form
};

/// Counts what each choice of a group loses, and ranks them: fewer axioms first, then fewer losses.
Group ranked(const RepairGroup& found, const explanation::AxiomSet& others, const Problem& problem,
             const Places& places, Losses& losses, const std::optional<Closure>& whole, const RepairRequest& request) {
  std::vector<Closure> closures;
  for (const explanation::AxiomSet& choice : found.choices) {
    if (!whole) break;
    explanation::AxiomSet removed = choice;
    removed.insert(removed.end(), others.begin(), others.end());
    auto closure = losses.closure_without(places.in_source(removed));
    if (!closure) break;
    closures.push_back(std::move(*closure));
  }
  Group group{found.subs, {}, found.may_have_more || found.choices.size() > request.limit};
  const bool are_counted = whole && closures.size() == found.choices.size();
  const auto lost = are_counted ? lost_in(*whole, closures) : std::vector<std::vector<Subsumption>>();
  for (std::size_t at = 0; at < found.choices.size(); ++at) {
    Option& one = group.choices.emplace_back();
    one.axioms = places.explained(found.choices[at]);
    if (!are_counted) continue;
    one.lost = lost[at];
    std::erase_if(*one.lost, [&](const Subsumption& pair) {
      return pair.super == problem.super && std::ranges::find(problem.subs, pair.sub) != problem.subs.end();
    });
    one.telling = telling(*one.lost, closures[at], max_lost_shown);
  }
  std::vector<std::size_t> order(group.choices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t at) {
    return std::pair(found.choices[at].size(), group.choices[at].lost ? group.choices[at].lost->size() : 0);
  });
  std::vector<Option> best;
  for (const std::size_t at : order) {
    if (best.size() < request.limit) best.push_back(std::move(group.choices[at]));
  }
  group.choices = std::move(best);
  return group;
}

Plan plan_of(const ClassifiedFiles& classified, const compiled::Ontology& ontology, const Problem& problem,
             const RepairRequest& request, base::Budget& budget) {
  Unwanted unwanted(ontology, problem.subs, problem.super, budget);
  RepairLimits limits;
  limits.choices = std::max<std::size_t>(limits.choices, request.limit);
  const Repairs found = find_repairs(unwanted, limits, budget);
  Plan plan{{}, found.is_certain, found.why_not};
  const Places places(classified.loaded.source, unwanted.module());
  Losses losses(classified.loaded.source, ontology, budget);
  const bool is_contradiction = !ontology.is_consistent();
  std::optional<Closure> whole;
  if (!found.groups.empty()) whole = losses.closure_without({});
  for (std::size_t at = 0; at < found.groups.size(); ++at) {
    // Nothing can be compared while a contradiction is left: the others are undone, too.
    explanation::AxiomSet others;
    for (std::size_t other = 0; is_contradiction && other < found.groups.size(); ++other) {
      if (other == at || found.groups[other].choices.empty()) continue;
      const explanation::AxiomSet& first = found.groups[other].choices.front();
      others.insert(others.end(), first.begin(), first.end());
    }
    plan.groups.push_back(ranked(found.groups[at], others, problem, places, losses, whole, request));
  }
  return plan;
}

std::string names_of(const compiled::Ontology& ontology, const std::vector<ClassNumber>& classes) {
  std::string text;
  for (std::size_t at = 0; at < std::min(classes.size(), max_named); ++at)
    text += (at == 0 ? "" : ", ") + ontology.short_name(classes[at]);
  if (classes.size() > max_named) text += " and " + std::to_string(classes.size() - max_named) + " more";
  return text;
}

std::string statement(const compiled::Ontology& ontology, const Problem& problem) {
  if (!ontology.is_consistent()) return "The ontology contradicts itself.\n";
  const bool is_nothing = ontology.iri(problem.super) == owl::owl_nothing;
  if (!is_nothing)
    return ontology.short_name(problem.subs.front()) + " is subsumed by " + ontology.short_name(problem.super) + ".\n";
  if (problem.subs.size() == 1) return ontology.short_name(problem.subs.front()) + " can have no instance.\n";
  return counted(problem.subs.size(), "class", "classes") + " can have no instance.\n";
}

std::string loss_as_text(const compiled::Ontology& ontology, const Option& choice, const std::string& indent) {
  if (!choice.lost) return indent + "what would be lost was not counted\n";
  if (choice.lost->empty()) return indent + "loses no other subsumption of named classes\n";
  const bool is_all = choice.telling.size() == choice.lost->size();
  std::string text = indent + "loses " + counted(choice.lost->size(), "subsumption", "subsumptions") +
                     (is_all ? ":\n" : ", such as\n");
  for (const Subsumption& pair : choice.telling)
    text += indent + "  " + ontology.short_name(pair.sub) + " SubClassOf " + ontology.short_name(pair.super) + '\n';
  return text;
}

std::string as_text(const compiled::Ontology& ontology, const Problem& problem, const Plan& plan) {
  std::string text = statement(ontology, problem);
  if (plan.groups.empty()) return text;
  const bool is_one = plan.groups.size() == 1;
  text += is_one ? "Any of these choices, taken out, mends it; the best is first:\n"
                 : "One choice of each of these " + std::to_string(plan.groups.size()) +
                       " groups, taken out, mends it; the best are first:\n";
  for (std::size_t number = 0; number < plan.groups.size(); ++number) {
    const Group& group = plan.groups[number];
    if (!is_one) text += "group " + std::to_string(number + 1);
    if (!is_one && ontology.is_consistent()) text += ", for " + names_of(ontology, group.subs);
    if (!is_one) text += '\n';
    for (std::size_t at = 0; at < group.choices.size(); ++at) {
      std::string head = (at < 9 ? "  " : " ") + std::to_string(at + 1) + ". ";
      const std::string indent(head.size(), ' ');
      const auto& axioms = group.choices[at].axioms;
      const std::size_t shown = axioms.size() > max_places_shown + 1 ? max_places_shown : axioms.size();
      for (std::size_t axiom = 0; axiom < shown; ++axiom)
        text += std::exchange(head, indent) + axiom_line(axioms[axiom]) + '\n';
      if (shown < axioms.size())
        text += indent + "and " + std::to_string(axioms.size() - shown) + " more axioms: --json\n";
      text += loss_as_text(ontology, group.choices[at], indent);
    }
    if (group.may_have_more) text += "  There are other choices, or may be: raise --limit.\n";
  }
  if (!plan.is_certain) text += "Something unwanted may be left: " + plan.why_not + ".\n";
  return text + "No file was changed.\n";
}

boost::json::object as_object(const compiled::Ontology& ontology, const Option& choice) {
  boost::json::object object{{"axioms", axiom_array(choice.axioms)}, {"loses", nullptr}};
  boost::json::array& lost = object["lost"].emplace_array();
  if (!choice.lost) return object;
  object["loses"] = choice.lost->size();
  for (const Subsumption& pair : choice.telling)
    lost.push_back(boost::json::object{{"sub", ontology.iri(pair.sub)}, {"super", ontology.iri(pair.super)}});
  return object;
}

std::string as_json(const compiled::Ontology& ontology, const reasoner::Answer& consistency,
                    const std::optional<Problem>& problem, const Plan& plan) {
  boost::json::object document;
  put_consistency(consistency, document);
  document["certain"] = plan.is_certain;
  if (!plan.is_certain) document["reason"] = plan.why_not;
  boost::json::array& unwanted = document["unwanted"].emplace_array();
  if (problem) {
    for (const ClassNumber sub : problem->subs)
      unwanted.push_back(boost::json::object{{"sub", ontology.iri(sub)}, {"super", ontology.iri(problem->super)}});
  }
  boost::json::array& groups = document["groups"].emplace_array();
  for (const Group& group : plan.groups) {
    boost::json::object one;
    boost::json::array& subs = one["subs"].emplace_array();
    for (const ClassNumber sub : group.subs) subs.emplace_back(ontology.iri(sub));
    boost::json::array& choices = one["choices"].emplace_array();
    for (const Option& choice : group.choices) choices.push_back(as_object(ontology, choice));
    one["may_have_more"] = group.may_have_more;
    groups.push_back(std::move(one));
  }
  return json_text(document) + '\n';
}

/// The words where nothing is known to have to be taken out.
std::string no_problem(bool is_asked, bool is_open) {
  if (is_open) return is_asked ? "" : "No class is known to have no instance.\n";
  return is_asked ? "It does not follow, and there is nothing to take out.\n"
                  : "No class is known to have no instance: there is nothing to take out.\n";
}

Exit repair(const RepairRequest& request, const WorkLimits& limits) {
  base::Budget budget = budget_of(limits);
  auto classified = classify_or_say(request.files, {.as_json = request.as_json,
                                                    .leaves_out_refused = !request.is_strict,
                                                    .is_lenient = request.is_lenient,
                                                    .budget = &budget});
  const auto ontology = classified ? compile_or_say(*classified) : std::nullopt;
  if (!ontology) return Exit::usage;
  std::optional<Subsumption> asked;
  if (!request.sub.empty()) {
    const auto sub = find_or_say(*ontology, request.sub, request.as_json);
    const auto super = sub ? find_or_say(*ontology, request.super, request.as_json) : std::nullopt;
    if (!sub || !super) return Exit::usage;
    asked = Subsumption{*sub, *super};
  }
  base::Budget mending = budget_of(limits);  // its own steps: a search that took all of them may have an answer
  const auto problem = problem_of(*ontology, asked, mending);
  const auto json = [&](const std::optional<Problem>& of, const Plan& plan) {
    return as_json(*ontology, consistency_of(*classified, &mending), of, plan);
  };
  const bool is_open = !asked || is_undecided(classified->classification, asked->sub);
  const auto undecided = is_open ? why_undecided(*classified) : std::nullopt;
  if (!problem) {
    const Plan none{.groups = {}, .is_certain = !undecided, .why_not = undecided.value_or("")};
    if (!print(request.as_json ? json(std::nullopt, none) : no_problem(asked.has_value(), undecided.has_value())))
      return say_unwritten();
    if (undecided && !classified->classification.is_cut_off)
      return say_error("it cannot be decided whether " + std::string(asked ? "it follows: " : "others have none: ") +
                       *undecided);
    return exit_of(*classified, exit_of_answer(classified->loaded, Exit::no));
  }
  Progress progress(!request.as_json);
  progress.show("looking for repairs");
  Plan plan = plan_of(*classified, *ontology, *problem, request, mending);
  progress.clear();
  if (plan.is_certain && !asked && undecided) {
    plan.is_certain = false;
    plan.why_not = *undecided;
  }
  if (!print(request.as_json ? json(problem, plan) : as_text(*ontology, *problem, plan))) return say_unwritten();
  if (mending.is_spent())
    return say_error(*mending.reason() + ", and what is printed may not be enough: raise it", Exit::timed_out);
  if (plan.groups.empty())
    return say_error("which axioms to take out cannot be decided: " + plan.why_not + ": see geminga-ontology explain");
  return exit_of(*classified, Exit::yes);
}

}  // namespace

void add_repair(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<RepairRequest>();
  CLI::App* command = program.add_subcommand(
      "repair", "Print the least sets of axioms to take out so that nothing unwanted follows; change no file");
  add_files(*command, request->files);
  auto* sub = command->add_option("--sub", request->sub, "the narrower class of a subsumption that is not wanted")
                  ->type_name("A");
  auto* super = command->add_option("--super", request->super, "its broader class")->type_name("B");
  sub->needs(super);
  super->needs(sub);
  add_number(*command, "--limit", request->limit, 1, max_choices,
             "at most this many choices a group (default: " + std::to_string(default_choices) + ")");
  command->add_flag("--json", request->as_json, "print one JSON document");
  add_lenient(*command, request->is_lenient);
  add_strict(*command, request->is_strict);
  add_work_limits(*command, choice.limits);
  command->footer(
      std::string(
          "\nWithout --sub and --super it takes out what makes the ontology contradict itself; where nothing does, "
          "what\n"
          "leaves classes without instances. A choice is a minimal set of axioms that has one of each reason (explain\n"
          "--all prints the reasons). Choices with fewer axioms come first, then those that lose fewer subsumptions\n"
          "between named classes. Each choice was verified together with the first choices of the other groups. Take\n"
          "out what you know to be wrong: the smallest loss is not always the mistake. An axiom that several RDF\n"
          "files state is named at its first place only.\n"
          "Exit status: 0 there are choices, 1 there is nothing to take out, 2 that cannot be decided, or a file\n"
          "cannot be loaded, 4 a limit was reached, and what is printed may not be enough.\n") +
      consistency_of_json + refused_of_answer +
      "\nExamples:\n"
      "  geminga-ontology repair team/\n"
      "  geminga-ontology repair team/ --sub soccer:SharedBallInfo --super soccer:TrackedObject --limit 10");
  run_when_named(*command, choice, request, repair);
}

}  // namespace geminga::ontology
