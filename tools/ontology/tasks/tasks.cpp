#include "ontology/tasks/tasks.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "base/text.hpp"
#include "reasoning/syntax/manchester/canonical.hpp"

namespace geminga::ontology {
namespace {

using owl::Axiom;
using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

class Reading {
 public:
  Reading(owl::Ontology& source, owl::FileId file, const owl::ShortName& name_of_iri)
      : source_(source), file_(file), name_of_iri_(name_of_iri) {
    for (std::size_t index = 0; index < source.axiom_count(); ++index) {
      const Axiom axiom = source.axiom(index);
      const bool is_fact = axiom.kind == AxiomKind::class_assertion ||
                           axiom.kind == AxiomKind::object_property_assertion ||
                           axiom.kind == AxiomKind::data_property_assertion;
      if (is_fact) facts_[axiom.arguments[1]].push_back(index);
    }
  }

  std::expected<std::vector<Task>, TaskFault> run() {
    for (const owl::Ontology::Omission& lost : source_.omissions()) {
      if (lost.file == file_) fail(lost.line, "cannot be used: " + std::string(source_.name(lost.construct)));
    }
    const TermId task = source_.named_class(word("Task"));
    std::vector<Task> all;
    for (std::size_t index = 0; index < source_.axiom_count(); ++index) {
      const Axiom axiom = source_.axiom(index);
      const bool is_task = axiom.kind == AxiomKind::class_assertion && axiom.arguments[0] == task;
      if (is_task && axiom.file == file_) all.push_back(task_of(axiom.arguments[1], axiom.line));
    }
    if (fault_) return std::unexpected(*fault_);
    return all;
  }

 private:
  /// Keeps the first fault. Reading goes on, and its result is not used.
  void fail(std::uint32_t line, std::string text) {
    if (!fault_) fault_ = {line, std::move(text)};
  }

  static std::string word(std::string_view name) { return std::string(task_words) + std::string(name); }

  /// The facts of a kind about an individual, by number.
  std::vector<std::size_t> facts(TermId individual, AxiomKind kind) const {
    std::vector<std::size_t> all;
    if (const auto found = facts_.find(individual); found != facts_.end()) {
      std::ranges::copy_if(found->second, std::back_inserter(all),
                           [&](std::size_t index) { return source_.axiom(index).kind == kind; });
    }
    return all;
  }

  /// The facts with one of our properties.
  std::vector<std::size_t> stated(TermId individual, AxiomKind kind, std::string_view property) {
    const std::string iri = word(property);
    const TermId term =
        kind == AxiomKind::object_property_assertion ? source_.object_property(iri) : source_.data_property(iri);
    auto all = facts(individual, kind);
    std::erase_if(all, [&](std::size_t index) { return source_.axiom(index).arguments[0] != term; });
    return all;
  }

  /// The text of the one literal that is stated; nothing where there is none.
  std::optional<std::pair<std::string, std::uint32_t>> text(TermId individual, std::string_view property) {
    const auto all = stated(individual, AxiomKind::data_property_assertion, property);
    if (all.empty()) return std::nullopt;
    const Axiom axiom = source_.axiom(all.front());
    if (all.size() > 1) {
      fail(source_.axiom(all[1]).line, "capability:" + std::string(property) + " is stated twice: state it once");
    }
    return std::pair(std::string(source_.name_of(axiom.arguments[2])), axiom.line);
  }

  std::string name_of(TermId individual) const {
    if (source_.term(individual).kind != TermKind::individual) return {};
    return name_of_iri_(source_.name_of(individual));
  }

  std::string iri_of(TermId individual) const {
    const bool has_name = source_.term(individual).kind == TermKind::individual;
    return has_name ? std::string(source_.name_of(individual)) : std::string();
  }

