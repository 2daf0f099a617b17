// make_man_pages FOLDER DATE VERSION: writes FOLDER/volplane.1 and FOLDER/volplane-cli.1 from what the programs parse their
// command lines with. Descriptions are those of --help.
#include "app/cli/command_line.h"
#include "app/gui/command_line.h"
#include "packaging/tools/man_page.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>

using vp::packaging::ManPage;

namespace {

std::string sentence(std::string text) {
  if (!text.empty() && std::string(".!?").find(text.back()) == std::string::npos) {
    text += '.';
  }
  return text;
}

/// What CLI11 calls "INT:INT in [1 - 64]" or "TEXT:{base,lazy}": the kind of value, and which ones are taken, as a sentence.
struct ValueKind {
  std::string name;
  std::string allowed;
};

ValueKind kindOf(const std::string& type) {
  const std::size_t colon = type.find(':');
  ValueKind kind{type.substr(0, colon), ""};
  if (colon == std::string::npos) {
    return kind;
  }
  const std::string limits = type.substr(colon + 1);
  if (limits.starts_with('{')) {
    kind.allowed = " One of:";
    for (const char c : limits.substr(1, limits.size() - 2)) {
      kind.allowed += c == ','                                                     ? std::string(",")
                      : (kind.allowed.back() == ':' || kind.allowed.back() == ',') ? std::string(" ") + c
                                                                                   : std::string(1, c);
    }
    kind.allowed += '.';
  } else if (const std::size_t bracket = limits.find('['); bracket != std::string::npos) {
    std::string range = limits.substr(bracket + 1, limits.rfind(']') - bracket - 1);
    if (const std::size_t dash = range.find(" - "); dash != std::string::npos) {
      range.replace(dash, 3, " to ");
    }
    kind.allowed = " From " + range + '.';
  } else {
    kind.allowed = " (" + limits + ")";
  }
  return kind;
}

std::string listOf(const std::set<CLI::Option*>& options) {
  std::set<std::string> names;  // sorted by name: pointers are in another order each time
  for (const CLI::Option* option : options) {
    names.insert(option->get_name());
  }
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

void addOption(ManPage& page, const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) {
    names.push_back('-' + name);
  }
  for (const std::string& name : option.get_lnames()) {
    names.push_back("--" + name);
  }
  const bool isFlag = option.get_items_expected_max() == 0;
  const ValueKind kind = isFlag ? ValueKind() : kindOf(option.get_type_name());
  std::string text = sentence(option.get_description()) + kind.allowed;
  if (!option.get_default_str().empty()) {
    text += " Default: " + option.get_default_str() + '.';
  }
  if (!option.get_needs().empty()) {
    text += " Only with " + listOf(option.get_needs()) + '.';
  }
  if (!option.get_excludes().empty()) {
    text += " Not with " + listOf(option.get_excludes()) + '.';
  }
  if (option.get_required()) {
    text += " Required.";
  }
  page.option(names, kind.name + (option.get_items_expected_max() > 1 ? " ..." : ""), text);
}

/// What of a command stands under one heading of its --help; groups without a name are hidden there too.
void addOptions(ManPage& page, const CLI::App& command) {
  std::vector<std::string> groups;
  for (const CLI::Option* option : command.get_options()) {
    const std::string& group = option->get_group();
    if (option->nonpositional() && !group.empty() && std::find(groups.begin(), groups.end(), group) == groups.end()) {
      groups.push_back(group);
    }
  }
  for (const std::string& group : groups) {
    if (group != "Options") {
      page.paragraph(group + ':');
    }
    for (const CLI::Option* option : command.get_options()) {
      if (option->nonpositional() && option->get_group() == group) {
        addOption(page, *option);
      }
    }
  }
  for (const CLI::App* inner : command.get_subcommands([](const CLI::App* app) { return app->get_name().empty(); })) {
    addOptions(page, *inner);
  }
}

std::string usageOf(const CLI::App& command) {
  std::string text = command.get_name();
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() && !option->get_group().empty()) {
      const std::string name = option->get_name(true) + (option->get_items_expected_max() > 1 ? "..." : "");
      text += option->get_required() ? ' ' + name : " [" + name + ']';
    }
  }
  return text;
}

void addCommand(ManPage& page, const CLI::App& command) {
  page.subsection(usageOf(command));
  page.paragraph(sentence(command.get_description()));
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() && !option->get_group().empty()) {
      const ValueKind kind = kindOf(option->get_type_name());
      page.option({}, option->get_name(true), sentence(option->get_description()) + kind.allowed);
    }
  }
  addOptions(page, command);
}

