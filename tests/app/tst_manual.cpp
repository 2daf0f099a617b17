// The manual against the programs that it is about: every command and option is in it, every link and picture is there, and what is made
// of it is whole.
#include "core/emergency/planners.h"
#include "core/formats/exports/export_formats.h"
#include "ui/help/manual.h"
#include "ui/help/manual_html.h"
#include "ui/help/manual_pdf.h"

#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include <map>

using namespace vp;

namespace {

const QString kFolder = QStringLiteral(VOLPLANE_SOURCE_DIR "/resources/manual");
constexpr qsizetype kWidestCode = 90;        // letters of 8.5 points on a page of A4
constexpr qint64 kMostPictures = 3'000'000;  // bytes, together

QString textOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QString helpOf(const QStringList& command) {
  QProcess process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
  process.setProcessEnvironment(environment);
  process.start(QStringLiteral(VOLPLANE_BIN_DIR "/") + command.front(), command.mid(1) << QStringLiteral("--help"));
  return process.waitForFinished() && process.exitCode() == 0 ? QString::fromUtf8(process.readAllStandardOutput()) : QString();
}

/// Options of a help text: what begins its lines with dashes.
QSet<QString> optionsOf(const QString& help) {
  static const QRegularExpression line(QStringLiteral("^ +((?:--?[a-z0-9][a-z0-9-]*[, ]*)+)"), QRegularExpression::MultilineOption);
  static const QRegularExpression option(QStringLiteral("--?[a-z0-9][a-z0-9-]*"));
  QSet<QString> options;
  for (auto found = line.globalMatch(help); found.hasNext();) {
    for (auto each = option.globalMatch(found.next().captured(1)); each.hasNext();) {
      options << each.next().captured();
    }
  }
  return options;
}

QStringList commandsOf(const QString& help) {
  static const QRegularExpression name(QStringLiteral("^  ([a-z][a-z-]+) +[A-Z]"), QRegularExpression::MultilineOption);
  QStringList commands;
  for (auto found = name.globalMatch(help.mid(help.indexOf(QStringLiteral("Subcommands:")))); found.hasNext();) {
    commands << found.next().captured(1);
  }
  return commands;
}

/// What stands below a heading, up to the next one of the same level or above.
QString sectionOf(const QString& markdown, const QString& heading) {
  const qsizetype start = markdown.indexOf(QLatin1Char('\n') + heading + QLatin1Char('\n'));
  if (start < 0) {
    return {};
  }
  static const QRegularExpression next(QStringLiteral("\n##? "));
  static const QRegularExpression nextBelow(QStringLiteral("\n##?#? "));
  const qsizetype end = markdown.indexOf(heading.startsWith(QStringLiteral("### ")) ? nextBelow : next, start + heading.size() + 1);
  return markdown.mid(start, end < 0 ? -1 : end - start);
}

/// Options that the first columns of the tables in a section explain.
QSet<QString> explainedIn(const QString& section) {
  static const QRegularExpression cell(QStringLiteral("^\\| (`-[^|]*) \\|"), QRegularExpression::MultilineOption);
  static const QRegularExpression option(QStringLiteral("`(--?[a-z0-9][a-z0-9-]*)[ `]"));
  QSet<QString> options;
  for (auto found = cell.globalMatch(section); found.hasNext();) {
    for (auto each = option.globalMatch(found.next().captured(1)); each.hasNext();) {
      options << each.next().captured(1);
    }
  }
  return options;
}

QString listOf(const QSet<QString>& options) {
  QStringList sorted(options.begin(), options.end());
  sorted.sort();
  return sorted.join(QLatin1Char(' '));
}

}  // namespace

