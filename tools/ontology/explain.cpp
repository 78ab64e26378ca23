// `geminga-ontology explain`: the axioms that entail a subsumption, or what is missing for it.
#include "reasoning/explanation/explain.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <boost/json.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/findings/axioms.hpp"
#include "ontology/loading/class_names.hpp"
#include "ontology/loading/compiled_form.hpp"
#include "ontology/verdict.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/explanation/laconic.hpp"
#include "reasoning/explanation/proof.hpp"
#include "reasoning/explanation/why_not.hpp"
#include "reasoning/reasoner/reasoner.hpp"

namespace geminga::ontology {
namespace {

using explanation::ExplainedAxiom;
using reasoner::Answer;
using reasoner::Verdict;

constexpr unsigned default_sets = 10;
constexpr unsigned max_sets = 1000;

struct ExplainRequest {
  std::vector<std::string> files;
  std::string sub;
  std::string super;
  bool is_about_contradiction = false;
  bool is_all = false;
  bool wants_proof = false;
  bool is_laconic = false;
  bool as_json = false;
  bool is_lenient = false;
  bool is_strict = false;
  unsigned limit = default_sets;
};

/// A question and its answer.
struct Explained {
  taxonomy::ClassNumber sub{};
  taxonomy::ClassNumber super{};
  Answer answer;                               ///< whether it is entailed
  bool is_all = false;                         ///< all sets are wanted
  explanation::AllSets sets;                   ///< one set, unless all are wanted
  std::vector<explanation::Proof> proofs;      ///< of each set, where they are wanted
  std::vector<explanation::Laconic> laconic;   ///< of each set, where they are wanted
  std::optional<explanation::WhyNot> why_not;  ///< where it is not entailed

