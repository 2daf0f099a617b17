#include "core/base/plain_text.h"

#include <QTest>

using vp::plainText;

class TestPlainText : public QObject {
  Q_OBJECT
private Q_SLOTS:
  void plainText_keepsWordsOfEveryScript() {
    const std::string words = "Zürich, Žďár, Αθήνα, 東京, 🛩 30°";
    QCOMPARE(plainText(words), words);
    QCOMPARE(plainText(""), std::string());
  }
  void controlCharacters_becomeBlanks() {
    QCOMPARE(plainText("a\x1b[2Jb\nc\x7f"), std::string("a [2Jb c "));
    QCOMPARE(plainText("a\xC2\x9B"
                       "31mb"),
             std::string("a 31mb"));  // CSI as one character
    QCOMPARE(plainText(std::string_view("a\0b", 3)), std::string("a b"));
  }
  void whatIsNoUtf8_isReplaced_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("lone follower") << QByteArray("\x80");
    QTest::newRow("cut short") << QByteArray("\xE2\x82");
    QTest::newRow("overlong") << QByteArray("\xC0\xAF");
    QTest::newRow("overlong of three") << QByteArray("\xE0\x80\x80");
    QTest::newRow("surrogate") << QByteArray("\xED\xA0\x80");
    QTest::newRow("beyond the last") << QByteArray("\xF4\x90\x80\x80");
  }
  void whatIsNoUtf8_isReplaced() {
    QFETCH(QByteArray, bytes);
    std::string expected = "x";
    for (int i = 0; i < bytes.size(); ++i) {
      expected += "\xEF\xBF\xBD";
    }
    QCOMPARE(plainText("x" + bytes.toStdString() + "y"), expected + "y");
  }
  void longText_isCutBetweenCharacters() {
    QCOMPARE(plainText("abcdef", 6), std::string("abcdef"));
    QCOMPARE(plainText("abcdefg", 6), std::string("abcdef..."));
    QCOMPARE(plainText("aüb", 2), std::string("a..."));
  }
};

QTEST_APPLESS_MAIN(TestPlainText)
#include "tst_plain_text.moc"
