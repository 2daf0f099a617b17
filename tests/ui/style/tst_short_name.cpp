// Names as drawings write them: short, and still told apart.
#include "ui/style/short_name.h"

#include <QTest>

using vp::style::kLongestName;
using vp::style::shortName;

class TestShortName : public QObject {
  Q_OBJECT

private slots:
  void shortNames_stayAsTheyAre() {
    for (const QString& name : {QString(), QStringLiteral("T01"), QStringLiteral("Castle & Lake"), QString(kLongestName, QLatin1Char('x'))}) {
      QCOMPARE(shortName(name), name);
    }
    QCOMPARE(shortName(QStringLiteral(" two \n lines ")), QStringLiteral("two lines"));
  }

  void longNames_keepBothEnds() {
    const QString glacier = QStringLiteral("Wolkenspitze north-eastern glacier tongue, observation station %1");
    QCOMPARE(shortName(glacier.arg(QStringLiteral("07"))), QStringLiteral("Wolkenspitze…n station 07"));
    QVERIFY(shortName(glacier.arg(7)) != shortName(glacier.arg(8)));
    for (int length = 0; length < 200; ++length) {
      QVERIFY(shortName(QString(length, QLatin1Char('W'))).size() <= kLongestName);
    }
  }

  void longNames_areCutBetweenLettersOnly() {
    const QString accent = QStringLiteral("e\u0301");           // e with an acute accent, in two
    const QString mountain = QString::fromUcs4(U"\U0001F3D4");  // beyond the first plane: two halves
    for (const QString& letter : {accent, mountain}) {
      const QString cut = shortName(letter.repeated(60));
      const QStringList parts = cut.split(QChar(0x2026));
      QCOMPARE(parts.size(), 2);
      for (const QString& part : parts) {
        QVERIFY(!part.isEmpty());
        QCOMPARE(QString(part).remove(letter), QString());
      }
    }
  }
};

QTEST_APPLESS_MAIN(TestShortName)
#include "tst_short_name.moc"
