// volplane: the window.
#include "app/gui/command_line.h"
#include "app/gui/main_window.h"
#include "ui/about/about_dialog.h"
#include "ui/about/commit.h"
#include "ui/document/settings.h"
#include "ui/style/language.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <QLocale>
#include <QTimer>

#include <cstdio>
#include <optional>

namespace {

void nameProgram() {
  QCoreApplication::setOrganizationName(QStringLiteral("Volplane"));
  QCoreApplication::setApplicationName(QStringLiteral("volplane"));
  QCoreApplication::setApplicationVersion(QStringLiteral(VOLPLANE_VERSION));
}

void nameCommit(QCoreApplication& application) {
  const std::string_view commit = vp::about::builtCommit();
  application.setProperty("commit", QString::fromLatin1(commit.data(), static_cast<qsizetype>(commit.size())));
}

/// The language of the command line, else of the settings, else of the system; nothing where the command line's is unknown.
std::optional<QString> chosenLanguage(const QCommandLineParser& parser) {
  const QString option = QStringLiteral("language");
  if (!parser.isSet(option)) {
    return vp::style::languageFor(vp::document::Settings().language(), QLocale::system().uiLanguages());
  }
  const QString wanted = parser.value(option);
  return vp::style::languages().contains(wanted) ? std::optional(wanted) : std::nullopt;
}

/// --help and --version work without a display, so before Qt looks for one; in English, as everything that a terminal is told.
int printText(int argc, char** argv) {
  QCoreApplication application(argc, argv);
  nameCommit(application);
  QCommandLineParser parser;
  vp::gui::prepare(parser);
  parser.parse(application.arguments());
  const bool isHelp = parser.isSet(QStringLiteral("help"));
  std::fputs(qUtf8Printable(isHelp ? parser.helpText() : vp::about::AboutDialog::plainText() + QLatin1Char('\n')), stdout);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  nameProgram();
  if (vp::gui::asksForText(argc, argv)) {
    return printText(argc, argv);
  }
  QApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
  QGuiApplication::setDesktopFileName(QStringLiteral("volplane"));
  QApplication application(argc, argv);
  QGuiApplication::setApplicationDisplayName(QString());
  nameCommit(application);

  QCommandLineParser parser;
  vp::gui::prepare(parser);
  parser.process(application);
  const std::optional<QString> language = chosenLanguage(parser);
  if (!language) {
    const QString known = vp::style::languages().join(QStringLiteral(", "));
    std::fprintf(stderr, "volplane: --language takes one of %s\n", qPrintable(known));
    return 2;
  }
  vp::style::useLanguage(*language);

  vp::gui::MainWindow window;
  window.show();
  const QStringList files = parser.positionalArguments();
  QTimer::singleShot(0, &window, [&window, files] {
    files.isEmpty() ? window.welcome() : window.take(files);
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/volplane.svg")));  // last: drawing it takes some milliseconds
  });
  return QApplication::exec();
}
