#include "daemon/configuration/configuration_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "base/edit_distance.hpp"
#include "base/text.hpp"

#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

namespace geminga::daemon {
namespace {

using Errors = std::vector<std::string>;

std::string place(const std::string& path, const toml::source_region& region) {
  return path + ':' + std::to_string(region.begin.line);
}

std::string_view wanted(ValueType type) {
  switch (type) {
    case ValueType::text:
      return "a text in quotes";
    case ValueType::texts:
      return "a text in quotes, or several in brackets";
    case ValueType::number:
      return "a whole number";
    case ValueType::seconds:
      return "a number of seconds";
    case ValueType::truth:
      return "true or false, without quotes";
  }
  return "";
}

/// The value as a flag would write it, or nothing where it has another type.
std::optional<std::string> as_text(const toml::node& node, ValueType type) {
  if (type == ValueType::text || type == ValueType::texts) return node.value_exact<std::string>();
  if (type == ValueType::truth) {
    const auto truth = node.value_exact<bool>();
    return truth ? std::optional<std::string>(*truth ? "true" : "false") : std::nullopt;
  }
  if (const auto number = node.value_exact<std::int64_t>()) return std::to_string(*number);
  if (type == ValueType::seconds) {
    if (const auto seconds = node.value_exact<double>()) {
      char digits[64];
      const auto [end, error] = std::to_chars(std::begin(digits), std::end(digits), *seconds);
      if (error == std::errc()) return std::string(std::begin(digits), end);
    }
  }
  return std::nullopt;
}

/// `did you mean 'interval'? `, or nothing where no key is similar.
std::string likely_key(std::string_view name) {
  const std::size_t limit = base::tolerated_slips(name);
  const auto distance = [&](const Key& key) { return base::edit_distance(name, key.name, limit); };
  const auto nearest = std::ranges::min_element(keys, {}, distance);
  return distance(*nearest) > limit ? "" : "did you mean '" + std::string(nearest->name) + "'? ";
}

class Reader {
 public:
  explicit Reader(std::string path) : path_(std::move(path)) {}

  std::expected<Layer, Errors> read(const toml::table& table) {
    for (const auto& [name, node] : table) take(std::string(name.str()), name.source(), node);
    if (!errors_.empty()) return std::unexpected(std::move(errors_));
    return std::move(layer_);
  }

 private:
  void take(const std::string& name, const toml::source_region& region, const toml::node& node) {
    if (name == "prefixes") return take_prefixes(node);
    const Key* key = find_key(name);
    if (key == nullptr || name == "config") {
      errors_.push_back(place(path_, region) + ": unknown key '" + base::printable(name) + "': " + likely_key(name) +
                        "the keys are the long flags of gemingad --help");
      return;
    }
    auto& values = layer_.values[name];
    const toml::array* array = node.as_array();
    if (array != nullptr && key->type == ValueType::texts) {
      for (const toml::node& element : *array) take_value(*key, element, values);
    } else {
      take_value(*key, node, values);
    }
  }

  void take_prefixes(const toml::node& node) {
    const toml::table* table = node.as_table();
    if (table == nullptr) {
      errors_.push_back(place(path_, node.source()) + ": prefixes must be a table: [prefixes]");
      return;
    }
    for (const auto& [name, value] : *table) {
      const auto iri = value.value_exact<std::string>();
      if (iri) {
        layer_.prefixes[std::string(name.str())] = {*iri, place(path_, value.source())};
      } else {
        errors_.push_back(place(path_, value.source()) + ": a prefix must be an IRI in quotes");
      }
    }
  }

  void take_value(const Key& key, const toml::node& node, std::vector<Stated>& values) {
    auto text = as_text(node, key.type);
    const std::string origin = place(path_, node.source());
    if (!text) {
      errors_.push_back(origin + ": " + std::string(key.name) + " must be " + std::string(wanted(key.type)));
      return;
    }
    if ((key.name == "ontology" || key.name == "gcnp-socket" || key.name == "key-file" || key.name == "state-folder") &&
        !text->empty()) {
      *text = (std::filesystem::path(path_).parent_path() / *text).string();
    }
    values.push_back({std::move(*text), origin});
  }

  std::string path_;
  Layer layer_;
  Errors errors_;
};

/// The files of a folder that configure, sorted by name.
std::expected<std::vector<std::string>, Errors> files_of(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.ends_with(".toml") || name.starts_with('.')) continue;
    if (files.size() == max_configuration_files) {
      return std::unexpected(
          Errors{folder + ": more than " + std::to_string(max_configuration_files) + " files of configuration"});
    }
    files.push_back(entry->path().string());
  }
  if (error) return std::unexpected(Errors{folder + ": " + error.message()});
  std::ranges::sort(files);
  return files;
}

/// Puts what `stronger` states over `layer`.
void put_over(Layer& layer, Layer stronger) {
  for (auto& [key, values] : stronger.values) layer.values.insert_or_assign(key, std::move(values));
  for (auto& [prefix, iri] : stronger.prefixes) layer.prefixes.insert_or_assign(prefix, std::move(iri));
}

}  // namespace

std::expected<Layer, Errors> read_configuration_files(const std::vector<Stated>& paths) {
  Layer all;
  for (const auto& [path, origin] : paths) {
    if (path.empty()) return std::unexpected(Errors{origin + ": an empty path: name a file or a folder"});
    std::vector<std::string> files{path};
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
      auto found = files_of(path);
      if (!found) return std::unexpected(std::move(found.error()));
      files = std::move(*found);
    }
    for (const std::string& file : files) {
      auto layer = read_configuration_file(file);
      if (!layer) return layer;
      put_over(all, std::move(*layer));
    }
  }
  return all;
}

std::expected<Layer, Errors> read_configuration_text(const std::string& text, const std::string& path) {
  const toml::parse_result parsed = toml::parse(std::string_view(text), std::string_view(path));
  if (!parsed) {
    return std::unexpected(
        Errors{place(path, parsed.error().source()) + ": " + base::printable(parsed.error().description(), 300)});
  }
  return Reader(path).read(parsed.table());
}

std::expected<Layer, Errors> read_configuration_file(const std::string& path) {
  // stat() comes first: open() of a FIFO would wait for a writer, and open() of a device can have side effects.
  struct stat status{};
  const bool is_there = ::stat(path.c_str(), &status) == 0;
  if (is_there && !S_ISREG(status.st_mode)) return std::unexpected(Errors{path + ": is not a regular file"});
  const int descriptor = is_there ? ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC) : -1;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(descriptor < 0 ? nullptr : ::fdopen(descriptor, "rb"),
                                                             &std::fclose);
  if (!file) return std::unexpected(Errors{path + ": " + std::generic_category().message(errno)});
  std::string text(max_configuration_bytes + 1, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file.get()));
  if (std::ferror(file.get()) != 0) return std::unexpected(Errors{path + ": cannot be read: is it a file?"});
  if (text.size() > max_configuration_bytes) return std::unexpected(Errors{path + ": longer than 1 MiB"});
  return read_configuration_text(text, path);
}

}  // namespace geminga::daemon
