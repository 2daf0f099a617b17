#pragma once

#include <QCommandLineOption>
#include <QList>
#include <QString>

class QCommandLineParser;

namespace vp::gui {

/** An argument of volplane that is not an option. */
struct Positional {
  QString name;
  QString description;
  QString syntax;
};

/** What volplane understands, beside the options of Qt: the program parses with it, the manual page is made from it. */
struct CommandLine {
  QString description;
  QList<QCommandLineOption> options;
  QList<Positional> positionals;
};

CommandLine commandLine();

/** Makes the parser understand commandLine(). */
void prepare(QCommandLineParser& parser);

/** True if the arguments ask for text alone (--help, --version), which needs no display. */
bool asksForText(int argc, char** argv);

}  // namespace vp::gui
