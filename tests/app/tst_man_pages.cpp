// The manual pages hold what --help and the sources say: every command, every option, every environment variable.
#include "tests/support/cli_run.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QStandardPaths>
#include <QTest>

using namespace vp::test;

namespace {

const QString kSource = QStringLiteral(VOLPLANE_SOURCE_DIR);

/// A page as one reads it: escapes and fonts undone.
QString page(const QString& name) {
  QFile file(QStringLiteral(VOLPLANE_BIN_DIR "/../package/man/%1.1").arg(name));
  if (!file.open(QIODevice::ReadOnly)) {
    return {};
  }
  QString text = QString::fromUtf8(file.readAll());
  text.remove(QRegularExpression(QStringLiteral("\\\\f[BIR]"))).replace(QStringLiteral("\\-"), QStringLiteral("-"));
  return text.replace(QStringLiteral("\\(aq"), QStringLiteral("'")).replace(QStringLiteral("\\(ti"), QStringLiteral("~"));
}

/// The part of a page on one command: from its heading to the next.
QString partOn(const QString& text, const QString& command) {
  const qsizetype start = text.indexOf(QRegularExpression(QStringLiteral("^\\.SS \"%1[ \"]").arg(command), QRegularExpression::MultilineOption));
  return start < 0 ? QString() : text.mid(start, text.indexOf(QRegularExpression(QStringLiteral("\n\\.S[SH] ")), start) - start);
}

/// Options in what --help prints: the words with hyphens at the start of indented lines.
QStringList optionsIn(const QString& help) {
  QStringList found;
  static const QRegularExpression line(QStringLiteral("^  (-[-\\w,]+)"), QRegularExpression::MultilineOption);
  static const QRegularExpression more(QStringLiteral("^  (-\\w), (--[-\\w]+)"), QRegularExpression::MultilineOption);
  for (auto it = line.globalMatch(help); it.hasNext();) {
    found += it.next().captured(1).split(QLatin1Char(','), Qt::SkipEmptyParts);
  }
  for (auto it = more.globalMatch(help); it.hasNext();) {
    found += it.next().captured(2);
  }
  found.removeDuplicates();
  return found;
}

QStringList commandsIn(const QString& help) {
  QStringList found;
  static const QRegularExpression line(QStringLiteral("^  ([a-z][-a-z]+) "), QRegularExpression::MultilineOption);
  for (auto it = line.globalMatch(help.mid(help.indexOf(QStringLiteral("Subcommands:")))); it.hasNext();) {
    found += it.next().captured(1);
  }
  return found;
}

/// True if the option is a word of its own there: "--hold" is not in "--hold-short".
bool names(const QString& text, const QString& option) {
  return text.contains(
      QRegularExpression(QStringLiteral("(^|[\\s,])%1($|[\\s,.])").arg(QRegularExpression::escape(option)), QRegularExpression::MultilineOption));
}

QString helpOf(const QStringList& command) {
  return QString::fromUtf8(runCli(command + QStringList{QStringLiteral("--help")}).out);
}

}  // namespace

class TestManPages : public QObject {
  Q_OBJECT

private slots:
  void pageOfTheCli_underEachCommand_holdsEveryOptionOfItsHelp() {
    const QString text = page(QStringLiteral("volplane-cli"));
    const QString help = helpOf({});
    const QStringList general = optionsIn(help);
    QVERIFY(general.contains(QStringLiteral("--json")) && general.contains(QStringLiteral("-q")) && general.contains(QStringLiteral("--version")));
    for (const QString& option : general) {
      QVERIFY2(names(text.left(text.indexOf(QStringLiteral("\n.SH COMMANDS"))), option), qPrintable(option));
    }
    const QStringList commands = commandsIn(help);
    QVERIFY2(commands.size() >= 12, qPrintable(commands.join(QLatin1Char(' '))));
    int options = 0;
    for (const QString& command : commands) {
      const QString part = partOn(text, command);
      QVERIFY2(!part.isEmpty(), qPrintable(command));
      for (const QString& option : optionsIn(helpOf({command}))) {
        QVERIFY2(names(part, option), qPrintable(command + QLatin1Char(' ') + option));
        ++options;
      }
    }
    QVERIFY(options > 100);
  }

