// Text from foreign files is shown as it is: no label, message box or tool tip reads what tags in it name.
#include "ui/style/plain_labels.h"

#include <QApplication>
#include <QLabel>
#include <QMessageBox>
#include <QTemporaryDir>
#include <QTest>
#include <QToolTip>

#include <csignal>
#include <sys/stat.h>
#include <unistd.h>

using namespace vp;

class TestPlainLabels : public QObject {
  Q_OBJECT
  QTemporaryDir folder_;
  QString trap_;  // a text whose picture is a pipe that nobody writes into: reading it never ends

private slots:
  void initTestCase() {
    style::keepTextPlain(*qApp);
    style::keepTextPlain(*qApp);
    QVERIFY(folder_.isValid());
    const QString pipe = folder_.filePath(QStringLiteral("pipe"));
    QCOMPARE(mkfifo(pipe.toLocal8Bit().constData(), 0600), 0);
    trap_ = QStringLiteral("<b>T01</b><img src=\"%1\"><link rel=\"stylesheet\" href=\"%1\">").arg(pipe);
    QVERIFY(Qt::mightBeRichText(trap_));
    alarm(20);  // ends the program if it hangs in the pipe
  }
  void cleanupTestCase() { alarm(0); }

  void label_showsTagsAsTheyAre() {
    QLabel label(trap_);
    label.setWordWrap(true);
    const QSize size = label.sizeHint();
    label.show();
    QVERIFY(QTest::qWaitForWindowExposed(&label));
    QCOMPARE(label.textFormat(), Qt::PlainText);
    QCOMPARE(label.text(), trap_);
    QVERIFY(size.isValid());
    label.setText(trap_ + QLatin1Char('2'));  // later too
    label.adjustSize();
    QCOMPARE(label.textFormat(), Qt::PlainText);
  }

  void messageBox_showsTagsAsTheyAre() {
    QMessageBox box(QMessageBox::Warning, QStringLiteral("Title"), trap_, QMessageBox::Ok);
    box.setInformativeText(trap_);
    box.show();
    QVERIFY(QTest::qWaitForWindowExposed(&box));
    int checked = 0;
    for (const QLabel* label : box.findChildren<QLabel*>()) {
      if (label->text() == trap_) {
        QCOMPARE(label->textFormat(), Qt::PlainText);
        ++checked;
      }
    }
    QCOMPARE(checked, 2);
  }

  void toolTip_showsTagsAsTheyAre() {
    QWidget window;
    window.resize(200, 100);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QToolTip::showText(window.mapToGlobal(QPoint(10, 10)), trap_, &window);
    const QLabel* tip = nullptr;
    for (const QWidget* widget : QApplication::topLevelWidgets()) {
      if (widget->inherits("QTipLabel")) {
        tip = qobject_cast<const QLabel*>(widget);
      }
    }
    QVERIFY(tip != nullptr);
    QCOMPARE(tip->textFormat(), Qt::PlainText);
    QCOMPARE(tip->text(), trap_);
  }

  void richText_thatTheProgramWrites_staysRich() {
    QLabel label;
    label.setTextFormat(Qt::RichText);
    label.setText(QStringLiteral("<b>Keys</b>"));
    label.show();
    QVERIFY(QTest::qWaitForWindowExposed(&label));
    QCOMPARE(label.textFormat(), Qt::RichText);
  }
};

QTEST_MAIN(TestPlainLabels)
#include "tst_plain_labels.moc"
