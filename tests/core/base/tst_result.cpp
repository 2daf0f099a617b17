#include "core/base/expect.h"
#include "core/base/result.h"

#include <QTest>

using namespace vp;

namespace {

Result<int> half(int value) {
  if (value % 2 != 0) {
    return fail(Errc::OutOfRange, "must be even", "line 3");
  }
  return value / 2;
}

Result<std::string> text(int value) {
  const Result<int> result = half(value);
  if (!result) {
    return forward(result);
  }
  return std::to_string(*result);
}

}  // namespace

class TestResult : public QObject {
  Q_OBJECT

private slots:
  void success_carriesTheValue() { QCOMPARE(text(8).value(), std::string("4")); }

  void failure_isForwardedWhole() {
    const Result<std::string> result = text(7);
    QVERIFY(!result);
    QVERIFY(result.error().code == Errc::OutOfRange);
    QCOMPARE(result.error().message(), std::string("line 3: must be even"));
  }

  void message_withoutPlace_isTheSentence() { QCOMPARE((Error{Errc::BadFile, "is empty", ""}).message(), std::string("is empty")); }

  void expect_whenBroken_throwsAndNamesThePlace() {
    VP_EXPECT(1 + 1 == 2);
    QVERIFY_EXCEPTION_THROWN(VP_EXPECT(1 + 1 == 3), LogicError);
    try {
      VP_EXPECT(1 + 1 == 3);
    } catch (const LogicError& error) {
      QVERIFY(std::string(error.what()).find("1 + 1 == 3") != std::string::npos);
      QVERIFY(std::string(error.what()).find("tst_result.cpp") != std::string::npos);
    }
  }
};

QTEST_APPLESS_MAIN(TestResult)
#include "tst_result.moc"
