#include "Description.h"
#include "stromar/params/ParamTable.h"
#include <algorithm>

namespace stromar {

namespace {
std::vector<const CLI::App*> commandsOf(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

bool isFlagLike(const CLI::Option* option) { return !option->get_positional(); }

/// Text as troff wants it.
std::string escaped(std::string_view text) {
    std::string all;
    for (const char c : text) {
        if (c == '\\')
            all += "\\e";
        else if (c == '-')
            all += "\\-";
        else
            all += c;
    }
    if (all.starts_with('.') || all.starts_with('\'')) all.insert(0, "\\&");
    return all;
}

/// "-o, --output"
std::string flagsOf(const CLI::Option* option) {
    std::string flags;
    for (const std::string& name : option->get_snames()) flags += (flags.empty() ? "-" : ", -") + name;
    for (const std::string& name : option->get_lnames()) flags += (flags.empty() ? "--" : ", --") + name;
    return flags;
}

/// What stands behind an option in its help: a name, or "{a,b}".
std::string valueOf(const CLI::Option* option) {
    if (option->get_expected_max() == 0) return {};
    const std::string& text = option->get_option_text();
    std::string value = text.empty() ? option->get_type_name() : text;
    if (value.starts_with("INT") || value.starts_with("FLOAT")) return "N";
    if (const std::size_t brace = value.find('{'); brace != std::string::npos) value = value.substr(brace);
    if (const std::size_t end = value.find('}'); end != std::string::npos) value = value.substr(0, end + 1);
    return value;
}

/// The words of "{a,b}".
std::string choicesOf(const CLI::Option* option) {
    std::string value = valueOf(option);
    if (!value.starts_with('{')) return {};
    value = value.substr(1, value.size() - 2);
    std::ranges::replace(value, ',', ' ');
    return value;
}

void describe(const CLI::App& command, std::ostream& out) {
    out << ".SS " << escaped(command.get_name()) << "\n" << escaped(command.get_description()) << ".\n";
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = isFlagLike(option) ? flagsOf(option) : option->get_type_name();
        const std::string value = isFlagLike(option) ? valueOf(option) : std::string();
        out << ".TP\n\\fB" << escaped(name) << "\\fR" << (value.empty() ? "" : " \\fI" + escaped(value) + "\\fR")
            << "\n"
            << escaped(option->get_description()) << "\n";
    }
}

/// The lines of a case statement: what may follow the option that stands before the cursor.
void completeValues(const std::vector<const CLI::App*>& commands, std::ostream& out) {
    std::vector<std::string> known;
    for (const CLI::App* command : commands)
        for (const CLI::Option* option : command->get_options()) {
            const std::string choices = choicesOf(option);
            if (choices.empty() || !isFlagLike(option) || option->get_lnames().empty()) continue;
            const std::string flag = "--" + option->get_lnames().front();
            if (std::ranges::find(known, flag) != known.end()) continue;
            known.push_back(flag);
            out << "    " << flag << ") COMPREPLY=($(compgen -W '" << choices << "' -- \"$current\")); return ;;\n";
        }
}
} // namespace

void printManPage(const CLI::App& app, std::ostream& out) {
    out << ".TH STROMAR\\-CLI 1 \"\" \"Stromar\" \"User Commands\"\n.SH NAME\nstromar\\-cli \\- grow trees and write "
           "them "
           "as models\n.SH SYNOPSIS\n";
    for (const CLI::App* command : commandsOf(app)) {
        out << ".B stromar\\-cli " << command->get_name() << "\n.RI [ options ]";
        for (const CLI::Option* option : command->get_options())
            if (!isFlagLike(option)) out << " \" \" " << option->get_type_name();
        out << "\n.br\n";
    }
    out << ".SH DESCRIPTION\n"
        << escaped(app.get_description())
        << " Data goes to standard output, messages to standard error.\n.SH COMMANDS\n";
    for (const CLI::App* command : commandsOf(app)) describe(*command, out);
    out << ".SH EXIT STATUS\n0 when all is done, 1 when the input or the work failed, 2 for wrong usage.\n"
           ".SH ENVIRONMENT\n.TP\n.B STROMAR_DATA\nThe folder of presets and textures, instead of the installed one.\n"
           ".SH SEE ALSO\n.BR stromar (1)\n";
}

void printCompletion(const CLI::App& app, std::ostream& out) {
    const auto commands = commandsOf(app);
    out << "# Completion of stromar-cli for bash.\n_stromar_cli() {\n"
           "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} options=''\n"
           "  COMPREPLY=()\n  if [ \"$COMP_CWORD\" -eq 1 ]; then\n    COMPREPLY=($(compgen -W '";
    for (const CLI::App* command : commands) out << command->get_name() << " ";
    out << "--help' -- \"$current\"))\n    return\n  fi\n  case $previous in\n";
    completeValues(commands, out);
    out << "    --set) COMPREPLY=($(compgen -S = -W '";
    for (const ParamRef& ref : allParams()) out << ref.key() << " ";
    out << "' -- \"$current\")); compopt -o nospace; return ;;\n"
           "    -o | --output) COMPREPLY=($(compgen -f -- \"$current\")); return ;;\n  esac\n"
           "  case ${COMP_WORDS[1]} in\n";
    for (const CLI::App* command : commands) {
        out << "    " << command->get_name() << ") options='";
        for (const CLI::Option* option : command->get_options()) {
            for (const std::string& name : option->get_snames()) out << "-" << name << " ";
            for (const std::string& name : option->get_lnames()) out << "--" << name << " ";
        }
        out << "' ;;\n";
    }
    out << "  esac\n  case $current in\n    -*) COMPREPLY=($(compgen -W \"$options\" -- \"$current\")) ;;\n"
           "    *) COMPREPLY=($(compgen -f -X '!*.tree' -- \"$current\") $(compgen -d -- \"$current\")) ;;\n  esac\n}\n"
           "complete -o filenames -F _stromar_cli stromar-cli\n";
}

} // namespace stromar