class TestManual : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    const Result<help::Manual> opened = help::Manual::open(kFolder);
    QVERIFY2(opened, opened ? "" : opened.error().message().c_str());
    manual_ = *opened;
    for (const QString& file : QDir(kFolder).entryList({QStringLiteral("*.md")})) {
      const Result<help::Page> page = manual_.page(file.chopped(3));
      QVERIFY(page);
      pages_[file.chopped(3)] = *page;
    }
    commands_ = QLatin1Char('\n') + textOf(kFolder + QStringLiteral("/commands.md"));
  }

  void contents_nameEveryChapterByItsTitle() {
    QStringList named;
    for (const help::Chapter& chapter : manual_.chapters()) {
      QVERIFY2(pages_.contains(chapter.file), qPrintable(chapter.file));
      QCOMPARE(chapter.title, pages_[chapter.file].title);
      named << chapter.file;
    }
    for (const auto& [file, page] : pages_) {
      QVERIFY2(file == QStringLiteral("index") || named.count(file) == 1, qPrintable(file + QStringLiteral(" is not once in the contents")));
    }
  }

  void links_leadToPagesAndHeadings() {
    static const QRegularExpression link(QStringLiteral("<a href=\"([^\"#]*)(?:#([^\"]*))?\""));
    int count = 0;
    for (const auto& [file, page] : pages_) {
      for (auto found = link.globalMatch(page.body); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        const QString target = match.captured(1).isEmpty() ? file : QString(match.captured(1)).remove(QStringLiteral(".html"));
        const QByteArray where = QStringLiteral("%1: %2").arg(file, match.captured(0)).toUtf8();
        QVERIFY2(pages_.contains(target), where.constData());
        const std::vector<help::Heading>& headings = pages_[target].headings;
        const QString anchor = match.captured(2);
        QVERIFY2(anchor.isEmpty() || std::any_of(headings.begin(), headings.end(), [&](const help::Heading& h) { return h.anchor == anchor; }),
                 where.constData());
        ++count;
      }
    }
    QVERIFY(count > 50);
  }

  void pictures_areThereUsedAndSmall() {
    QSet<QString> shown;
    for (const auto& [file, page] : pages_) {
      for (const QString& picture : help::picturesOf(page)) {
        QVERIFY2(!QImage(kFolder + QLatin1Char('/') + picture).isNull(), qPrintable(file + QStringLiteral(": ") + picture));
        shown << picture;
      }
      QVERIFY2(!page.body.contains(QStringLiteral("<img src=\"http")), qPrintable(file));
    }
    qint64 bytes = 0;
    for (const QFileInfo& file : QDir(kFolder + QStringLiteral("/pictures")).entryInfoList({QStringLiteral("*.png")})) {
      QVERIFY2(shown.contains(QStringLiteral("pictures/") + file.fileName()), qPrintable(file.fileName() + QStringLiteral(" is shown nowhere")));
      bytes += file.size();
    }
    QVERIFY2(bytes > 0 && bytes < kMostPictures, qPrintable(QString::number(bytes)));
  }

  void command_isExplainedWithAllOptions_data() {
    QTest::addColumn<QString>("command");
    const QStringList commands = commandsOf(helpOf({QStringLiteral("volplane-cli")}));
    QVERIFY(commands.size() >= 12);
    for (const QString& command : commands) {
      QTest::newRow(qPrintable(command)) << command;
    }
  }
  void command_isExplainedWithAllOptions() {
    QFETCH(QString, command);
    QString section = sectionOf(commands_, QStringLiteral("## ") + command);
    QVERIFY2(!section.isEmpty(), "no section in commands.md");
    if (section.contains(QStringLiteral("(#pilot-air-and-approach)"))) {
      section += sectionOf(commands_, QStringLiteral("### Pilot, air and approach"));
    }
    const QSet<QString> real = optionsOf(helpOf({QStringLiteral("volplane-cli"), command}));
    const QSet<QString> explained = explainedIn(section);
    QVERIFY(real.contains(QStringLiteral("--help")));
    QVERIFY2((real - explained).isEmpty(), qPrintable(QStringLiteral("missing in the manual: ") + listOf(real - explained)));
    const QSet<QString> made = explained - real;
    QVERIFY2(made.isEmpty(), qPrintable(QStringLiteral("the command has no such options: ") + listOf(made)));
  }

  void programs_areExplainedWithAllOptions() {
    const QSet<QString> cli = optionsOf(helpOf({QStringLiteral("volplane-cli")}));
    const QSet<QString> general = explainedIn(commands_.left(commands_.indexOf(QStringLiteral("\n## "))));
    QCOMPARE(listOf(general), listOf(cli));
    const QSet<QString> window = optionsOf(helpOf({QStringLiteral("volplane")})) - QSet<QString>{QStringLiteral("--help-all")};  // of Qt
    QVERIFY(window.contains(QStringLiteral("--version")));
    QCOMPARE(listOf(explainedIn(sectionOf(commands_, QStringLiteral("## volplane")))), listOf(window));
  }

  void choices_areNamed() {
    const QString exports = textOf(kFolder + QStringLiteral("/exports.md"));
    for (const formats::ExportFormat& format : formats::exportFormats()) {
      QVERIFY2(exports.contains(QStringLiteral("`%1`").arg(QString::fromStdString(format.name))), format.name.c_str());
    }
    const QString land = sectionOf(commands_, QStringLiteral("## land"));
    for (const std::string& planner : emergency::plannerNames()) {
      QVERIFY2(land.contains(QStringLiteral("`%1`").arg(QString::fromStdString(planner))), planner.c_str());
    }
  }

  void remedies_areExplained() {
    static const QRegularExpression action(QStringLiteral("\\{tr\\(\"([^\"]+)\"\\)[^\\n\\[]*, \\[this"));  // a button of the line above the map
    const QString page = textOf(kFolder + QStringLiteral("/troubleshooting.md"));
    int count = 0;
    const QDir gui(QStringLiteral(VOLPLANE_SOURCE_DIR "/app/gui"));
    for (const QString& file : gui.entryList({QStringLiteral("*.cpp")})) {
      const QString source = textOf(gui.filePath(file));
      for (auto found = action.globalMatch(source); found.hasNext(); ++count) {
        const QString name = found.next().captured(1).replace(QStringLiteral("%1"), QStringLiteral("…"));
        QVERIFY2(page.contains(QStringLiteral("**%1**").arg(name)), qPrintable(file + QStringLiteral(": ") + name));
      }
    }
    QVERIFY(count >= 9);
  }

  void profiles_areNamed() {
    const QString aircraft = textOf(kFolder + QStringLiteral("/aircraft.md"));
    const QStringList profiles = QDir(QStringLiteral(VOLPLANE_SOURCE_DIR "/resources/aircraft")).entryList({QStringLiteral("*.json")});
    QVERIFY(!profiles.isEmpty());
    for (const QString& profile : profiles) {
      QVERIFY2(aircraft.contains(QStringLiteral("`%1`").arg(profile.chopped(5))), qPrintable(profile));
    }
  }

  void commandsToType_fitOnPaper() {
    static const QRegularExpression block(QStringLiteral("<pre><code>(.*?)</code></pre>"), QRegularExpression::DotMatchesEverythingOption);
    int count = 0;
    for (const auto& [file, page] : pages_) {
      for (auto found = block.globalMatch(page.body); found.hasNext(); ++count) {
        for (const QString& line : found.next().captured(1).split(QLatin1Char('\n'))) {
          QVERIFY2(line.size() <= kWidestCode, qPrintable(file + QStringLiteral(": ") + line));
        }
      }
    }
    QVERIFY(count > 12);
  }

  void html_isWholeAndNeedsNoNetwork() {
    const QTemporaryDir folder;
    const Result<void> written = help::writeManualHtml(manual_, folder.path(), QStringLiteral("Volplane test"));
    QVERIFY2(written, written ? "" : written.error().message().c_str());
    const QStringList files = QDir(folder.path()).entryList({QStringLiteral("*.html")});
    QCOMPARE(files.size(), static_cast<qsizetype>(pages_.size()));
    for (const QString& file : files) {
      QFile page(folder.filePath(file));
      QVERIFY(page.open(QIODevice::ReadOnly));
      QXmlStreamReader reader(&page);
      while (!reader.atEnd()) {
        reader.readNext();
        for (const char* name : {"href", "src"}) {
          const QString to = reader.attributes().value(QLatin1String(name)).toString().section(QLatin1Char('#'), 0, 0);
          QVERIFY2(to.isEmpty() || QFileInfo::exists(folder.filePath(to)), qPrintable(file + QStringLiteral(": ") + to));
        }
      }
      QVERIFY2(!reader.hasError(), qPrintable(QStringLiteral("%1:%2 %3").arg(file).arg(reader.lineNumber()).arg(reader.errorString())));
    }
  }

  void pdf_numbersItsPagesAsTheContentsSay() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("manual.pdf"));
    const Result<void> written = help::writeManualPdf(manual_, path, QStringLiteral("Volplane test"));
    QVERIFY2(written, written ? "" : written.error().message().c_str());
    QProcess reader;
    reader.start(QStringLiteral("pdftotext"), {QStringLiteral("-layout"), path, QStringLiteral("-")});
    QVERIFY(reader.waitForFinished());
    const QString all = QString::fromUtf8(reader.readAllStandardOutput()).normalized(QString::NormalizationForm_KC);  // no ligatures
    const QStringList pages = all.split(QLatin1Char('\f'));
    QVERIFY(pages.size() > static_cast<qsizetype>(manual_.chapters().size()));
    for (int page = 1; page < pages.size() - 1; ++page) {
      QVERIFY2(pages[page].trimmed().endsWith(QStringLiteral(" %1").arg(page + 1)), qPrintable(pages[page].right(200)));
    }
    const QString contents = pages.mid(0, 5).join(QLatin1Char('\n'));
    for (std::size_t i = 0; i < manual_.chapters().size(); ++i) {
      const QString title = manual_.chapters()[i].title;
      const QRegularExpression row(QStringLiteral("^ *%1 +%2 +(\\d+)$").arg(i + 1).arg(QRegularExpression::escape(title)),
                                   QRegularExpression::MultilineOption);
      const QRegularExpressionMatch match = row.match(contents);
      QVERIFY2(match.hasMatch(), qPrintable(title + QStringLiteral(" is not in the contents of the PDF:\n") + contents));
      const QString page = pages.value(match.captured(1).toInt() - 1).trimmed();
      QVERIFY2(page.startsWith(title), qPrintable(title + QStringLiteral(" is not on its page: ") + page.left(80)));
    }
  }

  void markdown_namesHeadingsApart() {
    const help::Page page = help::pageFromMarkdown("# A & B: c_d\n\n## Same\n\n## Same\n\n[x](other.md#y) [z](https://a.b/c.md) <b>no</b>\n");
    QCOMPARE(page.title, QStringLiteral("A & B: c_d"));
    QCOMPARE(page.headings[0].anchor, QStringLiteral("a--b-c_d"));
    QCOMPARE(page.headings[2].anchor, QStringLiteral("same-1"));
    QVERIFY(page.body.contains(QStringLiteral("href=\"other.html#y\"")));
    QVERIFY(page.body.contains(QStringLiteral("href=\"https://a.b/c.md\"")));
    QVERIFY(page.body.contains(QStringLiteral("&lt;b&gt;no")));
  }

  void missingPagesAndPictures_areErrorsThatNameThem() {
    const QTemporaryDir folder;
    QVERIFY(!help::Manual::open(folder.path()));
    const auto put = [&](const char* name, const QByteArray& text) {
      QFile file(folder.filePath(QLatin1String(name)));
      QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    };
    put("index.md", "# M\n\n- [One](one.md)\n");
    put("one.md", "# One\n\n![p](pictures/none.png)\n");
    const Result<help::Manual> manual = help::Manual::open(folder.path());
    QVERIFY(manual);
    const Result<void> html = help::writeManualHtml(*manual, folder.filePath(QStringLiteral("out")), {});
    QVERIFY(!html && html.error().message().find("none.png") != std::string::npos);
    const Result<void> pdf = help::writeManualPdf(*manual, folder.filePath(QStringLiteral("m.pdf")), {});
    QVERIFY(!pdf && pdf.error().message().find("none.png") != std::string::npos);
    QVERIFY(!QFileInfo::exists(folder.filePath(QStringLiteral("m.pdf"))));
    QVERIFY(!manual->page(QStringLiteral("two")));
  }

private:
  help::Manual manual_;
  std::map<QString, help::Page> pages_;
  QString commands_;
};

QTEST_MAIN(TestManual)
#include "tst_manual.moc"
