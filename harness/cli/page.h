#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/cli/verbs.h"

namespace lcp::cli {

/// Adds an option to a verb's page; a repeatable one takes one value each time it is named.
template <class Value, class... Checks>
CLI::Option* add(CLI::App& page, const char* name, Value& value, const char* meaning,
                 const Checks&... checks) {
  CLI::Option* option = page.add_option(name, value, meaning);
  if (option->get_expected_max() > 1 && name[0] == '-') option->allow_extra_args(false);
  (option->check(checks), ...);
  return option;
}

/// The same for an option whose default the page shows.
template <class Value, class... Checks>
CLI::Option* add_with_default(CLI::App& page, const char* name, Value& value, const char* meaning,
                              const Checks&... checks) {
  return add(page, name, value, meaning, checks...)->capture_default_str();
}

/// --format with what it takes, the default shown.
inline CLI::Option* add_format(CLI::App& page, std::string& format,
                               const std::vector<std::string>& formats) {
  return add_with_default(page, "--format", format, "How it is printed", CLI::IsMember(formats));
}

/// A verb (or a part of one) whose options fill `Arguments` and whose action takes them.
template <class Arguments>
Verb make_verb(CLI::App& parent, const char* name, const char* summary,
               void (*options)(CLI::App&, Arguments&), int (*act)(const Arguments&),
               const char* footer) {
  CLI::App* page = parent.add_subcommand(name, summary);
  const auto arguments = std::make_shared<Arguments>();
  options(*page, *arguments);
  page->footer(footer);
  return {page, [arguments, act] { return act(*arguments); }};
}

}  // namespace lcp::cli
