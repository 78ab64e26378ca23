#include "web/site/exposition.hpp"

#include <array>

namespace geminga::web {
namespace {

/// The value of a label, or a help text, with the escapes of both forms.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\' || c == '"') out += '\\';
    if (c == '\n') {
      out += "\\n";
    } else {
      out += c;
    }
  }
  return out;
}

std::string_view suffix(Family::Type type) {
  static constexpr std::array<std::string_view, 3> suffixes{"", "_total", "_info"};
  return suffixes[std::to_underlying(type)];
}

std::string_view word(Family::Type type, Form form) {
  static constexpr std::array<std::string_view, 3> words{"gauge", "counter", "info"};
  // The older form has no type for an info, which is a gauge of value 1 there.
  return words[form == Form::plain && type == Family::Type::info ? 0 : std::to_underlying(type)];
}

void append(std::string& out, const Family& family, Form form) {
  const std::string sample_name = family.name + std::string(suffix(family.type));
  const std::string& name = form == Form::openmetrics ? family.name : sample_name;
  out += "# TYPE " + name + ' ' + std::string(word(family.type, form)) + '\n';
  if (form == Form::openmetrics && !family.unit.empty()) out += "# UNIT " + name + ' ' + family.unit + '\n';
  out += "# HELP " + name + ' ' + escaped(family.help) + ".\n";
  for (const Sample& sample : family.samples) {
    out += sample_name;
    const char* separator = "{";
    for (const auto& [key, value] : sample.labels) {
      out += separator + key + "=\"" + escaped(value) + '"';
      separator = ",";
    }
    out += (sample.labels.empty() ? " " : "} ") + sample.value + '\n';
  }
}

}  // namespace

Form form_for(std::string_view accept) {
  return accept.contains("text/plain") && !accept.contains("application/openmetrics-text") ? Form::plain
                                                                                           : Form::openmetrics;
}

std::string_view media_type(Form form) {
  return form == Form::openmetrics ? "application/openmetrics-text; version=1.0.0; charset=utf-8"
                                   : "text/plain; version=0.0.4; charset=utf-8";
}

std::string exposition(const std::vector<Family>& families, Form form) {
  std::string out;
  for (const Family& family : families) {
    if (!family.samples.empty()) append(out, family, form);
  }
  if (form == Form::openmetrics) out += "# EOF\n";
  return out;
}

}  // namespace geminga::web
