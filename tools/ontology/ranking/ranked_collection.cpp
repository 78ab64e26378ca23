#include "ontology/ranking/ranked_collection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "base/text.hpp"
#include "ontology/command/words.hpp"
#include "reasoning/syntax/folders.hpp"
#include "reasoning/syntax/inflate.hpp"
#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::ontology {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 1> owls_endings{".owls"};
constexpr std::array<std::string_view, 2> old_endings{".daml", ".rdfs"};  ///< of old ontologies

bool is_owls(std::string_view path) { return base::in_lower_case(syntax::name_without_gz(path)).ends_with(".owls"); }

/// The file's path below the folder on the command line.
std::string path_below(const std::string& path, const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) {
    std::error_code error;
    if (!fs::is_directory(argument, error)) continue;
    const fs::path relative = fs::path(path).lexically_relative(argument);
    if (!relative.empty() && *relative.begin() != "..") return relative.generic_string();
  }
  return fs::path(path).filename().string();
}

/// Shortens the names to file names where no other file has the same, and tells the profiles of one file apart.
void name_all(std::vector<Described>& described) {
  std::map<std::string, std::set<std::string>> paths_of;
  for (const Described& one : described) paths_of[fs::path(one.name).filename().string()].insert(one.path);
  std::map<std::string, std::size_t> profiles_of;
  for (const Described& one : described) ++profiles_of[one.path];
  for (Described& one : described) {
    const std::string file = fs::path(one.name).filename().string();
    if (paths_of[file].size() == 1) one.name = file;
    if (profiles_of[one.path] > 1) {
      const std::string& iri = one.profile.iri;
      one.name += '#' + iri.substr(iri.find('#') == std::string::npos ? 0 : iri.find('#') + 1);
    }
    one.name = base::printable(one.name, 1000);
  }
}

}  // namespace

std::vector<std::string> guess_ontologies(const CollectionPaths& paths) {
  constexpr int levels = 3;
  std::vector<std::string> found;
  std::vector<std::string> both = paths.services;
  both.insert(both.end(), paths.requests.begin(), paths.requests.end());
  for (const std::string& path : both) {
    std::error_code error;
    fs::path folder = fs::absolute(path, error).lexically_normal();
    if (!folder.has_filename()) folder = folder.parent_path();
    for (int level = 0; level <= levels; ++level, folder = folder.parent_path()) {
      for (const char* name : {"ontology", "ontologies"}) {
        const std::string candidate = (folder / name).string();
        if (fs::is_directory(candidate, error) && std::ranges::find(found, candidate) == found.end())
          found.push_back(candidate);
      }
    }
  }
  return found;
}

void RankedCollection::read_file(const std::string& path, const std::string& below, std::vector<Described>& described,
                                 std::vector<std::string>& others) {
  auto document = owls::read_profiles(path);
  if (!document) return problems_.push_back(syntax::to_string(document.error()));
  if (document->profiles.empty() && !is_owls(path)) return others.push_back(path);
  const auto lacks_type = [](const owls::Profile& profile) {
    const auto is_unstated = [](const std::string& type) { return type.empty(); };
    return std::ranges::any_of(profile.inputs, is_unstated) || std::ranges::any_of(profile.outputs, is_unstated);
  };
  if (document->broken_off) {
    // Types stand behind the profiles that name them. A profile that lost its types would be ranked by others.
    const bool is_half = document->profiles.empty() || std::ranges::any_of(document->profiles, lacks_type);
    problems_.push_back(syntax::to_string(*document->broken_off) +
                        (is_half ? ": it is not ranked" : ": only what stands before counts"));
    if (is_half) return;
  }
  if (document->profiles.empty())
    return problems_.push_back(base::printable(path, 4096) + ": holds no profile of a service");
  for (owls::Profile& profile : document->profiles) described.push_back({below, path, std::move(profile), {}});
}

