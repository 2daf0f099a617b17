// The ranked list of runways: every line by a known answer, order, what is not known, what is out of range.
#include "core/emergency/planners.h"
#include "core/emergency/runway_ranking.h"
#include "core/emergency/verified_answer.h"
#include "core/risk/people_under.h"
#include "tests/support/weather_cases.h"

#include <QTest>

#include <cmath>
#include <string>

using namespace vp;
using namespace vp::emergency;

namespace {

const RankingLine& lineOf(const RankedRunway& runway, const std::string& name) {
  for (const RankingLine& line : runway.lines) {
    if (line.name == name) {
      return line;
    }
  }
  static const RankingLine kNone{"none", 0.0, "", false, -1.0, "there is no such line"};
  return kNone;
}

/// The line's value, its risk and a part of its sentence.
bool says(const RankedRunway& runway, const std::string& name, double value, double logRisk, const std::string& part) {
  const RankingLine& line = lineOf(runway, name);
  if (std::abs(line.value - value) <= 1e-6 * std::max(1.0, std::abs(value)) && std::abs(line.logRisk - logRisk) <= 1e-9 &&
      line.sentence.find(part) != std::string::npos) {
    return true;
  }
  qWarning("%s: %g, %g, %s", name.c_str(), line.value, line.logRisk, line.sentence.c_str());
  return false;
}

/// Three runways on flat ground: A behind weather, B clear of it but short, narrow and of grass, C out of range.
LandingRequest threeRunways() {
  std::vector<mission::SiteInFrame> sites{test::placedSite("A/09", {6000.0, 0.0, 0.0}, 0.0),
                                          test::placedSite("B/36", {0.0, 6000.0, 0.5 * Angle::kPi}, 0.0),
                                          test::placedSite("C/09", {19000.0, 19000.0, 0.0}, 0.0)};
  sites[0].site.length = Length::fromSi(2000.0);
  sites[0].site.width = Length::fromSi(30.0);
  sites[0].site.lighted = true;
  sites[1].site.length = Length::fromSi(500.0);
  sites[1].site.width = Length::fromSi(9.0);
  sites[1].site.surface = mission::Surface::Grass;
  sites[2].site.length = std::nullopt;
  sites[2].site.surface = mission::Surface::Unknown;
  LandingRequest request = test::landingRequest(test::landingMission(test::oneBankCessna()), sites, test::wideGrid(), {-1000.0, 0.0, 0.0}, 1500.0);
  // all around A, so that no way there misses it: its own 4 x 4 km
  request.weather = test::weatherOf({test::weatherCell(test::rectangle(4000.0, -2000.0, 8000.0, 2000.0), 0.9)});
  request.deadline = 1.0;
  return request;
}

}  // namespace

class TestRunwayRanking : public QObject {
  Q_OBJECT

private slots:
  void lines_areWhatIsKnown() {
    const LandingRequest request = threeRunways();
    const std::vector<RankedRunway> ranked = rankRunways(request);
    QCOMPARE(ranked.size(), std::size_t{3});
    QVERIFY(ranked[0].isReached && ranked[1].isReached && !ranked[2].isReached && ranked[2].site == 2);
    const RankedRunway& a = ranked[0].site == 0 ? ranked[0] : ranked[1];
    const RankedRunway& b = ranked[0].site == 1 ? ranked[0] : ranked[1];
    QVERIFY(a.answer.verified && b.answer.verified && a.answer.path->site == 0 && b.answer.path->site == 1);
    // 2 km of weather to the threshold of A in its middle, straight ahead
    QVERIFY(says(a, "weather on the way", std::pow(0.9, 2.0), -2.0 * std::log(0.9), "Through 2.0 km of cell 1: 81 % come through."));
    QVERIFY(says(b, "weather on the way", 1.0, 0.0, "No bad weather on the way."));
    QVERIFY(says(a, "runway length", 2000.0, 0.02, "2000 m long; what the aircraft needs is not known."));
    QVERIFY(says(a, "runway width", 30.0, 0.0, "30 m wide."));
    QVERIFY(says(b, "runway width", 9.0, 0.025, "9 m wide."));
    QVERIFY(says(a, "surface", 0.0, 0.0, "A hard surface."));
    QVERIFY(says(b, "surface", 0.01, 0.01, "A grass surface."));
    QVERIFY(says(a, "lights", 1.0, 0.0, "Lighted."));
    QVERIFY(says(b, "lights", 0.0, 0.005, "Not known to be lighted."));
    QVERIFY(says(a, "wind", 0.0, 0.01, "The wind there is not known"));
    QVERIFY(says(a, "ceiling and visibility", 0.0, 0.02, "not known"));
    QVERIFY(says(a, "emergency services", 0.0, 0.02, "not known"));
    QVERIFY(says(a, "people under the final approach", 0.0, 0.01, "not known"));
    QVERIFY(says(ranked[2], "runway length", 0.0, 0.1, "not known"));
    QVERIFY(says(ranked[2], "surface", 0.0, 0.03, "not known"));
    QVERIFY(lineOf(ranked[2], "height in hand").sentence.starts_with("Not reached: No runway is in range: the closest is C/09"));
    QVERIFY(lineOf(ranked[2], "height in hand").value < 0.0 && ranked[2].logRisk > 10.0);
    for (const RankedRunway& runway : ranked) {
      double sum = 0.0;
      for (const RankingLine& line : runway.lines) {
        QVERIFY2(line.logRisk >= 0.0 && line.sentence.ends_with('.') && line.sentence.size() > 3, line.sentence.c_str());
        sum += line.logRisk;
      }
      QVERIFY(std::abs(sum - runway.logRisk) < 1e-12);
    }
    QVERIFY(ranked[0].logRisk <= ranked[1].logRisk);
    QCOMPARE(ranked[0].site, 1);  // grass and nine metres weigh less than two kilometres of that weather
  }

