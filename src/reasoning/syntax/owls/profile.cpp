#include "reasoning/syntax/owls/profile.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "base/text.hpp"
#include "reasoning/syntax/rdf/tolerant/tolerant.hpp"
#include "reasoning/syntax/rdf/triples/graph.hpp"

namespace geminga::owls {
namespace {

using rdf::Graph;
using rdf::NodeId;
using syntax::Word;

/// Whether an IRI is this word of that ontology: ".../Profile.owl#hasInput".
bool is_word(std::string_view iri, std::string_view ontology, std::string_view word) {
  if (!iri.ends_with(word)) return false;
  iri.remove_suffix(word.size());
  if (!iri.ends_with('#') && !iri.ends_with('/')) return false;
  iri.remove_suffix(1);
  if (iri.ends_with(".owl")) iri.remove_suffix(4);
  return iri.ends_with(ontology) && (iri.size() == ontology.size() || iri[iri.size() - ontology.size() - 1] == '/');
}

/// The words of profiles and processes.
bool is_about_parameters(std::string_view predicate, std::string_view word) {
  return is_word(predicate, "Profile", word) || is_word(predicate, "Process", word);
}

class Reading {
 public:
  explicit Reading(const Graph& graph) : graph_(graph) {
    for (std::uint32_t number = 0; number < graph.triple_count(); ++number) {
      const rdf::Triple& triple = graph.triple(number);
      if (graph.is_iri(triple.subject) && is_about_parameters(graph.text(triple.predicate), "parameterType"))
        described_.emplace(fragment_of(triple.subject), triple.subject);
    }
  }

  std::vector<NodeId> profiles() const {
    return subjects([&](std::string_view predicate, std::string_view object) {
      return predicate.empty()
                 ? is_word(object, "Profile", "Profile")
                 : is_word(predicate, "Profile", "hasInput") || is_word(predicate, "Profile", "hasOutput") ||
                       is_word(predicate, "Profile", "serviceName");
    });
  }
  std::vector<NodeId> processes() const {
    return subjects([&](std::string_view predicate, std::string_view object) {
      return predicate.empty()
                 ? is_word(object, "Process", "AtomicProcess") || is_word(object, "Process", "SimpleProcess") ||
                       is_word(object, "Process", "CompositeProcess")
                 : is_word(predicate, "Process", "hasInput") || is_word(predicate, "Process", "hasOutput");
    });
  }

  Profile profile(NodeId of) const {
    Profile profile;
    if (graph_.is_iri(of)) profile.iri = graph_.text(of);
    for (const std::uint32_t number : graph_.about(of)) {
      const rdf::Triple& triple = graph_.triple(number);
      const std::string_view predicate = graph_.text(triple.predicate);
      const bool is_any = is_about_parameters(predicate, "hasParameter");
      if (is_about_parameters(predicate, "hasInput") || (is_any && has_type(triple.object, "Input"))) {
        profile.inputs.push_back(type_of(triple.object, of));
      } else if (is_about_parameters(predicate, "hasOutput") || (is_any && has_type(triple.object, "Output"))) {
        profile.outputs.push_back(type_of(triple.object, of));
      }
    }
    return profile;
  }

  std::vector<std::string> imports() const {
    std::vector<std::string> found;
    for (std::uint32_t number = 0; number < graph_.triple_count(); ++number) {
      const rdf::Triple& triple = graph_.triple(number);
      if (triple.predicate == rdf::node_of(Word::owl_imports))
        found.emplace_back(base::trimmed(graph_.text(triple.object)));
    }
    return found;
  }

 private:
  /// The subjects of triples for which `is_one(predicate, object)` holds, in the order of the file. The predicate is
  /// empty for rdf:type.
  template <typename Test>
  std::vector<NodeId> subjects(const Test& is_one) const {
    std::vector<NodeId> found;
    std::set<NodeId> seen;
    for (std::uint32_t number = 0; number < graph_.triple_count(); ++number) {
      const rdf::Triple& triple = graph_.triple(number);
      const bool is_type = triple.predicate == rdf::node_of(Word::rdf_type);
      if (is_one(is_type ? std::string_view() : graph_.text(triple.predicate), graph_.text(triple.object)) &&
          seen.insert(triple.subject).second)
        found.push_back(triple.subject);
    }
    return found;
  }

