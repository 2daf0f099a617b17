#include "app/gui/command_line.h"

#include "ui/style/language.h"

#include <QCommandLineParser>
#include <QCoreApplication>

#include <string_view>

namespace vp::gui {
CommandLine commandLine() {
  return {
      QCoreApplication::translate("main", "Plans closed surveillance tours from every point of which the aircraft can glide to a runway."),
      {QCommandLineOption({QStringLiteral("h"), QStringLiteral("help")}, QCoreApplication::translate("main", "Print this help and exit.")),
       QCommandLineOption({QStringLiteral("v"), QStringLiteral("version")},
                          QCoreApplication::translate("main", "Print version, commit, libraries and data sources with their licences, and exit.")),
       QCommandLineOption(QStringLiteral("language"),
                          QCoreApplication::translate("main", "Language of the window, instead of that of the preferences: %1.")
                              .arg(style::languages().join(QStringLiteral(", "))),
                          QCoreApplication::translate("main", "code"))},
      {{QStringLiteral("files"), QCoreApplication::translate("main", "A mission (*.vpm) or plan (*.vpp), or terrain and airfields"),
        QStringLiteral("[files...]")}}};
}

void prepare(QCommandLineParser& parser) {
  const CommandLine all = commandLine();
  parser.setApplicationDescription(all.description);
  parser.addOptions(all.options);
  for (const Positional& positional : all.positionals) {
    parser.addPositionalArgument(positional.name, positional.description, positional.syntax);
  }
}

bool asksForText(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--") {
      return false;
    }
    if (argument == "-h" || argument == "--help" || argument == "-v" || argument == "--version") {
      return true;
    }
  }
  return false;
}

}  // namespace vp::gui
