#include "ui/about/about_dialog.h"

#include "ui/about/program_info.h"

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace vp::about {
namespace {

constexpr int kIconSize = 64;         // px
constexpr QSize kTextSize{620, 300};  // px: the longest licence on one line
constexpr const char* kCommit = "commit";

QString applicationCommit() {
  return QCoreApplication::instance()->property(kCommit).toString();
}

QString row(const QStringList& cells) {
  QString html = QStringLiteral("<tr>");
  for (const QString& cell : cells) {
    html += QStringLiteral("<td style=\"padding-right: 12px\">%1</td>").arg(cell.toHtmlEscaped());
  }
  return html + QStringLiteral("</tr>");
}

}  // namespace

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("aboutDialog"));
  setWindowTitle(tr("About Volplane"));
  const QString commit = applicationCommit();
  const QString version = QCoreApplication::applicationVersion();
  auto* head = new QLabel(
      tr("<h3>Volplane %1</h3>%2<p>Plans tours from every point of which the aircraft can glide to a runway if the engine stops.</p>"
         "<p>The promise is as good as its inputs: the wind of the mission, the polar in the aircraft profile, the terrain file and the runway "
         "list. The pilot checks those, and remains in command.</p><p>Licence: %3. No warranty.</p>")
          .arg(version.toHtmlEscaped(), commit.isEmpty() ? QString() : tr("Commit %1").arg(commit.toHtmlEscaped()), programLicence()),
      this);
  head->setWordWrap(true);
  head->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);

  QString html = QStringLiteral("<h4>%1</h4><table>").arg(tr("Data"));
  for (const DataSource& source : dataSources()) {
    html += row({source.name, source.use, source.rights});
  }
  html += QStringLiteral("</table><h4>%1</h4><table>").arg(tr("Libraries"));
  for (const Library& library : libraries()) {
    html += row({library.name, library.version, library.licence});
  }
  auto* details = new QTextBrowser(this);
  details->setObjectName(QStringLiteral("aboutDetails"));
  details->setHtml(html + QStringLiteral("</table>"));
  details->setMinimumSize(kTextSize);

  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  auto* copy = buttons->addButton(tr("&Copy all"), QDialogButtonBox::ActionRole);
  copy->setAutoDefault(false);
  copy->setObjectName(QStringLiteral("aboutCopy"));
  copy->setToolTip(tr("Version, libraries and data sources as text, for a report of a fault"));
  connect(copy, &QPushButton::clicked, this, [] { QGuiApplication::clipboard()->setText(plainText()); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

  auto* top = new QHBoxLayout;
  if (const QIcon icon = QApplication::windowIcon(); !icon.isNull()) {
    auto* picture = new QLabel(this);
    picture->setPixmap(icon.pixmap(kIconSize));
    picture->setAlignment(Qt::AlignTop);
    top->addWidget(picture);
  }
  top->addWidget(head, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(top);
  layout->addWidget(details, 1);
  layout->addWidget(buttons);
}

QString AboutDialog::plainText() {
  return versionText(QStringLiteral("volplane ") + QCoreApplication::applicationVersion(), applicationCommit());
}

}  // namespace vp::about