void addEnvironment(ManPage& page, bool hasWindow) {
  page.section("Environment");
  page.item("VOLPLANE_RESOURCES", "Folder with aircraft profiles and maps, looked at before the one that was installed.");
  page.item("VOLPLANE_TERRAIN_URL, VOLPLANE_AIRFIELDS_URL",
            "Servers to fetch terrain and airfields from instead of those of Copernicus GLO-30 and OurAirports; of the same layout.");
  page.item("http_proxy, https_proxy, no_proxy", "Proxies that fetching goes through. The network is used for nothing else.");
  page.item("XDG_CACHE_HOME", "Folder in which what was fetched is kept, in volplane; else ~/.cache.");
  if (hasWindow) {
    page.item("VOLPLANE_3D",
              "How the 3D view is drawn: widget, by OpenGL in the window even where that is done by the processor, or images, beside the window; "
              "else what suits.");
    page.item("XDG_CONFIG_HOME", "Folder in which preferences are kept, in Volplane; else ~/.config.");
  }
}

void addFiles(ManPage& page) {
  page.section("Files");
  page.item("*.vpm",
            "A mission: terrain, airfields, aircraft, targets and what is wanted of the flight, as JSON. Schemas of all three kinds of file lie in "
            "/usr/share/volplane/schema.");
  page.item("*.vpp", "A plan: the mission, the tour, the glide from each of its points, and the certificate.");
  page.item("/usr/share/volplane/aircraft", "Aircraft profiles that a mission may name without path and ending.");
  page.item("/usr/share/volplane/maps", "Missions to try.");
  page.item("~/.cache/volplane", "Terrain and airfields that were fetched.");
}

void addMeaning(ManPage& page) {
  page.section("What safe means");
  page.paragraph(
      "From every point of a verified tour a glide at the best glide speed of the aircraft reaches a runway in landing direction, with the chosen "
      "clearance above the terrain. "
      "The promise is as good as its inputs: wind, glide polar, terrain and runway list. The pilot checks those, and remains in command.");
}

std::string cliPage(const std::string& date, const std::string& version) {
  ManPage page("volplane-cli", "plan flights that can always glide to a runway", date, version);
  CLI::App app;
  vp::cli::Common common;
  int status = 0;
  vp::cli::defineCommandLine(app, common, status, [] { return std::string(); });
  page.section("Synopsis");
  page.example({"volplane-cli [OPTIONS] COMMAND [OPTIONS] ..."});
  page.section("Description");
  page.paragraph(app.get_description());
  page.paragraph("It does the whole job of volplane(1) without a window and without a display.");
  page.section("Options");
  addOptions(page, app);
  page.section("Commands");
  for (const CLI::App* command : app.get_subcommands([](const CLI::App* one) { return !one->get_name().empty() && !one->get_group().empty(); })) {
    addCommand(page, *command);
  }
  addMeaning(page);
  page.section("Exit status");
  page.item("0", "Done.");
  page.item("1", "There is no solution; the message says why.");
  page.item("2", "Bad input or usage.");
  page.item("3", "Verification failed: the plan is not safe.");
  page.item("130", "Stopped by Ctrl-C.");
  addFiles(page);
  addEnvironment(page, false);
  page.section("Examples");
  page.example({"volplane-cli plan /usr/share/volplane/maps/mountain-n20.vpm -o tour.vpp", "volplane-cli verify tour.vpp",
                "volplane-cli export tour.vpp --format fms -o tour.fms", "volplane-cli brief tour.vpp -o tour.pdf"});
  page.section("See also");
  page.paragraph("volplane(1)");
  return page.roff();
}

std::string windowPage(const std::string& date, const std::string& version) {
  const vp::gui::CommandLine line = vp::gui::commandLine();
  ManPage page("volplane", "plan flights that can always glide to a runway, in a window", date, version);
  std::string synopsis = "volplane [OPTIONS]";
  for (const vp::gui::Positional& positional : line.positionals) {
    synopsis += ' ' + positional.syntax.toStdString();
  }
  page.section("Synopsis");
  page.example({synopsis});
  page.section("Description");
  page.paragraph(line.description.toStdString());
  page.paragraph("The first start shows an example, already planned. Help > First steps (F1) says how to go on.");
  page.section("Options");
  for (const vp::gui::Positional& positional : line.positionals) {
    page.option({}, positional.name.toStdString(), sentence(positional.description.toStdString()));
  }
  for (const QCommandLineOption& option : line.options) {
    std::vector<std::string> names;
    for (const QString& name : option.names()) {
      names.push_back((name.size() == 1 ? "-" : "--") + name.toStdString());
    }
    page.option(names, option.valueName().toStdString(), sentence(option.description().toStdString()));
  }
  page.paragraph("Options of Qt, for example -style or -platform, are understood too.");
  addMeaning(page);
  addFiles(page);
  page.item("~/.config/Volplane/volplane.conf", "Preferences.");
  addEnvironment(page, true);
  page.section("See also");
  page.paragraph("volplane-cli(1), and the manual in /usr/share/doc/volplane.");
  return page.roff();
}

bool write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) {
    std::fprintf(stderr, "make_man_pages: %s cannot be written\n", file.c_str());
  }
  return static_cast<bool>(stream);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("make_man_pages FOLDER DATE VERSION\n", stderr);
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  const std::string version = std::string("Volplane ") + argv[3];
  return write(folder / "volplane.1", windowPage(argv[2], version)) && write(folder / "volplane-cli.1", cliPage(argv[2], version)) ? 0 : 1;
}