  [[nodiscard]] bool is_entailed() const { return answer.verdict == Verdict::yes; }
};

/// Whether the subsumption is entailed, and why that is not known.
Answer decide(const Opened& opened, taxonomy::ClassNumber sub, taxonomy::ClassNumber super, base::Budget& budget) {
  if (opened.ontology.is_subsumed(sub, super)) return {Verdict::yes, {}};
  if (opened.refused) return {Verdict::unknown, *opened.refused};
  if (opened.classified) {
    if (!is_undecided(opened.classified->classification, sub)) return {Verdict::no, {}};
    return {Verdict::unknown, why_undecided(*opened.classified).value_or("")};
  }
  // A compiled form keeps how many classes are undecided, and not which.
  const std::vector<std::string> gaps = opened.ontology.gaps();
  const auto line =
      std::ranges::find_if(gaps, [](const std::string& gap) { return gap.starts_with(compiled::undecided_words); });
  if (line == gaps.end()) return {Verdict::no, {}};
  explanation::Module module(opened.ontology, std::array{sub, super});
  const owl::TermId below = module.term(sub);
  const Verdict verdict = reasoner::entails(module.source(), std::nullopt, below, module.term(super), &budget).verdict;
  return {verdict, verdict == Verdict::unknown ? *line : ""};
}

/// The same for the question whether the ontology contradicts itself.
Answer decide_contradiction(const Opened& opened) {
  if (!opened.ontology.is_consistent()) return {Verdict::yes, {}};
  const Answer& consistency = opened.consistency;
  return consistency.verdict == Verdict::unknown ? consistency : Answer{Verdict::no, {}};
}

/// "1", "1 and 2", "1, 2 and 3".
std::string listed(const std::vector<std::uint32_t>& numbers) {
  std::string text;
  for (std::size_t at = 0; at < numbers.size(); ++at) {
    if (at > 0) text += at + 1 == numbers.size() ? " and " : ", ";
    text += std::to_string(numbers[at]);
  }
  return text;
}

std::string proof_as_text(const explanation::Proof& proof, const explanation::Explainer& explainer,
                          const std::string& indent) {
  std::string text;
  std::uint32_t number = 0;
  const auto numbered = [&] {
    const std::string digits = std::to_string(++number);
    return indent + std::string(digits.size() < 2 ? 1 : 0, ' ') + digits + ". ";
  };
  for (const std::uint32_t axiom : proof.axioms)
    text += numbered() + axiom_line(explainer.module().explained(axiom)) + '\n';
  if (!proof.steps.empty()) text += indent + "so\n";
  for (const explanation::ProofStep& step : proof.steps) {
    text += numbered() + step.text + "   from " + listed(step.from);
    text += step.rule == explanation::ProofRule::together ? ": " : " by ";
    text += std::string(to_string(step.rule)) + '\n';
  }
  return text;
}

std::string laconic_as_text(const explanation::Laconic& laconic, const explanation::Explainer& explainer,
                            const std::string& indent) {
  std::string text;
  for (const explanation::Laconic::PartOf& part : laconic.parts) {
    text += indent + axiom_line(explainer.module().explained(part.axiom)) + '\n';
    if (!part.is_whole) text += indent + "  is a part of " + explainer.module().explained(part.whole).text + '\n';
  }
  if (!laconic.is_laconic) text += indent + "A limit was reached: there may be parts that are not needed.\n";
  return text;
}

std::string set_as_text(const Explained& explained, std::size_t at, const explanation::Explainer& explainer,
                        const std::string& indent) {
  if (at < explained.laconic.size()) return laconic_as_text(explained.laconic[at], explainer, indent);
  if (at < explained.proofs.size()) return proof_as_text(explained.proofs[at], explainer, indent);
  std::string text;
  for (const ExplainedAxiom& axiom : explainer.explained(explained.sets.sets[at]))
    text += indent + axiom_line(axiom) + '\n';
  return text;
}

std::string why_not_as_text(const compiled::Ontology& ontology, const Explained& explained) {
  std::string text;
  for (const std::string& line : explanation::describe(ontology, explained.sub, explained.super, *explained.why_not))
    text += line + '\n';
  return text;
}

/// "a:A is not subsumed by a:B", or that it is not known, and why.
std::string denial(const compiled::Ontology& ontology, const Explained& explained, bool is_about_contradiction) {
  const bool is_known = explained.answer.verdict == Verdict::no;
  const std::string why = is_known ? "\n" : ": " + explained.answer.reason + '\n';
  if (is_about_contradiction)
    return (is_known ? "The ontology does not contradict itself" : "The ontology is not known to contradict itself") +
           why;
  return ontology.short_name(explained.sub) + (is_known ? " is not subsumed by " : " is not known to be subsumed by ") +
         ontology.short_name(explained.super) + why;
}

/// "a:A is subsumed by a:B", or its meaning where one of them is owl:Nothing or owl:Thing.
std::string statement(const compiled::Ontology& ontology, const Explained& explained) {
  const bool is_nothing = ontology.iri(explained.super) == owl::owl_nothing;
  if (is_nothing && ontology.iri(explained.sub) == owl::owl_thing) return "The ontology contradicts itself";
  if (is_nothing) return ontology.short_name(explained.sub) + " can have no instance";
  return ontology.short_name(explained.sub) + " is subsumed by " + ontology.short_name(explained.super);
}

boost::json::object as_object(const explanation::Proof& proof, const explanation::Explainer& explainer) {
  boost::json::object object;
  boost::json::array& axioms = object["axioms"].emplace_array();
  std::uint32_t number = 0;
  for (const std::uint32_t axiom : proof.axioms) {
    boost::json::object one{{"number", ++number}};
    for (const auto& member : axiom_object(explainer.module().explained(axiom))) one.insert(member);
    axioms.push_back(std::move(one));
  }
  boost::json::array& steps = object["steps"].emplace_array();
  for (const explanation::ProofStep& step : proof.steps)
    steps.push_back(boost::json::object{{"number", ++number},
                                        {"conclusion", step.text},
                                        {"rule", to_string(step.rule)},
                                        {"from", boost::json::value_from(step.from)}});
  return object;
}

boost::json::object as_object(const compiled::Ontology& ontology, const explanation::WhyNot& why_not) {
  boost::json::object object;
  boost::json::array& common = object["common"].emplace_array();
  for (const taxonomy::ClassNumber number : why_not.common) common.emplace_back(ontology.iri(number));
  boost::json::array& ways = object["ways"].emplace_array();
  for (const explanation::Way& way : why_not.ways) {
    boost::json::object one = axiom_object(way.axiom);
    one["sufficient"] = way.is_sufficient;
    boost::json::array& requirements = one["requirements"].emplace_array();
    for (const explanation::Requirement& requirement : way.requirements)
      requirements.push_back(boost::json::object{
          {"requirement", requirement.text}, {"met", requirement.is_met}, {"remark", requirement.remark}});
    ways.push_back(std::move(one));
  }
  object["excluded"] = why_not.is_excluded;
  object["exclusion"] = axiom_array(why_not.exclusion);
  object["may_be_incomplete"] = why_not.may_be_incomplete;
  return object;
}

/// `explainer` found the sets; null where the subsumption is not entailed.
std::string as_text(const compiled::Ontology& ontology, const Explained& explained,
                    const explanation::Explainer* explainer, bool is_about_contradiction) {
  const std::string what = statement(ontology, explained);
  if (!explained.is_entailed())
    return denial(ontology, explained, is_about_contradiction) +
           (explained.why_not ? why_not_as_text(ontology, explained) : "");
  const auto& sets = explained.sets.sets;
  if (sets.empty() || explainer == nullptr)
    return what + ", but no engine found within its limits which axioms say so\n";
  if (sets.front().empty()) return what + ": that is so in every ontology\n";
  if (!explained.is_all) return what + ", because:\n" + set_as_text(explained, 0, *explainer, "");
  std::string text = what + ", for " + counted(sets.size(), "reason", "reasons") + ":\n";
  for (std::size_t at = 0; at < sets.size(); ++at) {
    text += "reason " + std::to_string(at + 1) + '\n';
    text += set_as_text(explained, at, *explainer, "  ");
  }
  return text +
         (explained.sets.may_have_more ? "There are more, or may be: raise --limit.\n" : "There are no others.\n");
}

/// The axioms of a set, or their parts with `whole` where it says more.
boost::json::array set_as_json(const Explained& explained, std::size_t at, const explanation::Explainer& explainer) {
  if (at >= explained.laconic.size()) return axiom_array(explainer.explained(explained.sets.sets[at]));
  boost::json::array list;
  for (const explanation::Laconic::PartOf& part : explained.laconic[at].parts) {
    boost::json::object one = axiom_object(explainer.module().explained(part.axiom));
    if (!part.is_whole) one["whole"] = explainer.module().explained(part.whole).text;
    list.push_back(std::move(one));
  }
  return list;
}

/// One document on one line.
std::string as_json(const compiled::Ontology& ontology, const Explained& explained,
                    const explanation::Explainer* explainer) {
  boost::json::object document{{"sub", ontology.iri(explained.sub)},
                               {"super", ontology.iri(explained.super)},
                               {"entailed", verdict_as_json(explained.answer.verdict)}};
  if (!explained.answer.reason.empty()) document["reason"] = explained.answer.reason;
  boost::json::array& first = document["axioms"].emplace_array();
  const auto& sets = explained.sets.sets;
  if (explainer != nullptr && !sets.empty()) first = set_as_json(explained, 0, *explainer);
  if (explainer != nullptr && explained.is_all) {
    boost::json::array& all = document["sets"].emplace_array();
    for (std::size_t at = 0; at < sets.size(); ++at) all.push_back(set_as_json(explained, at, *explainer));
    document["may_have_more"] = explained.sets.may_have_more;
  }
  if (explainer != nullptr && !explained.proofs.empty()) {
    boost::json::array& proofs = document["proofs"].emplace_array();
    for (const explanation::Proof& proof : explained.proofs) proofs.push_back(as_object(proof, *explainer));
  }
  if (explained.why_not) document["why_not"] = as_object(ontology, *explained.why_not);
  return json_text(document) + '\n';
}

Exit explain(const ExplainRequest& request, const WorkLimits& limits) {
  base::Budget budget = budget_of(limits);
  const auto opened = open_or_say(request.files, {.as_json = request.as_json,
                                                  .leaves_out_refused = !request.is_strict,
                                                  .is_lenient = request.is_lenient,
                                                  .budget = &budget});
  if (!opened) return Exit::usage;
  const compiled::Ontology& ontology = opened->ontology;
  const bool is_plain = !request.is_about_contradiction;
  const auto sub = find_or_say(ontology, is_plain ? request.sub : std::string(owl::owl_thing), request.as_json);
  const auto super = find_or_say(ontology, is_plain ? request.super : std::string(owl::owl_nothing), request.as_json);
  if (!sub || !super) return Exit::usage;

  Explained explained;
  explained.sub = *sub;
  explained.super = *super;
  explained.is_all = request.is_all;
  explained.answer = is_plain ? decide(*opened, *sub, *super, budget) : decide_contradiction(*opened);
  std::optional<explanation::Explainer> explainer;
  Progress progress(!request.as_json);
  progress.show("looking for reasons");
  base::Budget explaining = budget_of(limits);  // its own steps: a search that took all of them may have an answer
  if (explained.is_entailed()) {
    explainer.emplace(ontology, *sub, *super, explanation::Patience::of_a_person, &explaining);
    if (request.is_all) {
      explained.sets = explainer->find_all({.sets = request.limit});
    } else if (auto found = explainer->find_one()) {
      explained.sets.sets.push_back(std::move(*found));
    }
    if (request.wants_proof) {
      for (const explanation::AxiomSet& set : explained.sets.sets) explained.proofs.push_back(prove(*explainer, set));
    }
    if (request.is_laconic) {
      for (const explanation::AxiomSet& set : explained.sets.sets)
        explained.laconic.push_back(explanation::find_laconic(*explainer, set));
    }
  } else if (is_plain && explained.answer.verdict == Verdict::no) {
    explained.why_not = explanation::why_not(ontology, *sub, *super);
    explained.why_not->may_be_incomplete = !ontology.left_out().empty();
  }
  progress.clear();
  const explanation::Explainer* found_by = explainer ? &*explainer : nullptr;
  const std::string text = request.as_json ? as_json(ontology, explained, found_by)
                                           : as_text(ontology, explained, found_by, request.is_about_contradiction);
  if (!print(text)) return say_unwritten();
  if (explaining.is_spent())
    return say_error(*explaining.reason() + ": what is printed entails it, and may hold more than is needed: raise it",
                     Exit::timed_out);
  if (explained.is_entailed()) return Exit::yes;
  return budget.is_spent() ? say_error(*budget.reason() + ": raise it", Exit::timed_out) : Exit::no;
}

}  // namespace

void add_explain(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<ExplainRequest>();
  CLI::App* command = program.add_subcommand(
      "explain", "Print a minimal set of axioms that entails that A is subsumed by B, or what is missing");
  add_files(*command, request->files);
  auto* sub = command->add_option("--sub", request->sub, "the narrower class")->type_name("A");
  auto* super =
      command->add_option("--super", request->super, "the broader class; owl:Nothing asks why A can have no instance")
          ->type_name("B");
  command
      ->add_flag("--inconsistent", request->is_about_contradiction,
                 "ask why the ontology contradicts itself, instead of --sub and --super")
      ->excludes(sub)
      ->excludes(super);
  command->add_flag("--all", request->is_all, "print all minimal sets, up to --limit");
  add_number(*command, "--limit", request->limit, 1, max_sets,
             "at most this many sets with --all (default: " + std::to_string(default_sets) + ")");
  CLI::Option* proof =
      command->add_flag("--proof", request->wants_proof, "print the steps from the axioms to the conclusion");
  command
      ->add_flag("--laconic", request->is_laconic,
                 "print only the parts of axioms that are needed: each class that can be left out is")
      ->excludes(proof);
  command->add_flag("--json", request->as_json, "print one JSON document");
  add_lenient(*command, request->is_lenient);
  add_strict(*command, request->is_strict);
  add_work_limits(*command, choice.limits);
  command->footer(
      "\nExit status 0: it is subsumed; 1: it is not, or is not known to be; 4: a limit was reached before it was\n"
      "decided. In the document of --json `entailed` is null and has a `reason` where it is not known.\n"
      "A file of a folder that cannot be read is left out and named; then only yes can be decided.\n"
      "\nExamples:\n"
      "  geminga-ontology explain team/ --sub soccer:BallInfo --super geminga:TrackedObject\n"
      "  geminga-ontology explain team/ --sub soccer:SharedBallInfo --super soccer:TrackedObject --proof\n"
      "  geminga-ontology explain team/ --sub soccer:SharedBallInfo --super soccer:TrackedObject --laconic\n"
      "  geminga-ontology explain team/ --inconsistent --all --limit 3");
  command->callback([request, &choice] {
    if (!request->is_about_contradiction && (request->sub.empty() || request->super.empty()))
      throw CLI::ValidationError("explain", "--sub and --super, or --inconsistent, are required");
    choice.run = [request, &choice] { return explain(*request, choice.limits); };
  });
}

}  // namespace geminga::ontology