std::optional<std::string> RankedCollection::list(const std::vector<std::string>& arguments,
                                                  std::vector<Described>& described, std::vector<std::string>& others) {
  for (const std::string& argument : arguments) {
    std::error_code error;
    if (!fs::exists(argument, error)) return base::printable(argument, 4096) + ": there is no such file or folder";
  }
  const auto listing = syntax::list_files(arguments, {}, owls_endings);
  if (!listing) return syntax::to_string(listing.error());
  folders_.insert(folders_.end(), listing->folders.begin(), listing->folders.end());
  for (const std::string& file : listing->files) read_file(file, path_below(file, arguments), described, others);
  name_all(described);
  return std::nullopt;
}

std::expected<RankedCollection, std::string> RankedCollection::read(const CollectionPaths& paths,
                                                                    const WorkLimits& limits) {
  RankedCollection collection;
  std::vector<std::string> ontologies;
  if (const auto problem = collection.list(paths.services, collection.services_, ontologies))
    return std::unexpected(*problem);
  if (const auto problem = collection.list(paths.requests, collection.requests_, ontologies))
    return std::unexpected(*problem);
  if (!paths.ontologies.empty()) {
    auto listing = syntax::list_files(paths.ontologies, {}, old_endings);
    if (!listing) return std::unexpected(syntax::to_string(listing.error()));
    std::ranges::move(listing->files, std::back_inserter(ontologies));
    std::ranges::move(listing->folders, std::back_inserter(collection.folders_));
  }
  for (const std::string& folder : paths.guessed) {
    auto listing = syntax::list_files(std::span(&folder, 1), {}, old_endings);
    if (!listing) continue;  // a folder that only has the name
    std::ranges::move(listing->files, std::back_inserter(ontologies));
    std::ranges::move(listing->folders, std::back_inserter(collection.folders_));
  }
  std::set<std::string> seen;
  std::erase_if(ontologies, [&](const std::string& path) {
    std::error_code error;
    return !seen.insert(fs::weakly_canonical(path, error).string()).second;
  });
  CollectionClasses classes = read_collection(ontologies, collection.folders_, limits);
  std::ranges::move(classes.problems, std::back_inserter(collection.problems_));
  std::ranges::move(classes.remarks, std::back_inserter(collection.remarks_));
  if (classes.files == 0)
    collection.remarks_.emplace_back(
        "no ontology was found, so that only equal types match: name its folder behind --ontologies");
  collection.names_.emplace(std::move(classes));
  collection.resolve();
  return collection;
}

void RankedCollection::resolve() {
  std::map<std::string, std::string> unknown;  // by type: the first file that names it
  const auto resolve_side = [&](const std::vector<std::string>& types, const std::string& path,
                                std::vector<signature::Concept>& concepts) {
    for (const std::string& type : types) {
      const signature::Concept found = names_->find(type);
      concepts.push_back(found);
      if (names_->is_unknown(found) && !type.starts_with(syntax::xsd_namespace)) unknown.emplace(type, path);
    }
  };
  for (std::vector<Described>* side : {&services_, &requests_}) {
    for (Described& one : *side) {
      resolve_side(one.profile.inputs, one.path, one.signature.inputs);
      resolve_side(one.profile.outputs, one.path, one.signature.outputs);
    }
  }
  if (unknown.empty()) return;
  const auto& [type, path] = *unknown.begin();
  remarks_.push_back(counted(unknown.size(), "type is", "types are") +
                     " in no ontology and match only themselves, the first <" + base::printable(type, 1000) + "> of " +
                     base::printable(path, 1000));
}

std::vector<Ranked> rank_services(signature::Scorer& scorer, const Described& request,
                                  const std::vector<Described>& services) {
  std::vector<Ranked> ranked;
  ranked.reserve(services.size());
  for (std::size_t number = 0; number < services.size(); ++number)
    ranked.push_back({number, scorer.score(request.signature, services[number].signature)});
  // Smaller differences come from the order of additions alone.
  constexpr double grain = 1e9;
  const auto order = [&](const Ranked& one) { return -std::llround(one.score.total * grain); };
  std::ranges::stable_sort(ranked, [&](const Ranked& a, const Ranked& b) {
    return std::tuple(order(a), std::string_view(services[a.service].name)) <
           std::tuple(order(b), std::string_view(services[b.service].name));
  });
  return ranked;
}

}  // namespace geminga::ontology
