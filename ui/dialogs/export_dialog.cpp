#include "ui/dialogs/export_dialog.h"

#include "core/formats/exports/export_formats.h"
#include "ui/exports/export_files.h"
#include "ui/style/core_text.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace vp::dialogs {
namespace {

constexpr int kNameRole = Qt::UserRole;
constexpr QSize kSize{760, 620};

QListWidget* makeList(const QStringList& chosen) {
  auto* list = new QListWidget;
  list->setObjectName(QStringLiteral("exportFormats"));
  list->setAccessibleName(ExportDialog::tr("Formats"));
  for (const formats::ExportFormat& format : formats::exportFormats()) {
    const QString name = QString::fromStdString(format.name);
    auto* item = new QListWidgetItem(ExportDialog::tr("%1 (.%2)").arg(style::coreText(format.what), QString::fromStdString(format.extension)), list);
    item->setData(kNameRole, name);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(chosen.contains(name) ? Qt::Checked : Qt::Unchecked);
    item->setToolTip(format.loses.empty() ? ExportDialog::tr("Nothing of the plan is lost") : style::coreText(format.loses));
  }
  return list;
}

}  // namespace

ExportDialog::ExportDialog(QString mission, const QString& folder, const QStringList& chosen, QWidget* parent)
    : QDialog(parent), mission_(std::move(mission)) {
  setWindowTitle(tr("Export the plan"));
  setObjectName(QStringLiteral("exportDialog"));
  list_ = makeList(chosen);
  folder_ = new QLineEdit(QDir::toNativeSeparators(folder));
  folder_->setObjectName(QStringLiteral("exportFolder"));
  auto* browse = new QPushButton(tr("&Browse…"));
  browse->setAutoDefault(false);
  auto* place = new QHBoxLayout;
  place->addWidget(folder_, 1);
  place->addWidget(browse);
  pattern_ = new QLineEdit(QString::fromLatin1(exports::kNamePattern));
  pattern_->setObjectName(QStringLiteral("exportPattern"));
  pattern_->setToolTip(tr("{mission}, {format} and {part} are replaced"));
  auto* form = new QFormLayout;
  auto* folderLabel = new QLabel(tr("F&older"));
  folderLabel->setBuddy(folder_);
  form->addRow(folderLabel, place);
  form->addRow(tr("&Names"), pattern_);
  preview_ = new QLabel;
  preview_->setObjectName(QStringLiteral("exportPreview"));
  preview_->setWordWrap(true);
  preview_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  preview_->setMargin(6);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setWidget(preview_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  export_ = buttons->addButton(tr("&Export"), QDialogButtonBox::AcceptRole);
  export_->setObjectName(QStringLiteral("exportNow"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(list_, 3);
  column->addLayout(form);
  column->addWidget(scroll, 2);
  column->addWidget(buttons);
  connect(browse, &QPushButton::clicked, this, &ExportDialog::chooseFolder);
  connect(list_, &QListWidget::itemChanged, this, &ExportDialog::showPreview);
  connect(folder_, &QLineEdit::textChanged, this, &ExportDialog::showPreview);
  connect(pattern_, &QLineEdit::textChanged, this, &ExportDialog::showPreview);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  resize(kSize);
  showPreview();
}

QStringList ExportDialog::formats() const {
  QStringList names;
  for (int i = 0; i < list_->count(); ++i) {
    if (list_->item(i)->checkState() == Qt::Checked) {
      names.append(list_->item(i)->data(kNameRole).toString());
    }
  }
  return names;
}

QString ExportDialog::folder() const {
  return QDir::fromNativeSeparators(folder_->text());
}

QString ExportDialog::pattern() const {
  return pattern_->text();
}

QString ExportDialog::preview() const {
  return preview_->text();
}

void ExportDialog::chooseFolder() {
  const QString chosen = QFileDialog::getExistingDirectory(this, tr("Folder for the exported files"), folder());
  if (!chosen.isEmpty()) {
    folder_->setText(QDir::toNativeSeparators(chosen));
  }
}

void ExportDialog::showPreview() {
  exports::PreparedExport planned;  // names alone
  for (const QString& name : formats()) {
    planned.files.push_back({vp::formats::findExportFormat(name.toStdString()), 1, 1, {}});
  }
  const std::vector<std::string> paths = exports::pathsOf(planned, folder().toStdString(), pattern().toStdString(), mission_.toStdString());
  QStringList lines;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const QFileInfo file(QString::fromStdString(paths[i]));
    QString line = file.fileName();
    if (file.exists()) {
      line += tr(" (is there; the old one is kept as %1)").arg(file.fileName() + QLatin1Char('~'));
    }
    const QString loses = style::coreText(planned.files[i].format->loses);
    lines.append(loses.isEmpty() ? line : tr("%1: %2").arg(line, loses));
  }
  const bool isFolder = QFileInfo(folder()).isDir();
  if (!isFolder) {
    lines.prepend(tr("There is no folder of this name."));
  }
  preview_->setTextFormat(Qt::PlainText);
  preview_->setText(lines.isEmpty() ? tr("Choose at least one format.") : lines.join(QLatin1Char('\n')));
  export_->setEnabled(isFolder && !paths.empty());
}

}  // namespace vp::dialogs
