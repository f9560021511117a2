#pragma once
#include <CLI/CLI.hpp>
#include <ostream>

namespace stromar {

// What the command line tells about itself, made from its own definition.

/// A manual page for man(1).
void printManPage(const CLI::App& app, std::ostream& out);
/// Completion for bash.
void printCompletion(const CLI::App& app, std::ostream& out);

} // namespace stromar
