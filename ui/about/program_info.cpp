#include "ui/about/program_info.h"

#include "core/terrain/library_version.h"
#include "ui/scene3d/library_version.h"

#include <QCoreApplication>
#include <QStringList>

#include <string>

namespace vp::about {
namespace {

QString text(const std::string& bytes) {
  return QString::fromStdString(bytes);
}

struct Words {
  Q_DECLARE_TR_FUNCTIONS(vp::about::Words)
};

}  // namespace

QList<Library> libraries() {
  // Licences: /usr/share/doc/PACKAGE/copyright of Debian 12.
  return {
      {QStringLiteral("Boost"), {}, QStringLiteral("BSL-1.0")},
      {QStringLiteral("CLI11"), {}, QStringLiteral("BSD-3-Clause")},
      {QStringLiteral("Eigen"), {}, QStringLiteral("MPL-2.0")},
      {QStringLiteral("fmt"), {}, QStringLiteral("MIT")},
      {QStringLiteral("GDAL"), text(terrain::gdalVersion()), QStringLiteral("MIT")},
      {QStringLiteral("GeographicLib"), {}, QStringLiteral("MIT")},
      {QStringLiteral("libexpected"), {}, QStringLiteral("CC0-1.0")},
      {QStringLiteral("MD4C"), {}, QStringLiteral("MIT")},
      {QStringLiteral("nlohmann-json"), {}, QStringLiteral("MIT")},
      {QStringLiteral("NLopt"), {}, QStringLiteral("LGPL-2.1-or-later")},
      {QStringLiteral("OpenSceneGraph"), scene3d::openSceneGraphVersion(), QStringLiteral("OSGPL (LGPL-2.1 with exceptions)")},
      {QStringLiteral("OpenSSL"), {}, QStringLiteral("Apache-2.0")},
      {QStringLiteral("PROJ"), text(terrain::projVersion()), QStringLiteral("MIT")},
      {QStringLiteral("pugixml"), {}, QStringLiteral("MIT")},
      {QStringLiteral("Qt"), QString::fromLatin1(qVersion()), QStringLiteral("LGPL-3.0-only OR GPL-2.0-only OR GPL-3.0-only")},
      {QStringLiteral("zlib"), {}, QStringLiteral("Zlib")},
  };
}

QList<DataSource> dataSources() {
  return {
      {QStringLiteral("Copernicus GLO-30"), Words::tr("terrain, fetched when you ask for it"),
       QStringLiteral("© DLR e.V. 2010-2014 and © Airbus Defence and Space GmbH 2014-2018, provided under COPERNICUS by the European Union and ESA; "
                      "all rights reserved")},
      {QStringLiteral("OurAirports"), Words::tr("airfields, fetched when you ask for them"), Words::tr("public domain")},
      {QStringLiteral("WMM2025"), Words::tr("magnetic variation 2025 to 2029, by NOAA NCEI and the British Geological Survey"),
       Words::tr("public domain")},
      {Words::tr("Aircraft profiles"), Words::tr("each number with its source in the profile"), programLicence()},
      {Words::tr("Bundled maps"), Words::tr("made-up country, the project's own"), programLicence()},
  };
}

QString programLicence() {
  return QStringLiteral("GPL-3.0-or-later");
}

QString versionText(const QString& programAndVersion, const QString& commit) {
  QStringList lines{
      QStringLiteral("%1 (commit %2)").arg(programAndVersion, commit),
      Words::tr("Licence %1; no warranty. Plans are as good as their inputs: the pilot checks those, and remains in command.").arg(programLicence()),
      QString(), Words::tr("Libraries:")};
  for (const Library& library : libraries()) {
    const QString name = library.version.isEmpty() ? library.name : library.name + QLatin1Char(' ') + library.version;
    lines << QStringLiteral("  %1  %2").arg(name, -22).arg(library.licence);
  }
  lines << QString() << Words::tr("Data:");
  for (const DataSource& source : dataSources()) {
    lines << QStringLiteral("  %1  %2; %3").arg(source.name, -22).arg(source.use, source.rights);
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace vp::about