  bool has_type(NodeId node, std::string_view word) const {
    return std::ranges::any_of(graph_.about(node, Word::rdf_type), [&](std::uint32_t number) {
      return is_word(graph_.text(graph_.triple(number).object), "Process", word);
    });
  }

  /// The IRI of the type of a parameter. A collection may also name the class in place of the parameter, or as another
  /// of its types.
  std::string type_of(NodeId parameter, NodeId profile) const {
    if (graph_.is_literal(parameter)) return absolute(graph_.text(parameter), parameter);
    if (graph_.is_iri(parameter) && graph_.about(parameter).empty()) {
      // Files that were moved name their parameters by two URLs.
      const auto same = described_.find(fragment_of(parameter));
      if (same != described_.end()) parameter = same->second;
    }
    const auto about = graph_.about(parameter);
    for (const std::uint32_t number : about) {
      const rdf::Triple& triple = graph_.triple(number);
      if (is_about_parameters(graph_.text(triple.predicate), "parameterType") && !graph_.is_blank(triple.object))
        return absolute(graph_.text(triple.object), parameter);
    }
    for (const std::uint32_t number : graph_.about(parameter, Word::rdf_type)) {
      const NodeId type = graph_.triple(number).object;
      const std::string_view iri = graph_.text(type);
      const bool is_of_owls =
          is_word(iri, "Process", "Input") || is_word(iri, "Process", "Output") || is_word(iri, "Process", "Parameter");
      if (graph_.is_iri(type) && !is_of_owls && rdf::word_of(type) == Word::none) return std::string(iri);
    }
    // A parameter of the same file without a description was forgotten.
    const bool is_elsewhere =
        about.empty() && graph_.is_iri(parameter) && document_of(parameter) != document_of(profile);
    return is_elsewhere ? std::string(graph_.text(parameter)) : std::string();
  }

  [[nodiscard]] std::string_view fragment_of(NodeId node) const {
    const std::string_view text = graph_.text(node);
    return text.substr(std::min(text.find('#'), text.size()));
  }

  [[nodiscard]] std::string_view document_of(NodeId node) const {
    const std::string_view text = graph_.text(node);
    return text.substr(0, text.find('#'));
  }

  /// An IRI without white space; a fragment alone belongs to the file.
  std::string absolute(std::string_view written, NodeId parameter) const {
    std::string iri(base::trimmed(written));
    std::erase_if(iri, [](char c) { return c == '\n' || c == '\r' || c == '\t'; });
    if (!iri.starts_with('#') || !graph_.is_iri(parameter)) return iri;
    return std::string(document_of(parameter)) + iri;
  }

  const Graph& graph_;
  std::map<std::string_view, NodeId> described_;  ///< parameters that have a type, by their fragments
};

}  // namespace

std::expected<Document, syntax::LoadError> read_profiles(const std::string& path, const syntax::FileLimits& limits) {
  auto read = rdf::read_tolerantly(path, limits);
  if (!read) return std::unexpected(std::move(read.error()));
  const auto refuse = [&](std::string text) {
    return std::unexpected(syntax::LoadError{base::printable(path, 4096), 0, std::move(text)});
  };
  read->graph.index();
  const Reading reading(read->graph);
  Document document;
  document.broken_off = std::move(read->broken_off);
  document.imports = reading.imports();
  std::vector<NodeId> found = reading.profiles();
  if (found.empty()) found = reading.processes();
  if (found.size() > max_profiles) return refuse("has more than " + std::to_string(max_profiles) + " profiles");
  for (const NodeId node : found) {
    Profile profile = reading.profile(node);
    if (profile.inputs.size() > max_parameters || profile.outputs.size() > max_parameters)
      return refuse("has a profile with more than " + std::to_string(max_parameters) + " inputs or outputs");
    document.profiles.push_back(std::move(profile));
  }
  // A profile may leave its parameters to the process.
  const bool is_bare = document.profiles.size() == 1 && document.profiles.front().inputs.empty() &&
                       document.profiles.front().outputs.empty();
  if (is_bare) {
    if (const std::vector<NodeId> processes = reading.processes(); processes.size() == 1) {
      Profile process = reading.profile(processes.front());
      if (process.inputs.size() <= max_parameters && process.outputs.size() <= max_parameters) {
        document.profiles.front().inputs = std::move(process.inputs);
        document.profiles.front().outputs = std::move(process.outputs);
      }
    }
  }
  return document;
}

}  // namespace geminga::owls
