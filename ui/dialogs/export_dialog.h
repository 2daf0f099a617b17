#pragma once

#include <QDialog>
#include <QString>
#include <QStringList>

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace vp::dialogs {

/** Asks for the formats that a plan is handed on in, a folder and a pattern of names; shows the names that this gives, which of
 *  them are there already and are kept as a copy, and what each chosen format loses. */
class ExportDialog : public QDialog {
  Q_OBJECT

public:
  ExportDialog(QString mission, const QString& folder, const QStringList& chosen, QWidget* parent = nullptr);

  [[nodiscard]] QStringList formats() const;
  [[nodiscard]] QString folder() const;
  [[nodiscard]] QString pattern() const;
  /** The lines of the preview: file names, and what is lost. */
  [[nodiscard]] QString preview() const;

private:
  void chooseFolder();
  void showPreview();

  QString mission_;
  QListWidget* list_ = nullptr;
  QLineEdit* folder_ = nullptr;
  QLineEdit* pattern_ = nullptr;
  QLabel* preview_ = nullptr;
  QPushButton* export_ = nullptr;
};

}  // namespace vp::dialogs
