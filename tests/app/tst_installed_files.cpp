// What an installation holds, and what a desktop makes of it: programs and resources find each other under any prefix,
// missions and plans are recognised by name and by content, icons have their sizes.
#include "tests/support/cli_run.h"

#include <QDir>
#include <QDirIterator>
#include <QImage>
#include <QMimeDatabase>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace vp::test;

namespace {

const QString kSource = QStringLiteral(VOLPLANE_SOURCE_DIR);
const QStringList kTypes{QStringLiteral("application/x-volplane-mission"), QStringLiteral("application/x-volplane-plan")};

QString typeOf(const QString& file) {
  return kTypes[file.endsWith(QStringLiteral(".vpm")) ? 0 : 1];
}

QString resource(const char* name) {
  return QString::fromUtf8(readAll(kSource + QStringLiteral("/resources/desktop/") + QLatin1String(name)));
}

}  // namespace

class TestInstalledFiles : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    QVERIFY(prefix_.isValid());
    QProcess install;
    install.setProcessChannelMode(QProcess::MergedChannels);
    install.start(QStringLiteral(VOLPLANE_CMAKE),
                  {QStringLiteral("--install"), QStringLiteral(VOLPLANE_BIN_DIR "/.."), QStringLiteral("--prefix"), prefix_.path()});
    QVERIFY(install.waitForFinished(120'000));
    QVERIFY2(install.exitCode() == 0, install.readAll().constData());
    // the types of the desktop, looked up as in a home folder
    QVERIFY(QDir().mkpath(prefix_.filePath(QStringLiteral("share/mime/packages"))));
    qputenv("XDG_DATA_HOME", QFile::encodeName(prefix_.filePath(QStringLiteral("share"))));
    const QString update = QStandardPaths::findExecutable(QStringLiteral("update-mime-database"));
    if (!update.isEmpty()) {
      QCOMPARE(QProcess::execute(update, {prefix_.filePath(QStringLiteral("share/mime"))}), 0);
    }
  }

  void installation_underAnyPrefix_isComplete() {
    const QStringList expected{"bin/volplane",
                               "bin/volplane-cli",
                               "share/applications/volplane.desktop",
                               "share/doc/volplane/NEWS.gz",
                               "share/doc/volplane/changelog.gz",
                               "share/doc/volplane/copyright",
                               "share/icons/hicolor/16x16/apps/volplane.png",
                               "share/icons/hicolor/512x512/mimetypes/application-x-volplane-plan.png",
                               "share/icons/hicolor/scalable/apps/volplane.svg",
                               "share/man/man1/volplane-cli.1.gz",
                               "share/man/man1/volplane.1.gz",
                               "share/metainfo/org.volplane.Volplane.metainfo.xml",
                               "share/mime/packages/volplane.xml",
                               "share/volplane/aircraft/cessna172-handbook.json",
                               "share/volplane/maps/alpine-airports.csv",
                               "share/volplane/maps/alpine-n10.vpm",
                               "share/volplane/maps/alpine-n10.vpp",
                               "share/volplane/maps/alpine.tif",
                               "share/volplane/schema/mission.schema.json"};
    for (const QString& file : expected) {
      QVERIFY2(QFileInfo(prefix_.filePath(file)).size() > 0, qPrintable(file));
    }
    QDirIterator sources(prefix_.path(), {QStringLiteral("*.cpp"), QStringLiteral("*.h"), QStringLiteral("CMake*")}, QDir::Files,
                         QDirIterator::Subdirectories);
    QVERIFY2(!sources.hasNext(), qPrintable(sources.next()));
  }

  void programs_underAnyPrefix_readTheResourcesBesideThem() {
    const QString aircraft = prefix_.filePath(QStringLiteral("share/volplane/aircraft/"));
    QVERIFY(QFile::copy(aircraft + QStringLiteral("cessna172-handbook.json"), aircraft + QStringLiteral("only-in-this-prefix.json")));
    QProcess program;
    program.start(prefix_.filePath(QStringLiteral("bin/volplane-cli")),
                  {QStringLiteral("plan"), prefix_.filePath(QStringLiteral("share/volplane/maps/mountain-n5.vpm")), QStringLiteral("-o"),
                   prefix_.filePath(QStringLiteral("x.vpp")), QStringLiteral("--aircraft"), QStringLiteral("no-such-aircraft")});
    QVERIFY(program.waitForFinished());
    QCOMPARE(program.exitCode(), 2);
    const QByteArray words = program.readAllStandardError();
    QVERIFY2(words.contains("only-in-this-prefix"), words.constData());
  }

  void bundledFiles_underTheDesktopsTypes_areRecognisedByNameAndByContent() {
    const QMimeDatabase types;
    if (!types.mimeTypeForName(QStringLiteral("application/json")).isValid()) {
      QSKIP("there are no types of files on this machine (package shared-mime-info)");
    }
    const QDir maps(kSource + QStringLiteral("/maps"));
    const QStringList files = maps.entryList({QStringLiteral("*.vpm"), QStringLiteral("*.vpp")}, QDir::Files);
    QVERIFY(files.size() > 9);
    for (const QString& file : files) {
      QCOMPARE(types.mimeTypeForFile(maps.filePath(file), QMimeDatabase::MatchExtension).name(), typeOf(file));
      QCOMPARE(types.mimeTypeForData(readAll(maps.filePath(file)).left(4096)).name(), typeOf(file));
      QVERIFY(types.mimeTypeForFile(maps.filePath(file)).inherits(QStringLiteral("application/json")));
    }
    QVERIFY(!kTypes.contains(types.mimeTypeForData(QByteArray("{\n  \"format\": \"volplane-aircraft\",\n")).name()));
    QVERIFY(!kTypes.contains(types.mimeTypeForData(QByteArray("{\"note\": \"about a volplane-mission\"}")).name()));
  }

  void desktopEntry_underItsOtherFiles_namesTheSameTypesAndIcons() {
    const QString entry = resource("volplane.desktop");
    const QString meta = resource("org.volplane.Volplane.metainfo.xml.in");
    const QString types = resource("volplane.xml");
    for (const QString& type : kTypes) {
      QVERIFY(entry.contains(QRegularExpression(QStringLiteral("^MimeType=.*%1;").arg(type), QRegularExpression::MultilineOption)));
      QVERIFY(meta.contains(QStringLiteral("<mediatype>%1</mediatype>").arg(type)));
      QVERIFY(types.contains(QStringLiteral("type=\"%1\"").arg(type)));
      QVERIFY(QFile::exists(kSource + QStringLiteral("/resources/desktop/%1.svg").arg(QString(type).replace(QLatin1Char('/'), QLatin1Char('-')))));
    }
    QVERIFY(entry.contains(QStringLiteral("\nExec=volplane %F\n")) && entry.contains(QStringLiteral("\nIcon=volplane\n")));
    QVERIFY(meta.contains(QStringLiteral("<launchable type=\"desktop-id\">volplane.desktop</launchable>")));
  }

  void icons_underEachSize_areOfThatSizeAndNotEmpty() {
    const QDir icons(prefix_.filePath(QStringLiteral("share/icons/hicolor")));
    int count = 0;
    for (const QString& size : icons.entryList({QStringLiteral("*x*")}, QDir::Dirs)) {
      for (const char* name : {"apps/volplane", "mimetypes/application-x-volplane-mission", "mimetypes/application-x-volplane-plan"}) {
        const QImage image(icons.filePath(QStringLiteral("%1/%2.png").arg(size, QLatin1String(name))));
        QCOMPARE(image.size(), QSize(size.section(QLatin1Char('x'), 0, 0).toInt(), size.section(QLatin1Char('x'), 1).toInt()));
        QCOMPARE(image.pixelColor(0, 0).alpha(), 0);
        QCOMPARE(image.pixelColor(image.width() / 2, image.height() / 2).alpha(), 255);
        ++count;
      }
    }
    QCOMPARE(count, 27);  // nine sizes
  }

private:
  QTemporaryDir prefix_;
};

QTEST_GUILESS_MAIN(TestInstalledFiles)
#include "tst_installed_files.moc"
