#pragma once

#include "core/aircraft/glide_conditions.h"
#include "core/mission/plan.h"
#include "ui/style/units.h"

#include <QString>
#include <QStringList>

namespace vp::document {

/** "52 to 75 kt": true airspeeds of the plan's glides; one speed where they do not range. */
QString glideSpeedWords(const mission::Plan& plan, const style::Units& units);

/** "680 to 1043 kg"; empty where one mass alone counts. */
QString massWords(const aircraft::AircraftProfile& aircraft);

/** "ISA −10 °C, QNH 1005 hPa". */
QString airWords(const air::Atmosphere& air);

/** "4.0 s, 98 ft lost in it"; empty where nothing is allowed for. Times and heights are those promised, so never rounded up. */
QString reactionWords(const mission::SafetySettings& safety, const style::Units& units);

/** What rolling into turns takes of the height above ground, as a part of a sentence: "rolling into turns and out of them, at 15° per second, leaves
 *  its glides at least 131 ft above the ground"; without a rate of roll, or a certificate, that it is not modelled. */
QString rollingWords(const mission::Plan& plan, const style::Units& units);

/** "after a straight of 0.81 NM on the landing course, descending 4.0° over ground"; how glides end, without the obstacle surface. */
QString approachWords(const mission::ApproachSettings& approach, const style::Units& units);

/** "an obstacle surface that begins 197 ft before the touchdown point and rises by 5.0 %"; empty where the whole clearance counts everywhere. */
QString surfaceWords(const mission::ApproachSettings& approach, const style::Units& units);

/** "65 %: 115 kt TAS, 27.6 l per hour"; empty at best glide speed. */
QString powerWords(const mission::Mission& mission, const style::Units& units);

/** "0:42 with the ways from and to home, 1410 ft of climb, 18.4 l of 151 l usable"; the tour alone where there is no home. */
QString flightWords(const mission::Plan& plan, const style::Units& units);

/** "the flight takes 160 l, and 151 l are usable"; empty where it takes no more, or nothing is known of it. Reserves are not in it. */
QString beyondUsableWords(const mission::Plan& plan);

/** "LSZS 21: left circles of 1200 ft radius, no lower than 6700 ft MSL", one for each hold. */
QStringList holdWords(const mission::Plan& plan, const style::Units& units);

/** How much an altimeter shows too much in the cold air of the mission at the lowest and the highest altitude of the tour, set to the QNH of the
 *  lowest runway; empty where the air is not colder than standard, or not given. */
QString altimeterWords(const mission::Plan& plan, const style::Units& units);

}  // namespace vp::document
