#pragma once

#include <QList>
#include <QString>

namespace vp::about {

/** A library that the program runs with. */
struct Library {
  QString name;
  QString version;  ///< the one in use, not the one it was built with; empty where the library does not say it
  QString licence;  ///< SPDX expression where there is one
};

/** Data that the program holds or fetches. */
struct DataSource {
  QString name;
  QString use;     ///< what it is used for
  QString rights;  ///< licence or the notice that its owner asks for
};

/** The libraries of the program with their versions and licences, by name. */
QList<Library> libraries();

/** Where data come from that the program holds (magnetic model, profiles, maps) or fetches when asked. */
QList<DataSource> dataSources();

/** SPDX expression of the program's own licence. */
QString programLicence();

/** What `--version` prints, without a line end: first line "PROGRAM VERSION (commit COMMIT)", then licence, libraries and data sources.
 *  @param programAndVersion  for example "volplane-cli 0.1.0" */
QString versionText(const QString& programAndVersion, const QString& commit);

}  // namespace vp::about