  void lengthWindAndPeople_countByTheirLimits() {
    LandingRequest request = threeRunways();
    mission::Mission mission = *request.mission;
    mission.aircraft.landingDistance = Length::fromSi(600.0);
    mission.aircraft.maxCrosswind = Speed::fromSi(10.0);
    mission.aircraft.maxTailwind = Speed::fromSi(5.0);
    mission.wind = {{geo::HeightMsl::fromMetres(0.0), {360.0, 0.0, 5.0, 5.0}}};  // from the north, 5 m/s
    request.mission = std::make_shared<const mission::Mission>(mission);
    request.world = std::make_shared<const landing::World>(landing::worldOf(mission, request.world->sites, request.world->terrain));
    const geo::LocalFrame frame(test::kLandingOrigin);
    mission::PopulationArea town;
    town.name = "town";
    town.perSquareKm = 1000.0;
    mission::PopulatedPolygon part;
    for (const geo::Point& corner : test::rectangle(-20000.0, -1000.0, 6000.0, 1000.0)) {
      part.outline.push_back(frame.toLatLon(corner));
    }
    town.parts = {part};
    auto people = std::make_shared<const risk::Population>(std::move(*risk::Population::from({town}, frame)));
    request.risk = std::make_shared<const risk::PeopleUnder>(people, 33.0, 1500.0);
    const std::vector<RankedRunway> ranked = rankRunways(request);
    const RankedRunway& a = *std::find_if(ranked.begin(), ranked.end(), [](const RankedRunway& one) { return one.site == 0; });
    const RankedRunway& b = *std::find_if(ranked.begin(), ranked.end(), [](const RankedRunway& one) { return one.site == 1; });
    const double knot = 1852.0 / 3600.0;
    // the course of A in the frame is east at its threshold to a hundredth of a degree
    QVERIFY(std::abs(lineOf(a, "wind").value - 5.0 / knot) < 0.01 && std::abs(lineOf(a, "wind").logRisk - 0.02 * 0.25) < 1e-4);
    QVERIFY2(lineOf(b, "wind").sentence.find("of headwind") != std::string::npos && lineOf(b, "wind").logRisk < 1e-4,
             lineOf(b, "wind").sentence.c_str());
    // 3 NM of 1000 people / km^2, 200 m wide
    QVERIFY(says(a, "people under the final approach", 5556.0 * 200.0 * 1e-3, 1e-4 * 5556.0 * 0.2, "1111 people live under the last 3 NM"));
    QVERIFY(lineOf(a, "runway length").logRisk == 0.0);
    QVERIFY2(lineOf(b, "runway length").logRisk > 0.1 && lineOf(b, "runway length").sentence.find("too short") != std::string::npos,
             lineOf(b, "runway length").sentence.c_str());
  }

  void knownAnswer_countsForItsRunway_andThreadsDecideNothing() {
    LandingRequest request = threeRunways();
    request.weather = nullptr;
    LandingAnswer answer = verifiedAnswer(request, makePlanner("anytime")->plan(request));
    QVERIFY(answer.verified);
    RankingOptions options;
    options.known = &answer;
    const std::vector<RankedRunway> one = rankRunways(request, options);
    const auto chosen = std::find_if(one.begin(), one.end(), [&](const RankedRunway& runway) { return runway.site == answer.path->site; });
    QCOMPARE(chosen->answer.planner, std::string("anytime"));
    QVERIFY(says(*chosen, "weather on the way", 0.0, 0.02, "not known"));
    request.threads = 3;
    const std::vector<RankedRunway> three = rankRunways(request, options);
    QCOMPARE(one.size(), three.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      QVERIFY(one[i].site == three[i].site && one[i].logRisk == three[i].logRisk && one[i].answer.path == three[i].answer.path);
    }
  }

  void stopped_saysWhatWasNotLookedAt() {
    LandingRequest request = threeRunways();
    std::stop_source stop;
    stop.request_stop();
    request.job = Job(stop.get_token());
    const std::vector<RankedRunway> ranked = rankRunways(request);
    QCOMPARE(ranked.size(), std::size_t{3});
    QVERIFY(!ranked[0].isReached && lineOf(ranked[0], "height in hand").sentence.find("There was not enough time") != std::string::npos);
  }
};

QTEST_APPLESS_MAIN(TestRunwayRanking)
#include "tst_runway_ranking.moc"