  Task task_of(TermId individual, std::uint32_t line) {
    Task task{.iri = iri_of(individual), .name = name_of(individual), .prefer = {}, .roles = {}, .line = line};
    if (const auto wish = text(individual, "prefer")) task.prefer = wish->first;
    for (const std::size_t index : stated(individual, AxiomKind::object_property_assertion, "hasRole")) {
      const Axiom axiom = source_.axiom(index);
      const TermId role = axiom.arguments[2];
      const std::uint32_t place = axiom.line;
      task.roles.push_back(role_of(role, place));
    }
    if (task.roles.empty()) fail(line, "the task has no role: state what it capability:hasRole");
    return task;
  }

  Role role_of(TermId individual, std::uint32_t line) {
    if (const auto own = facts_.find(individual); own != facts_.end()) line = source_.axiom(own->second.front()).line;
    Role role{.iri = iri_of(individual), .name = name_of(individual), .expression = {}, .condition = {}, .line = line};
    role.expression = expression_of(individual, line);
    if (const auto condition = text(individual, "where")) role.condition = condition->first;
    if (const auto count = text(individual, "count")) {
      const auto number = base::parse_number<std::uint64_t>(count->first);
      if (!number || *number == 0) {
        fail(count->second, "capability:count is '" + count->first + "': write a whole number from 1");
      }
      role.count = *number;
    }
    if (const auto shared = text(individual, "shared")) {
      role.is_shared = shared->first == "true" || shared->first == "1";
      if (!role.is_shared && shared->first != "false" && shared->first != "0") {
        fail(shared->second, "capability:shared is '" + shared->first + "': write true or false");
      }
    }
    return role;
  }

  std::string expression_of(TermId role, std::uint32_t line) {
    constexpr const char* advice =
        ": state one capability:heldBy with its class, or capability:expression with a class expression as text";
    const auto written = text(role, "expression");
    const auto holders = stated(role, AxiomKind::object_property_assertion, "heldBy");
    if (holders.size() + (written ? 1 : 0) != 1) {
      fail(line, "the role '" + name_of(role) + "' " +
                     std::string(holders.empty() && !written ? "does not say who may hold it"
                                                             : "says twice who may hold it") +
                     advice);
      return {};
    }
    if (written) return written->first;
    return class_of(source_.axiom(holders.front()).arguments[2], source_.axiom(holders.front()).line);
  }

  /// All classes of an individual as one expression.
  std::string class_of(TermId holder, std::uint32_t line) {
    for (const AxiomKind kind : {AxiomKind::object_property_assertion, AxiomKind::data_property_assertion}) {
      if (const auto others = facts(holder, kind); !others.empty()) {
        fail(source_.axiom(others.front()).line,
             "a holder is described by its classes alone: state this as a restriction, as in "
             "'a [ a owl:Restriction ; owl:onProperty capability:hasPart ; owl:someValuesFrom capability:Gripper ]'");
      }
    }
    std::vector<TermId> classes;
    for (const std::size_t index : facts(holder, AxiomKind::class_assertion)) {
      const TermId one = source_.axiom(index).arguments[0];
      if (one != owl::thing_term) classes.push_back(one);
    }
    if (classes.empty()) {
      fail(line, "who holds the role has no class: state it with 'a'");
      return {};
    }
    std::ranges::sort(classes);
    classes.erase(std::ranges::unique(classes).begin(), classes.end());
    const TermId whole =
        classes.size() == 1 ? classes.front() : source_.term(TermKind::object_intersection_of, classes);
    return manchester::canonical(source_, whole);
  }

  owl::Ontology& source_;
  owl::FileId file_;
  const owl::ShortName& name_of_iri_;
  std::map<TermId, std::vector<std::size_t>> facts_;  ///< by the individual that they are about
  std::optional<TaskFault> fault_{};
};

}  // namespace

std::expected<std::vector<Task>, TaskFault> read_tasks(owl::Ontology& source, owl::FileId file,
                                                       const owl::ShortName& name_of_iri) {
  return Reading(source, file, name_of_iri).run();
}

}  // namespace geminga::ontology
