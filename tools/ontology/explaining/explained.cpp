#include "ontology/explaining/explained.hpp"

#include <boost/json.hpp>
#include <cstdint>
#include <string_view>

#include "ontology/command/words.hpp"
#include "ontology/findings/axioms.hpp"
#include "ontology/loading/verdict.hpp"

namespace geminga::ontology {
namespace {

using explanation::ExplainedAxiom;

/// Whether an axiom defines a class of the question: it is in no file.
bool is_definition(const ExplainedAxiom& axiom) { return axiom.file.empty(); }

/// The axioms of a set that files state, in the order of the argument.
std::vector<ExplainedAxiom> axioms_of(const explanation::AxiomSet& set, const explanation::Explainer& explainer) {
  std::vector<ExplainedAxiom> axioms = explainer.explained(set);
  std::erase_if(axioms, is_definition);
  return axioms;
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
    if (is_definition(explainer.module().explained(part.axiom))) continue;
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
  for (const ExplainedAxiom& axiom : axioms_of(explained.sets.sets[at], explainer))
    text += indent + axiom_line(axiom) + '\n';
  return text;
}

std::string why_not_as_text(const Question& question, const explanation::WhyNot& why_not) {
  std::string text;
  for (const std::string& line :
       explanation::describe(question.ontology(), question.sub.number, question.super.number, why_not))
    text += line + '\n';
  return text;
}

/// "a:A is subsumed by a:B" or "a:i is in a:B", with words between the two sides.
std::string relation(const Question& question, std::string_view is_below, std::string_view is_in) {
  return question.sub.words + std::string(question.is_about_individual ? is_in : is_below) + question.super.words;
}

/// "a:A is not subsumed by a:B", or that it is not known, and why.
std::string denial(const Question& question, const reasoner::Answer& answer) {
  const bool is_known = answer.verdict == reasoner::Verdict::no;
  const std::string why = is_known ? "\n" : ": " + answer.reason + '\n';
  if (question.is_about_contradiction())
    return (is_known ? "The ontology does not contradict itself" : "The ontology is not known to contradict itself") +
           why;
  if (is_known) return relation(question, " is not subsumed by ", " need not be in ") + why;
  return relation(question, " is not known to be subsumed by ", " is not known to be in ") + why;
}

/// "a:A is subsumed by a:B", or its meaning where one of them is owl:Nothing or owl:Thing.
std::string statement(const Question& question) {
  if (question.is_about_contradiction()) return "The ontology contradicts itself";
  const bool is_nothing = question.super.name == owl::owl_nothing && !question.is_about_individual;
  return is_nothing ? question.sub.words + " can have no instance" : relation(question, " is subsumed by ", " is in ");
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

/// The axioms of a set, or their parts with `whole` where it says more.
boost::json::array set_as_json(const Explained& explained, std::size_t at, const explanation::Explainer& explainer) {
  if (at >= explained.laconic.size()) return axiom_array(axioms_of(explained.sets.sets[at], explainer));
  boost::json::array list;
  for (const explanation::Laconic::PartOf& part : explained.laconic[at].parts) {
    if (is_definition(explainer.module().explained(part.axiom))) continue;
    boost::json::object one = axiom_object(explainer.module().explained(part.axiom));
    if (!part.is_whole) one["whole"] = explainer.module().explained(part.whole).text;
    list.push_back(std::move(one));
  }
  return list;
}

}  // namespace

std::string as_text(const Question& question, const Explained& explained, const explanation::Explainer* explainer) {
  const std::string what = statement(question);
  if (!explained.is_entailed())
    return denial(question, explained.answer) +
           (explained.why_not ? why_not_as_text(question, *explained.why_not) : "");
  const auto& sets = explained.sets.sets;
  if (sets.empty() || explainer == nullptr)
    return what + ", but no engine found within its limits which axioms say so\n";
  if (axioms_of(sets.front(), *explainer).empty()) return what + ": that is so in every ontology\n";
  if (!explained.is_all) return what + ", because:\n" + set_as_text(explained, 0, *explainer, "");
  std::string text = what + ", for " + counted(sets.size(), "reason", "reasons") + ":\n";
  for (std::size_t at = 0; at < sets.size(); ++at) {
    text += "reason " + std::to_string(at + 1) + '\n';
    text += set_as_text(explained, at, *explainer, "  ");
  }
  return text +
         (explained.sets.may_have_more ? "There are more, or may be: raise --limit.\n" : "There are no others.\n");
}

std::string as_json(const Question& question, const Explained& explained, const explanation::Explainer* explainer) {
  boost::json::object document{{question.is_about_individual ? "individual" : "sub", question.sub.name},
                               {"super", question.super.name},
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
  if (explained.why_not) document["why_not"] = as_object(question.ontology(), *explained.why_not);
  return json_text(document) + '\n';
}

}  // namespace geminga::ontology