  void pageOfTheWindow_underItsHelp_holdsEveryOption() {
    QProcess program;
    program.start(QStringLiteral(VOLPLANE_BIN_DIR "/volplane"), {QStringLiteral("--help")});
    QVERIFY(program.waitForFinished());
    QCOMPARE(program.exitCode(), 0);
    const QStringList options = optionsIn(QString::fromUtf8(program.readAllStandardOutput()));
    QVERIFY(options.contains(QStringLiteral("--help")) && options.contains(QStringLiteral("--version")));
    const QString text = page(QStringLiteral("volplane"));
    for (const QString& option : options) {
      QVERIFY2(names(text, option), qPrintable(option));
    }
  }

  void pages_underTheSources_nameEveryEnvironmentVariable() {
    QSet<QString> variables;
    static const QRegularExpression use(QStringLiteral("(?:fromEnvironment|getenv|qgetenv|qEnvironmentVariable\\w*)\\(\"(VOLPLANE_\\w+)\""));
    for (const char* folder : {"core", "ui", "app"}) {
      QDirIterator files(kSource + QLatin1Char('/') + QLatin1String(folder), {QStringLiteral("*.cpp")}, QDir::Files, QDirIterator::Subdirectories);
      while (files.hasNext()) {
        const QString code = QString::fromUtf8(readAll(files.next()));
        for (auto it = use.globalMatch(code); it.hasNext();) {
          variables.insert(it.next().captured(1));
        }
      }
    }
    QVERIFY(variables.contains(QStringLiteral("VOLPLANE_RESOURCES")));
    const QString window = page(QStringLiteral("volplane"));
    for (const QString& variable : variables) {
      QVERIFY2(window.contains(variable), qPrintable(variable));
    }
  }

  void pages_underTheRulesOfRoff_areClean() {
    const QString mandoc = QStandardPaths::findExecutable(QStringLiteral("mandoc"));
    if (mandoc.isEmpty()) {
      QSKIP("mandoc is not installed (packaging/dependencies.sh package)");
    }
    for (const char* name : {"volplane", "volplane-cli"}) {
      QProcess lint;
      lint.start(mandoc, {QStringLiteral("-T"), QStringLiteral("lint"), QStringLiteral("-W"), QStringLiteral("warning"),
                          QStringLiteral(VOLPLANE_BIN_DIR "/../package/man/%1.1").arg(QLatin1String(name))});
      QVERIFY(lint.waitForFinished());
      QVERIFY2(lint.exitCode() == 0, lint.readAllStandardOutput().constData());
    }
  }

  void version_underBothPrograms_tellsCommitLibrariesAndData() {
    const QString cli = QString::fromUtf8(runCli({QStringLiteral("--version")}).out);
    QProcess program;
    QProcessEnvironment noDisplay = QProcessEnvironment::systemEnvironment();
    noDisplay.remove(QStringLiteral("DISPLAY"));
    noDisplay.remove(QStringLiteral("QT_QPA_PLATFORM"));
    program.setProcessEnvironment(noDisplay);
    program.start(QStringLiteral(VOLPLANE_BIN_DIR "/volplane"), {QStringLiteral("--version")});
    QVERIFY(program.waitForFinished());
    QCOMPARE(program.exitCode(), 0);
    const QString window = QString::fromUtf8(program.readAllStandardOutput());
    QCOMPARE(window.section(QLatin1Char('\n'), 1), cli.section(QLatin1Char('\n'), 1));
    static const QRegularExpression first(QStringLiteral("^volplane(-cli)? \\d+\\.\\d+\\.\\d+ \\(commit [\\w.-]+\\)\n"));
    QVERIFY2(first.match(cli).hasMatch() && first.match(window).hasMatch(), qPrintable(cli));
    for (const char* part :
         {"GPL-3.0-or-later", "Qt " QT_VERSION_STR, "GDAL 3.", "OpenSceneGraph 3.", "Copernicus GLO-30", "DLR e.V.", "OurAirports", "WMM2025"}) {
      QVERIFY2(cli.contains(QString::fromUtf8(part)), part);
    }
  }
};

QTEST_APPLESS_MAIN(TestManPages)
#include "tst_man_pages.moc"
