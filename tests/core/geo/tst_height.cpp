#include "core/geo/height.h"
#include "core/geo/pose.h"

#include <QTest>

#include <type_traits>

using namespace vp;
using namespace vp::geo;
using namespace vp::literals;

template <typename A, typename B>
concept Subtractable = requires(A a, B b) {
  a - b;
};

static_assert(Subtractable<HeightMsl, HeightMsl> && !Subtractable<HeightMsl, HeightAgl>);
static_assert(std::is_same_v<decltype(HeightMsl{} - HeightMsl{}), Length>);
static_assert(!std::is_convertible_v<HeightAgl, HeightMsl> && !std::is_constructible_v<HeightMsl, double>);

class TestHeight : public QObject {
  Q_OBJECT

private slots:
  void differences_areLengths() {
    const HeightMsl ground = HeightMsl::fromMetres(1200.0);
    QCOMPARE((ground + 100.0_m - ground).si(), 100.0);
    QCOMPARE((ground - 200.0_m).metres(), 1000.0);
    QVERIFY(ground < ground + 1.0_ft);
  }

  void feet_areInternational() { QCOMPARE(HeightMsl::fromMetres(3048.0).feet(), 10'000.0); }

  void box_growsFromEmptyAndContainsItsEdges() {
    Box box;
    QVERIFY(box.isEmpty());
    box.add({10.0, -5.0});
    QVERIFY(!box.isEmpty() && box.contains({10.0, -5.0}) && !box.contains({10.0, -4.999}));
    box.add({-2.0, 7.0});
    QVERIFY(box.contains({-2.0, -5.0}) && box.contains({10.0, 7.0}) && !box.contains({10.001, 0.0}));
    QVERIFY(box.grown(1.0).contains({11.0, 8.0}) && !box.grown(1.0).contains({11.1, 8.0}));
  }
};

QTEST_APPLESS_MAIN(TestHeight)
#include "tst_height.moc"
