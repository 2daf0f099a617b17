#pragma once

#include "core/aircraft/aircraft_profile.h"

namespace vp::aircraft {

/** Fuel or charge that a flight under power takes, in the unit of the setting: what the setting takes in level flight for the time, and
 *  what raising the aircraft takes beside that. Descents give nothing back.
 *
 *  Of avgas (43.5 MJ/kg, 0.72 kg/l) a quarter becomes climb: 0.31 of the brake (0.27 kg/kWh, a specific consumption of 0.44 lb/hp/h) times 0.8 of the
 *  propeller. Of a battery's charge 0.6 does (0.8 of motor and controller times 0.75 of a small propeller). So 1000 m cost a 172 of 1043 kg 1.3 l.
 *  @source energy of avgas and efficiencies: Anderson 1999, Aircraft Performance and Design, sections 3.3 and 5.13; Traub 2011, Range and endurance
 *  estimates for battery-powered aircraft, J. Aircraft 48 (0.5 to 0.7 in all)
 *  @param seconds  >= 0   @param climbed  sum of all climbs [m], >= 0   @threads pure */
double energyUsed(const PowerSetting& setting, double mass_kg, double seconds, double climbed);

/** "l", "kg", "Wh" */
const char* unitText(PowerSetting::Unit unit);

}  // namespace vp::aircraft
