#pragma once
// What an operator does with a window beside clicking: drop files on it and answer its dialogs.

#include <QAbstractButton>
#include <QApplication>
#include <QCoreApplication>
#include <QDialog>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QPoint>
#include <QPointF>
#include <QPointer>
#include <QTest>
#include <QTimer>
#include <QUrl>
#include <QWidget>

#include <functional>
#include <memory>

namespace vp::test {

/// Lets go of files above a window, as from a file manager.
inline void drop(QWidget& window, const QStringList& files) {
  QMimeData data;
  QList<QUrl> urls;
  for (const QString& file : files) {
    urls << QUrl::fromLocalFile(file);
  }
  data.setUrls(urls);
  QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&window, &enter);
  QVERIFY(enter.isAccepted());
  QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&window, &event);
}

/// Types a file name into the next file dialog and presses Enter, until that dialog is gone; later ones are not its business.
inline void answerFileDialog(const QString& path) {
  auto* timer = new QTimer(qApp);
  auto answered = std::make_shared<QPointer<QFileDialog>>();
  auto seen = std::make_shared<bool>(false);
  QObject::connect(timer, &QTimer::timeout, timer, [timer, path, answered, seen] {
    if (!*seen) {
      *answered = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      *seen = !answered->isNull();
    }
    auto* name = answered->isNull() || !(*answered)->isVisible() ? nullptr : (*answered)->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    if (name != nullptr) {
      name->setText(path);
      QTest::keyClick(name, Qt::Key_Return);
    } else if (*seen) {
      timer->stop();
      timer->deleteLater();
    }
  });
  timer->start(50);
}

/// Presses the button of the next message box whose text holds `text`.
inline void answerMessageBox(const QString& text) {
  auto* timer = new QTimer(qApp);
  QObject::connect(timer, &QTimer::timeout, timer, [timer, text] {
    if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
      for (QAbstractButton* button : box->buttons()) {
        if (button->text().contains(text)) {
          timer->deleteLater();
          button->click();
          return;
        }
      }
    }
  });
  timer->start(20);
}

/// Waits for the dialog of a name and does something in it.
inline void inDialog(const QString& name, const std::function<void(QDialog&)>& act) {
  auto* timer = new QTimer(qApp);
  QObject::connect(timer, &QTimer::timeout, timer, [timer, name, act] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (dialog != nullptr && dialog->objectName() == name) {
      timer->deleteLater();
      timer->stop();
      act(*dialog);
    }
  });
  timer->start(20);
}

}  // namespace vp::test
