<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Briefing</name>
    <message>
        <source>d MMM yyyy</source>
        <comment>date, as QDate::toString takes it</comment>
        <translation>d. MMM yyyy</translation>
    </message>
    <message>
        <source>, %1 kg</source>
        <translation>, %1 kg</translation>
    </message>
    <message>
        <source>NOT ENOUGH: %1</source>
        <translation>REICHT NICHT: %1</translation>
    </message>
    <message>
        <source>%1 TAS, glide ratio %2 straight ahead (%3 down, %4); polar: drag coefficient %5 + %6 × lift coefficient², wing %7 m², air %8 kg/m³</source>
        <translation>%1 TAS, Gleitzahl %2 geradeaus (%3 Sinkwinkel, %4); Polare: Widerstandsbeiwert %5 + %6 × Auftriebsbeiwert², Flügel %7 m², Luft %8 kg/m³</translation>
    </message>
    <message>
        <source>%1 in still air and %2 over ground against the strongest wind,</source>
        <translation>%1 in ruhiger Luft und %2 über Grund gegen den stärksten Wind,</translation>
    </message>
    <message>
        <source>%1° of bank: radius %2, a half turn loses %3</source>
        <translation>%1° Querlage: Radius %2, ein Halbkreis kostet %3</translation>
    </message>
    <message>
        <source>at most %1° of bank: radius over ground %2, a half turn loses up to %3</source>
        <translation>höchstens %1° Querlage: Radius über Grund %2, ein Halbkreis kostet bis zu %3</translation>
    </message>
    <message>
        <source>none set</source>
        <translation>keine festgelegt</translation>
    </message>
    <message>
        <source>calm assumed: wind, up- and downdrafts are not in the figures</source>
        <translation>Windstille angenommen: Wind, Auf- und Abwinde sind nicht in den Zahlen</translation>
    </message>
    <message>
        <source>%1 (directions true). The glides hold in every such wind with the track over ground kept; up- and downdrafts are not in the figures</source>
        <translation>%1 (Richtungen rechtweisend). Die Gleitwege gelten bei jedem solchen Wind, wenn der Kurs über Grund gehalten wird; Auf- und Abwinde sind nicht in den Zahlen</translation>
    </message>
    <message>
        <source>Calm air. A headwind on the glide, or sinking air, costs height that is nowhere in the figures. With wind, keep more height or do not rely on this plan.</source>
        <translation>Windstille. Gegenwind beim Gleiten oder sinkende Luft kosten Höhe, die in keiner Zahl steht. Bei Wind mehr Höhe halten oder sich nicht auf diesen Plan verlassen.</translation>
    </message>
    <message>
        <source>The glides hold in %1, if the track over ground is kept by crabbing and by banking with the ground speed. Stronger wind, wind from elsewhere, gusts and sinking air cost height that is nowhere in the figures.</source>
        <translation>Die Gleitwege gelten bei %1, wenn der Kurs über Grund durch Vorhalten und durch Querlage nach der Geschwindigkeit über Grund gehalten wird. Stärkerer Wind, Wind aus anderer Richtung, Böen und sinkende Luft kosten Höhe, die in keiner Zahl steht.</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Tour</translation>
    </message>
    <message>
        <source>%1 targets, %2, %3 at %7 in %6, between %4 and %5</source>
        <translation>%1 Ziele, %2, %3 mit %7 bei %6, zwischen %4 und %5</translation>
    </message>
    <message>
        <source>calm air</source>
        <translation>Windstille</translation>
    </message>
    <message>
        <source>the middle of the forecast wind</source>
        <translation>mittlerem vorhergesagtem Wind</translation>
    </message>
    <message>
        <source>%1 TAS</source>
        <translation>%1 TAS</translation>
    </message>
    <message>
        <source>the glide speed</source>
        <translation>Gleitgeschwindigkeit</translation>
    </message>
    <message>
        <source>Flight</source>
        <translation>Flug</translation>
    </message>
    <message>
        <source>Aircraft</source>
        <translation>Flugzeug</translation>
    </message>
    <message>
        <source>Best glide</source>
        <translation>Bestes Gleiten</translation>
    </message>
    <message>
        <source>Glide turns</source>
        <translation>Gleitkurven</translation>
    </message>
    <message>
        <source>Tour limits</source>
        <translation>Grenzen der Tour</translation>
    </message>
    <message>
        <source>%1° of bank (radius %2), climb %3°, descent %4°</source>
        <translation>%1° Querlage (Radius %2), Steigen %3°, Sinken %4°</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Heimat</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Wind</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Bodenabstand</translation>
    </message>
    <message>
        <source>%1 above the ground on tour and glides, what the glide model leaves out included</source>
        <translation>%1 über dem Boden auf Tour und Gleitwegen, einschließlich dessen, was das Gleitmodell auslässt</translation>
    </message>
    <message>
        <source>On arrival</source>
        <translation>Bei Ankunft</translation>
    </message>
    <message>
        <source>at least %1 above the runway</source>
        <translation>mindestens %1 über der Piste</translation>
    </message>
    <message>
        <source>Ceiling</source>
        <translation>Obergrenze</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Erstellt von</translation>
    </message>
    <message>
        <source>plan: %1; briefing: %2</source>
        <translation>Plan: %1; Briefing: %2</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Quellen</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Last changed</source>
        <translation>Letzte Änderung</translation>
    </message>
    <message>
        <source>SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>not here</source>
        <translation>nicht vorhanden</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Gelände</translation>
    </message>
    <message>
        <source>Airfields</source>
        <translation>Flugplätze</translation>
    </message>
    <message>
        <source>now: </source>
        <translation>jetzt: </translation>
    </message>
    <message>
        <source>in the mission itself</source>
        <translation>in der Mission selbst</translation>
    </message>
    <message>
        <source>Terrain is used in cells of %1 m, each with the highest ground inside it. Runways are as the plan holds them; check them against current publications.</source>
        <translation>Das Gelände wird in Zellen von %1 m verwendet, jede mit dem höchsten Boden in ihr. Die Pisten sind die des Plans; sie sind mit aktuellen Veröffentlichungen zu vergleichen.</translation>
    </message>
    <message>
        <source>VERIFIED SAFE</source>
        <translation>GEPRÜFT, SICHER</translation>
    </message>
    <message>
        <source>UNVERIFIED – DO NOT FLY</source>
        <translation>UNGEPRÜFT – NICHT FLIEGEN</translation>
    </message>
    <message>
        <source>The independent checker refused this plan: %1 findings, listed below. No one has shown that a glide to a runway exists from every point of it, and the figures in this briefing may be wrong.</source>
        <translation>Die unabhängige Prüfung hat diesen Plan abgelehnt: %1 Befunde, unten aufgeführt. Niemand hat gezeigt, dass von jedem Punkt aus eine Piste im Gleitflug erreichbar ist, und die Zahlen in diesem Briefing können falsch sein.</translation>
    </message>
    <message>
        <source>Tour above ground and clearance</source>
        <translation>Tour über Boden und Bodenabstand</translation>
    </message>
    <message>
        <source>Tour above what the glides need</source>
        <translation>Tour über dem, was die Gleitwege brauchen</translation>
    </message>
    <message>
        <source>Glides above ground and clearance</source>
        <translation>Gleitwege über Boden und Bodenabstand</translation>
    </message>
    <message>
        <source>Glides above ground less what rolling may cost</source>
        <translation>Gleitwege über Boden, abzüglich was das Rollen kosten kann</translation>
    </message>
    <message>
        <source>Glides above what is asked for on arrival</source>
        <translation>Gleitwege über dem bei Ankunft Verlangten</translation>
    </message>
    <message>
        <source>Climb below the steepest allowed</source>
        <translation>Steigen unter dem steilsten erlaubten</translation>
    </message>
    <message>
        <source>Descent below the steepest allowed</source>
        <translation>Sinken unter dem steilsten erlaubten</translation>
    </message>
    <message>
        <source>Tour below the ceiling</source>
        <translation>Tour unter der Obergrenze</translation>
    </message>
    <message>
        <source>Tour above the targets</source>
        <translation>Tour über den Zielen</translation>
    </message>
    <message>
        <source>Spirals above ground and clearance</source>
        <translation>Spiralen über Boden und Bodenabstand</translation>
    </message>
    <message>
        <source>Least margins of the whole plan</source>
        <translation>Kleinste Reserven des ganzen Plans</translation>
    </message>
    <message>
        <source>As the independent checker found them: what is left beyond the requirement.</source>
        <translation>Wie die unabhängige Prüfung sie fand: was über das Verlangte hinaus übrig ist.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Reserve</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>whole plan</source>
        <translation>ganzer Plan</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>bei %1</translation>
    </message>
    <message>
        <source>leg %1→%2, %3</source>
        <translation>Teilstrecke %1→%2, %3</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>What the checker wants a pilot to know; in its own words, heights in metres.</source>
        <translation>Was die Prüfung den Piloten wissen lassen will; in ihren eigenen Worten (Englisch), Höhen in Metern.</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>VIOLATED</source>
        <translation>VERLETZT</translation>
    </message>
    <message>
        <source>UNKNOWN</source>
        <translation>UNBEKANNT</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Airspaces</source>
        <translation>Lufträume</translation>
    </message>
    <message>
        <source>Those near the tour that the mission keeps the tour out of or warns of. A glide after an engine failure may enter any of them.</source>
        <translation>Jene nahe der Tour, aus denen die Mission die Tour fernhält oder vor denen sie warnt. Ein Gleitweg nach einem Motorausfall kann in jeden von ihnen führen.</translation>
    </message>
    <message>
        <source>Airspace</source>
        <translation>Luftraum</translation>
    </message>
    <message>
        <source>Ceiling / floor</source>
        <translation>Ober-/Untergrenze</translation>
    </message>
    <message>
        <source>The tour</source>
        <translation>Die Tour</translation>
    </message>
    <message>
        <source>keeps out</source>
        <translation>bleibt draußen</translation>
    </message>
    <message>
        <source>may enter; a warning</source>
        <translation>darf einfliegen; Warnung</translation>
    </message>
    <message>
        <source>Magnetic tracks are true tracks corrected by the %1, for %2; iron in the ground and in the aircraft comes on top.</source>
        <translation>Missweisende Kurse sind rechtweisende, berichtigt um das %1, für %2; Eisen im Boden und im Flugzeug kommt hinzu.</translation>
    </message>
    <message>
        <source>The magnetic model is not made for this date: its rates were carried on, so expect errors of some degrees.</source>
        <translation>Das magnetische Modell ist nicht für dieses Datum gemacht: seine Änderungsraten wurden fortgeschrieben, Fehler von einigen Grad sind zu erwarten.</translation>
    </message>
    <message>
        <source>So near a magnetic pole compasses are unreliable: fly true tracks. Where no magnetic track is given, a compass is of no use at all.</source>
        <translation>So nahe an einem magnetischen Pol sind Kompasse unzuverlässig: rechtweisende Kurse fliegen. Wo kein missweisender Kurs steht, ist ein Kompass gar nicht zu gebrauchen.</translation>
    </message>
    <message>
        <source>A simulated Cessna 172 that flew such glides ended up to %1 lower at 30° of bank and %2 at 45°: that part of the clearance is spoken for. A worse polar than the one on the first page (propeller windmilling, dirty wing, flaps, wrong speed) costs more: 35 % more sink ended up to %3 lower per %4 of glide.</source>
        <translation>Eine simulierte Cessna 172, die solche Gleitwege flog, endete bei 30° Querlage bis zu %1 tiefer und bei 45° bis zu %2: dieser Teil des Bodenabstands ist vergeben. Eine schlechtere Polare als die der ersten Seite (drehender Propeller, schmutziger Flügel, Klappen, falsche Geschwindigkeit) kostet mehr: 35 % mehr Sinken endete bis zu %3 tiefer je %4 Gleitweg.</translation>
    </message>
    <message>
        <source>Between two decision points the aircraft first glides on along the tour to the next one, then turns for the runway: at most %1 further.</source>
        <translation>Zwischen zwei Entscheidungspunkten gleitet das Flugzeug zuerst auf der Tour zum nächsten weiter und dreht dann zur Piste: höchstens %1 weiter.</translation>
    </message>
    <message>
        <source>Ground is the highest of each terrain cell, from the file named on the first page. Masts, cables, trees, buildings and errors of that file are in it only if the file has them.</source>
        <translation>Boden ist der höchste Punkt jeder Geländezelle, aus der Datei auf der ersten Seite. Masten, Kabel, Bäume, Gebäude und Fehler jener Datei sind nur darin, wenn die Datei sie enthält.</translation>
    </message>
    <message>
        <source>Spirals down to low targets suspend the guarantee from the moment they are entered until the tour&apos;s altitude is reached again.</source>
        <translation>Spiralen hinab zu tiefen Zielen setzen die Garantie aus, vom Beginn der Spirale, bis die Höhe der Tour wieder erreicht ist.</translation>
    </message>
    <message>
        <source>The pilot in command decides. This briefing replaces no official source.</source>
        <translation>Die Entscheidung liegt beim verantwortlichen Piloten. Dieses Briefing ersetzt keine amtliche Quelle.</translation>
    </message>
    <message>
        <source>MSL</source>
        <translation>MSL</translation>
    </message>
    <message>
        <source>above mean sea level</source>
        <translation>über dem mittleren Meeresspiegel</translation>
    </message>
    <message>
        <source>AGL</source>
        <translation>AGL</translation>
    </message>
    <message>
        <source>above ground level: the highest ground of the terrain cell below</source>
        <translation>über Grund: über dem höchsten Boden der Geländezelle darunter</translation>
    </message>
    <message>
        <source>°T, °M</source>
        <translation>°T, °M</translation>
    </message>
    <message>
        <source>true and magnetic degrees; magnetic = true − east variation, + west variation</source>
        <translation>Grad rechtweisend (T) und missweisend (M); missweisend = rechtweisend − östliche Missweisung, + westliche Missweisung</translation>
    </message>
    <message>
        <source>Var.</source>
        <translation>Missw.</translation>
    </message>
    <message>
        <source>magnetic variation, E east, W west</source>
        <translation>Ortsmissweisung, E Ost, W West</translation>
    </message>
    <message>
        <source>TAS</source>
        <translation>TAS</translation>
    </message>
    <message>
        <source>true airspeed</source>
        <translation>wahre Eigengeschwindigkeit</translation>
    </message>
    <message>
        <source>1→2</source>
        <translation>1→2</translation>
    </message>
    <message>
        <source>leg from target 1 to target 2</source>
        <translation>Teilstrecke von Ziel 1 zu Ziel 2</translation>
    </message>
    <message>
        <source>Safe</source>
        <translation>Sicher</translation>
    </message>
    <message>
        <source>lowest altitude from which the plan&apos;s glides work, on a whole leg</source>
        <translation>tiefste Höhe, aus der die Gleitwege des Plans möglich sind, auf einer ganzen Teilstrecke</translation>
    </message>
    <message>
        <source>height above the lowest from which the glide works</source>
        <translation>Höhe über der tiefsten, aus der der Gleitweg möglich ist</translation>
    </message>
    <message>
        <source>Clear.</source>
        <translation>Abst.</translation>
    </message>
    <message>
        <source>clearance: height above the highest ground of the cells below</source>
        <translation>Bodenabstand: Höhe über dem höchsten Boden der Zellen darunter</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>the airfield file does not say</source>
        <translation>die Flugplatzdatei sagt es nicht</translation>
    </message>
    <message>
        <source>out, in</source>
        <translation>hin, heim</translation>
    </message>
    <message>
        <source>way from the home runway to the tour, way from the tour to the home runway</source>
        <translation>Weg von der Heimatpiste zur Tour, Weg von der Tour zur Heimatpiste</translation>
    </message>
    <message>
        <source>Unnamed mission</source>
        <translation>Unbenannte Mission</translation>
    </message>
    <message>
        <source>briefing: terrain</source>
        <translation>Briefing: Gelände</translation>
    </message>
    <message>
        <source>the plan is damaged and cannot be briefed: %1</source>
        <translation>der Plan ist beschädigt und kann nicht ausgegeben werden: %1</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Runways that the glides lead to</source>
        <translation>Pisten, zu denen die Gleitwege führen</translation>
    </message>
    <message>
        <source>Letters as on the map, in the order in which the tour needs them. “Serves” is the length of tour from which the glides lead here. What is approximate stands under Findings.</source>
        <translation>Buchstaben wie auf der Karte, in der Reihenfolge, in der die Tour sie braucht. „Dient“ ist die Länge der Tour, von der die Gleitwege hierher führen. Was nur ungefähr bekannt ist, steht unter Befunde.</translation>
    </message>
    <message>
        <source>Runway</source>
        <translation>Piste</translation>
    </message>
    <message>
        <source>Airfield</source>
        <translation>Flugplatz</translation>
    </message>
    <message>
        <source>Elev.
%1 MSL</source>
        <translation>Höhe
%1 MSL</translation>
    </message>
    <message>
        <source>Lands
°T</source>
        <translation>Landet
°T</translation>
    </message>
    <message>
        <source>
°M</source>
        <translation>
°M</translation>
    </message>
    <message>
        <source>Length
%1</source>
        <translation>Länge
%1</translation>
    </message>
    <message>
        <source>Width
%1</source>
        <translation>Breite
%1</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Serves
%1</source>
        <translation>Dient
%1</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>approximate</source>
        <translation>ungefähr</translation>
    </message>
    <message>
        <source>SPIRAL %1, turns down: %2 to %3, up: %4. NO GLIDE GUARANTEE inside it</source>
        <translation>SPIRALE nach %1, Kreise hinab: %2 bis %3, hinauf: %4. DARIN KEINE GLEITGARANTIE</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>Targets in the order of the tour</source>
        <translation>Ziele in der Reihenfolge der Tour</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Asked for</source>
        <translation>Verlangt</translation>
    </message>
    <message>
        <source>Passed at
%1 MSL</source>
        <translation>Überflug
%1 MSL</translation>
    </message>
    <message>
        <source>
%1 AGL</source>
        <translation>
%1 AGL</translation>
    </message>
    <message>
        <source>Above
asked, %1</source>
        <translation>Über
Verlangtem, %1</translation>
    </message>
    <message>
        <source>At
%1</source>
        <translation>Bei
%1</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>Teilstrecken</translation>
    </message>
    <message>
        <source>Track: of the longest straight part; i: the leg is all turns, heading at its start. Time in %1. “Safe”: fly at or above it and the glides of the whole leg work; it is the highest that any point of the leg needs.</source>
        <translation>Kurs: des längsten geraden Stücks; i: die Teilstrecke besteht nur aus Kurven, Steuerkurs an ihrem Anfang. Zeit bei %1. „Sicher“: in oder über dieser Höhe gelten die Gleitwege der ganzen Teilstrecke; sie ist die höchste, die irgendein Punkt der Teilstrecke braucht.</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>To target</source>
        <translation>Zu Ziel</translation>
    </message>
    <message>
        <source>Track
°T</source>
        <translation>Kurs
°T</translation>
    </message>
    <message>
        <source>Dist.
%1</source>
        <translation>Dist.
%1</translation>
    </message>
    <message>
        <source>Time
min</source>
        <translation>Zeit
min</translation>
    </message>
    <message>
        <source>Start
%1 MSL</source>
        <translation>Beginn
%1 MSL</translation>
    </message>
    <message>
        <source>Highest
%1 MSL</source>
        <translation>Höchste
%1 MSL</translation>
    </message>
    <message>
        <source>End
%1 MSL</source>
        <translation>Ende
%1 MSL</translation>
    </message>
    <message>
        <source>Least
%1 AGL</source>
        <translation>Kleinste
%1 AGL</translation>
    </message>
    <message>
        <source>Safe
%1 MSL</source>
        <translation>Sicher
%1 MSL</translation>
    </message>
    <message>
        <source>Least
margin %1</source>
        <translation>Kleinste
Reserve %1</translation>
    </message>
    <message>
        <source>at
%1</source>
        <translation>bei
%1</translation>
    </message>
    <message>
        <source>tour</source>
        <translation>Tour</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>sum, once around</source>
        <translation>Summe, eine Runde</translation>
    </message>
    <message>
        <source>out</source>
        <translation>hin</translation>
    </message>
    <message>
        <source>climb-out, NO GLIDE GUARANTEE</source>
        <translation>Abflug, KEINE GLEITGARANTIE</translation>
    </message>
    <message>
        <source>the tour, on leg %1</source>
        <translation>die Tour, auf Teilstrecke %1</translation>
    </message>
    <message>
        <source>in</source>
        <translation>heim</translation>
    </message>
    <message>
        <source>above %1, from leg %2</source>
        <translation>über %1, von Teilstrecke %2</translation>
    </message>
    <message>
        <source>If the engine stops</source>
        <translation>Wenn der Motor ausfällt</translation>
    </message>
    <message>
        <source>From every place on the stretch the glides lead to this runway end. Glide and time: shortest and longest, best-glide speed, %1, to the touchdown point without the spiral that loses height left over. Margin: least height above the lowest from which the glide works. Clearance: least above the ground on all glides of the row. Bold: the worst places, drawn further on: least margin, and among margins alike within a metre the longest glide.</source>
        <translation>Von jedem Ort des Abschnitts führen die Gleitwege zu diesem Pistenende. Gleitweg und Zeit: kürzeste und längste, mit der Geschwindigkeit des besten Gleitens, %1, bis zum Aufsetzpunkt ohne die Spirale, die übrige Höhe abbaut. Reserve: kleinste Höhe über der tiefsten, aus der der Gleitweg möglich ist. Abstand: kleinster über dem Boden auf allen Gleitwegen der Zeile. Fett: die schlechtesten Stellen, weiter hinten gezeichnet: kleinste Reserve, und bei auf einen Meter gleichen Reserven der längste Gleitweg.</translation>
    </message>
    <message>
        <source>the slowest wind of the forecast</source>
        <translation>der langsamste Wind der Vorhersage</translation>
    </message>
    <message>
        <source>“out” and “in”: the ways from and to the home runway; the stretches of “out” are counted from where the guarantee begins. Before that there is no glide to brief.</source>
        <translation>„hin“ und „heim“: die Wege von und zu der Heimatpiste; die Abschnitte von „hin“ zählen von dort, wo die Garantie beginnt. Vorher gibt es keinen Gleitweg zu beschreiben.</translation>
    </message>
    <message>
        <source>Stretch
%1</source>
        <translation>Abschnitt
%1</translation>
    </message>
    <message>
        <source>Glide
%1</source>
        <translation>Gleitweg
%1</translation>
    </message>
    <message>
        <source>Margin
%1</source>
        <translation>Reserve
%1</translation>
    </message>
    <message>
        <source>Clear.
%1 AGL</source>
        <translation>Abst.
%1 AGL</translation>
    </message>
    <message>
        <source>Arrives
%1 above</source>
        <translation>Kommt an
%1 darüber</translation>
    </message>
    <message>
        <source>Worst place %1: leg %2, %3 from its start, to runway %4 (%5)</source>
        <translation>Schlechteste Stelle %1: Teilstrecke %2, %3 nach ihrem Beginn, zu Piste %4 (%5)</translation>
    </message>
    <message>
        <source>glide</source>
        <translation>Gleitweg</translation>
    </message>
    <message>
        <source>least clearance</source>
        <translation>kleinster Bodenabstand</translation>
    </message>
    <message>
        <source>arrives</source>
        <translation>kommt an</translation>
    </message>
    <message>
        <source>%1 above the runway</source>
        <translation>%1 über der Piste</translation>
    </message>
    <message>
        <source>lands</source>
        <translation>landet</translation>
    </message>
    <message>
        <source>%1° T, %2° M</source>
        <translation>%1° T, %2° M</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>Platzhöhe</translation>
    </message>
    <message>
        <source>windmilling, turned by the air</source>
        <translation>drehend, vom Fahrtwind getrieben</translation>
    </message>
    <message>
        <source>stopped: the glides hold only if it is</source>
        <translation>stehend: die Gleitwege gelten nur, wenn er steht</translation>
    </message>
    <message>
        <source>%1; on that last part only above %2, where that is less than the clearance</source>
        <translation>%1; auf diesem letzten Stück nur über %2, wo das weniger als der Bodenabstand ist</translation>
    </message>
    <message>
        <source>Masses</source>
        <translation>Massen</translation>
    </message>
    <message>
        <source>%1, each at its best glide speed, which goes with the root of the mass</source>
        <translation>%1, jede mit ihrer Geschwindigkeit des besten Gleitens, die mit der Wurzel der Masse geht</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>Altimeter</source>
        <translation>Höhenmesser</translation>
    </message>
    <message>
        <source>Reaction</source>
        <translation>Reaktion</translation>
    </message>
    <message>
        <source>%1; the aircraft flies on meanwhile, then the glide is established</source>
        <translation>%1; das Flugzeug fliegt solange weiter, dann ist der Gleitflug eingenommen</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Widerstand</translation>
    </message>
    <message>
        <source>%1 times that of the polar; the glide ratios are with it</source>
        <translation>das %1-Fache der Polare; die Gleitzahlen enthalten es</translation>
    </message>
    <message>
        <source>Propeller</source>
        <translation>Propeller</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Approach</source>
        <translation>Anflug</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Warteräume</translation>
    </message>
    <message>
        <source>The engine fails and the aircraft is at best-glide speed and in the right turn at once. Reaction and slowing down are not modelled; they have to be paid from the clearance of %1. What is modelled: %2.</source>
        <translation>Der Motor fällt aus, und das Flugzeug fliegt sofort mit der Geschwindigkeit des besten Gleitens und in der richtigen Kurve. Reaktion und Verlangsamen sind nicht berücksichtigt; sie gehen vom Bodenabstand von %1 ab. Berücksichtigt ist: %2.</translation>
    </message>
    <message>
        <source>The engine fails and the aircraft flies on (%1); then it is at best-glide speed. A longer reaction is not modelled; it has to be paid from the clearance of %2. What is modelled: %3.</source>
        <translation>Der Motor fällt aus, und das Flugzeug fliegt weiter (%1); dann fliegt es mit der Geschwindigkeit des besten Gleitens. Eine längere Reaktion ist nicht berücksichtigt; sie geht vom Bodenabstand von %2 ab. Berücksichtigt ist: %3.</translation>
    </message>
    <message>
        <source>The engine fails and the aircraft is at best-glide speed and in the right turn at once. Reaction, slowing down and rolling into turns are not modelled; they have to be paid from the clearance of %1.</source>
        <translation>Der Motor fällt aus, und das Flugzeug fliegt sofort mit der Geschwindigkeit des besten Gleitens und in der richtigen Kurve. Reaktion, Verlangsamen und Rollen in Kurven sind nicht berücksichtigt; sie gehen vom Bodenabstand von %1 ab.</translation>
    </message>
    <message>
        <source>The engine fails and the aircraft flies on (%1); then it is at best-glide speed and in the right turn at once. A longer reaction and rolling into turns are not modelled; they have to be paid from the clearance of %2.</source>
        <translation>Der Motor fällt aus, und das Flugzeug fliegt weiter (%1); dann fliegt es mit der Geschwindigkeit des besten Gleitens und in der richtigen Kurve. Eine längere Reaktion und Rollen in Kurven sind nicht berücksichtigt; sie gehen vom Bodenabstand von %2 ab.</translation>
    </message>
    <message>
        <source>lost in a spiral above the runway</source>
        <translation>in einer Spirale über der Piste abzubauen</translation>
    </message>
    <message>
        <source>lost in the circles of the line “Holds”, where the approach begins</source>
        <translation>in den Kreisen der Zeile „Warteräume“, wo der Anflug beginnt, abzubauen</translation>
    </message>
    <message>
        <source>The glide ends over the touchdown point on the landing course, with the height in the column “Arrives”. What is more than needed is %1; traffic, obstacles, surface state and closures are not known to the program.</source>
        <translation>Der Gleitweg endet über dem Aufsetzpunkt auf dem Landekurs, mit der Höhe in der Spalte „Kommt an“. Was mehr ist als nötig, ist %1; Verkehr, Hindernisse, Zustand der Oberfläche und Sperrungen kennt das Programm nicht.</translation>
    </message>
    <message>
        <source>Altitudes are above mean sea level in the datum of the terrain file, not pressure altitudes: a warm or cold day or a wrong QNH shifts them.</source>
        <translation>Höhen sind über dem mittleren Meeresspiegel im Höhensystem der Geländedatei, keine Druckhöhen: ein warmer oder kalter Tag oder ein falsches QNH verschiebt sie.</translation>
    </message>
    <message>
        <source>Altitudes are above mean sea level in the datum of the terrain file, not what an altimeter shows: the line “Altimeter” says by how much it is wrong in the air of the plan; a colder day or a wrong QNH shifts them more.</source>
        <translation>Höhen sind über dem mittleren Meeresspiegel im Höhensystem der Geländedatei, nicht das, was ein Höhenmesser zeigt: die Zeile „Höhenmesser“ sagt, um wie viel er in der Luft des Plans falsch geht; ein kälterer Tag oder ein falsches QNH verschiebt sie weiter.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source> (NO GLIDE GUARANTEE on the first %1, up to %2)</source>
        <translation> (KEINE GLEITGARANTIE auf den ersten %1, bis %2)</translation>
    </message>
    <message>
        <source>none: the plan is the tour alone; the guarantee holds on the tour only</source>
        <translation>keine: der Plan ist die Tour allein; die Garantie gilt nur auf der Tour</translation>
    </message>
    <message>
        <source>from %1; to %2. In the tables the ways from and to it are called “out” and “in”</source>
        <translation>von %1; nach %2. In den Tabellen heißen die Wege von und zu ihr „hin“ und „heim“</translation>
    </message>
    <message>
        <source>After taking off from %1 there is NO gliding guarantee on the first %2 of flight past the far end of the runway, up to %3 (%4 above the runway): if the engine stops there, this plan has no glide, and the aircraft lands ahead as after any takeoff. The guarantee ends above the threshold of %5 at %6; from there the landing is the pilot&apos;s.</source>
        <translation>Nach dem Start von %1 gibt es auf den ersten %2 Flug nach dem Pistenende, bis %3 (%4 über der Piste), KEINE Gleitgarantie: fällt der Motor dort aus, hat dieser Plan keinen Gleitweg, und das Flugzeug landet geradeaus wie nach jedem Start. Die Garantie endet über der Schwelle von %5 in %6; ab dort ist die Landung Sache des Piloten.</translation>
    </message>
    <message>
        <source>%1, continued</source>
        <translation>%1, Fortsetzung</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>briefing: glides</source>
        <translation>Briefing: Gleitwege</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>Engine-out briefing, %1</source>
        <translation>Motorausfall-Briefing, %1</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Targets by their numbers in the tour. A bar across the tour: from here on the glides lead to another runway, whose letter stands on the stretch.</source>
        <translation>Ziele mit ihren Nummern in der Tour. Ein Strich quer zur Tour: von hier an führen die Gleitwege zu einer anderen Piste, deren Buchstabe am Abschnitt steht.</translation>
    </message>
    <message>
        <source>Altitude profile</source>
        <translation>Höhenprofil</translation>
    </message>
    <message>
        <source>What these figures assume, and where they end</source>
        <translation>Was diese Zahlen voraussetzen und wo sie enden</translation>
    </message>
    <message>
        <source>Abbreviations</source>
        <translation>Abkürzungen</translation>
    </message>
    <message>
        <source>%1 · %2 · altitudes above mean sea level</source>
        <translation>%1 · %2 · Höhen über dem mittleren Meeresspiegel</translation>
    </message>
    <message>
        <source>calm air assumed</source>
        <translation>Windstille angenommen</translation>
    </message>
    <message>
        <source>wind as on the first page</source>
        <translation>Wind wie auf der ersten Seite</translation>
    </message>
    <message>
        <source>UNVERIFIED – DO NOT FLY – no one has shown that a glide to a runway exists</source>
        <translation>UNGEPRÜFT – NICHT FLIEGEN – niemand hat gezeigt, dass es einen Gleitweg zu einer Piste gibt</translation>
    </message>
    <message>
        <source>the PDF could not be made</source>
        <translation>das PDF konnte nicht erzeugt werden</translation>
    </message>
    <message>
        <source>briefing: pages</source>
        <translation>Briefing: Seiten</translation>
    </message>
</context>
<context>
    <name>Conditions</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 to %2 kg</source>
        <translation>%1 bis %2 kg</translation>
    </message>
    <message>
        <source>ISA</source>
        <translation>ISA</translation>
    </message>
    <message>
        <source>ISA %1 °C</source>
        <translation>ISA %1 °C</translation>
    </message>
    <message>
        <source>%1, QNH %2 hPa</source>
        <translation>%1, QNH %2 hPa</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, %2 lost in it</source>
        <translation>%1, %2 gehen darin verloren</translation>
    </message>
    <message>
        <source>%1 lost at once</source>
        <translation>%1 gehen sofort verloren</translation>
    </message>
    <message>
        <source>rolling into turns and out of them, at %1° per second, at its worst leaves every glide from the tour at least %2 above the ground</source>
        <translation>das Rollen in Kurven und aus ihnen, mit %1° pro Sekunde, lässt jedem Gleitweg von der Tour im schlechtesten Fall mindestens %2 über dem Boden</translation>
    </message>
    <message>
        <source>rolling into turns is not modelled and is covered by the clearance only</source>
        <translation>das Rollen in Kurven ist nicht berücksichtigt und nur durch den Bodenabstand gedeckt</translation>
    </message>
    <message>
        <source>after a straight of %1 on the landing course</source>
        <translation>nach einer Geraden von %1 auf dem Landekurs</translation>
    </message>
    <message>
        <source>%1, descending %2 over ground</source>
        <translation>%1, mit %2 Sinken über Grund</translation>
    </message>
    <message>
        <source>by a full circle from overhead, at least %1 above the runway where it begins</source>
        <translation>mit einem Vollkreis von über dem Platz, der mindestens %1 über der Piste beginnt</translation>
    </message>
    <message>
        <source>by a full circle from overhead</source>
        <translation>mit einem Vollkreis von über dem Platz</translation>
    </message>
    <message>
        <source>at the threshold on the landing course, by whatever curve leads there</source>
        <translation>an der Schwelle auf dem Landekurs, über welche Kurve auch immer</translation>
    </message>
    <message>
        <source>an obstacle surface that begins %1 before the touchdown point and rises by %2 %</source>
        <translation>einer Hindernisfläche, die %1 vor dem Aufsetzpunkt beginnt und um %2 % ansteigt</translation>
    </message>
    <message>
        <source>%1: %2 TAS, %3 per hour</source>
        <translation>%1: %2 TAS, %3 pro Stunde</translation>
    </message>
    <message>
        <source>%1, %2 of climb</source>
        <translation>%1, %2 Steigen</translation>
    </message>
    <message>
        <source>%1 with the ways from and to home</source>
        <translation>%1 mit den Wegen von und nach der Heimatpiste</translation>
    </message>
    <message>
        <source> of %1 usable</source>
        <translation> von %1 ausfliegbar</translation>
    </message>
    <message>
        <source>the flight takes %1, and %2 are usable</source>
        <translation>der Flug braucht %1, ausfliegbar sind %2</translation>
    </message>
    <message>
        <source>%1: %2 circles of %3 radius, no lower than %4</source>
        <translation>%1: Kreise nach %2 mit Radius %3, nicht tiefer als %4</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>in this cold air it shows up to %1 too much at %2 and %3 at %4, set to the QNH of a runway at %5: fly so much higher than the altitudes of this briefing say</source>
        <translation>in dieser kalten Luft zeigt er, auf das QNH einer Piste in %5 gestellt, bis zu %1 zu viel in %2 und %3 in %4: um so viel höher fliegen, als die Höhen dieses Briefings sagen</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>X-Plane 11/12 flight plan (1100)</source>
        <translation>X-Plane-11/12-Flugplan (1100)</translation>
    </message>
    <message>
        <source>X-Plane 10 flight plan (version 3)</source>
        <translation>X-Plane-10-Flugplan (Version 3)</translation>
    </message>
    <message>
        <source>Garmin flight plan (G1000, GTN)</source>
        <translation>Garmin-Flugplan (G1000, GTN)</translation>
    </message>
    <message>
        <source>Garmin user waypoints</source>
        <translation>Garmin-Benutzerwegpunkte</translation>
    </message>
    <message>
        <source>Microsoft Flight Simulator flight plan</source>
        <translation>Flugplan für Microsoft Flight Simulator</translation>
    </message>
    <message>
        <source>Little Navmap flight plan</source>
        <translation>Little-Navmap-Flugplan</translation>
    </message>
    <message>
        <source>QGroundControl plan</source>
        <translation>QGroundControl-Plan</translation>
    </message>
    <message>
        <source>SeeYou waypoints and tasks</source>
        <translation>SeeYou-Wendepunkte und -Aufgaben</translation>
    </message>
    <message>
        <source>GPX route and track</source>
        <translation>GPX-Route und -Track</translation>
    </message>
    <message>
        <source>KML for Google Earth</source>
        <translation>KML für Google Earth</translation>
    </message>
    <message>
        <source>KMZ for Google Earth</source>
        <translation>KMZ für Google Earth</translation>
    </message>
    <message>
        <source>FlightGear flight plan</source>
        <translation>FlightGear-Flugplan</translation>
    </message>
    <message>
        <source>GeoJSON for maps and GIS</source>
        <translation>GeoJSON für Karten und GIS</translation>
    </message>
    <message>
        <source>GeoPackage for GIS</source>
        <translation>GeoPackage für GIS</translation>
    </message>
    <message>
        <source>Table of waypoints and decision points</source>
        <translation>Tabelle der Wegpunkte und Entscheidungspunkte</translation>
    </message>
    <message>
        <source>turns are fly-by turns of the navigator, altitudes are rounded up to whole feet and some readers replace all by the highest, glides and margins are left out</source>
        <translation>Kurven sind Fly-by-Kurven des Navigationsgeräts, Höhen werden auf ganze Fuß aufgerundet und manche Leser ersetzen alle durch die höchste, Gleitwege und Reserven fehlen</translation>
    </message>
    <message>
        <source>altitudes and home runways are in the comments alone, a second runway of the home airport is a user waypoint, glides and margins are left out</source>
        <translation>Höhen und Heimatpisten stehen nur in den Kommentaren, eine zweite Piste des Heimatplatzes ist ein Benutzerwegpunkt, Gleitwege und Reserven fehlen</translation>
    </message>
    <message>
        <source>altitudes are in the names alone, the order is that of the rows, glides and margins are left out</source>
        <translation>Höhen stehen nur in den Namen, die Reihenfolge ist jene der Zeilen, Gleitwege und Reserven fehlen</translation>
    </message>
    <message>
        <source>targets beyond ten letters are shortened, glides and margins are left out</source>
        <translation>Zielnamen über zehn Zeichen werden gekürzt, Gleitwege und Reserven fehlen</translation>
    </message>
    <message>
        <source>its reader moves places by up to half a metre, glides and margins are left out</source>
        <translation>sein Leser verschiebt Orte um bis zu einen halben Meter, Gleitwege und Reserven fehlen</translation>
    </message>
    <message>
        <source>names are left out, rally points stand for runways, glides and margins are left out</source>
        <translation>Namen fehlen, Rally Points stehen für Pisten, Gleitwege und Reserven fehlen</translation>
    </message>
    <message>
        <source>places are rounded to 1.85 m, a task has no altitudes: they are in the names and in the elevation column, glides and margins are left out</source>
        <translation>Orte werden auf 1.85 m gerundet, eine Aufgabe hat keine Höhen: sie stehen in den Namen und in der Spalte der Ortshöhe, Gleitwege und Reserven fehlen</translation>
    </message>
    <message>
        <source>glides and margins are left out</source>
        <translation>Gleitwege und Reserven fehlen</translation>
    </message>
    <message>
        <source>turns are those of its autopilot, glides and margins are left out</source>
        <translation>Kurven sind jene des Autopiloten, Gleitwege und Reserven fehlen</translation>
    </message>
    <message>
        <source>the paths of the glides are left out</source>
        <translation>die Verläufe der Gleitwege fehlen</translation>
    </message>
    <message>
        <source>weather</source>
        <translation>Wetter</translation>
    </message>
    <message>
        <source>success probability in weather</source>
        <translation>Erfolgswahrscheinlichkeit im Wetter</translation>
    </message>
    <message>
        <source>overflown population risk</source>
        <translation>Risiko für überflogene Menschen</translation>
    </message>
    <message>
        <source>people under the path</source>
        <translation>Menschen unter dem Weg</translation>
    </message>
    <message>
        <source>height lost to the approach</source>
        <translation>Höhenverlust bis zum Anflug</translation>
    </message>
    <message>
        <source>approach higher than the lowest in range</source>
        <translation>Anflug über dem tiefsten erreichbaren</translation>
    </message>
    <message>
        <source>manoeuvres</source>
        <translation>Manöver</translation>
    </message>
    <message>
        <source>how far away it ends</source>
        <translation>wie weit entfernt er endet</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Entfernung</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>airfields</source>
        <translation>Flugplätze</translation>
    </message>
    <message>
        <source>asking for sizes</source>
        <translation>Größen werden erfragt</translation>
    </message>
    <message>
        <source>contours</source>
        <translation>Höhenlinien</translation>
    </message>
    <message>
        <source>joining the tiles</source>
        <translation>Kacheln werden zusammengefügt</translation>
    </message>
    <message>
        <source>lowest safe altitudes</source>
        <translation>tiefste sichere Höhen</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>geplant</translation>
    </message>
    <message>
        <source>reading the airfields</source>
        <translation>Flugplätze werden gelesen</translation>
    </message>
    <message>
        <source>terrain: read</source>
        <translation>Gelände: gelesen</translation>
    </message>
    <message>
        <source>terrain: reading heights</source>
        <translation>Gelände: Höhen werden gelesen</translation>
    </message>
    <message>
        <source>terrain: warping to the local frame</source>
        <translation>Gelände: Umrechnung ins örtliche System</translation>
    </message>
    <message>
        <source>waiting for another program that fetches the same</source>
        <translation>auf ein anderes Programm warten, das dasselbe holt</translation>
    </message>
    <message>
        <source>{}: a turn at {:.0f} degrees of bank needs load factor {:.2f}, but at the glide speed of {:.1f} m/s the aircraft stalls above {:.2f} ({:.0f} degrees of bank); plan with a profile of less bank before flying this</source>
        <translation>%1: eine Kurve mit %2 Grad Querlage braucht das Lastvielfache %3, aber bei der Gleitgeschwindigkeit von %4 m/s überzieht das Flugzeug über %5 (%6 Grad Querlage); mit einem Profil mit weniger Querlage planen, bevor dies geflogen wird</translation>
    </message>
    <message>
        <source>{}: a turn at {:.0f} degrees of bank needs load factor {:.2f}, above the structural limit of {:.2f}</source>
        <translation>%1: eine Kurve mit %2 Grad Querlage braucht das Lastvielfache %3, mehr als die Festigkeitsgrenze von %4</translation>
    </message>
    <message>
        <source>{} of up to {:.0f} kt, the aircraft&apos;s limit is {:.0f} kt</source>
        <translation>%1 bis zu %2 kt, die Grenze des Flugzeugs ist %3 kt</translation>
    </message>
    <message>
        <source>the wind&apos;s altitude of {} is not between {:.0f} and {:.0f} ft</source>
        <translation>die Höhe des Winds, %1, liegt nicht zwischen %2 und %3 ft</translation>
    </message>
    <message>
        <source>the wind{} blows from {} degrees, but a direction lies between 0 and 360</source>
        <translation>der Wind%1 kommt aus %2 Grad, aber eine Richtung liegt zwischen 0 und 360</translation>
    </message>
    <message>
        <source>the wind{} varies by {} degrees to each side, but a spread lies between 0 and 180</source>
        <translation>der Wind%1 schwankt um %2 Grad nach jeder Seite, aber eine Schwankung liegt zwischen 0 und 180</translation>
    </message>
    <message>
        <source>the wind{} has a speed of {}, but a speed lies between 0 and {}</source>
        <translation>der Wind%1 hat eine Stärke von %2, aber eine Stärke liegt zwischen 0 und %3</translation>
    </message>
    <message>
        <source>the greatest speed of the wind{}, {}, is below its least, {}</source>
        <translation>die größte Stärke des Winds%1, %2, liegt unter der kleinsten, %3</translation>
    </message>
    <message>
        <source>the wind at {} is given twice; give one for each altitude</source>
        <translation>der Wind in %1 ist zweimal angegeben; für jede Höhe einen angeben</translation>
    </message>
    <message>
        <source>the wind at {} comes after the one at {}; give the lowest layer first</source>
        <translation>der Wind in %1 kommt nach dem in %2; die tiefste Schicht zuerst angeben</translation>
    </message>
    <message>
        <source>the wind may change by {} between {} and {}; sinking through that the aircraft makes no way in a steep turn</source>
        <translation>der Wind kann sich um %1 zwischen %2 und %3 ändern; beim Sinken durch diese Schicht kommt das Flugzeug in einer steilen Kurve nicht voran</translation>
    </message>
    <message>
        <source>, that of the lightest aircraft in the densest air</source>
        <translation>, der des leichtesten Flugzeugs in der dichtesten Luft</translation>
    </message>
    <message>
        <source>the wind of {} at {} is not below the gliding speed of {}{}; no glide makes way against it</source>
        <translation>der Wind von %1 in %2 liegt nicht unter der Gleitgeschwindigkeit von %3%4; kein Gleitweg kommt gegen ihn voran</translation>
    </message>
    <message>
        <source>the wind of {} at {} is not below the {} over ground that the aircraft glides at in a steep turn in still air; it makes no way against it</source>
        <translation>der Wind von %1 in %2 liegt nicht unter den %3 über Grund, mit denen das Flugzeug bei Windstille in einer steilen Kurve gleitet; es kommt gegen ihn nicht voran</translation>
    </message>
    <message>
        <source>internal error: expected </source>
        <translation>interner Fehler: erwartet war </translation>
    </message>
    <message>
        <source>there is no such file; check the name and the folder it is relative to</source>
        <translation>es gibt keine solche Datei; den Namen prüfen und den Ordner, auf den er sich bezieht</translation>
    </message>
    <message>
        <source>this is a folder, not a file</source>
        <translation>dies ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>this is a device or pipe, not a file; copy what is to be read into a file</source>
        <translation>dies ist ein Gerät oder eine Pipe, keine Datei; was gelesen werden soll, in eine Datei kopieren</translation>
    </message>
    <message>
        <source>this is an address, and only files of this computer are read; download the file and name the copy</source>
        <translation>dies ist eine Adresse, und nur Dateien dieses Rechners werden gelesen; die Datei herunterladen und die Kopie angeben</translation>
    </message>
    <message>
        <source>larger than </source>
        <translation>größer als </translation>
    </message>
    <message>
        <source>; this is no file that the program reads</source>
        <translation>; dies ist keine Datei, die das Programm liest</translation>
    </message>
    <message>
        <source>the name says what to write: .tif for values, .kml or .gpkg for contours</source>
        <translation>der Name bestimmt, was geschrieben wird: .tif für Werte, .kml oder .gpkg für Höhenlinien</translation>
    </message>
    <message>
        <source>No glide to any of the {} runway ends that are near enough stays clear of the ground, of {} that were tried.</source>
        <translation>Kein Gleitweg zu einem der %1 Pistenenden, die nah genug sind, bleibt frei vom Boden; versucht wurden %2.</translation>
    </message>
    <message>
        <source>No path leaves more height in hand by half a metre or more.</source>
        <translation>Kein Weg lässt mindestens einen halben Meter mehr Höhe übrig.</translation>
    </message>
    <message>
        <source>The planner {} ended with an error of its own: {}.</source>
        <translation>Das Verfahren %1 endete mit einem eigenen Fehler: %2.</translation>
    </message>
    <message>
        <source>There was not enough time to find and verify a glide: give a later deadline.</source>
        <translation>Die Zeit reichte nicht, um einen Gleitweg zu finden und zu prüfen: eine spätere Frist setzen.</translation>
    </message>
    <message>
        <source>{}: {:.0f} m in hand.</source>
        <translation>%1: %2 m Höhe übrig.</translation>
    </message>
    <message>
        <source>This planner keeps height and looks at no risk: its risk is told, not kept low.</source>
        <translation>Dieses Verfahren erhält Höhe und achtet auf kein Risiko: das Risiko wird genannt, nicht klein gehalten.</translation>
    </message>
    <message>
        <source>No glide to any of the {} runway ends that are near enough stays clear of the ground, of {} ways that were tried.</source>
        <translation>Kein Gleitweg zu einem der %1 Pistenenden, die nah genug sind, bleibt frei vom Boden; versucht wurden %2 Wege.</translation>
    </message>
    <message>
        <source>The aircraft comes to the approach {:.0f} m too high: lose that in circles before it.</source>
        <translation>Das Flugzeug kommt %1 m zu hoch zum Anflug: diese Höhe vorher in Kreisen abbauen.</translation>
    </message>
    <message>
        <source>No way of turns and straights from here arrives at a runway clear of the ground within the deadline: try another planner.</source>
        <translation>Innerhalb der Frist fand sich kein Weg aus Kurven und Geraden, der von hier frei vom Boden zu einer Piste führt: ein anderes Verfahren versuchen.</translation>
    </message>
    <message>
        <source>A turn, a straight and a turn, or an S-turn.</source>
        <translation>Eine Kurve, eine Gerade und eine Kurve, oder eine S-Kurve.</translation>
    </message>
    <message>
        <source>Fallback to </source>
        <translation>Ersatzweg zu </translation>
    </message>
    <message>
        <source>: a turn, a straight and a turn, or an S-turn.</source>
        <translation>: eine Kurve, eine Gerade und eine Kurve, oder eine S-Kurve.</translation>
    </message>
    <message>
        <source>Gradient-guided search to {}{}.</source>
        <translation>Gradientengeführte Suche zu %1%2.</translation>
    </message>
    <message>
        <source>, height lost in circles first</source>
        <translation>, Höhe zuerst in Kreisen abgebaut</translation>
    </message>
    <message>
        <source>No runway is in range: the closest is {}, {:.1f} km away, and even straight there the glide would have to begin {:.0f} m higher.</source>
        <translation>Keine Piste ist in Reichweite: die nächste ist %1, %2 km entfernt, und selbst geradeaus dorthin müsste der Gleitweg %3 m höher beginnen.</translation>
    </message>
    <message>
        <source>No runway can be landed on: {}.</source>
        <translation>Auf keiner Piste kann gelandet werden: %1.</translation>
    </message>
    <message>
        <source>The path is NOT to a runway: of the glides that keep the clearance it gets farthest.</source>
        <translation>Der Weg führt NICHT zu einer Piste: von den Gleitwegen, die den Bodenabstand halten, kommt er am weitesten.</translation>
    </message>
    <message>
        <source>The path is NOT to a runway: of the glides that keep the clearance and get far it is the one of least risk to people.</source>
        <translation>Der Weg führt NICHT zu einer Piste: von den Gleitwegen, die den Bodenabstand halten und weit kommen, ist er der mit dem kleinsten Risiko für Menschen.</translation>
    </message>
    <message>
        <source>A deadline of zero leaves no time for any answer: give at least a few milliseconds, for example 1s.</source>
        <translation>Eine Frist von null lässt keine Zeit für eine Antwort: mindestens einige Millisekunden angeben, zum Beispiel 1s.</translation>
    </message>
    <message>
        <source>The aircraft&apos;s position, course and altitude must be finite numbers: give longitude, latitude, altitude and true course.</source>
        <translation>Position, Kurs und Höhe des Flugzeugs müssen endliche Zahlen sein: Länge, Breite, Höhe und rechtweisenden Kurs angeben.</translation>
    </message>
    <message>
        <source>The aircraft is outside the terrain of the mission, where nothing is known about the ground: give a place on the map, or add terrain that covers this one.</source>
        <translation>Das Flugzeug ist außerhalb des Geländes der Mission, wo über den Boden nichts bekannt ist: einen Ort auf der Karte angeben, oder Gelände hinzufügen, das diesen Ort abdeckt.</translation>
    </message>
    <message>
        <source>The terrain has no data at the aircraft&apos;s place, so nothing is known about the ground: give another place, or terrain without this gap.</source>
        <translation>Das Gelände hat am Ort des Flugzeugs keine Daten, daher ist über den Boden nichts bekannt: einen anderen Ort angeben, oder Gelände ohne diese Lücke.</translation>
    </message>
    <message>
        <source>The aircraft would be below the ground: {:.0f} m MSL where the terrain is up to {:.0f} m MSL; give an altitude above that.</source>
        <translation>Das Flugzeug wäre unter dem Boden: %1 m MSL, wo das Gelände bis zu %2 m MSL hoch ist; eine Höhe darüber angeben.</translation>
    </message>
    <message>
        <source>The aircraft is at {:.0f} m MSL, above the ceiling of {:.0f} m MSL up to which the mission&apos;s figures hold: give a lower altitude, or raise the ceiling of mission and aircraft.</source>
        <translation>Das Flugzeug ist in %1 m MSL, über der Obergrenze von %2 m MSL, bis zu der die Zahlen der Mission gelten: eine tiefere Höhe angeben, oder die Obergrenze von Mission und Flugzeug anheben.</translation>
    </message>
    <message>
        <source>The mission has no landing site at all: add airfields to it.</source>
        <translation>Die Mission hat gar keinen Landeplatz: ihr Flugplätze hinzufügen.</translation>
    </message>
    <message>
        <source>The octree of free space was stopped.</source>
        <translation>Der Octree des freien Raums wurde angehalten.</translation>
    </message>
    <message>
        <source>There was not enough time to build the roadmap of landing glides: give a later deadline.</source>
        <translation>Die Zeit reichte nicht, um das Wegenetz der Gleitwege zu erstellen: eine spätere Frist setzen.</translation>
    </message>
    <message>
        <source>There is no roadmap of landing glides: {}.</source>
        <translation>Es gibt kein Wegenetz der Gleitwege: %1.</translation>
    </message>
    <message>
        <source>The roadmap knows no glide from here to a runway, from any height.</source>
        <translation>Das Wegenetz kennt von hier keinen Gleitweg zu einer Piste, aus keiner Höhe.</translation>
    </message>
    <message>
        <source>The lowest glide that the roadmap knows from here is to another runway: ask another planner.</source>
        <translation>Der tiefste Gleitweg, den das Wegenetz von hier kennt, führt zu einer anderen Piste: ein anderes Verfahren fragen.</translation>
    </message>
    <message>
        <source>There is no approach to the runway of the roadmap: {}.</source>
        <translation>Es gibt keinen Anflug zur Piste des Wegenetzes: %1.</translation>
    </message>
    <message>
        <source>The lowest glide that the roadmap knows from here, to {}, has to begin at {:.0f} m MSL: {:.0f} m are missing.</source>
        <translation>Der tiefste Gleitweg, den das Wegenetz von hier kennt, zu %1, muss in %2 m MSL beginnen: es fehlen %3 m.</translation>
    </message>
    <message>
        <source>ceiling and visibility</source>
        <translation>Wolkenuntergrenze und Sicht</translation>
    </message>
    <message>
        <source>Ceiling and visibility there are not known.</source>
        <translation>Wolkenuntergrenze und Sicht dort sind nicht bekannt.</translation>
    </message>
    <message>
        <source>emergency services</source>
        <translation>Feuerwehr und Rettungsdienst</translation>
    </message>
    <message>
        <source>Fire and rescue services there are not known.</source>
        <translation>Ob es dort Feuerwehr und Rettungsdienst gibt, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>weather on the way</source>
        <translation>Wetter auf dem Weg</translation>
    </message>
    <message>
        <source>Weather on the way is not known.</source>
        <translation>Das Wetter auf dem Weg ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Weather on the way does not count, as there is no way.</source>
        <translation>Wetter auf dem Weg zählt nicht, da es keinen Weg gibt.</translation>
    </message>
    <message>
        <source>{}{:.1f} km of {}</source>
        <translation>%1%2 km %3</translation>
    </message>
    <message>
        <source>No bad weather on the way.</source>
        <translation>Kein schlechtes Wetter auf dem Weg.</translation>
    </message>
    <message>
        <source>Through {}: {:.0f} % come through.</source>
        <translation>Durch %1: %2 % kommen durch.</translation>
    </message>
    <message>
        <source>height in hand</source>
        <translation>übrige Höhe</translation>
    </message>
    <message>
        <source>Not reached: </source>
        <translation>Nicht erreicht: </translation>
    </message>
    <message>
        <source>Reached with {:.0f} m of height in hand.</source>
        <translation>Erreicht mit %1 m übriger Höhe.</translation>
    </message>
    <message>
        <source>runway length</source>
        <translation>Pistenlänge</translation>
    </message>
    <message>
        <source>The length of the runway is not known.</source>
        <translation>Die Länge der Piste ist nicht bekannt.</translation>
    </message>
    <message>
        <source>{:.0f} m long; what the aircraft needs is not known.</source>
        <translation>%1 m lang; was das Flugzeug braucht, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>{:.0f} m long, {:.0f} m needed{}.</source>
        <translation>%1 m lang, %2 m nötig%3.</translation>
    </message>
    <message>
        <source>: too short</source>
        <translation>: zu kurz</translation>
    </message>
    <message>
        <source>runway width</source>
        <translation>Pistenbreite</translation>
    </message>
    <message>
        <source>The width of the runway is not known.</source>
        <translation>Die Breite der Piste ist nicht bekannt.</translation>
    </message>
    <message>
        <source>A hard surface.</source>
        <translation>Befestigte Oberfläche.</translation>
    </message>
    <message>
        <source>A gravel surface.</source>
        <translation>Oberfläche aus Schotter.</translation>
    </message>
    <message>
        <source>A grass surface.</source>
        <translation>Oberfläche aus Gras.</translation>
    </message>
    <message>
        <source>A dirt surface.</source>
        <translation>Oberfläche aus Erde.</translation>
    </message>
    <message>
        <source>A surface of snow.</source>
        <translation>Oberfläche aus Schnee.</translation>
    </message>
    <message>
        <source>The surface is not known.</source>
        <translation>Die Oberfläche ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The wind there is not known; the way is planned in still air.</source>
        <translation>Der Wind dort ist nicht bekannt; der Weg ist bei Windstille geplant.</translation>
    </message>
    <message>
        <source>Up to {:.0f} kt of crosswind, {}.</source>
        <translation>Bis zu %1 kt Seitenwind, %2.</translation>
    </message>
    <message>
        <source>up to {:.0f} kt of tailwind</source>
        <translation>bis zu %1 kt Rückenwind</translation>
    </message>
    <message>
        <source>at least {:.0f} kt of headwind</source>
        <translation>mindestens %1 kt Gegenwind</translation>
    </message>
    <message>
        <source>people under the final approach</source>
        <translation>Menschen unter dem Endanflug</translation>
    </message>
    <message>
        <source>How many people live under the final approach is not known.</source>
        <translation>Wie viele Menschen unter dem Endanflug leben, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>{:.0f} people live under the last {:.0f} NM of the final course.</source>
        <translation>%1 Menschen leben unter den letzten %2 NM des Endanflugs.</translation>
    </message>
    <message>
        <source>Not known to be lighted.</source>
        <translation>Keine Befeuerung bekannt.</translation>
    </message>
    <message>
        <source>There was not enough time to look for a way there: give a later deadline.</source>
        <translation>Die Zeit reichte nicht, um einen Weg dorthin zu suchen: eine spätere Frist setzen.</translation>
    </message>
    <message>
        <source>Rolling into its turns and out of them may cost this way up to {:.0f} m, more than the clearance of {:.0f} m.</source>
        <translation>Das Rollen in die Kurven und aus ihnen kann diesen Weg bis zu %1 m kosten, mehr als den Bodenabstand von %2 m.</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>kein Grund genannt</translation>
    </message>
    <message>
        <source>A path was found, but the checker did not accept it: {}.</source>
        <translation>Ein Weg wurde gefunden, aber die Prüfung hat ihn nicht angenommen: %1.</translation>
    </message>
    <message>
        <source>No glide to any of the {} runway ends that are near enough stays clear of the ground, of {} ways that were flown.</source>
        <translation>Kein Gleitweg zu einem der %1 Pistenenden, die nah genug sind, bleibt frei vom Boden; geflogen wurden %2 Wege.</translation>
    </message>
    <message>
        <source>the server sends no table of OurAirports; check the address, and whether the network wants a login first</source>
        <translation>der Server schickt keine Tabelle von OurAirports; die Adresse prüfen, und ob das Netz zuerst eine Anmeldung verlangt</translation>
    </message>
    <message>
        <source>the server has no such file; check the address</source>
        <translation>der Server hat keine solche Datei; die Adresse prüfen</translation>
    </message>
    <message>
        <source>what the server sent holds no landing site; the files from before stay</source>
        <translation>was der Server geschickt hat, enthält keinen Landeplatz; die Dateien von vorher bleiben</translation>
    </message>
    <message>
        <source>what the server sent is no table of OurAirports, the files from before stay: </source>
        <translation>was der Server geschickt hat, ist keine Tabelle von OurAirports, die Dateien von vorher bleiben: </translation>
    </message>
    <message>
        <source>there is no airfield &quot;{}&quot;; check the code, or give latitude,longitude instead</source>
        <translation>es gibt keinen Flugplatz „%1“; die Kennung prüfen, oder stattdessen Breite,Länge angeben</translation>
    </message>
    <message>
        <source>the header has no column &quot;{}&quot;; name airports.csv of OurAirports or a .cup file</source>
        <translation>der Kopfzeile fehlt die Spalte &quot;%1&quot;; airports.csv von OurAirports oder eine .cup-Datei angeben</translation>
    </message>
    <message>
        <source>neither XDG_CACHE_HOME nor HOME is set, so there is no place for the cache; name a folder</source>
        <translation>weder XDG_CACHE_HOME noch HOME ist gesetzt, daher gibt es keinen Platz für den Cache; einen Ordner angeben</translation>
    </message>
    <message>
        <source>this is no address of a server; it begins with https:// and has neither spaces nor ?</source>
        <translation>dies ist keine Adresse eines Servers; eine solche beginnt mit https:// und enthält weder Leerzeichen noch ?</translation>
    </message>
    <message>
        <source>the server does not send parts of files (HTTP range requests), so a broken download could not be continued; choose another server</source>
        <translation>der Server schickt keine Teile von Dateien (HTTP range requests), daher könnte ein abgebrochener Download nicht fortgesetzt werden; einen anderen Server wählen</translation>
    </message>
    <message>
        <source>the server refuses access (HTTP {}); check the address, or the proxy&apos;s settings</source>
        <translation>der Server verweigert den Zugriff (HTTP %1); die Adresse prüfen, oder die Einstellungen des Proxys</translation>
    </message>
    <message>
        <source>the connection breaks off again and again; try again later, what came so far is kept</source>
        <translation>die Verbindung bricht immer wieder ab; später noch einmal versuchen, was bisher kam, bleibt</translation>
    </message>
    <message>
        <source>the server answers with HTTP {}; try again later, or check the address</source>
        <translation>der Server antwortet mit HTTP %1; später noch einmal versuchen, oder die Adresse prüfen</translation>
    </message>
    <message>
        <source>the file on the server was changed while it was fetched; fetch it again</source>
        <translation>die Datei auf dem Server wurde geändert, während sie geholt wurde; sie noch einmal holen</translation>
    </message>
    <message>
        <source>the file on the server is empty; try again later, or choose another server</source>
        <translation>die Datei auf dem Server ist leer; später noch einmal versuchen, oder einen anderen Server wählen</translation>
    </message>
    <message>
        <source>the proxy that the environment names cannot be found; correct http_proxy or https_proxy</source>
        <translation>der Proxy, den die Umgebung nennt, ist nicht zu finden; http_proxy oder https_proxy berichtigen</translation>
    </message>
    <message>
        <source>the server&apos;s name cannot be found; check the network and the address, what was fetched before works without</source>
        <translation>der Name des Servers ist nicht zu finden; das Netz und die Adresse prüfen, früher Geholtes geht auch ohne</translation>
    </message>
    <message>
        <source>no server answers there; check the network and the address, what was fetched before works without</source>
        <translation>dort antwortet kein Server; das Netz und die Adresse prüfen, früher Geholtes geht auch ohne</translation>
    </message>
    <message>
        <source>the server does not answer in time; try again later, what came so far is kept</source>
        <translation>der Server antwortet nicht rechtzeitig; später noch einmal versuchen, was bisher kam, bleibt</translation>
    </message>
    <message>
        <source>no secure connection to the server could be made; check the system&apos;s date and certificates</source>
        <translation>es konnte keine sichere Verbindung zum Server hergestellt werden; Datum und Zertifikate des Systems prüfen</translation>
    </message>
    <message>
        <source>the connection failed; check the network and the address</source>
        <translation>die Verbindung ist gescheitert; das Netz und die Adresse prüfen</translation>
    </message>
    <message>
        <source>fetching was stopped; what came so far is kept and will be continued</source>
        <translation>das Holen wurde angehalten; was bisher kam, bleibt und wird fortgesetzt</translation>
    </message>
    <message>
        <source>the GDAL library of this system was built without network access</source>
        <translation>die GDAL-Bibliothek dieses Systems wurde ohne Netzzugriff gebaut</translation>
    </message>
    <message>
        <source>cannot be written: </source>
        <translation>kann nicht geschrieben werden: </translation>
    </message>
    <message>
        <source>stopped while another program fetches the same file</source>
        <translation>angehalten, während ein anderes Programm dieselbe Datei holt</translation>
    </message>
    <message>
        <source>the folder cannot be made: </source>
        <translation>der Ordner kann nicht angelegt werden: </translation>
    </message>
    <message>
        <source>a folder has this name; choose another file name</source>
        <translation>ein Ordner hat diesen Namen; einen anderen Dateinamen wählen</translation>
    </message>
    <message>
        <source>the file is write-protected; remove the protection or choose another name</source>
        <translation>die Datei ist schreibgeschützt; den Schutz aufheben oder einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>the raster could not be made</source>
        <translation>das Raster konnte nicht erzeugt werden</translation>
    </message>
    <message>
        <source>the raster was not taken</source>
        <translation>das Raster wurde nicht angenommen</translation>
    </message>
    <message>
        <source>the tile cannot be read</source>
        <translation>die Kachel kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>; remove it and fetch it again</source>
        <translation>; sie entfernen und neu holen</translation>
    </message>
    <message>
        <source>the tile is damaged</source>
        <translation>die Kachel ist beschädigt</translation>
    </message>
    <message>
        <source>fetching was stopped; the tiles that are here stay</source>
        <translation>das Holen wurde angehalten; die vorhandenen Kacheln bleiben</translation>
    </message>
    <message>
        <source>the area holds no post of the terrain; choose a larger one</source>
        <translation>das Gebiet enthält keinen Geländepunkt; ein größeres wählen</translation>
    </message>
    <message>
        <source>no terrain on the server for {}: taken as sea, flat at 0 m</source>
        <translation>kein Gelände auf dem Server für %1: als Meer genommen, flach auf 0 m</translation>
    </message>
    <message>
        <source>no terrain is published for {}: nothing is known there, so nothing counts as safe there</source>
        <translation>kein Gelände ist veröffentlicht für %1: dort ist nichts bekannt, daher gilt dort nichts als sicher</translation>
    </message>
    <message>
        <source>1 tile: {} on this machine, {} to fetch</source>
        <translation>1 Kachel: %1 auf diesem Rechner, %2 zu laden</translation>
    </message>
    <message>
        <source>{} tiles: {} on this machine, {} to fetch</source>
        <translation>%1 Kacheln: %2 auf diesem Rechner, %3 zu laden</translation>
    </message>
    <message>
        <source>, {} not published</source>
        <translation>, %1 nicht veröffentlicht</translation>
    </message>
    <message>
        <source>the area crosses a parallel where the spacing of posts changes, so it is in several files; a mission needs all of them</source>
        <translation>das Gebiet kreuzt einen Breitenkreis, an dem sich der Abstand der Geländepunkte ändert, daher liegt es in mehreren Dateien; eine Mission braucht sie alle</translation>
    </message>
    <message>
        <source>the area is not on earth; give west, south, east, north in degrees, -180 to 180 and -90 to 90</source>
        <translation>das Gebiet liegt nicht auf der Erde; West, Süd, Ost, Nord in Grad angeben, -180 bis 180 und -90 bis 90</translation>
    </message>
    <message>
        <source>west lies east of east; exchange them, and fetch an area across the 180th meridian in two parts</source>
        <translation>West liegt östlich von Ost; sie vertauschen, und ein Gebiet über den 180. Meridian in zwei Teilen holen</translation>
    </message>
    <message>
        <source>the area is empty or less than 0.001 degrees wide; give west, south, east, north</source>
        <translation>das Gebiet ist leer oder weniger als 0.001 Grad breit; West, Süd, Ost, Nord angeben</translation>
    </message>
    <message>
        <source>the area covers {} tiles of one degree, at most {} can be fetched at once; choose a smaller area</source>
        <translation>das Gebiet umfasst %1 Kacheln von einem Grad, höchstens %2 können auf einmal geholt werden; ein kleineres Gebiet wählen</translation>
    </message>
    <message>
        <source>the radius must be 0.1 to 300 km</source>
        <translation>der Radius muss 0.1 bis 300 km sein</translation>
    </message>
    <message>
        <source>the circle holds a pole; choose a smaller radius</source>
        <translation>der Kreis enthält einen Pol; einen kleineren Radius wählen</translation>
    </message>
    <message>
        <source>the area crosses the 180th meridian; fetch it in two parts, each given by its corners</source>
        <translation>das Gebiet kreuzt den 180. Meridian; es in zwei Teilen holen, jeden durch seine Ecken angegeben</translation>
    </message>
    <message>
        <source>what the server sent is no terrain tile: it must be one band in degrees; choose another server</source>
        <translation>was der Server geschickt hat, ist keine Geländekachel: es muss ein Band in Grad sein; einen anderen Server wählen</translation>
    </message>
    <message>
        <source>what the server sent lies elsewhere than tile {}; choose another server</source>
        <translation>was der Server geschickt hat, liegt anderswo als Kachel %1; einen anderen Server wählen</translation>
    </message>
    <message>
        <source>the server sends no GeoTIFF{}; check the address, and whether the network wants a login first</source>
        <translation>der Server schickt kein GeoTIFF%1; die Adresse prüfen, und ob das Netz zuerst eine Anmeldung verlangt</translation>
    </message>
    <message>
        <source> but a web page</source>
        <translation> (sondern eine Webseite)</translation>
    </message>
    <message>
        <source>what the server sent is no GeoTIFF</source>
        <translation>was der Server geschickt hat, ist kein GeoTIFF</translation>
    </message>
    <message>
        <source>; try again, or choose another server</source>
        <translation>; noch einmal versuchen, oder einen anderen Server wählen</translation>
    </message>
    <message>
        <source>what the server sent is damaged</source>
        <translation>was der Server geschickt hat, ist beschädigt</translation>
    </message>
    <message>
        <source>the server&apos;s list of tiles names none; check the address, and whether the network wants a login first</source>
        <translation>die Kachelliste des Servers nennt keine; die Adresse prüfen, und ob das Netz zuerst eine Anmeldung verlangt</translation>
    </message>
    <message>
        <source>the server&apos;s list of tiles cannot be read; try again later</source>
        <translation>die Kachelliste des Servers kann nicht gelesen werden; später noch einmal versuchen</translation>
    </message>
    <message>
        <source>the server&apos;s list of tiles was changed while it was read; try again</source>
        <translation>die Kachelliste des Servers wurde geändert, während sie gelesen wurde; noch einmal versuchen</translation>
    </message>
    <message>
        <source>the server has neither a list of tiles (tileList.txt) nor any tile of this area; it may be sea, or the address is wrong</source>
        <translation>der Server hat weder eine Kachelliste (tileList.txt) noch eine Kachel dieses Gebiets; es kann Meer sein, oder die Adresse ist falsch</translation>
    </message>
    <message>
        <source>the server lists this tile and does not have it; try again later, or choose another server</source>
        <translation>der Server führt diese Kachel in seiner Liste und hat sie nicht; später noch einmal versuchen, oder einen anderen Server wählen</translation>
    </message>
    <message>
        <source>the server does not have this tile any more; try again later</source>
        <translation>der Server hat diese Kachel nicht mehr; später noch einmal versuchen</translation>
    </message>
    <message>
        <source>the cached tile {} was damaged (its checksum did not fit) and was made or fetched again</source>
        <translation>die Kachel %1 im Cache war beschädigt (ihre Prüfsumme passte nicht) und wurde neu erzeugt oder geholt</translation>
    </message>
    <message>
        <source>the cached tile {} is damaged, its checksum does not fit, and it cannot be fetched again: {}</source>
        <translation>die Kachel %1 im Cache ist beschädigt, ihre Prüfsumme passt nicht, und sie kann nicht neu geholt werden: %2</translation>
    </message>
    <message>
        <source>The wind or the airspeed is not a number.</source>
        <translation>Der Wind oder die Eigengeschwindigkeit ist keine Zahl.</translation>
    </message>
    <message>
        <source>The wind is as strong as the airspeed or stronger, so the aircraft cannot fly against it.</source>
        <translation>Der Wind ist so stark wie die Eigengeschwindigkeit oder stärker, daher kann das Flugzeug nicht gegen ihn fliegen.</translation>
    </message>
    <message>
        <source>A place or heading is not a number.</source>
        <translation>Ein Ort oder Kurs ist keine Zahl.</translation>
    </message>
    <message>
        <source>The turn radius is not above zero.</source>
        <translation>Der Kurvenradius liegt nicht über null.</translation>
    </message>
    <message>
        <source>The two places are too far apart for so small a turn radius.</source>
        <translation>Die zwei Orte sind zu weit auseinander für einen so kleinen Kurvenradius.</translation>
    </message>
    <message>
        <source>No path of three parts connects the two places in this wind.</source>
        <translation>Kein Weg aus drei Teilen verbindet die zwei Orte bei diesem Wind.</translation>
    </message>
    <message>
        <source>there is no aircraft &quot;{}&quot;: no bundled profiles were found in {}; set VOLPLANE_RESOURCES to their folder</source>
        <translation>es gibt kein Flugzeug „%1“: in %2 wurden keine mitgelieferten Profile gefunden; VOLPLANE_RESOURCES auf ihren Ordner setzen</translation>
    </message>
    <message>
        <source>there is no bundled aircraft &quot;{}&quot;{}; choose one of {}, or name a .json file</source>
        <translation>es gibt kein mitgeliefertes Flugzeug „%1“%2; eines von diesen wählen: %3, oder eine .json-Datei angeben</translation>
    </message>
    <message>
        <source>, is &quot;{}&quot; meant?</source>
        <translation>, ist „%1“ gemeint?</translation>
    </message>
    <message>
        <source>degrees per second</source>
        <translation>Grad pro Sekunde</translation>
    </message>
    <message>
        <source>the least mass of {} kg is above the mass of the polar, {} kg</source>
        <translation>die kleinste Masse von %1 kg liegt über der Masse der Polare, %2 kg</translation>
    </message>
    <message>
        <source>the greatest mass of {} kg is below the mass of the polar, {} kg</source>
        <translation>die größte Masse von %1 kg liegt unter der Masse der Polare, %2 kg</translation>
    </message>
    <message>
        <source>the speed never to be exceeded, {} m/s, is not above the speed of best glide, {} m/s</source>
        <translation>die Höchstgeschwindigkeit, %1 m/s, liegt nicht über der Geschwindigkeit des besten Gleitens, %2 m/s</translation>
    </message>
    <message>
        <source>the steepest descent of {:.2f} degrees is shallower than the glide, {:.2f} degrees</source>
        <translation>das steilste Sinken von %1 Grad ist flacher als das Gleiten, %2 Grad</translation>
    </message>
    <message>
        <source>{} is given twice; names must differ</source>
        <translation>%1 ist zweimal angegeben; Namen müssen verschieden sein</translation>
    </message>
    <message>
        <source>all power settings of an aircraft must count in the same unit</source>
        <translation>alle Leistungseinstellungen eines Flugzeugs müssen in derselben Einheit zählen</translation>
    </message>
    <message>
        <source>the airspeed of {}, {} m/s, is not above the stall speed of {} m/s</source>
        <translation>die Eigengeschwindigkeit von %1, %2 m/s, liegt nicht über der Überziehgeschwindigkeit von %3 m/s</translation>
    </message>
    <message>
        <source>the airspeed of {}, {} m/s, is above the speed never to be exceeded, {} m/s</source>
        <translation>die Eigengeschwindigkeit von %1, %2 m/s, liegt über der Höchstgeschwindigkeit, %3 m/s</translation>
    </message>
    <message>
        <source>fuel or charge is counted in the unit of the power settings, and there are none; add one, or leave it out</source>
        <translation>Kraftstoff oder Ladung wird in der Einheit der Leistungseinstellungen gezählt, und es gibt keine; eine hinzufügen, oder die Angabe weglassen</translation>
    </message>
    <message>
        <source>with the propeller windmilling drag exceeds weight, no glide exists; check it against zeroLiftDrag</source>
        <translation>mit drehendem Propeller ist der Widerstand größer als das Gewicht, es gibt kein Gleiten; mit zeroLiftDrag vergleichen</translation>
    </message>
    <message>
        <source>with the propeller stopped drag exceeds weight, no glide exists; check it against zeroLiftDrag</source>
        <translation>mit stehendem Propeller ist der Widerstand größer als das Gewicht, es gibt kein Gleiten; mit zeroLiftDrag vergleichen</translation>
    </message>
    <message>
        <source>at least one bank angle is needed, a glide must be able to turn</source>
        <translation>mindestens eine Querlage ist nötig, ein Gleitweg muss Kurven enthalten können</translation>
    </message>
    <message>
        <source>bank angles must ascend and none be given twice</source>
        <translation>Querlagen müssen ansteigen, und keine darf zweimal angegeben sein</translation>
    </message>
    <message>
        <source>must be below bestGlideSpeed_mps, or the aircraft stalls in its glide</source>
        <translation>muss unter bestGlideSpeed_mps liegen, sonst überzieht das Flugzeug im Gleitflug</translation>
    </message>
    <message>
        <source>at this speed drag exceeds weight, no glide exists; check speed, mass, wing area and polar</source>
        <translation>bei dieser Geschwindigkeit ist der Widerstand größer als das Gewicht, es gibt kein Gleiten; Geschwindigkeit, Masse, Flügelfläche und Polare prüfen</translation>
    </message>
    <message>
        <source>at {:.1f} degrees of bank drag exceeds weight, no glide exists; leave this bank angle out</source>
        <translation>bei %1 Grad Querlage ist der Widerstand größer als das Gewicht, es gibt kein Gleiten; diese Querlage weglassen</translation>
    </message>
    <message>
        <source>heading in the file differs by {:.0f} degrees from the runway ends; the ends count</source>
        <translation>Richtung in der Datei weicht um %1 Grad von den Pistenenden ab; die Enden gelten</translation>
    </message>
    <message>
        <source>length in the file is {:.0f} m but the runway ends are {:.0f} m apart; the shorter counts</source>
        <translation>Länge in der Datei ist %1 m, aber die Pistenenden liegen %2 m auseinander; die kürzere gilt</translation>
    </message>
    <message>
        <source>one runway end derived from the other, length and heading</source>
        <translation>ein Pistenende aus dem anderen, Länge und Richtung abgeleitet</translation>
    </message>
    <message>
        <source>runway length unknown</source>
        <translation>Pistenlänge unbekannt</translation>
    </message>
    <message>
        <source>runway ends derived from the airport&apos;s position, length and heading</source>
        <translation>Pistenenden aus Position des Flugplatzes, Länge und Richtung abgeleitet</translation>
    </message>
    <message>
        <source>runway length unknown; the airport&apos;s position is taken as touchdown point</source>
        <translation>Pistenlänge unbekannt; die Position des Flugplatzes gilt als Aufsetzpunkt</translation>
    </message>
    <message>
        <source>elevation of the airport, not of the threshold</source>
        <translation>Höhe des Flugplatzes, nicht der Schwelle</translation>
    </message>
    <message>
        <source>elevation of the threshold ({:.0f} m) and of the airport ({:.0f} m) disagree; the higher counts</source>
        <translation>Höhe der Schwelle (%1 m) und des Flugplatzes (%2 m) stimmen nicht überein; die größere gilt</translation>
    </message>
    <message>
        <source>more than {} landing sites; take the part of the file for the region</source>
        <translation>mehr als %1 Landeplätze; den Teil der Datei für die Region nehmen</translation>
    </message>
    <message>
        <source>displaced threshold negative or beyond the runway</source>
        <translation>versetzte Schwelle negativ oder jenseits der Piste</translation>
    </message>
    <message>
        <source>no elevation in the file, the terrain&apos;s is used</source>
        <translation>keine Höhe in der Datei, die des Geländes wird verwendet</translation>
    </message>
    <message>
        <source>excluded by the mission</source>
        <translation>von der Mission ausgeschlossen</translation>
    </message>
    <message>
        <source>excluded by the mission: </source>
        <translation>von der Mission ausgeschlossen: </translation>
    </message>
    <message>
        <source>geometry only approximate, which the mission does not accept</source>
        <translation>Geometrie nur ungefähr, was die Mission nicht zulässt</translation>
    </message>
    <message>
        <source>shorter than {:.0f} m</source>
        <translation>kürzer als %1 m</translation>
    </message>
    <message>
        <source>narrower than {:.0f} m</source>
        <translation>schmaler als %1 m</translation>
    </message>
    <message>
        <source>surface unknown</source>
        <translation>Oberfläche unbekannt</translation>
    </message>
    <message>
        <source>surface not among those that the mission allows</source>
        <translation>Oberfläche nicht unter denen, die die Mission erlaubt</translation>
    </message>
    <message>
        <source>not lighted, as far as the file says</source>
        <translation>nicht befeuert, soweit die Datei es sagt</translation>
    </message>
    <message>
        <source>runway end more than 15 km from its airport</source>
        <translation>Pistenende mehr als 15 km von seinem Flugplatz</translation>
    </message>
    <message>
        <source>no heading and not both runway ends in the file</source>
        <translation>keine Richtung und nicht beide Pistenenden in der Datei</translation>
    </message>
    <message>
        <source>length unknown, so the least length that the mission asks for is not assured</source>
        <translation>Länge unbekannt, daher ist die von der Mission verlangte kleinste Länge nicht gesichert</translation>
    </message>
    <message>
        <source>width unknown, so the least width that the mission asks for is not assured</source>
        <translation>Breite unbekannt, daher ist die von der Mission verlangte kleinste Breite nicht gesichert</translation>
    </message>
    <message>
        <source>opposite end of a one-way runway</source>
        <translation>Gegenrichtung einer Piste, die nur in einer Richtung benutzbar ist</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>weggelassen</translation>
    </message>
    <message>
        <source>an OurAirports file needs its runways file too; add &quot;runways&quot;: &quot;runways.csv&quot; beside it</source>
        <translation>eine OurAirports-Datei braucht auch ihre Pistendatei; daneben &quot;runways&quot;: &quot;runways.csv&quot; hinzufügen</translation>
    </message>
    <message>
        <source>this is no file of airfields that the program knows: OurAirports .csv, X-Plane apt.dat, SeeYou .cup, or a table or GeoJSON of own fields with the columns latitude, longitude and course_deg</source>
        <translation>dies ist keine Flugplatzdatei, die das Programm kennt: OurAirports .csv, X-Plane apt.dat, SeeYou .cup, oder eine Tabelle oder GeoJSON mit eigenen Feldern und den Spalten latitude, longitude und course_deg</translation>
    </message>
    <message>
        <source>only the airports file of OurAirports goes with a runways file; this one holds its runways itself, remove &quot;runways&quot;</source>
        <translation>nur zur Flugplatzdatei von OurAirports gehört eine Pistendatei; diese Datei enthält ihre Pisten selbst, &quot;runways&quot; entfernen</translation>
    </message>
    <message>
        <source>a rule needs either a kind or a name</source>
        <translation>eine Regel braucht entweder eine Art (kind) oder einen Namen (name)</translation>
    </message>
    <message>
        <source>must be [longitude, latitude] in degrees</source>
        <translation>muss [Länge, Breite] in Grad sein</translation>
    </message>
    <message>
        <source>an airspace needs three corners or more</source>
        <translation>ein Luftraum braucht drei Ecken oder mehr</translation>
    </message>
    <message>
        <source>{} in line {}</source>
        <translation>%1 in Zeile %2</translation>
    </message>
    <message>
        <source>no name</source>
        <translation>ohne Namen</translation>
    </message>
    <message>
        <source>floor or ceiling missing</source>
        <translation>Unter- oder Obergrenze fehlt</translation>
    </message>
    <message>
        <source>less than three corners</source>
        <translation>weniger als drei Ecken</translation>
    </message>
    <message>
        <source>more than {} corners in the file; take the part of it for the region</source>
        <translation>mehr als %1 Ecken in der Datei; den Teil davon für die Region nehmen</translation>
    </message>
    <message>
        <source>too many corners</source>
        <translation>zu viele Ecken</translation>
    </message>
    <message>
        <source>, so its airspace</source>
        <translation>, daher auch der Luftraum dazu</translation>
    </message>
    <message>
        <source>a floor counts as the surface</source>
        <translation>eine Untergrenze gilt als Erdoberfläche</translation>
    </message>
    <message>
        <source>a ceiling counts as none</source>
        <translation>eine Obergrenze gilt als keine</translation>
    </message>
    <message>
        <source>centre is no place</source>
        <translation>Mittelpunkt ist kein Ort</translation>
    </message>
    <message>
        <source>corner is no place</source>
        <translation>Ecke ist kein Ort</translation>
    </message>
    <message>
        <source>circle without centre or with a radius that makes no sense</source>
        <translation>Kreis ohne Mittelpunkt oder mit unsinnigem Radius</translation>
    </message>
    <message>
        <source>arc without centre, or with a radius or angles that make no sense</source>
        <translation>Bogen ohne Mittelpunkt, oder mit unsinnigem Radius oder unsinnigen Winkeln</translation>
    </message>
    <message>
        <source>arc without centre, or between places that are none</source>
        <translation>Bogen ohne Mittelpunkt, oder zwischen Orten, die keine sind</translation>
    </message>
    <message>
        <source>there is no airspace in this file; an OpenAir file has lines that begin with AC, AN, AL, AH and DP</source>
        <translation>es gibt keinen Luftraum in dieser Datei; eine OpenAir-Datei hat Zeilen, die mit AC, AN, AL, AH und DP beginnen</translation>
    </message>
    <message>
        <source>limits given in words</source>
        <translation>Grenzen in Worten angegeben</translation>
    </message>
    <message>
        <source>header of an airport cut short</source>
        <translation>Kopfzeile eines Flugplatzes abgeschnitten</translation>
    </message>
    <message>
        <source>row of a runway cut short</source>
        <translation>Zeile einer Piste abgeschnitten</translation>
    </message>
    <message>
        <source>runway outside an airport</source>
        <translation>Piste außerhalb eines Flugplatzes</translation>
    </message>
    <message>
        <source>a value of the runway makes no sense</source>
        <translation>ein Wert der Piste ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>runway of a heliport</source>
        <translation>Piste eines Hubschrauberlandeplatzes</translation>
    </message>
    <message>
        <source>more runways than an airport has</source>
        <translation>mehr Pisten, als ein Flugplatz hat</translation>
    </message>
    <message>
        <source>this is no apt.dat: it begins with I or A, and its second line with the version, for example &quot;1100 Version&quot;</source>
        <translation>dies ist keine apt.dat: eine solche beginnt mit I oder A, und ihre zweite Zeile mit der Version, zum Beispiel &quot;1100 Version&quot;</translation>
    </message>
    <message>
        <source>version {:.0f} of apt.dat is not read; 850 to 1299 are</source>
        <translation>Version %1 von apt.dat wird nicht gelesen; gelesen werden 850 bis 1299</translation>
    </message>
    <message>
        <source>there is no airport in this apt.dat; the file may be cut short</source>
        <translation>es gibt keinen Flugplatz in dieser apt.dat; die Datei kann abgeschnitten sein</translation>
    </message>
    <message>
        <source>no file name was given for the output</source>
        <translation>für die Ausgabe wurde kein Dateiname angegeben</translation>
    </message>
    <message>
        <source>this names a folder; add a file name</source>
        <translation>dies bezeichnet einen Ordner; einen Dateinamen anfügen</translation>
    </message>
    <message>
        <source>there is no permission to write there; choose another folder or change its permissions</source>
        <translation>dort darf nicht geschrieben werden; einen anderen Ordner wählen oder seine Zugriffsrechte ändern</translation>
    </message>
    <message>
        <source>the file system is read-only; choose another folder</source>
        <translation>das Dateisystem ist schreibgeschützt; einen anderen Ordner wählen</translation>
    </message>
    <message>
        <source>the disk is full; free some space or choose another folder</source>
        <translation>die Platte ist voll; Platz schaffen oder einen anderen Ordner wählen</translation>
    </message>
    <message>
        <source>the file would be larger than the system allows</source>
        <translation>die Datei wäre größer, als das System erlaubt</translation>
    </message>
    <message>
        <source>there is no such folder; create it first</source>
        <translation>es gibt keinen solchen Ordner; ihn zuerst anlegen</translation>
    </message>
    <message>
        <source>the file name is too long; choose a shorter one</source>
        <translation>der Dateiname ist zu lang; einen kürzeren wählen</translation>
    </message>
    <message>
        <source>; choose another place</source>
        <translation>; einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>{}, row {}, column {}</source>
        <translation>%1, Zeile %2, Spalte %3</translation>
    </message>
    <message>
        <source>{}, row {}, column {} ({})</source>
        <translation>%1, Zeile %2, Spalte %3 (%4)</translation>
    </message>
    <message>
        <source>a quote is opened here and never closed; add the closing quote</source>
        <translation>hier beginnt ein Anführungszeichen, das nie geschlossen wird; das schließende hinzufügen</translation>
    </message>
    <message>
        <source>text follows a closing quote; double the quotes inside a field or add the missing comma</source>
        <translation>nach einem schließenden Anführungszeichen folgt Text; Anführungszeichen innerhalb eines Felds verdoppeln oder das fehlende Komma hinzufügen</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not a {}; write it like {}</source>
        <translation>„%1“ ist keine %2; so schreiben: %3</translation>
    </message>
    <message>
        <source>no usable elevation with a unit</source>
        <translation>keine brauchbare Höhe mit Einheit</translation>
    </message>
    <message>
        <source>no runway direction</source>
        <translation>keine Pistenrichtung</translation>
    </message>
    <message>
        <source>runway direction makes no sense</source>
        <translation>Pistenrichtung ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>runway direction published to whole degrees at best</source>
        <translation>Pistenrichtung bestenfalls auf ganze Grad veröffentlicht</translation>
    </message>
    <message>
        <source>outlanding field, not an aerodrome</source>
        <translation>Außenlandefeld, kein Flugplatz</translation>
    </message>
    <message>
        <source>elevation 0 in the file, which may stand for unknown</source>
        <translation>Höhe 0 in der Datei, was für unbekannt stehen kann</translation>
    </message>
    <message>
        <source>the header has no column &quot;{}&quot;; a .cup file begins with name,code,country,lat,lon,elev,style,rwdir,rwlen,...</source>
        <translation>der Kopfzeile fehlt die Spalte &quot;%1&quot;; eine .cup-Datei beginnt mit name,code,country,lat,lon,elev,style,rwdir,rwlen,...</translation>
    </message>
    <message>
        <source>no geometry</source>
        <translation>keine Geometrie</translation>
    </message>
    <message>
        <source>geometry without coordinates</source>
        <translation>Geometrie ohne Koordinaten</translation>
    </message>
    <message>
        <source>a geometry of unknown type</source>
        <translation>eine Geometrie unbekannter Art</translation>
    </message>
    <message>
        <source>coordinates are no places in degrees of longitude and latitude</source>
        <translation>Koordinaten sind keine Orte in Grad Länge und Breite</translation>
    </message>
    <message>
        <source>the FeatureCollection has no list &quot;features&quot;</source>
        <translation>der FeatureCollection fehlt die Liste &quot;features&quot;</translation>
    </message>
    <message>
        <source>this is no GeoJSON: it has no &quot;type&quot; of a FeatureCollection, Feature or geometry</source>
        <translation>dies ist kein GeoJSON: der &quot;type&quot; einer FeatureCollection, eines Feature oder einer Geometrie fehlt</translation>
    </message>
    <message>
        <source>there is not enough memory for the file; choose wider cells</source>
        <translation>der Speicher reicht nicht für die Datei; größere Zellen wählen</translation>
    </message>
    <message>
        <source>the file could not be made</source>
        <translation>die Datei konnte nicht angelegt werden</translation>
    </message>
    <message>
        <source>there would be more than 2,000 levels of contours; choose a wider interval</source>
        <translation>es gäbe mehr als 2 000 Stufen von Höhenlinien; einen größeren Abstand wählen</translation>
    </message>
    <message>
        <source>the contours could not be drawn</source>
        <translation>die Höhenlinien konnten nicht gezeichnet werden</translation>
    </message>
    <message>
        <source>the map was stopped; nothing was written</source>
        <translation>die Karte wurde angehalten; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>eine endliche Zahl</translation>
    </message>
    <message>
        <source>more than</source>
        <translation>mehr als</translation>
    </message>
    <message>
        <source>at least</source>
        <translation>mindestens</translation>
    </message>
    <message>
        <source>more than {} and at most {}{}</source>
        <translation>mehr als %1 und höchstens %2%3</translation>
    </message>
    <message>
        <source>{}, line {}, column {} ({})</source>
        <translation>%1, Zeile %2, Spalte %3 (%4)</translation>
    </message>
    <message>
        <source>must be an object in braces {{...}}, not {}</source>
        <translation>muss ein Objekt in geschweiften Klammern {...} sein, nicht %1</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is missing; is {} meant?</source>
        <translation>&quot;%1&quot; fehlt; ist %2 gemeint?</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is missing; add it</source>
        <translation>&quot;%1&quot; fehlt; es hinzufügen</translation>
    </message>
    <message>
        <source>must be a number, {}, not {}</source>
        <translation>muss eine Zahl sein, %1, nicht %2</translation>
    </message>
    <message>
        <source>must be {}, not {}</source>
        <translation>muss %1 sein, nicht %2</translation>
    </message>
    <message>
        <source>at least {}</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>must be a whole number, {}, not {}</source>
        <translation>muss eine ganze Zahl sein, %1, nicht %2</translation>
    </message>
    <message>
        <source>must be a whole number, 0 to 18446744073709551615, not {}</source>
        <translation>muss eine ganze Zahl sein, 0 bis 18446744073709551615, nicht %1</translation>
    </message>
    <message>
        <source>must be true or false, not {}</source>
        <translation>muss true oder false sein, nicht %1</translation>
    </message>
    <message>
        <source>must not be empty</source>
        <translation>darf nicht leer sein</translation>
    </message>
    <message>
        <source>must be text in quotes, not {}</source>
        <translation>muss Text in Anführungszeichen sein, nicht %1</translation>
    </message>
    <message>
        <source>must be a list in brackets [...], not {}</source>
        <translation>muss eine Liste in eckigen Klammern [...] sein, nicht %1</translation>
    </message>
    <message>
        <source>&quot;{}_deg&quot; is given too; keep one of them</source>
        <translation>&quot;%1_deg&quot; ist auch angegeben; eines von beiden behalten</translation>
    </message>
    <message>
        <source>must be &quot;{}&quot;, not {}</source>
        <translation>muss &quot;%1&quot; sein, nicht %2</translation>
    </message>
    <message>
        <source>unknown field {}; remove it</source>
        <translation>unbekanntes Feld %1; es entfernen</translation>
    </message>
    <message>
        <source>unknown field {}; is &quot;{}&quot; meant?</source>
        <translation>unbekanntes Feld %1; ist &quot;%2&quot; gemeint?</translation>
    </message>
    <message>
        <source>this is not a {} file: its format is {}</source>
        <translation>dies ist keine Datei der Art %1: ihr Format ist %2</translation>
    </message>
    <message>
        <source>written by a newer Volplane (version {} of the format, this program reads up to {}); update Volplane</source>
        <translation>von einem neueren Volplane geschrieben (Version %1 des Formats, dieses Programm liest bis %2); Volplane aktualisieren</translation>
    </message>
    <message>
        <source>an object has more than {} members; this is no file of this program</source>
        <translation>ein Objekt hat mehr als %1 Einträge; dies ist keine Datei dieses Programms</translation>
    </message>
    <message>
        <source>{} is given twice; keep one of them</source>
        <translation>%1 ist zweimal angegeben; eines davon behalten</translation>
    </message>
    <message>
        <source>nested deeper than {} levels; this is no file of this program</source>
        <translation>tiefer als %1 Ebenen verschachtelt; dies ist keine Datei dieses Programms</translation>
    </message>
    <message>
        <source>more than {} values; this is no file of this program</source>
        <translation>mehr als %1 Werte; dies ist keine Datei dieses Programms</translation>
    </message>
    <message>
        <source>{}, line {}, column {}</source>
        <translation>%1, Zeile %2, Spalte %3</translation>
    </message>
    <message>
        <source>a long text</source>
        <translation>ein langer Text</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>this is not JSON ({})</source>
        <translation>dies ist kein JSON (%1)</translation>
    </message>
    <message>
        <source>the number {} is too large; write a finite one</source>
        <translation>die Zahl %1 ist zu groß; eine endliche schreiben</translation>
    </message>
    <message>
        <source>the JSON text ends in the middle; the file is cut short or a closing bracket is missing</source>
        <translation>der JSON-Text endet mittendrin; die Datei ist abgeschnitten, oder eine schließende Klammer fehlt</translation>
    </message>
    <message>
        <source>this is not JSON: {}; near &apos;{}&apos;</source>
        <translation>dies ist kein JSON: %1; nahe &apos;%2&apos;</translation>
    </message>
    <message>
        <source>{} is no surface; use one of {}</source>
        <translation>%1 ist keine Oberfläche; eine von diesen verwenden: %2</translation>
    </message>
    <message>
        <source>must be {}a profile in braces {{...}}, not {}</source>
        <translation>muss %1ein Profil in geschweiften Klammern {...} sein, nicht %2</translation>
    </message>
    <message>
        <source>the name of an aircraft or </source>
        <translation>der Name eines Flugzeugs oder </translation>
    </message>
    <message>
        <source>{} are too many; a mission has {} at most</source>
        <translation>%1 sind zu viele; eine Mission hat höchstens %2</translation>
    </message>
    <message>
        <source>at least one terrain file is needed</source>
        <translation>mindestens eine Geländedatei ist nötig</translation>
    </message>
    <message>
        <source>the file was changed while it was read; try again when nothing writes to it any more</source>
        <translation>die Datei wurde geändert, während sie gelesen wurde; noch einmal versuchen, wenn nichts mehr in sie schreibt</translation>
    </message>
    <message>
        <source>{} left out: farther than {:.1f} km from {}</source>
        <translation>%1 weggelassen: weiter als %2 km von %3</translation>
    </message>
    <message>
        <source>the point that the mission gives</source>
        <translation>dem Punkt, den die Mission angibt</translation>
    </message>
    <message>
        <source>every target</source>
        <translation>jedem Ziel</translation>
    </message>
    <message>
        <source>reading the airfields was stopped</source>
        <translation>das Lesen der Flugplätze wurde angehalten</translation>
    </message>
    <message>
        <source>{}: elevation {:.0f} m, but the terrain there is {:.0f} m; check both before relying on this site</source>
        <translation>%1: Höhe %2 m, aber das Gelände dort hat %3 m; beides prüfen und sich erst dann auf diesen Landeplatz verlassen</translation>
    </message>
    <message>
        <source>{} landing sites lie outside the terrain or where it has no data and are not used</source>
        <translation>%1 Landeplätze liegen außerhalb des Geländes oder wo es keine Daten hat, und werden nicht verwendet</translation>
    </message>
    <message>
        <source>not landed on in this wind</source>
        <translation>bei diesem Wind nicht angeflogen</translation>
    </message>
    <message>
        <source>too short to be landed on that day</source>
        <translation>zu kurz zum Landen an diesem Tag</translation>
    </message>
    <message>
        <source>targets {} and {} are at the same place; remove one of them</source>
        <translation>die Ziele %1 und %2 liegen am selben Ort; eines davon entfernen</translation>
    </message>
    <message>
        <source>siteFilter names {}, but no landing site inside the terrain is called that; correct the name or remove it</source>
        <translation>siteFilter nennt %1, aber kein Landeplatz im Gelände heißt so; den Namen berichtigen oder entfernen</translation>
    </message>
    <message>
        <source>target {} at {:.5f}, {:.5f} lies {}; move it or load terrain that covers it</source>
        <translation>Ziel %1 bei %2, %3 liegt %4; es verschieben, oder Gelände laden, das es abdeckt</translation>
    </message>
    <message>
        <source>outside the terrain</source>
        <translation>außerhalb des Geländes</translation>
    </message>
    <message>
        <source>where the terrain has no data</source>
        <translation>dort, wo das Gelände keine Daten hat</translation>
    </message>
    <message>
        <source>target {} at {:.0f} m MSL lies below the ground there ({:.0f} m); give a greater height, or one above ground</source>
        <translation>Ziel %1 in %2 m MSL liegt unter dem Boden dort (%3 m); eine größere Höhe angeben, oder eine über Grund</translation>
    </message>
    <message>
        <source>reading the airspaces was stopped</source>
        <translation>das Lesen der Lufträume wurde angehalten</translation>
    </message>
    <message>
        <source>in this wind the aircraft may land on no runway inside the terrain: {}; wait for less wind, load terrain with other runways, or correct the limits of the aircraft</source>
        <translation>bei diesem Wind darf das Flugzeug auf keiner Piste im Gelände landen: %1; auf weniger Wind warten, Gelände mit anderen Pisten laden, oder die Grenzen des Flugzeugs berichtigen</translation>
    </message>
    <message>
        <source>every runway inside the terrain is too short for the aircraft on that day: {}; load terrain with other runways, or correct the landing distance of the aircraft</source>
        <translation>jede Piste im Gelände ist an diesem Tag zu kurz für das Flugzeug: %1; Gelände mit anderen Pisten laden, oder die Landestrecke des Flugzeugs berichtigen</translation>
    </message>
    <message>
        <source>no usable landing site lies inside the terrain; load terrain that covers a runway, add airfields, or relax the site filter</source>
        <translation>kein verwendbarer Landeplatz liegt im Gelände; Gelände laden, das eine Piste abdeckt, Flugplätze hinzufügen, oder den Pistenfilter lockern</translation>
    </message>
    <message>
        <source>; the plan needs the terrain it was made with to be verified</source>
        <translation>; der Plan braucht zum Prüfen das Gelände, mit dem er gemacht wurde</translation>
    </message>
    <message>
        <source>export the file from ourairports.com/data again</source>
        <translation>die Datei von ourairports.com/data neu exportieren</translation>
    </message>
    <message>
        <source>this is an airports file; name runways.csv as &quot;runways&quot;</source>
        <translation>dies ist eine Flugplatzdatei; runways.csv als &quot;runways&quot; angeben</translation>
    </message>
    <message>
        <source>this is a runways file; name airports.csv as &quot;airports&quot; and this one as &quot;runways&quot;</source>
        <translation>dies ist eine Pistendatei; airports.csv als &quot;airports&quot; angeben und diese als &quot;runways&quot;</translation>
    </message>
    <message>
        <source>the header has no column &quot;{}&quot;; {}</source>
        <translation>der Kopfzeile fehlt die Spalte &quot;%1&quot;; %2</translation>
    </message>
    <message>
        <source>the row has {} fields and the header {}; a comma or a quote is missing or too many</source>
        <translation>die Zeile hat %1 Felder und die Kopfzeile %2; ein Komma oder Anführungszeichen fehlt oder ist zu viel</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not a number of degrees; correct it or remove the row</source>
        <translation>„%1“ ist keine Zahl in Grad; sie berichtigen oder die Zeile entfernen</translation>
    </message>
    <message>
        <source>airport without a usable position</source>
        <translation>Flugplatz ohne brauchbare Position</translation>
    </message>
    <message>
        <source>airport closed</source>
        <translation>Flugplatz geschlossen</translation>
    </message>
    <message>
        <source>seaplane base</source>
        <translation>Wasserflugplatz</translation>
    </message>
    <message>
        <source>more than {} airports; take the part of the file for the region</source>
        <translation>mehr als %1 Flugplätze; den Teil der Datei für die Region nehmen</translation>
    </message>
    <message>
        <source>headings of the two ends are not opposite; the first counts</source>
        <translation>Richtungen der beiden Enden sind nicht entgegengesetzt; die erste gilt</translation>
    </message>
    <message>
        <source>heading disagrees with the runway number; the heading counts</source>
        <translation>Richtung passt nicht zur Pistennummer; die Richtung gilt</translation>
    </message>
    <message>
        <source>runway without a name</source>
        <translation>Piste ohne Namen</translation>
    </message>
    <message>
        <source>{} in row {}</source>
        <translation>%1 in Zeile %2</translation>
    </message>
    <message>
        <source>opposite end not in the file</source>
        <translation>Gegenende nicht in der Datei</translation>
    </message>
    <message>
        <source>elevation makes no sense</source>
        <translation>Höhe ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>length makes no sense</source>
        <translation>Länge ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>width makes no sense</source>
        <translation>Breite ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>displaced threshold makes no sense</source>
        <translation>versetzte Schwelle ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>lighted, closed and one_way take yes or no</source>
        <translation>lighted, closed und one_way nehmen yes oder no an</translation>
    </message>
    <message>
        <source>course is no number of 0 to 360 degrees</source>
        <translation>Kurs ist keine Zahl von 0 bis 360 Grad</translation>
    </message>
    <message>
        <source>neither a course nor the other end nor a runway number</source>
        <translation>weder ein Kurs noch das andere Ende noch eine Pistennummer</translation>
    </message>
    <message>
        <source>latitude and longitude are no place in degrees</source>
        <translation>Breite und Länge sind kein Ort in Grad</translation>
    </message>
    <message>
        <source>field of </source>
        <translation>Feld aus </translation>
    </message>
    <message>
        <source>the header lacks latitude and longitude, or course_deg (or end_latitude and end_longitude, or runway)</source>
        <translation>der Kopfzeile fehlen latitude und longitude, oder course_deg (oder end_latitude und end_longitude, oder runway)</translation>
    </message>
    <message>
        <source>neither a point nor a line</source>
        <translation>weder ein Punkt noch eine Linie</translation>
    </message>
    <message>
        <source>must be [metres east, metres north, heading in radians]</source>
        <translation>muss [Meter nach Osten, Meter nach Norden, Kurs in Radiant] sein</translation>
    </message>
    <message>
        <source>there is no element {} in {}, which has {}</source>
        <translation>es gibt kein Element %1 in %2 (Zahl der Elemente dort: %3)</translation>
    </message>
    <message>
        <source>the file names no coordinate system and its coordinates are no degrees; add the .prj file that belongs to it</source>
        <translation>die Datei nennt kein Koordinatensystem, und ihre Koordinaten sind keine Grad; die .prj-Datei hinzufügen, die zu ihr gehört</translation>
    </message>
    <message>
        <source>the coordinate system of the file is none that the program understands; save it in WGS 84 degrees (EPSG:4326)</source>
        <translation>das Koordinatensystem der Datei ist keines, das das Programm versteht; sie in WGS 84 in Grad (EPSG:4326) speichern</translation>
    </message>
    <message>
        <source>this is no file of polygons that the program reads (GeoJSON, shapefile, GeoPackage, KML)</source>
        <translation>dies ist keine Polygondatei, die das Programm liest (GeoJSON, Shapefile, GeoPackage, KML)</translation>
    </message>
    <message>
        <source>the file has no polygons; </source>
        <translation>die Datei hat keine Polygone; </translation>
    </message>
    <message>
        <source>more than {} areas; cut the file to the region that is flown over</source>
        <translation>mehr als %1 Flächen; die Datei auf die überflogene Region zuschneiden</translation>
    </message>
    <message>
        <source>more than {} corners; cut the file to the region that is flown over</source>
        <translation>mehr als %1 Ecken; die Datei auf die überflogene Region zuschneiden</translation>
    </message>
    <message>
        <source>population is read from areas with people in them</source>
        <translation>Bevölkerung wird aus Flächen gelesen, in denen Menschen leben</translation>
    </message>
    <message>
        <source>no field of this file says how many people live in its polygons; call one POPULATION, or DENSITY for people per square kilometre</source>
        <translation>kein Feld dieser Datei sagt, wie viele Menschen in ihren Polygonen leben; eines POPULATION nennen, oder DENSITY für Menschen je Quadratkilometer</translation>
    </message>
    <message>
        <source>{}: 1 feature {} left out; nobody is taken to live there.</source>
        <translation>%1: 1 Feature %2 weggelassen; dort gilt niemand als ansässig.</translation>
    </message>
    <message>
        <source>{}: {} features {} left out; nobody is taken to live there.</source>
        <translation>%1: %2 Features %3 weggelassen; dort gilt niemand als ansässig.</translation>
    </message>
    <message>
        <source>without a polygon</source>
        <translation>ohne Polygon</translation>
    </message>
    <message>
        <source>without a number of people</source>
        <translation>ohne Zahl der Menschen</translation>
    </message>
    <message>
        <source>no feature has both a polygon and a number of people; this is no file of population</source>
        <translation>kein Feature hat sowohl ein Polygon als auch eine Zahl der Menschen; dies ist keine Bevölkerungsdatei</translation>
    </message>
    <message>
        <source>heading derived from the runway&apos;s name, a direction of the wind rose</source>
        <translation>Richtung aus dem Namen der Piste abgeleitet, einer Richtung der Windrose</translation>
    </message>
    <message>
        <source>heading derived from the runway number, taken as true: compasses are unreliable here</source>
        <translation>Richtung aus der Pistennummer abgeleitet, als rechtweisend genommen: Kompasse sind hier unzuverlässig</translation>
    </message>
    <message>
        <source>heading derived from the runway number and the magnetic variation of {:.0f} degrees {}</source>
        <translation>Richtung aus der Pistennummer und der Missweisung abgeleitet (%1 Grad %2)</translation>
    </message>
    <message>
        <source>the header has no column &quot;{}&quot;</source>
        <translation>der Kopfzeile fehlt die Spalte &quot;%1&quot;</translation>
    </message>
    <message>
        <source>lat and lon are no place like 4632.046N 00953.046E</source>
        <translation>lat und lon sind kein Ort wie 4632.046N 00953.046E</translation>
    </message>
    <message>
        <source>reading the targets was stopped</source>
        <translation>das Lesen der Ziele wurde angehalten</translation>
    </message>
    <message>
        <source>the root of this XML is {}, not gpx</source>
        <translation>das Wurzelelement dieses XML ist %1, nicht gpx</translation>
    </message>
    <message>
        <source>lat and lon are no place in degrees</source>
        <translation>lat und lon sind kein Ort in Grad</translation>
    </message>
    <message>
        <source>link to another file, which is not followed</source>
        <translation>Verweis auf eine andere Datei, dem nicht gefolgt wird</translation>
    </message>
    <message>
        <source>a coordinate is no place in degrees</source>
        <translation>eine Koordinate ist kein Ort in Grad</translation>
    </message>
    <message>
        <source>polygon of less than three corners</source>
        <translation>Polygon mit weniger als drei Ecken</translation>
    </message>
    <message>
        <source>this is no Little Navmap flight plan: LittleNavmap/Flightplan/Waypoints is missing</source>
        <translation>dies ist kein Little-Navmap-Flugplan: LittleNavmap/Flightplan/Waypoints fehlt</translation>
    </message>
    <message>
        <source>airport of the flight plan</source>
        <translation>Flugplatz des Flugplans</translation>
    </message>
    <message>
        <source>Pos is no place in degrees</source>
        <translation>Pos ist kein Ort in Grad</translation>
    </message>
    <message>
        <source>complex item without a polygon of places</source>
        <translation>komplexes Element ohne Polygon aus Orten</translation>
    </message>
    <message>
        <source>no waypoint (take-off, landing or another command)</source>
        <translation>kein Wegpunkt (Start, Landung oder ein anderer Befehl)</translation>
    </message>
    <message>
        <source>waypoint without a place</source>
        <translation>Wegpunkt ohne Ort</translation>
    </message>
    <message>
        <source>height of a waypoint whose reference is unknown; the usual height is taken</source>
        <translation>Höhe eines Wegpunkts, deren Bezug unbekannt ist; die übliche Höhe wird genommen</translation>
    </message>
    <message>
        <source>this is no QGroundControl plan: mission/items is missing</source>
        <translation>dies ist kein QGroundControl-Plan: mission/items fehlt</translation>
    </message>
    <message>
        <source>survey lines need an area of three corners or more and a spacing above zero</source>
        <translation>Vermessungslinien brauchen eine Fläche mit drei Ecken oder mehr und einen Abstand über null</translation>
    </message>
    <message>
        <source>a spacing of {:.1f} m gives {:.0f} survey lines; choose a wider one</source>
        <translation>ein Abstand von %1 m ergibt %2 Vermessungslinien; einen größeren wählen</translation>
    </message>
    <message>
        <source>height makes no sense (metres, or with a unit; reference agl or msl)</source>
        <translation>Höhe ergibt keinen Sinn (Meter, oder mit Einheit; Bezug agl oder msl)</translation>
    </message>
    <message>
        <source>the header has no columns latitude and longitude</source>
        <translation>der Kopfzeile fehlen die Spalten latitude und longitude</translation>
    </message>
    <message>
        <source>at the place of another target</source>
        <translation>am Ort eines anderen Ziels</translation>
    </message>
    <message>
        <source>height out of range</source>
        <translation>Höhe außerhalb des zulässigen Bereichs</translation>
    </message>
    <message>
        <source>more than {} corners of areas; simplify them</source>
        <translation>mehr als %1 Ecken von Flächen; sie vereinfachen</translation>
    </message>
    <message>
        <source>area without extent</source>
        <translation>Fläche ohne Ausdehnung</translation>
    </message>
    <message>
        <source>this is no file of targets that the program knows: SeeYou .cup, GPX, KML or KMZ, a table with the columns latitude and longitude, GeoJSON, QGroundControl .plan, Little Navmap .lnmpln</source>
        <translation>dies ist keine Zieldatei, die das Programm kennt: SeeYou .cup, GPX, KML oder KMZ, eine Tabelle mit den Spalten latitude und longitude, GeoJSON, QGroundControl .plan, Little Navmap .lnmpln</translation>
    </message>
    <message>
        <source>holds {} places; at most {} targets are imported at once, so take a part of them</source>
        <translation>enthält %1 Orte; höchstens %2 Ziele werden auf einmal importiert, daher nur einen Teil davon nehmen</translation>
    </message>
    <message>
        <source>gives {} targets or more; at most {} are imported at once, so choose a wider spacing</source>
        <translation>ergibt %1 Ziele oder mehr; höchstens %2 werden auf einmal importiert, daher einen größeren Abstand wählen</translation>
    </message>
    <message>
        <source>{} survey lines; their ends are targets, which the tour visits in the order that is shortest</source>
        <translation>%1 Vermessungslinien; ihre Enden sind Ziele, die die Tour in der kürzesten Reihenfolge besucht</translation>
    </message>
    <message>
        <source>{} points of tracks were not taken</source>
        <translation>%1 Punkte von Tracks wurden nicht genommen</translation>
    </message>
    <message>
        <source>there are no places for targets in this file</source>
        <translation>es gibt in dieser Datei keine Orte für Ziele</translation>
    </message>
    <message>
        <source>the XML is larger than {} MiB; split it</source>
        <translation>das XML ist größer als %1 MiB; es aufteilen</translation>
    </message>
    <message>
        <source>the XML cannot be read here ({}); the file is damaged or cut short</source>
        <translation>das XML ist hier nicht lesbar (%1); die Datei ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>there is no XML element in this file</source>
        <translation>es gibt kein XML-Element in dieser Datei</translation>
    </message>
    <message>
        <source>the zip archive is damaged or cut short; save it again</source>
        <translation>das Zip-Archiv ist beschädigt oder abgeschnitten; es neu speichern</translation>
    </message>
    <message>
        <source>unpacks to more than 64 MiB; this is no file that the program reads</source>
        <translation>ergibt entpackt mehr als 64 MiB; dies ist keine Datei, die das Programm liest</translation>
    </message>
    <message>
        <source>cannot be unpacked: out of memory</source>
        <translation>kann nicht entpackt werden: zu wenig Speicher</translation>
    </message>
    <message>
        <source>the zip archive is damaged or cut short, or has no </source>
        <translation>das Zip-Archiv ist beschädigt oder abgeschnitten, oder hat keine Datei </translation>
    </message>
    <message>
        <source> in it</source>
        <translation> in sich</translation>
    </message>
    <message>
        <source>the archive is encrypted or packed in a way that is not read; save it again</source>
        <translation>das Archiv ist verschlüsselt oder auf eine Weise gepackt, die nicht gelesen wird; es neu speichern</translation>
    </message>
    <message>
        <source>holds more than 64 MiB; this is no file that the program reads</source>
        <translation>enthält mehr als 64 MiB; dies ist keine Datei, die das Programm liest</translation>
    </message>
    <message>
        <source>larger than {} MiB; this is no file that the program reads</source>
        <translation>größer als %1 MiB; dies ist keine Datei, die das Programm liest</translation>
    </message>
    <message>
        <source>cannot be read: </source>
        <translation>kann nicht gelesen werden: </translation>
    </message>
    <message>
        <source>; check its permissions</source>
        <translation>; die Zugriffsrechte prüfen</translation>
    </message>
    <message>
        <source>the gzip file is damaged or cut short; download it again</source>
        <translation>die gzip-Datei ist beschädigt oder abgeschnitten; sie neu herunterladen</translation>
    </message>
    <message>
        <source>cannot be read; check that it exists and its permissions</source>
        <translation>kann nicht gelesen werden; prüfen, ob es die Datei gibt, und ihre Zugriffsrechte</translation>
    </message>
    <message>
        <source>the text is UTF-16; save it as UTF-8</source>
        <translation>der Text ist UTF-16; ihn als UTF-8 speichern</translation>
    </message>
    <message>
        <source>this is not a text file; check that the right file was named</source>
        <translation>dies ist keine Textdatei; prüfen, ob die richtige Datei angegeben wurde</translation>
    </message>
    <message>
        <source>feature {}{}: {} is &quot;{}&quot;; {}</source>
        <translation>Feature %1%2: %3 ist „%4“; %5</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>eine Zahl angeben</translation>
    </message>
    <message>
        <source>give it with its unit, for example 3000 m, 25000 ft or FL250, or call the field FLOOR_M or TOP_FT</source>
        <translation>mit Einheit angeben, zum Beispiel 3000 m, 25000 ft oder FL250, oder das Feld FLOOR_M oder TOP_FT nennen</translation>
    </message>
    <message>
        <source>weather is read from areas</source>
        <translation>Wetter wird aus Flächen gelesen</translation>
    </message>
    <message>
        <source>no feature has a polygon; this is no file of weather</source>
        <translation>kein Feature hat ein Polygon; dies ist keine Wetterdatei</translation>
    </message>
    <message>
        <source>feature without a polygon is left out; no weather is taken to be there.</source>
        <translation>Feature ohne Polygon wird weggelassen; angenommen wird, dass dort kein Wetter ist.</translation>
    </message>
    <message>
        <source>features without a polygon are left out; no weather is taken to be there.</source>
        <translation>Features ohne Polygon werden weggelassen; angenommen wird, dass dort kein Wetter ist.</translation>
    </message>
    <message>
        <source>cell does not say how likely it is to come through (SUCCESS); 0.9 for a nautical mile is taken.</source>
        <translation>Zelle sagt nicht, wie wahrscheinlich das Durchkommen ist (SUCCESS); 0.9 für eine Seemeile wird genommen.</translation>
    </message>
    <message>
        <source>cells do not say how likely it is to come through (SUCCESS); 0.9 for a nautical mile is taken.</source>
        <translation>Zellen sagen nicht, wie wahrscheinlich das Durchkommen ist (SUCCESS); 0.9 für eine Seemeile wird genommen.</translation>
    </message>
    <message>
        <source>cell has a hole, which counts as weather too.</source>
        <translation>Zelle hat ein Loch, das auch als Wetter gilt.</translation>
    </message>
    <message>
        <source>cells have holes, which count as weather too.</source>
        <translation>Zellen haben Löcher, die auch als Wetter gelten.</translation>
    </message>
    <message>
        <source>weather {} has a number that is not finite; correct it before it is saved</source>
        <translation>Wetter %1 hat eine Zahl, die nicht endlich ist; sie vor dem Speichern berichtigen</translation>
    </message>
    <message>
        <source>a weather cell needs three corners or more</source>
        <translation>eine Wetterzelle braucht drei Ecken oder mehr</translation>
    </message>
    <message>
        <source>the top must be above the floor</source>
        <translation>die Obergrenze muss über der Untergrenze liegen</translation>
    </message>
    <message>
        <source>a wind such as 270/15kt, 27015G25KT, 270+-20/10-20kt, VRB05KT or calm is expected</source>
        <translation>erwartet wird ein Wind wie 270/15kt, 27015G25KT, 270+-20/10-20kt, VRB05KT oder calm</translation>
    </message>
    <message>
        <source>kt, mps or km/h</source>
        <translation>kt, mps oder km/h</translation>
    </message>
    <message>
        <source>{} is no unit of speed here; {} is expected</source>
        <translation>%1 ist hier keine Einheit der Windstärke; erwartet wird %2</translation>
    </message>
    <message>
        <source>the unit of the speed is expected, {}</source>
        <translation>erwartet wird die Einheit der Windstärke, %1</translation>
    </message>
    <message>
        <source>the wind should end here</source>
        <translation>der Wind sollte hier enden</translation>
    </message>
    <message>
        <source>the speed is above 200 kt; a wind of 0 to 200 kt is expected</source>
        <translation>die Stärke liegt über 200 kt; erwartet wird ein Wind von 0 bis 200 kt</translation>
    </message>
    <message>
        <source>P stands for more than the speed after it, and a wind without an upper limit cannot be planned for</source>
        <translation>P steht für mehr als die Stärke dahinter, und für einen Wind ohne obere Grenze kann nicht geplant werden</translation>
    </message>
    <message>
        <source>a speed of two or three digits is expected</source>
        <translation>erwartet wird eine Stärke aus zwei oder drei Ziffern</translation>
    </message>
    <message>
        <source>gusts must be stronger than the wind before them</source>
        <translation>Böen müssen stärker sein als der Wind davor</translation>
    </message>
    <message>
        <source>direction 000 stands for calm, 00000KT; a wind from the north is written 360</source>
        <translation>Richtung 000 steht für Windstille, 00000KT; ein Wind aus Norden wird 360 geschrieben</translation>
    </message>
    <message>
        <source>a speed cannot be below zero</source>
        <translation>eine Stärke kann nicht unter null liegen</translation>
    </message>
    <message>
        <source>a speed is expected, such as 15, 10-20, 15G25 or 15+-5</source>
        <translation>erwartet wird eine Stärke, etwa 15, 10-20, 15G25 oder 15+-5</translation>
    </message>
    <message>
        <source>a number is expected here</source>
        <translation>hier wird eine Zahl erwartet</translation>
    </message>
    <message>
        <source>the lower speed goes first</source>
        <translation>die kleinere Stärke kommt zuerst</translation>
    </message>
    <message>
        <source>the speed would go below zero; write the range, such as 0-15kt</source>
        <translation>die Stärke würde unter null fallen; den Bereich schreiben, etwa 0-15kt</translation>
    </message>
    <message>
        <source>degrees to each side of the direction are expected, such as 270+-20/15kt</source>
        <translation>erwartet werden Grad nach jeder Seite der Richtung, etwa 270+-20/15kt</translation>
    </message>
    <message>
        <source>a spread of 0 to 180 degrees to each side is expected</source>
        <translation>erwartet wird eine Schwankung von 0 bis 180 Grad nach jeder Seite</translation>
    </message>
    <message>
        <source>a slash and a speed are expected after the direction, such as 270/15kt</source>
        <translation>nach der Richtung werden ein Schrägstrich und eine Stärke erwartet, etwa 270/15kt</translation>
    </message>
    <message>
        <source>four digits are a wind of a winds-aloft forecast, which needs its line of altitudes; else a direction of three digits and a speed are expected, such as 270/15kt</source>
        <translation>vier Ziffern sind ein Wind einer Höhenwindvorhersage, die ihre Zeile mit den Höhen braucht; sonst werden eine Richtung aus drei Ziffern und eine Stärke erwartet, etwa 270/15kt</translation>
    </message>
    <message>
        <source>a direction of three digits is expected, such as 027 or 270, and a speed, such as 270/15kt</source>
        <translation>erwartet wird eine Richtung aus drei Ziffern, etwa 027 oder 270, und eine Stärke, etwa 270/15kt</translation>
    </message>
    <message>
        <source>the direction is above 360; 000 to 360 degrees are expected</source>
        <translation>die Richtung liegt über 360; erwartet werden 000 bis 360 Grad</translation>
    </message>
    <message>
        <source>a range of directions is expected, such as 240V300</source>
        <translation>erwartet wird ein Bereich von Richtungen, etwa 240V300</translation>
    </message>
    <message>
        <source>the direction of the wind does not lie in this range, which goes clockwise</source>
        <translation>die Richtung des Winds liegt nicht in diesem Bereich, der im Uhrzeigersinn geht</translation>
    </message>
    <message>
        <source>the direction is missing here; 000 to 360 degrees or VRB are expected</source>
        <translation>hier fehlt die Richtung; erwartet werden 000 bis 360 Grad oder VRB</translation>
    </message>
    <message>
        <source>a wind has either speed_mps or leastSpeed_mps and mostSpeed_mps</source>
        <translation>ein Wind hat entweder speed_mps oder leastSpeed_mps und mostSpeed_mps</translation>
    </message>
    <message>
        <source>peak wind </source>
        <translation>Spitzenwind </translation>
    </message>
    <message>
        <source>the wind of the report is measured near the ground and is taken for all heights</source>
        <translation>der Wind der Meldung ist nahe am Boden gemessen und wird für alle Höhen genommen</translation>
    </message>
    <message>
        <source>other winds of the report are not taken: </source>
        <translation>andere Winde der Meldung werden nicht genommen: </translation>
    </message>
    <message>
        <source>a wind of a winds-aloft forecast is expected, such as 2715, 2725+00 or 283045</source>
        <translation>erwartet wird ein Wind einer Höhenwindvorhersage, etwa 2715, 2725+00 oder 283045</translation>
    </message>
    <message>
        <source>the first two digits are a direction in tens of degrees: 01 to 36, or 51 to 86 from 100 kt on</source>
        <translation>die ersten zwei Ziffern sind eine Richtung in Zehnergraden: 01 bis 36, oder 51 bis 86 ab 100 kt</translation>
    </message>
    <message>
        <source>this stands for 199 kt or more, and a wind without an upper limit cannot be planned for</source>
        <translation>das steht für 199 kt oder mehr, und mit einem Wind ohne obere Grenze kann nicht geplant werden</translation>
    </message>
    <message>
        <source>{} winds for {} altitudes; take out the altitudes that have none, or keep each wind below its altitude</source>
        <translation>%1 Winde für %2 Höhen; die Höhen ohne Wind herausnehmen, oder jeden Wind unter seine Höhe setzen</translation>
    </message>
    <message>
        <source>a station and its winds are expected after the altitudes, such as BRL 2715 2725+00</source>
        <translation>nach den Höhen werden eine Station und ihre Winde erwartet, etwa BRL 2715 2725+00</translation>
    </message>
    <message>
        <source>the winds of one station are expected; take out the others</source>
        <translation>erwartet werden die Winde einer einzigen Station; die anderen herausnehmen</translation>
    </message>
    <message>
        <source>the winds of the station are expected, such as 2715 2725+00</source>
        <translation>erwartet werden die Winde der Station, etwa 2715 2725+00</translation>
    </message>
    <message>
        <source>what stands before the altitudes is ignored: check that the forecast is valid for the flight</source>
        <translation>was vor den Höhen steht, wird nicht beachtet: prüfen, ob die Vorhersage für den Flug gilt</translation>
    </message>
    <message>
        <source>temperatures are ignored</source>
        <translation>Temperaturen werden nicht beachtet</translation>
    </message>
    <message>
        <source>station {}: below {} ft its lowest wind is taken</source>
        <translation>Station %1: unter %2 ft wird der Wind ihrer tiefsten Höhe genommen</translation>
    </message>
    <message>
        <source>altitudes from 18000 ft up are flight levels and are taken as heights above mean sea level</source>
        <translation>Höhen ab 18000 ft sind Flugflächen und werden als Höhen über dem mittleren Meeresspiegel genommen</translation>
    </message>
    <message>
        <source>the wind of the report is expected here, such as 27015KT</source>
        <translation>hier wird der Wind der Meldung erwartet, etwa 27015KT</translation>
    </message>
    <message>
        <source>one report is expected; take out the others</source>
        <translation>erwartet wird eine einzige Meldung; die anderen herausnehmen</translation>
    </message>
    <message>
        <source>an altitude in whole hundreds of feet, or the station behind the altitudes, is expected</source>
        <translation>erwartet wird eine Höhe in ganzen Hundert Fuß, oder die Station nach den Höhen</translation>
    </message>
    <message>
        <source>wind {} at character {}: {}</source>
        <translation>Wind %1 bei Zeichen %2: %3</translation>
    </message>
    <message>
        <source>a wind, or an altitude in whole hundreds of feet or with its unit, ft or m, is expected</source>
        <translation>erwartet wird ein Wind, oder eine Höhe in ganzen Hundert Fuß oder mit ihrer Einheit, ft oder m</translation>
    </message>
    <message>
        <source>a flight level of two or three digits is expected, such as FL095</source>
        <translation>erwartet wird eine Flugfläche mit zwei oder drei Ziffern, etwa FL095</translation>
    </message>
    <message>
        <source>the wind should end here, or a semicolon and the next layer follow</source>
        <translation>hier sollte der Wind enden, oder ein Strichpunkt und die nächste Schicht folgen</translation>
    </message>
    <message>
        <source>with several layers each needs its altitude, such as 5000ft 290/25kt</source>
        <translation>bei mehreren Schichten braucht jede ihre Höhe, etwa 5000ft 290/25kt</translation>
    </message>
    <message>
        <source>flight levels are taken as heights above mean sea level</source>
        <translation>Flugflächen werden als Höhen über dem mittleren Meeresspiegel genommen</translation>
    </message>
    <message>
        <source>any direction</source>
        <translation>jeder Richtung</translation>
    </message>
    <message>
        <source>the wind is empty; write for example 270/15kt, 27015G25KT, 0ft 270/15kt; 5000ft 290/25kt, or calm</source>
        <translation>der Wind ist leer; zum Beispiel 270/15kt, 27015G25KT, 0ft 270/15kt; 5000ft 290/25kt oder calm schreiben</translation>
    </message>
    <message>
        <source>still air</source>
        <translation>Windstille</translation>
    </message>
    <message>
        <source> at every height</source>
        <translation> in jeder Höhe</translation>
    </message>
    <message>
        <source>calm air</source>
        <translation>Windstille</translation>
    </message>
    <message>
        <source>every wind</source>
        <translation>jedem Wind</translation>
    </message>
    <message>
        <source>every wind between the layers of the forecast ({}; true)</source>
        <translation>jedem Wind zwischen den Schichten der Vorhersage (%1; rechtweisend)</translation>
    </message>
    <message>
        <source>World Magnetic Model {} (NOAA NCEI, BGS), valid {:.0f} to {:.0f}</source>
        <translation>World Magnetic Model %1 (NOAA NCEI, BGS), gültig %2 bis %3</translation>
    </message>
    <message>
        <source>stopped while bounding the safe altitudes</source>
        <translation>beim Eingrenzen der sicheren Höhen angehalten</translation>
    </message>
    <message>
        <source>the glide makes no way against the wind on its approach</source>
        <translation>der Gleitflug kommt auf dem Anflug nicht gegen den Wind voran</translation>
    </message>
    <message>
        <source>the aircraft&apos;s profile has no steepest descent, which an approach of a chosen slope needs</source>
        <translation>dem Profil des Flugzeugs fehlt das steilste Sinken, das ein Anflug mit wählbarer Neigung braucht</translation>
    </message>
    <message>
        <source>its approach of {:.1f} degrees cannot be held, as the glide descends at {:.1f} degrees there</source>
        <translation>der Anflug mit %1 Grad kann nicht gehalten werden, da der Gleitflug dort mit %2 Grad sinkt</translation>
    </message>
    <message>
        <source>its approach of {:.1f} degrees cannot be held, as the aircraft descends at no more than {:.1f} degrees there</source>
        <translation>der Anflug mit %1 Grad kann nicht gehalten werden, da das Flugzeug dort mit höchstens %2 Grad sinkt</translation>
    </message>
    <message>
        <source>the ground under its approach is of unknown height</source>
        <translation>der Boden unter dem Anflug ist von unbekannter Höhe</translation>
    </message>
    <message>
        <source>there is no room for a holding circle over known ground at the beginning of its approach</source>
        <translation>am Beginn des Anflugs ist über bekanntem Boden kein Platz für einen Kreis des Warteraums</translation>
    </message>
    <message>
        <source>no landing site lies on terrain with known height; load terrain that covers at least one runway of the airfield list</source>
        <translation>kein Landeplatz liegt auf Gelände mit bekannter Höhe; Gelände laden, das mindestens eine Piste der Flugplatzliste abdeckt</translation>
    </message>
    <message>
        <source>, and neither do the {} others have theirs</source>
        <translation>, und ebenso wenig die übrigen (%1)</translation>
    </message>
    <message>
        <source>no landing site can have the approach that the mission asks for: {}{}</source>
        <translation>kein Landeplatz kann den Anflug haben, den die Mission verlangt: %1%2</translation>
    </message>
    <message>
        <source>roadmap: {} glides</source>
        <translation>Wegenetz: %1 Gleitwege</translation>
    </message>
    <message>
        <source>stopped while building the roadmap of landing glides</source>
        <translation>beim Aufbau des Wegenetzes der Gleitwege angehalten</translation>
    </message>
    <message>
        <source>the area for the roadmap of landing glides is empty</source>
        <translation>die Fläche für das Wegenetz der Gleitwege ist leer</translation>
    </message>
    <message>
        <source>roadmap: {} of {} glides</source>
        <translation>Wegenetz: %1 von %2 Gleitwegen</translation>
    </message>
    <message>
        <source>the map needs an area, cells of at least 10 m and a course</source>
        <translation>die Karte braucht eine Fläche, Zellen von mindestens 10 m und einen Kurs</translation>
    </message>
    <message>
        <source>the map would have more than four million values; choose wider cells or fewer courses</source>
        <translation>die Karte hätte mehr als vier Millionen Werte; größere Zellen oder weniger Kurse wählen</translation>
    </message>
    <message>
        <source>stopped while looking for other runways</source>
        <translation>beim Suchen anderer Pisten angehalten</translation>
    </message>
    <message>
        <source>other runways: {}</source>
        <translation>andere Pisten: %1</translation>
    </message>
    <message>
        <source>{:.0f} m long, {:.0f} m needed</source>
        <translation>%1 m lang, %2 m nötig</translation>
    </message>
    <message>
        <source>more than {} and at most {}</source>
        <translation>mehr als %1 und höchstens %2</translation>
    </message>
    <message>
        <source>between {} and {}</source>
        <translation>von %1 bis %2</translation>
    </message>
    <message>
        <source>the {} of {}{} is not {}{}</source>
        <translation>%1: %2%3 geht nicht; erlaubt: %4%5</translation>
    </message>
    <message>
        <source>temperature offset</source>
        <translation>Temperatur über der Standardatmosphäre</translation>
    </message>
    <message>
        <source>final approach</source>
        <translation>Endanflug</translation>
    </message>
    <message>
        <source>start of the obstacle surface</source>
        <translation>Beginn der Hindernisfläche</translation>
    </message>
    <message>
        <source>approach slope</source>
        <translation>Neigung des Anflugs</translation>
    </message>
    <message>
        <source>slope of the obstacle surface</source>
        <translation>Neigung der Hindernisfläche</translation>
    </message>
    <message>
        <source>height at high key</source>
        <translation>Höhe am High Key</translation>
    </message>
    <message>
        <source>the profile of {} does not say what the drag is with the propeller {}; take the propeller as in its polar, or another profile</source>
        <translation>das Profil von %1 sagt nicht, wie groß der Widerstand mit dem Propeller in diesem Zustand ist (%2); den Propeller wie in der Polare nehmen, oder ein anderes Profil</translation>
    </message>
    <message>
        <source>{} has no power setting &quot;{}&quot;; {}</source>
        <translation>%1 hat keine Leistungseinstellung „%2“; %3</translation>
    </message>
    <message>
        <source>its profile has none</source>
        <translation>das Profil hat keine</translation>
    </message>
    <message>
        <source>it has </source>
        <translation>das Profil hat </translation>
    </message>
    <message>
        <source>an approach slope of {} degrees needs a profile that says how steeply the aircraft can descend, and that of {} does not; leave the slope to the best glide</source>
        <translation>eine Neigung des Anflugs von %1 Grad braucht ein Profil, das sagt, wie steil das Flugzeug sinken kann, und das von %2 tut es nicht; die Neigung dem besten Gleiten überlassen</translation>
    </message>
    <message>
        <source>the approach slope of {} degrees is steeper than {} can descend, {} degrees</source>
        <translation>die Neigung des Anflugs von %1 Grad ist steiler, als %2 sinken kann, %3 Grad</translation>
    </message>
    <message>
        <source>with a drag factor of {} drag exceeds the weight of {}{}, and no glide exists</source>
        <translation>mit einem Widerstandsfaktor von %1 ist der Widerstand größer als das Gewicht von %2%3, und es gibt keinen Gleitflug</translation>
    </message>
    <message>
        <source> in turns of {} degrees of bank</source>
        <translation> in Kurven mit %1 Grad Querlage</translation>
    </message>
    <message>
        <source>reaction time</source>
        <translation>Reaktionszeit</translation>
    </message>
    <message>
        <source>height lost in the reaction</source>
        <translation>Höhenverlust bei der Reaktion</translation>
    </message>
    <message>
        <source>drag factor</source>
        <translation>Widerstandsfaktor</translation>
    </message>
    <message>
        <source>person s/ha</source>
        <translation>Personen·s/ha</translation>
    </message>
    <message>
        <source>a polygon has fewer than three different corners; correct it or leave the feature out</source>
        <translation>ein Polygon hat weniger als drei verschiedene Ecken; berichtigen oder das Objekt weglassen</translation>
    </message>
    <message>
        <source>a corner is no place on Earth; correct it or leave the feature out</source>
        <translation>eine Ecke ist kein Ort auf der Erde; berichtigen oder das Objekt weglassen</translation>
    </message>
    <message>
        <source>sides of the polygon cross each other at {}; draw the outline without the loop, for example with QGIS &gt; Fix geometries</source>
        <translation>Seiten des Polygons kreuzen einander bei %1; den Umriss ohne die Schleife zeichnen, zum Beispiel mit QGIS &gt; Fix geometries</translation>
    </message>
    <message>
        <source>a hole lies outside its polygon at {}; make it a polygon of its own or leave it out</source>
        <translation>ein Loch liegt bei %1 außerhalb seines Polygons; ein eigenes Polygon daraus machen oder es weglassen</translation>
    </message>
    <message>
        <source>{} is {:g}, which cannot be; correct it or leave the feature out</source>
        <translation>%1 ist %2, was nicht sein kann; berichtigen oder das Objekt weglassen</translation>
    </message>
    <message>
        <source>the number of people</source>
        <translation>die Zahl der Menschen</translation>
    </message>
    <message>
        <source>the number of people per square kilometre</source>
        <translation>die Zahl der Menschen je Quadratkilometer</translation>
    </message>
    <message>
        <source>it covers no ground that people could live on; correct its outline or leave the feature out</source>
        <translation>es deckt keinen Boden ab, auf dem Menschen leben könnten; den Umriss berichtigen oder das Objekt weglassen</translation>
    </message>
    <message>
        <source>a probability of {:g} to come through cannot be; give one above 0 and up to 1, for example 0.95</source>
        <translation>eine Wahrscheinlichkeit des Durchkommens von %1 kann nicht sein; eine über 0 und bis 1 angeben, zum Beispiel 0.95</translation>
    </message>
    <message>
        <source>its probability holds for {:g} m, which is no distance; give one above 0, for example 1852 m</source>
        <translation>die Wahrscheinlichkeit gilt für %1 m, was keine Strecke ist; eine über 0 angeben, zum Beispiel 1852 m</translation>
    </message>
    <message>
        <source>its floor or its top is no finite number; give metres above mean sea level, or leave it out</source>
        <translation>die Untergrenze oder die Obergrenze ist keine endliche Zahl; Meter über dem mittleren Meeresspiegel angeben, oder sie weglassen</translation>
    </message>
    <message>
        <source>its floor at {:.0f} m MSL is not below its top at {:.0f} m MSL; exchange or correct them</source>
        <translation>die Untergrenze in %1 m MSL liegt nicht unter der Obergrenze in %2 m MSL; vertauschen oder berichtigen</translation>
    </message>
    <message>
        <source>its outline has fewer than three different corners; add corners or leave the cell out</source>
        <translation>der Umriss hat weniger als drei verschiedene Ecken; Ecken hinzufügen oder die Zelle weglassen</translation>
    </message>
    <message>
        <source>a corner is no place on Earth; correct it or leave the cell out</source>
        <translation>eine Ecke ist kein Ort auf der Erde; berichtigen oder die Zelle weglassen</translation>
    </message>
    <message>
        <source>sides of its outline cross each other at {}; draw it without the loop, or as two cells</source>
        <translation>Seiten des Umrisses kreuzen einander bei %1; ohne die Schleife zeichnen, oder als zwei Zellen</translation>
    </message>
    <message>
        <source>the plan has no tour to export; plan a mission with at least one target</source>
        <translation>der Plan hat keine Tour zum Exportieren; eine Mission mit mindestens einem Ziel planen</translation>
    </message>
    <message>
        <source>the ways from and to the home runway do not fit the plan; plan the mission again</source>
        <translation>die Wege von und zu der Heimatpiste passen nicht zum Plan; die Mission neu planen</translation>
    </message>
    <message>
        <source>the turns of the tour follow each other too closely to be flown from waypoint to waypoint</source>
        <translation>die Kurven der Tour folgen einander zu dicht, um von Wegpunkt zu Wegpunkt geflogen zu werden</translation>
    </message>
    <message>
        <source>takeoff: no gliding guarantee yet</source>
        <translation>Start: noch keine Gleitgarantie</translation>
    </message>
    <message>
        <source>far end of the runway: no gliding guarantee yet</source>
        <translation>Pistenende: noch keine Gleitgarantie</translation>
    </message>
    <message>
        <source>no gliding guarantee yet</source>
        <translation>noch keine Gleitgarantie</translation>
    </message>
    <message>
        <source>gliding guarantee begins</source>
        <translation>Gleitgarantie beginnt</translation>
    </message>
    <message>
        <source>above the threshold: gliding guarantee ends</source>
        <translation>über der Schwelle: Gleitgarantie endet</translation>
    </message>
    <message>
        <source>landing: no gliding guarantee any more</source>
        <translation>Landung: keine Gleitgarantie mehr</translation>
    </message>
    <message>
        <source>Nothing is known of gliding guarantees on this route.</source>
        <translation>Über Gleitgarantien auf dieser Route ist nichts bekannt.</translation>
    </message>
    <message>
        <source>The gliding guarantee begins {:.0f} m of flight past the far end of the runway of {}, at {} ft MSL, at or before SAFE-BEGIN, and ends above the threshold of {} at {} ft MSL; before and after that no glide to a runway is guaranteed.</source>
        <translation>Die Gleitgarantie beginnt %1 m Flug nach dem Pistenende von %2, in %3 ft MSL, bei oder vor SAFE-BEGIN, und endet über der Schwelle von %4 in %5 ft MSL; davor und danach ist kein Gleitweg zu einer Piste garantiert.</translation>
    </message>
    <message>
        <source>the turns where the way </source>
        <translation>die Kurven dort, wo der Weg </translation>
    </message>
    <message>
        <source> home meets the tour follow each other too closely to be flown from waypoint to waypoint</source>
        <translation> der Heimatpiste auf die Tour trifft, folgen einander zu dicht, um von Wegpunkt zu Wegpunkt geflogen zu werden</translation>
    </message>
    <message>
        <source>{:.1f} km from {} ({})</source>
        <translation>%1 km von %2 (%3)</translation>
    </message>
    <message>
        <source>stopped while checking the waypoints</source>
        <translation>beim Prüfen der Wegpunkte angehalten</translation>
    </message>
    <message>
        <source>flown from waypoint to waypoint the path comes over ground of unknown height </source>
        <translation>von Wegpunkt zu Wegpunkt geflogen kommt der Weg über Boden unbekannter Höhe </translation>
    </message>
    <message>
        <source>flown from waypoint to waypoint no glide reaches a landing site from the place </source>
        <translation>von Wegpunkt zu Wegpunkt geflogen erreicht kein Gleitweg einen Landeplatz von dem Ort </translation>
    </message>
    <message>
        <source>the surface</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>{:.0f} m above ground</source>
        <translation>%1 m über Grund</translation>
    </message>
    <message>
        <source>FL {:.0f} (taken as {:.0f} m MSL: standard atmosphere, QNH 1013.25 hPa)</source>
        <translation>FL %1 (als %2 m MSL genommen: Standardatmosphäre, QNH 1013.25 hPa)</translation>
    </message>
    <message>
        <source>a limit in words (NOTAM)</source>
        <translation>Grenze in Worten (NOTAM)</translation>
    </message>
    <message>
        <source>{} (class {}, {} to {})</source>
        <translation>%1 (Klasse %2, %3 bis %4)</translation>
    </message>
    <message>
        <source>an airspace without a name</source>
        <translation>ohne Namen</translation>
    </message>
    <message>
        <source>in the spiral at target {}</source>
        <translation>in der Spirale bei Ziel %1</translation>
    </message>
    <message>
        <source>the tour flies {:.0f} m inside {}, first {}</source>
        <translation>die Tour fliegt %1 m im Luftraum %2, zuerst %3</translation>
    </message>
    <message>
        <source>; the mission keeps the tour out of it: plan again, or allow it (Mission &gt; Airspace)</source>
        <translation>; die Mission hält die Tour aus ihm fern: neu planen, oder ihn erlauben (Mission &gt; Luftraum)</translation>
    </message>
    <message>
        <source>after an engine failure the glides from {} points, the first from {}, enter {}, which an emergency may</source>
        <translation>nach einem Motorausfall führen die Gleitwege von %1 Punkten, der erste von %2, in den Luftraum %3, was ein Notfall darf</translation>
    </message>
    <message>
        <source>airspace {}: its outline or limits are no places and heights on Earth</source>
        <translation>Luftraum %1: Umriss oder Grenzen sind keine Orte und Höhen auf der Erde</translation>
    </message>
    <message>
        <source>the approach to {} at {:.2f} degrees is flatter than the glide there, which needs up to {:.2f} degrees</source>
        <translation>der Anflug zu %1 mit %2 Grad ist flacher als der Gleitflug dort, der bis zu %3 Grad braucht</translation>
    </message>
    <message>
        <source>the approach to {} at {:.2f} degrees is steeper than the aircraft can descend there, {:.2f} degrees with the wind from behind</source>
        <translation>der Anflug zu %1 mit %2 Grad ist steiler, als das Flugzeug dort sinken kann, %3 Grad mit Wind von hinten</translation>
    </message>
    <message>
        <source>the hold before {} has a radius of {:.2f} m to the {}, the aircraft needs {:.2f} m to one side</source>
        <translation>der Warteraum vor %1 hat einen Radius von %2 m nach %3, das Flugzeug braucht %4 m nach einer Seite</translation>
    </message>
    <message>
        <source>the hold before {} crosses ground of unknown height</source>
        <translation>der Warteraum vor %1 quert Boden unbekannter Höhe</translation>
    </message>
    <message>
        <source>the hold before {} goes down to {:.1f} m MSL, but its ground of {:.1f} m and the approach need {:.1f} m</source>
        <translation>der Warteraum vor %1 reicht hinab bis %2 m MSL, aber sein Boden von %3 m und der Anflug brauchen %4 m</translation>
    </message>
    <message>
        <source>after the last whole circle of the hold before {} up to {:.0f} m above the runway may be left, and the steepest descent on the final approach loses {:.0f} m: lose the rest in S-turns or on a part of a circle</source>
        <translation>nach dem letzten ganzen Kreis des Warteraums vor %1 können bis zu %2 m über der Piste übrig sein, und das steilste Sinken auf dem Endanflug kostet %3 m: den Rest in S-Kurven oder auf einem Teil eines Kreises abbauen</translation>
    </message>
    <message>
        <source>glides end at {}, which is {:.0f} m long, but the aircraft needs {:.0f} m to land there</source>
        <translation>Gleitwege enden auf %1 mit %2 m Länge, aber das Flugzeug braucht dort %3 m zum Landen</translation>
    </message>
    <message>
        <source>the mission asks for one hold before each landing site that a glide ends at, but the plan has {} before {}</source>
        <translation>die Mission verlangt einen Warteraum vor jedem Landeplatz, auf dem ein Gleitweg endet, aber der Plan hat %1 vor %2</translation>
    </message>
    <message>
        <source>landing site {} is approximate: {}</source>
        <translation>Landeplatz %1 ist nur ungefähr bekannt: %2</translation>
    </message>
    <message>
        <source>landing site {} is given at {:.0f} m MSL, but the terrain there is at most {:.0f} m: check both heights</source>
        <translation>Landeplatz %1 ist mit %2 m MSL angegeben, aber das Gelände dort ist höchstens %3 m hoch: beide Höhen prüfen</translation>
    </message>
    <message>
        <source>the clearance of {:.0f} m leaves no room for what the glide model leaves out (rolling into turns: up to {:.0f} m)</source>
        <translation>der Bodenabstand von %1 m lässt keinen Raum für das, was das Gleitmodell auslässt (Rollen in Kurven: bis zu %2 m)</translation>
    </message>
    <message>
        <source>rolling into turns is not modelled and is covered by the clearance only</source>
        <translation>das Rollen in Kurven ist nicht berücksichtigt und nur durch den Bodenabstand gedeckt</translation>
    </message>
    <message>
        <source>rolling into turns and out of them, at {:.10g} degrees per second, may cost up to {:.0f} m, for which every glide has the height above the ground</source>
        <translation>das Rollen in Kurven und aus ihnen, mit %1 Grad pro Sekunde, kann bis zu %2 m kosten, für die jeder Gleitweg die Höhe über dem Boden hat</translation>
    </message>
    <message>
        <source>the one runway end used</source>
        <translation>das eine verwendete Pistenende</translation>
    </message>
    <message>
        <source>one of {} runway ends</source>
        <translation>eines von %1 Pistenenden</translation>
    </message>
    <message>
        <source> in still air, {:.1f} against the strongest wind</source>
        <translation> in ruhiger Luft, %1 gegen den stärksten Wind</translation>
    </message>
    <message>
        <source>From every point of this tour ({} decision points and all points between them) the aircraft, its engine stopped and gliding at {} m/s in {} with the polar of {} (glide ratio {:.1f} straight ahead{}), can reach {} on the landing course, at least {} m above the terrain on all the way and at least {} m above the runway on arrival. Terrain is the highest ground of each cell of {:.1f} m, runways are as listed in the plan; {}.</source>
        <translation>Von jedem Punkt dieser Tour (%1 Entscheidungspunkte und alle Punkte dazwischen) kann das Flugzeug mit stehendem Motor, gleitend mit %2 m/s bei %3 und mit der Polare von %4 (Gleitzahl %5 geradeaus%6), %7 auf dem Landekurs erreichen, auf dem ganzen Weg mindestens %8 m über dem Gelände und bei Ankunft mindestens %9 m über der Piste. Gelände ist der höchste Boden jeder Zelle von %10 m, Pisten sind die im Plan aufgeführten; %11.</translation>
    </message>
    <message>
        <source>the check was stopped before it was done; nothing is known about the plan</source>
        <translation>die Prüfung wurde angehalten, bevor sie fertig war; über den Plan ist nichts bekannt</translation>
    </message>
    <message>
        <source>as warm as</source>
        <translation>so warm wie</translation>
    </message>
    <message>
        <source> It holds from {:.0f} to {:.0f} m MSL in air {} the standard atmosphere under a QNH of {:.10g} hPa, at the true airspeeds that the indicated best glide speed has there.</source>
        <translation> Sie gilt von %1 bis %2 m MSL in Luft, die %3 die Standardatmosphäre ist, bei einem QNH von %4 hPa, mit den wahren Eigengeschwindigkeiten, die die angezeigte Geschwindigkeit des besten Gleitens dort hat.</translation>
    </message>
    <message>
        <source> It holds for every mass from {:.10g} to {:.10g} kg, at the best glide speed of the mass.</source>
        <translation> Sie gilt für jede Masse von %1 bis %2 kg, mit der Geschwindigkeit des besten Gleitens dieser Masse.</translation>
    </message>
    <message>
        <source> The propeller is taken to {} after the failure.</source>
        <translation> Angenommener Zustand des Propellers nach dem Ausfall: %1.</translation>
    </message>
    <message>
        <source>stand still</source>
        <translation>steht</translation>
    </message>
    <message>
        <source> The drag is counted as {:.10g} times that of the polar.</source>
        <translation> Der Widerstand zählt das %1-Fache der Polare.</translation>
    </message>
    <message>
        <source> Under power it climbs nowhere steeper than an aircraft can whose rate of climb falls from {:.10g} m/s at sea level to {} m/s at a density altitude of {:.10g} m.</source>
        <translation> Mit Motorleistung steigt das Flugzeug nirgends steiler, als es ein Flugzeug kann, dessen Steigrate von %1 m/s auf Meereshöhe auf %2 m/s in einer Dichtehöhe von %3 m abnimmt.</translation>
    </message>
    <message>
        <source> The tour is flown at a true airspeed of {:.1f} m/s ({}).</source>
        <translation> Die Tour wird mit einer wahren Eigengeschwindigkeit von %1 m/s geflogen (%2).</translation>
    </message>
    <message>
        <source> After the engine stops the pilot may take {:.10g} s to react: for {:.0f} m every glide follows the tour or goes straight on.</source>
        <translation> Nach dem Motorausfall darf der Pilot %1 s für seine Reaktion brauchen: auf %2 m folgt jeder Gleitweg der Tour oder führt geradeaus weiter.</translation>
    </message>
    <message>
        <source> Until the glide is established it may lose {:.10g} m of height besides.</source>
        <translation> Bis der Gleitflug eingenommen ist, darf das Flugzeug außerdem %1 m Höhe verlieren.</translation>
    </message>
    <message>
        <source> Every glide ends in a straight final of {:.10g} m</source>
        <translation> Jeder Gleitweg endet mit einem geraden Endanflug von %1 m</translation>
    </message>
    <message>
        <source>, flown at {:.10g} degrees.</source>
        <translation>, mit %1 Grad geflogen.</translation>
    </message>
    <message>
        <source> Every glide ends in one full circle from above the touchdown point</source>
        <translation> Jeder Gleitweg endet mit einem Vollkreis von über dem Aufsetzpunkt</translation>
    </message>
    <message>
        <source>, begun at least {:.10g} m above it.</source>
        <translation>, mindestens %1 m darüber begonnen.</translation>
    </message>
    <message>
        <source> On that last part it may be as low above the terrain as an obstacle surface that begins {:.10g} m before the touchdown point and rises by {:.10g} %.</source>
        <translation> Auf diesem letzten Stück darf er so tief über dem Gelände sein wie eine Hindernisfläche, die %1 m vor dem Aufsetzpunkt beginnt und um %2 % ansteigt.</translation>
    </message>
    <message>
        <source> Before every approach there is room for a hold, down to its altitude in the plan.</source>
        <translation> Vor jedem Anflug ist Platz für einen Warteraum, hinab bis zu seiner Höhe im Plan.</translation>
    </message>
    <message>
        <source> Runways of known length are long enough for an aircraft that lands in {:.10g} m at sea level, with the day&apos;s air, wind, slope and surface.</source>
        <translation> Pisten bekannter Länge sind lang genug für ein Flugzeug, das auf Meereshöhe in %1 m landet, mit Luft, Wind, Neigung und Oberfläche des Tages.</translation>
    </message>
    <message>
        <source>the tour is flown at {:.1f} m/s and glides at up to {:.1f} m/s: speeding up costs {:.0f} m of height, but only {:.0f} m are counted as lost after an engine failure</source>
        <translation>die Tour wird mit %1 m/s geflogen, geglitten wird mit bis zu %2 m/s: das Beschleunigen kostet %3 m Höhe, aber nur %4 m zählen als Verlust nach einem Motorausfall</translation>
    </message>
    <message>
        <source>in air {:.10g} K colder than the standard atmosphere an altimeter set at the lowest landing site shows about {:.0f} m too much at the highest point ({:.0f} m MSL), and about {:.0f} m where the flight is closest to its clearance ({:.0f} m MSL): add as much, or fly by satellite height</source>
        <translation>in Luft, die %1 K kälter als die Standardatmosphäre ist, zeigt ein am tiefsten Landeplatz eingestellter Höhenmesser etwa %2 m zu viel am höchsten Punkt (%3 m MSL), und etwa %4 m, wo der Flug seinem Bodenabstand am nächsten kommt (%5 m MSL): so viel hinzuzählen, oder nach Satellitenhöhe fliegen</translation>
    </message>
    <message>
        <source>{} gives no drag for a {} propeller, so its polar is used as it is</source>
        <translation>%1 nennt keinen Widerstand für den Propeller in diesem Zustand (%2), daher wird die Polare verwendet, wie sie ist</translation>
    </message>
    <message>
        <source>the plan counts with a true airspeed of {:.1f} m/s at {:.0f} m MSL, above the aircraft&apos;s limit of {:.1f} m/s</source>
        <translation>der Plan rechnet mit einer wahren Eigengeschwindigkeit von %1 m/s in %2 m MSL, über der Grenze des Flugzeugs von %3 m/s</translation>
    </message>
    <message>
        <source>{} more findings of rule {} are not listed, {} in all</source>
        <translation>%1 weitere Befunde der Regel %2 sind nicht aufgeführt, %3 insgesamt</translation>
    </message>
    <message>
        <source>{}: its glide turns with a radius of {:.2f} m, the aircraft needs {:.2f} m</source>
        <translation>%1: die Kurven des Gleitwegs haben einen Radius von %2 m, das Flugzeug braucht %3 m</translation>
    </message>
    <message>
        <source>{}: its glide ends {:.2f} m from the touchdown point of {}</source>
        <translation>%1: der Gleitweg endet %2 m vom Aufsetzpunkt von %3 entfernt</translation>
    </message>
    <message>
        <source>{}: its glide arrives {:.2f} degrees off the landing course of {}</source>
        <translation>%1: der Gleitweg kommt %2 Grad neben dem Landekurs von %3 an</translation>
    </message>
    <message>
        <source>{}: the last {:.0f} m of its glide to {} are not straight</source>
        <translation>%1: die letzten %2 m des Gleitwegs zu %3 sind nicht gerade</translation>
    </message>
    <message>
        <source>{}: its glide to {} does not end in one full circle from above the touchdown point</source>
        <translation>%1: der Gleitweg zu %2 endet nicht mit einem Vollkreis von über dem Aufsetzpunkt</translation>
    </message>
    <message>
        <source>{}: its glide is at {:.1f} m MSL at the high key of {}, {:.1f} m below the {:.1f} m required</source>
        <translation>%1: der Gleitweg ist in %2 m MSL am High Key von %3, %4 m unter den verlangten %5 m</translation>
    </message>
    <message>
        <source>{}: on its glide from {:.1f} m MSL to {} rolling into turns and out of them may cost {:.1f} m up to a place where it is {:.1f} m above the ground: fly {:.1f} m higher, or glide with fewer turns</source>
        <translation>%1: auf dem Gleitweg aus %2 m MSL zu %3 kann das Rollen in Kurven und aus ihnen %4 m kosten bis zu einer Stelle, an der er %5 m über dem Boden ist: %6 m höher fliegen, oder mit weniger Kurven gleiten</translation>
    </message>
    <message>
        <source>{}: the glide from {:.1f} m MSL loses {:.1f} m and arrives at {} at {:.1f} m, {:.1f} m below the {:.1f} m required (runway at {:.1f} m)</source>
        <translation>%1: der Gleitweg aus %2 m MSL verliert %3 m und kommt bei %4 in %5 m an, %6 m unter den verlangten %7 m (Piste in %8 m)</translation>
    </message>
    <message>
        <source>{}: the glide from {:.1f} m MSL to {} is at {:.1f} m over ground of {:.1f} m, {:.1f} m too low for the clearance of {:.0f} m</source>
        <translation>%1: der Gleitweg aus %2 m MSL zu %3 liegt in %4 m, der Boden darunter in %5 m, %6 m zu tief für den Bodenabstand von %7 m</translation>
    </message>
    <message>
        <source>{}: the plan gives {:.1f} m MSL as safe altitude, but its glide needs {:.1f} m</source>
        <translation>%1: der Plan nennt %2 m MSL als Sicherheitshöhe, aber der Gleitweg braucht %3 m</translation>
    </message>
    <message>
        <source>{}: the tour is at {:.1f} m MSL, below the safe altitude of {:.1f} m that the plan gives</source>
        <translation>%1: die Tour liegt in %2 m MSL, unter der Sicherheitshöhe von %3 m, die der Plan nennt</translation>
    </message>
    <message>
        <source>{}: its glide to {} crosses ground of unknown height</source>
        <translation>%1: der Gleitweg zu %2 quert Boden unbekannter Höhe</translation>
    </message>
    <message>
        <source>{} glide {} of {}</source>
        <translation>%1: Gleitweg %2 von %3</translation>
    </message>
    <message>
        <source>the {} has {} points, runway no. {}, meets the tour at point {} and promises a glide from its point {} on, which does not fit the plan</source>
        <translation>%1: %2 Punkte, Piste Nr. %3, trifft an Punkt %4 auf die Tour und verspricht ab dem eigenen Punkt %5 einen Gleitweg, was nicht zum Plan passt</translation>
    </message>
    <message>
        <source>the {} uses {}, but the mission asks for {}</source>
        <translation>%1: verwendet %2, aber die Mission verlangt %3</translation>
    </message>
    <message>
        <source>the {} meets the tour {:.2f} m beside its point {}, {:.2f} m above it</source>
        <translation>%1: trifft %2 m neben Punkt %3 der Tour auf sie, %4 m darüber</translation>
    </message>
    <message>
        <source>{}: the climb-out crosses ground of unknown height</source>
        <translation>%1: der Abflug quert Boden unbekannter Höhe</translation>
    </message>
    <message>
        <source>{}: {:.0f} m after the runway the climb-out is {:.1f} m above ground of {:.1f} m, {:.1f} m are required</source>
        <translation>%1: %2 m nach der Piste ist der Abflug %3 m über Boden von %4 m Höhe, verlangt sind %5 m</translation>
    </message>
    <message>
        <source>the climb-out starts up to {:.0f} m below the highest ground of the terrain cells within {:.0f} m of the runway, which are no finer than {:.0f} m: look out for obstacles there</source>
        <translation>der Abflug beginnt bis zu %1 m unter dem höchsten Boden der Geländezellen im Umkreis von %2 m um die Piste, die nicht feiner als %3 m sind: dort auf Hindernisse achten</translation>
    </message>
    <message>
        <source>the departure begins {:.1f} m from the far end of {} at {:.1f} m MSL, the runway is at {:.1f} m</source>
        <translation>der Weg von der Heimatpiste beginnt %1 m vom Pistenende von %2 entfernt in %3 m MSL, die Piste liegt in %4 m</translation>
    </message>
    <message>
        <source>the arrival must lead above the threshold of {} with the glide promised all along; it ends {:.1f} m from it, {:.1f} m above it, promised from its point {} on</source>
        <translation>der Weg zur Heimatpiste muss bis über die Schwelle von %1 führen, auf ganzer Länge mit versprochenem Gleitweg; er endet %2 m von ihr entfernt, %3 m über ihr, versprochen ab seinem Punkt %4</translation>
    </message>
    <message>
        <source>The same holds on the ways from and to the runway, but for the climb-out: after taking off from {} it begins {:.0f} m of flight past the far end of the runway, at {:.0f} m MSL ({:.0f} m above the runway), and it ends above the threshold of {} at {:.0f} m MSL ({:.0f} m above the runway), from where the landing is the pilot&apos;s.</source>
        <translation>Dasselbe gilt auf den Wegen von und zu der Piste, außer im Abflug: nach dem Start von %1 beginnt es %2 m Flug nach dem Pistenende, in %3 m MSL (%4 m über der Piste), und es endet über der Schwelle von %5 in %6 m MSL (%7 m über der Piste), von wo die Landung Sache des Piloten ist.</translation>
    </message>
    <message>
        <source>the mission asks for a home runway, but the plan lacks the way from it or to it</source>
        <translation>die Mission verlangt eine Heimatpiste, aber dem Plan fehlt der Weg von ihr oder zu ihr</translation>
    </message>
    <message>
        <source>the plan has a way from or to a runway that the mission does not ask for</source>
        <translation>der Plan hat einen Weg von oder zu einer Piste, den die Mission nicht verlangt</translation>
    </message>
    <message>
        <source>landing path</source>
        <translation>Landeweg</translation>
    </message>
    <message>
        <source>number of legs</source>
        <translation>Zahl der Teilstrecken</translation>
    </message>
    <message>
        <source>altitude at the end of a leg</source>
        <translation>Höhe am Ende einer Teilstrecke</translation>
    </message>
    <message>
        <source>landing path: it leads to landing site no. {}, but {} are given</source>
        <translation>Landeweg: er führt zu Landeplatz Nr. %1, aber die Zahl der angegebenen ist %2</translation>
    </message>
    <message>
        <source>landing path: a leg is neither a straight of radius 0 nor a turn of at most {} full circles, so it cannot be flown</source>
        <translation>Landeweg: eine Teilstrecke ist weder eine Gerade mit Radius 0 noch eine Kurve von höchstens %1 Vollkreisen und kann daher nicht geflogen werden</translation>
    </message>
    <message>
        <source>landing path: leg {} turns with a radius of {:.2f} m, the aircraft needs {:.2f} m: widen the turn</source>
        <translation>Landeweg: Teilstrecke %1 hat einen Kurvenradius von %2 m, das Flugzeug braucht %3 m: die Kurve weiter machen</translation>
    </message>
    <message>
        <source>landing path: leg {} changes altitude by {:.1f} m on the spot</source>
        <translation>Landeweg: Teilstrecke %1 ändert die Höhe auf der Stelle um %2 m</translation>
    </message>
    <message>
        <source>landing path: leg {} goes down by {:.2f} degrees, flatter than the glide there, which needs up to {:.2f} degrees: plan it steeper</source>
        <translation>Landeweg: Teilstrecke %1 sinkt mit %2 Grad, flacher als der Gleitflug dort, der bis zu %3 Grad braucht: steiler planen</translation>
    </message>
    <message>
        <source>landing path: leg {} goes down by {:.2f} degrees, steeper than the aircraft can descend there, {:.2f} degrees: lose the height in circles, or name a steeper descent in the profile</source>
        <translation>Landeweg: Teilstrecke %1 sinkt mit %2 Grad, steiler, als das Flugzeug dort sinken kann, %3 Grad: die Höhe in Kreisen abbauen, oder im Profil ein steileres Sinken nennen</translation>
    </message>
    <message>
        <source>landing path: leg {} is at {:.1f} m MSL over ground of {:.1f} m, {:.1f} m too low for the clearance of {:.0f} m</source>
        <translation>Landeweg: Teilstrecke %1 liegt in %2 m MSL, der Boden darunter in %3 m, %4 m zu tief für den Bodenabstand von %5 m</translation>
    </message>
    <message>
        <source>landing path: leg {} crosses ground of unknown height</source>
        <translation>Landeweg: Teilstrecke %1 quert Boden unbekannter Höhe</translation>
    </message>
    <message>
        <source>landing path: its last {:.0f} m to {} are not straight</source>
        <translation>Landeweg: die letzten %1 m zu %2 sind nicht gerade</translation>
    </message>
    <message>
        <source>landing path: it does not end in one full circle from above the touchdown point of {}</source>
        <translation>Landeweg: er endet nicht mit einem Vollkreis von über dem Aufsetzpunkt von %1</translation>
    </message>
    <message>
        <source>landing path: it is at {:.1f} m MSL at the high key of {}, {:.1f} m below the {:.1f} m required</source>
        <translation>Landeweg: er ist in %1 m MSL am High Key von %2, %3 m unter den verlangten %4 m</translation>
    </message>
    <message>
        <source>landing path: it ends {:.2f} m from the touchdown point of {}</source>
        <translation>Landeweg: er endet %1 m vom Aufsetzpunkt von %2 entfernt</translation>
    </message>
    <message>
        <source>landing path: it arrives {:.2f} degrees off the landing course of {}</source>
        <translation>Landeweg: er kommt %1 Grad neben dem Landekurs von %2 an</translation>
    </message>
    <message>
        <source>landing path: it arrives at {} at {:.1f} m MSL, {:.1f} m below the {:.1f} m required (runway at {:.1f} m)</source>
        <translation>Landeweg: er kommt bei %1 in %2 m MSL an, %3 m unter den verlangten %4 m (Piste in %5 m)</translation>
    </message>
    <message>
        <source>it is {:.0f} m wide, the mission asks for {:.0f} m</source>
        <translation>%1 m breit, die Mission verlangt %2 m</translation>
    </message>
    <message>
        <source>its surface is not one that the mission allows</source>
        <translation>die Oberfläche ist keine, die die Mission erlaubt</translation>
    </message>
    <message>
        <source>it is not lighted, which the mission asks for</source>
        <translation>nicht befeuert, die Mission verlangt Befeuerung</translation>
    </message>
    <message>
        <source>it lies {:.1f} km away, the mission allows {:.1f} km</source>
        <translation>%1 km entfernt, die Mission erlaubt %2 km</translation>
    </message>
    <message>
        <source>the wind may blow from behind at {:.1f} m/s, the aircraft allows {:.1f} m/s</source>
        <translation>der Wind kann mit %1 m/s von hinten wehen, das Flugzeug erlaubt %2 m/s</translation>
    </message>
    <message>
        <source>the wind may blow across at {:.1f} m/s, the aircraft allows {:.1f} m/s</source>
        <translation>der Wind kann mit %1 m/s von der Seite wehen, das Flugzeug erlaubt %2 m/s</translation>
    </message>
    <message>
        <source>the mission excludes {}</source>
        <translation>die Mission schließt %1 aus</translation>
    </message>
    <message>
        <source>the mission allows landings on {} only</source>
        <translation>die Mission erlaubt Landungen nur auf %1</translation>
    </message>
    <message>
        <source>the mission names neither this site nor any airfield file it could come from</source>
        <translation>die Mission nennt weder diesen Platz noch eine Flugplatzdatei, aus der er stammen könnte</translation>
    </message>
    <message>
        <source>its geometry is approximate, which the mission excludes</source>
        <translation>die Geometrie ist nur ungefähr bekannt, was die Mission ausschließt</translation>
    </message>
    <message>
        <source>it is water, which the mission excludes</source>
        <translation>es ist Wasser, was die Mission ausschließt</translation>
    </message>
    <message>
        <source>it is {:.0f} m long, the mission asks for {:.0f} m</source>
        <translation>%1 m lang, die Mission verlangt %2 m</translation>
    </message>
    <message>
        <source>target {}: the plan has it {:.2f} m away from its own position</source>
        <translation>Ziel %1: der Plan hat es %2 m von seiner eigenen Position entfernt</translation>
    </message>
    <message>
        <source>target {}: the terrain below it is unknown, so its altitude is</source>
        <translation>Ziel %1: das Gelände darunter ist unbekannt, daher auch die Höhe des Ziels</translation>
    </message>
    <message>
        <source>target {}: the plan puts it at {:.1f} m MSL, terrain and mission at {:.1f} m</source>
        <translation>Ziel %1: der Plan setzt es auf %2 m MSL, Gelände und Mission auf %3 m</translation>
    </message>
    <message>
        <source>landing site {}: the plan uses it {:.2f} m and {:.3f} degrees away from its own position and course</source>
        <translation>Landeplatz %1: der Plan verwendet ihn %2 m und %3 Grad neben seiner eigenen Position und seinem Kurs</translation>
    </message>
    <message>
        <source>landing site {}: position, elevation or course differ from the mission&apos;s</source>
        <translation>Landeplatz %1: Position, Platzhöhe oder Kurs weichen von denen der Mission ab</translation>
    </message>
    <message>
        <source>landing site {} must not be used: {}</source>
        <translation>Landeplatz %1 darf nicht verwendet werden: %2</translation>
    </message>
    <message>
        <source>landing site {} is listed twice</source>
        <translation>Landeplatz %1 ist zweimal aufgeführt</translation>
    </message>
    <message>
        <source>the mission has two targets named {}</source>
        <translation>die Mission hat zwei Ziele mit dem Namen %1</translation>
    </message>
    <message>
        <source>target {} of the plan is not as the mission has it (position, height or reference)</source>
        <translation>Ziel %1 des Plans ist nicht so, wie die Mission es hat (Position, Höhe oder Bezug)</translation>
    </message>
    <message>
        <source>target {} is listed twice in the plan</source>
        <translation>Ziel %1 ist im Plan zweimal aufgeführt</translation>
    </message>
    <message>
        <source>target {} of the mission is not in the plan</source>
        <translation>Ziel %1 der Mission ist nicht im Plan</translation>
    </message>
    <message>
        <source>{}: {} is {}, must be between {} and {}</source>
        <translation>%1: %2 ist %3, muss zwischen %4 und %5 liegen</translation>
    </message>
    <message>
        <source>length of a piece</source>
        <translation>Länge eines Stücks</translation>
    </message>
    <message>
        <source>radius of a piece</source>
        <translation>Radius eines Stücks</translation>
    </message>
    <message>
        <source>{}: its glide begins to turn {:.1f} m on, but until the pilot reacts after {:.1f} s the aircraft may have gone on for {:.1f} m</source>
        <translation>%1: der Gleitweg beginnt nach %2 m zu drehen, aber bis der Pilot nach %3 s reagiert, kann das Flugzeug %4 m weitergeflogen sein</translation>
    </message>
    <message>
        <source>mass is {} kg, must be positive</source>
        <translation>die Masse ist %1 kg, muss positiv sein</translation>
    </message>
    <message>
        <source>wing area is {} m2, must be positive</source>
        <translation>die Flügelfläche ist %1 m2, muss positiv sein</translation>
    </message>
    <message>
        <source>zero-lift drag is {}, which no aircraft has</source>
        <translation>der Nullwiderstand ist %1, was kein Flugzeug hat</translation>
    </message>
    <message>
        <source>induced drag is {}, which no aircraft has</source>
        <translation>der induzierte Widerstand ist %1, was kein Flugzeug hat</translation>
    </message>
    <message>
        <source>air density is {} kg/m3, must be between 0.01 and 2</source>
        <translation>die Luftdichte ist %1 kg/m3, muss zwischen 0.01 und 2 liegen</translation>
    </message>
    <message>
        <source>glide speed is {} m/s, must be positive</source>
        <translation>die Gleitgeschwindigkeit ist %1 m/s, muss positiv sein</translation>
    </message>
    <message>
        <source>no bank angle for glides is given</source>
        <translation>keine Querlage für den Gleitflug ist angegeben</translation>
    </message>
    <message>
        <source>{} is {} degrees, must be between 0 and 90</source>
        <translation>%1 ist %2 Grad, muss zwischen 0 und 90 liegen</translation>
    </message>
    <message>
        <source>a glide bank</source>
        <translation>eine Querlage im Gleitflug</translation>
    </message>
    <message>
        <source>tour bank</source>
        <translation>Querlage auf der Tour</translation>
    </message>
    <message>
        <source>climb limit</source>
        <translation>steilstes Steigen</translation>
    </message>
    <message>
        <source>descent limit</source>
        <translation>steilstes Sinken der Tour</translation>
    </message>
    <message>
        <source>the steepest descent</source>
        <translation>das steilste Sinken ohne Motor</translation>
    </message>
    <message>
        <source>the ceiling is no altitude</source>
        <translation>die Obergrenze ist keine Höhe</translation>
    </message>
    <message>
        <source>its masses range from {} to {} kg, which does not hold its {} kg</source>
        <translation>die Massen reichen von %1 bis %2 kg, was die %3 kg des Flugzeugs nicht enthält</translation>
    </message>
    <message>
        <source>its greatest speed of {} m/s is not above its glide speed of {} m/s</source>
        <translation>die Höchstgeschwindigkeit von %1 m/s liegt nicht über der Gleitgeschwindigkeit von %2 m/s</translation>
    </message>
    <message>
        <source>its stall speed is no speed</source>
        <translation>die Überziehgeschwindigkeit ist keine Geschwindigkeit</translation>
    </message>
    <message>
        <source>zero-lift drag with the propeller windmilling or stopped is {}, which no aircraft has</source>
        <translation>der Nullwiderstand mit drehendem oder stehendem Propeller ist %1, was kein Flugzeug hat</translation>
    </message>
    <message>
        <source>its rate of climb is not more at sea level than at its service ceiling</source>
        <translation>die Steigrate ist auf Meereshöhe nicht größer als in der Dienstgipfelhöhe</translation>
    </message>
    <message>
        <source>its rate of roll is {} degrees per second, which no aircraft has</source>
        <translation>die Rollrate ist %1 Grad pro Sekunde, was kein Flugzeug hat</translation>
    </message>
    <message>
        <source>its landing distance is {} m, must be positive</source>
        <translation>die Landestrecke ist %1 m, muss positiv sein</translation>
    </message>
    <message>
        <source>the setting {} is {}, which the safety of a plan cannot be measured against</source>
        <translation>die Einstellung %1 ist %2, woran die Sicherheit eines Plans nicht gemessen werden kann</translation>
    </message>
    <message>
        <source>temperature of the air</source>
        <translation>Temperatur der Luft</translation>
    </message>
    <message>
        <source>altitude in this air</source>
        <translation>Höhe in dieser Luft</translation>
    </message>
    <message>
        <source>airspeed of the tour</source>
        <translation>Eigengeschwindigkeit der Tour</translation>
    </message>
    <message>
        <source>length of the final approach</source>
        <translation>Länge des Endanflugs</translation>
    </message>
    <message>
        <source>slope of the final approach</source>
        <translation>Neigung des Endanflugs</translation>
    </message>
    <message>
        <source>{} degrees while the aircraft names no steepest descent</source>
        <translation>%1 Grad, obwohl das Flugzeug kein steilstes Sinken nennt</translation>
    </message>
    <message>
        <source>height of the high key</source>
        <translation>Höhe von High Key</translation>
    </message>
    <message>
        <source>turn radii of {} m and {} m are none of an aircraft</source>
        <translation>Kurvenradien von %1 m und %2 m sind nicht die eines Flugzeugs</translation>
    </message>
    <message>
        <source>the polar gives no glide at a bank angle that the profile allows</source>
        <translation>die Polare ergibt bei einer Querlage, die das Profil erlaubt, keinen Gleitflug</translation>
    </message>
    <message>
        <source>arrival margin</source>
        <translation>Ankunftshöhe</translation>
    </message>
    <message>
        <source>height lost on reaction</source>
        <translation>Höhenverlust bei der Reaktion</translation>
    </message>
    <message>
        <source>tour point {}</source>
        <translation>Tourpunkt %1</translation>
    </message>
    <message>
        <source>safe altitude</source>
        <translation>Sicherheitshöhe</translation>
    </message>
    <message>
        <source>number of pieces of the glide</source>
        <translation>Zahl der Stücke des Gleitwegs</translation>
    </message>
    <message>
        <source>length of the glide</source>
        <translation>Länge des Gleitwegs</translation>
    </message>
    <message>
        <source>landing course</source>
        <translation>Landekurs</translation>
    </message>
    <message>
        <source>target of the mission</source>
        <translation>Ziel der Mission</translation>
    </message>
    <message>
        <source>circles down</source>
        <translation>Kreise hinab</translation>
    </message>
    <message>
        <source>circles up</source>
        <translation>Kreise hinauf</translation>
    </message>
    <message>
        <source>lowest altitude</source>
        <translation>tiefste Höhe</translation>
    </message>
    <message>
        <source>lower bound</source>
        <translation>untere Schranke</translation>
    </message>
    <message>
        <source>lower bound of any tour</source>
        <translation>untere Schranke jeder Tour</translation>
    </message>
    <message>
        <source>{}: a piece of the tour or of its glide is neither a straight of radius 0 nor a turn of at most {} full circles, so it cannot be flown</source>
        <translation>%1: ein Stück der Tour oder des Gleitwegs ist weder eine Gerade mit Radius 0 noch eine Kurve von höchstens %2 Vollkreisen und kann daher nicht geflogen werden</translation>
    </message>
    <message>
        <source>{}: its glide leads to landing site no. {}, but the plan lists {}</source>
        <translation>%1: der Gleitweg führt zu Landeplatz Nr. %2, aber die Zahl der Landeplätze im Plan ist %3</translation>
    </message>
    <message>
        <source>{}: it visits target no. {}, but the plan lists {}</source>
        <translation>%1: angeflogen wird Ziel Nr. %2, aber die Zahl der Ziele im Plan ist %3</translation>
    </message>
    <message>
        <source>a hold is before landing site no. {}, but the plan lists {}</source>
        <translation>ein Warteraum liegt vor Landeplatz Nr. %1, aber die Zahl der Landeplätze im Plan ist %2</translation>
    </message>
    <message>
        <source>a spiral visits target no. {}, but the plan lists {}</source>
        <translation>eine Spirale fliegt Ziel Nr. %1 an, aber die Zahl der Ziele im Plan ist %2</translation>
    </message>
    <message>
        <source>the plan was made with {} terrain files, but {} were read</source>
        <translation>der Plan wurde mit %1 Geländedateien gemacht, aber gelesen wurden %2</translation>
    </message>
    <message>
        <source>{} is not the terrain that the plan was made with (SHA-256 {} now, {} in the plan)</source>
        <translation>%1 ist nicht das Gelände, mit dem der Plan gemacht wurde (SHA-256 jetzt %2, im Plan %3)</translation>
    </message>
    <message>
        <source>the plan was made with terrain cells of {} m, but {} m were read</source>
        <translation>der Plan wurde mit Geländezellen von %1 m gemacht, aber gelesen wurden solche von %2 m</translation>
    </message>
    <message>
        <source>origin of the frame</source>
        <translation>Ursprung des örtlichen Systems</translation>
    </message>
    <message>
        <source>landing site</source>
        <translation>Landeplatz</translation>
    </message>
    <message>
        <source>landing site </source>
        <translation>Landeplatz </translation>
    </message>
    <message>
        <source>landing site of the mission</source>
        <translation>Landeplatz der Mission</translation>
    </message>
    <message>
        <source>the terrain grid ({} x {} cells of {} m) cannot be used</source>
        <translation>das Geländegitter (%1 x %2 Zellen von %3 m) kann nicht verwendet werden</translation>
    </message>
    <message>
        <source>the plan has no tour</source>
        <translation>der Plan hat keine Tour</translation>
    </message>
    <message>
        <source>{}: the tour turns with a radius of {:.2f} m, the aircraft needs {:.2f} m at its tour bank</source>
        <translation>%1: die Tour hat einen Kurvenradius von %2 m, das Flugzeug braucht %3 m bei seiner Querlage auf der Tour</translation>
    </message>
    <message>
        <source>{}: the tour turns with a radius of {:.2f} m, but a glide of this aircraft needs {:.2f} m, so it could not follow the turn after an engine failure in it</source>
        <translation>%1: die Tour hat einen Kurvenradius von %2 m, aber ein Gleitflug dieses Flugzeugs braucht %3 m und könnte daher nach einem Motorausfall in der Kurve dieser nicht folgen</translation>
    </message>
    <message>
        <source>{}: the next decision point is {:.3f} m on, the mission allows {:.3f} m</source>
        <translation>%1: der nächste Entscheidungspunkt kommt nach %2 m, die Mission erlaubt %3 m</translation>
    </message>
    <message>
        <source>{}: the way on ends {:.3f} m and {:.5f} degrees from {}</source>
        <translation>%1: der weitere Weg endet %2 m und %3 Grad von %4 entfernt</translation>
    </message>
    <message>
        <source>{}: the tour climbs at {:.2f} degrees to {}, the aircraft can climb at {:.2f}</source>
        <translation>%1: die Tour steigt mit %2 Grad zu %3, das Flugzeug kann mit %4 Grad steigen</translation>
    </message>
    <message>
        <source>{}: the tour descends at {:.2f} degrees to {}, the aircraft may descend at {:.2f}</source>
        <translation>%1: die Tour sinkt mit %2 Grad zu %3, das Flugzeug darf mit %4 Grad sinken</translation>
    </message>
    <message>
        <source>{}: {:.1f} m MSL is above the ceiling of {:.1f} m</source>
        <translation>%1: %2 m MSL liegt über der Obergrenze von %3 m</translation>
    </message>
    <message>
        <source>{}: after an engine failure behind it the aircraft reaches {} at {:.1f} m MSL, {:.1f} m below the {:.1f} m that the glide from there needs</source>
        <translation>%1: nach einem Motorausfall hinter diesem Punkt erreicht das Flugzeug %2 in %3 m MSL, %4 m unter den %5 m, die der Gleitweg von dort braucht</translation>
    </message>
    <message>
        <source>{}: {:.1f} m after it the tour is at {:.1f} m MSL over ground of {:.1f} m, {:.1f} m too low for the clearance of {:.0f} m</source>
        <translation>%1: %2 m danach liegt die Tour in %3 m MSL, der Boden darunter in %4 m, %5 m zu tief für den Bodenabstand von %6 m</translation>
    </message>
    <message>
        <source>{}: a glide along the tour from here is at {:.1f} m MSL over ground of {:.1f} m, {:.1f} m on, {:.1f} m too low for the clearance of {:.0f} m</source>
        <translation>%1: ein Gleitflug von hier entlang der Tour liegt in %2 m MSL, der Boden darunter in %3 m, nach %4 m Strecke, %5 m zu tief für den Bodenabstand von %6 m</translation>
    </message>
    <message>
        <source>{}: {:.1f} m after it the tour crosses ground of unknown height</source>
        <translation>%1: %2 m danach quert die Tour Boden unbekannter Höhe</translation>
    </message>
    <message>
        <source>{} point {} of {}</source>
        <translation>%1: Punkt %2 von %3</translation>
    </message>
    <message>
        <source>tour point {}: it should visit target {} but passes {:.2f} m beside it</source>
        <translation>Tourpunkt %1: er soll Ziel %2 anfliegen, liegt aber %3 m daneben</translation>
    </message>
    <message>
        <source>tour point {}: it passes target {} at {:.1f} m MSL, below its {:.1f} m</source>
        <translation>Tourpunkt %1: er überfliegt Ziel %2 in %3 m MSL, unter dessen %4 m</translation>
    </message>
    <message>
        <source>the spiral at target {} goes from {:.1f} m to {:.1f} m MSL in {} + {} circles; it must lead from the tour ({:.1f} m) down, not below the target ({:.1f} m), and back in whole circles to one side</source>
        <translation>die Spirale bei Ziel %1 führt von %2 m auf %3 m MSL in %4 + %5 Kreisen; sie muss von der Tour (%6 m) hinab führen, nicht unter das Ziel (%7 m), und zurück, in ganzen Kreisen nach einer Seite</translation>
    </message>
    <message>
        <source>the spiral at target {} turns with a radius of {:.2f} m, the aircraft needs {:.2f} m</source>
        <translation>die Spirale bei Ziel %1 hat einen Radius von %2 m, das Flugzeug braucht %3 m</translation>
    </message>
    <message>
        <source>the spiral at target {} changes height by {:.1f} m in {} circles down and {} up, which is steeper than the aircraft may fly</source>
        <translation>die Spirale bei Ziel %1 ändert die Höhe um %2 m, Kreise hinab: %3, hinauf: %4, was steiler ist, als das Flugzeug fliegen darf</translation>
    </message>
    <message>
        <source>the spiral at target {} crosses ground of unknown height</source>
        <translation>die Spirale bei Ziel %1 quert Boden unbekannter Höhe</translation>
    </message>
    <message>
        <source>the spiral at target {} is {:.1f} m too low over ground of {:.1f} m for the clearance of {:.0f} m</source>
        <translation>die Spirale bei Ziel %1 ist %2 m zu tief über Boden von %3 m Höhe für den Bodenabstand von %4 m</translation>
    </message>
    <message>
        <source>the plan descends to target {}, but the mission asks to pass above low targets</source>
        <translation>der Plan sinkt zu Ziel %1, aber die Mission verlangt, über tiefe Ziele hinwegzufliegen</translation>
    </message>
    <message>
        <source>between {:.0f} and {:.0f} m MSL at target {} the tour leaves the safe altitude in a spiral of {} circles: there the gliding guarantee is suspended</source>
        <translation>zwischen %1 und %2 m MSL bei Ziel %3 verlässt die Tour die Sicherheitshöhe in einer Spirale von %4 Kreisen: dort ist die Gleitgarantie ausgesetzt</translation>
    </message>
    <message>
        <source>the plan gives a {} of {:.1f} m, it is {:.1f} m</source>
        <translation>der Plan nennt %1: %2 m, es sind %3 m</translation>
    </message>
    <message>
        <source>the plan says that no tour over its headings costs less than {:.1f} m, but {} costs {:.1f} m</source>
        <translation>der Plan sagt, dass keine Tour über seine Kurse weniger als %1 m kostet, aber %2 kostet %3 m</translation>
    </message>
    <message>
        <source>the one that it was refined from</source>
        <translation>jene vor der Verfeinerung</translation>
    </message>
    <message>
        <source>its own</source>
        <translation>seine eigene</translation>
    </message>
    <message>
        <source>the plan says that no tour at all costs less than {:.1f} m, but its own costs {:.1f} m</source>
        <translation>der Plan sagt, dass überhaupt keine Tour weniger als %1 m kostet, aber seine eigene kostet %2 m</translation>
    </message>
    <message>
        <source>the plan says that it was refined from a tour of {:.1f} m, but its own costs {:.1f} m</source>
        <translation>der Plan sagt, dass er aus einer Tour von %1 m verfeinert wurde, aber seine eigene kostet %2 m</translation>
    </message>
    <message>
        <source>target {}: no point of the tour visits it</source>
        <translation>Ziel %1: kein Punkt der Tour fliegt es an</translation>
    </message>
    <message>
        <source>target {} has two spirals</source>
        <translation>Ziel %1 hat zwei Spiralen</translation>
    </message>
    <message>
        <source>target {} is passed above its height without a descent</source>
        <translation>Ziel %1 wird über seiner Höhe überflogen, ohne dass zu ihm gesunken wird</translation>
    </message>
    <message>
        <source>its altitude is {} m MSL, must be between {} and {}</source>
        <translation>die Höhe ist %1 m MSL, muss zwischen %2 und %3 liegen</translation>
    </message>
    <message>
        <source>it blows from {} degrees, must be between 0 and 360</source>
        <translation>der Wind weht aus %1 Grad, muss zwischen 0 und 360 liegen</translation>
    </message>
    <message>
        <source>its direction is uncertain by {} degrees, must be between 0 and 180</source>
        <translation>die Richtung ist um %1 Grad ungewiss, muss zwischen 0 und 180 liegen</translation>
    </message>
    <message>
        <source>its speeds are {} and {} m/s, which no wind has</source>
        <translation>die Stärken sind %1 und %2 m/s, was kein Wind hat</translation>
    </message>
    <message>
        <source>its least speed of {} m/s is above its greatest of {} m/s</source>
        <translation>die kleinste Stärke von %1 m/s liegt über der größten von %2 m/s</translation>
    </message>
    <message>
        <source>{:.10g} degrees true</source>
        <translation>%1 Grad rechtweisend</translation>
    </message>
    <message>
        <source>{:.10g} to {:.10g} degrees true</source>
        <translation>%1 bis %2 Grad rechtweisend</translation>
    </message>
    <message>
        <source>from {} at {} kt</source>
        <translation>aus %1 mit %2 kt</translation>
    </message>
    <message>
        <source>between the wind layers at {:.0f} and {:.0f} m MSL the wind may change by {:.1f} m/s, too fast for a glide at {:.1f} m/s that sinks through it: give winds that differ less, or layers further apart</source>
        <translation>zwischen den Windschichten in %1 und %2 m MSL kann sich der Wind um %3 m/s ändern, zu schnell für einen Gleitflug mit %4 m/s, der dort hindurch sinkt: Winde angeben, die sich weniger unterscheiden, oder weiter auseinanderliegende Schichten</translation>
    </message>
    <message>
        <source>wind layer {}: {}</source>
        <translation>Windschicht %1: %2</translation>
    </message>
    <message>
        <source>wind layer {}: it is not above the layer before it</source>
        <translation>Windschicht %1: sie liegt nicht über der Schicht davor</translation>
    </message>
    <message>
        <source>aircraft {}: with this drag there is no glide at a bank angle that the profile allows</source>
        <translation>Flugzeug %1: mit diesem Widerstand gibt es bei einer Querlage, die das Profil erlaubt, keinen Gleitflug</translation>
    </message>
    <message>
        <source>the wind may blow at {:.1f} m/s, but the aircraft glides at {:.1f} m/s in its steepest turns, so it could be blown backwards</source>
        <translation>der Wind kann mit %1 m/s wehen, aber das Flugzeug gleitet in seinen steilsten Kurven mit %2 m/s und könnte daher rückwärts getrieben werden</translation>
    </message>
    <message>
        <source>the wind may blow at {:.1f} m/s, but the tour is flown at {:.1f} m/s, so it could be blown backwards</source>
        <translation>der Wind kann mit %1 m/s wehen, aber die Tour wird mit %2 m/s geflogen, das Flugzeug könnte daher rückwärts getrieben werden</translation>
    </message>
    <message>
        <source>in this wind the aircraft turns with a radius of {:.0f} m, which is none of an aircraft</source>
        <translation>in diesem Wind hat das Flugzeug einen Kurvenradius von %1 m, der nicht der eines Flugzeugs ist</translation>
    </message>
    <message>
        <source>every wind </source>
        <translation>jedem Wind </translation>
    </message>
    <message>
        <source>every wind that at its height lies between those of the layers next to it, and changes from the one to the other nowhere faster than evenly between those that differ most:</source>
        <translation>jedem Wind, der in seiner Höhe zwischen denen der benachbarten Schichten liegt und sich vom einen zum anderen nirgends schneller ändert als gleichmäßig zwischen jenen, die sich am meisten unterscheiden:</translation>
    </message>
    <message>
        <source>reading the terrain was stopped</source>
        <translation>das Lesen des Geländes wurde angehalten</translation>
    </message>
    <message>
        <source>this is not a coordinate system that GDAL knows</source>
        <translation>das ist kein Koordinatensystem, das GDAL kennt</translation>
    </message>
    <message>
        <source>its coordinate system names a file of datum shifts; state a system that needs none, for example EPSG:4326</source>
        <translation>das Koordinatensystem nennt eine Datei mit Datumsverschiebungen; ein System angeben, das keine braucht, zum Beispiel EPSG:4326</translation>
    </message>
    <message>
        <source>no transformation is known between its coordinate system and WGS 84; state its datum with gdal_edit.py -a_srs</source>
        <translation>zwischen dem Koordinatensystem und WGS 84 ist keine Umrechnung bekannt; das Datum mit gdal_edit.py -a_srs angeben</translation>
    </message>
    <message>
        <source>the network is used on command only</source>
        <translation>das Netz wird nur auf Anweisung verwendet</translation>
    </message>
    <message>
        <source>this is a VRT, which only names other files; name those files themselves, they are joined</source>
        <translation>das ist ein VRT, das nur andere Dateien nennt; diese Dateien selbst angeben, sie werden zusammengefügt</translation>
    </message>
    <message>
        <source>the terrain files that join here span {} x {} heights, more than {} million; cut out the part that the mission needs or use coarser files</source>
        <translation>die Geländedateien, die hier zusammengehören, umfassen %1 x %2 Höhen, mehr als %3 Millionen; den Teil ausschneiden, den die Mission braucht, oder gröbere Dateien verwenden</translation>
    </message>
    <message>
        <source>the file changed while it was being read; try again</source>
        <translation>die Datei wurde geändert, während sie gelesen wurde; noch einmal versuchen</translation>
    </message>
    <message>
        <source>the raster holds no height at all, only no-data; leave it out or fetch it again</source>
        <translation>das Raster enthält gar keine Höhe, nur Stellen ohne Daten; weglassen oder neu holen</translation>
    </message>
    <message>
        <source>the file is truncated or damaged; fetch it again</source>
        <translation>die Datei ist abgeschnitten oder beschädigt; neu holen</translation>
    </message>
    <message>
        <source>there is no such file; correct the path of the terrain file</source>
        <translation>es gibt keine solche Datei; den Pfad der Geländedatei berichtigen</translation>
    </message>
    <message>
        <source>this is a folder; name the terrain files in it one by one</source>
        <translation>das ist ein Ordner; die Geländedateien darin einzeln angeben</translation>
    </message>
    <message>
        <source>this is not a complete raster in a format that is read; give a GeoTIFF, HGT, DTED or ASCII grid</source>
        <translation>das ist kein vollständiges Raster in einem Format, das gelesen wird; ein GeoTIFF-, HGT-, DTED- oder ASCII-Raster angeben</translation>
    </message>
    <message>
        <source>the raster has no coordinate system; add it, for example with gdal_edit.py -a_srs EPSG:4326, or a .prj file beside it</source>
        <translation>das Raster hat kein Koordinatensystem; eines hinzufügen, zum Beispiel mit gdal_edit.py -a_srs EPSG:4326, oder eine .prj-Datei daneben</translation>
    </message>
    <message>
        <source>the raster&apos;s coordinate system is not tied to the earth; give one, for example with gdal_edit.py -a_srs</source>
        <translation>das Koordinatensystem des Rasters ist nicht an die Erde gebunden; eines angeben, zum Beispiel mit gdal_edit.py -a_srs</translation>
    </message>
    <message>
        <source>the raster does not say where on the map its pixels lie; rectify it, for example with gdalwarp</source>
        <translation>das Raster sagt nicht, wo auf der Karte seine Bildpunkte liegen; entzerren, zum Beispiel mit gdalwarp</translation>
    </message>
    <message>
        <source>the raster&apos;s pixels have no extent on the map; its georeference is damaged, fetch it again</source>
        <translation>die Bildpunkte des Rasters haben auf der Karte keine Ausdehnung; seine Georeferenz ist beschädigt, neu holen</translation>
    </message>
    <message>
        <source>the raster has {} x {} heights, and terrain needs at least 2 x 2</source>
        <translation>das Raster hat %1 x %2 Höhen, und Gelände braucht mindestens 2 x 2</translation>
    </message>
    <message>
        <source>the file holds no band of heights; if it is a container, extract the elevation raster with gdal_translate</source>
        <translation>die Datei enthält kein Band mit Höhen; wenn sie ein Container ist, das Höhenraster mit gdal_translate herausholen</translation>
    </message>
    <message>
        <source>the raster has {} bands where terrain has one; extract the heights with gdal_translate -b</source>
        <translation>das Raster hat %1 Bänder, wo Gelände eines hat; die Höhen mit gdal_translate -b herausholen</translation>
    </message>
    <message>
        <source>the raster holds colours or complex numbers, not heights; give an elevation raster</source>
        <translation>das Raster enthält Farben oder komplexe Zahlen, keine Höhen; ein Höhenraster angeben</translation>
    </message>
    <message>
        <source>the raster&apos;s scale {} and offset {} give no heights; correct them with gdal_edit.py</source>
        <translation>Maßstab %1 und Versatz %2 des Rasters ergeben keine Höhen; mit gdal_edit.py berichtigen</translation>
    </message>
    <message>
        <source>the raster&apos;s unit &quot;{}&quot; is not one of length that is known here; set it to m or ft with gdal_edit.py -units</source>
        <translation>die Einheit „%1“ des Rasters ist keine hier bekannte Längeneinheit; mit gdal_edit.py -units auf m oder ft setzen</translation>
    </message>
    <message>
        <source>there is no such file; correct the path</source>
        <translation>es gibt keine solche Datei; den Pfad berichtigen</translation>
    </message>
    <message>
        <source>this is not a file; name the file itself</source>
        <translation>das ist keine Datei; die Datei selbst angeben</translation>
    </message>
    <message>
        <source>the file cannot be opened; check that it may be read</source>
        <translation>die Datei kann nicht geöffnet werden; prüfen, ob sie gelesen werden darf</translation>
    </message>
    <message>
        <source>the file cannot be read to its end; check the disk and copy it again</source>
        <translation>die Datei kann nicht bis zum Ende gelesen werden; den Datenträger prüfen und sie neu kopieren</translation>
    </message>
    <message>
        <source>the raster&apos;s corners do not lie on the earth in its coordinate system; correct the one or the other</source>
        <translation>die Ecken des Rasters liegen in seinem Koordinatensystem nicht auf der Erde; das eine oder das andere berichtigen</translation>
    </message>
    <message>
        <source>no terrain file is named; give at least one elevation raster</source>
        <translation>keine Geländedatei ist angegeben; mindestens ein Höhenraster angeben</translation>
    </message>
    <message>
        <source>the raster reaches too far from the mission for its local frame; cut out the part around the mission with gdalwarp -te</source>
        <translation>das Raster reicht für das örtliche System der Mission zu weit von ihr weg; den Teil um die Mission mit gdalwarp -te ausschneiden</translation>
    </message>
    <message>
        <source>the terrain files together span {:.0f} x {:.0f} km, more than {:.0f} km; load only those around the mission</source>
        <translation>die Geländedateien umfassen zusammen %1 x %2 km, mehr als %3 km; nur jene um die Mission laden</translation>
    </message>
    <message>
        <source>a terrain cell of {} m is not possible; give a size above zero</source>
        <translation>eine Geländezelle von %1 m ist nicht möglich; eine Größe über null angeben</translation>
    </message>
    <message>
        <source>terrain cells of {} m over {:.0f} x {:.0f} km would be more than {:.0f}; give a larger cell size</source>
        <translation>Geländezellen von %1 m über %2 x %3 km wären mehr als %4; größere Zellen angeben</translation>
    </message>
    <message>
        <source>stopped while joining the tour</source>
        <translation>beim Zusammenfügen der Tour angehalten</translation>
    </message>
    <message>
        <source>joined into one loop within the pitch limits the tour is too high to pass below {}, which the mission forbids to the tour, and there is no way over it; allow that airspace, raise the ceiling, or move the targets beside it</source>
        <translation>zu einer Runde verbunden ist die Tour innerhalb der Steig- und Sinkgrenzen zu hoch, um unter dem Luftraum %1 durchzufliegen, den die Mission der Tour verbietet, und darüber gibt es keinen Weg; diesen Luftraum erlauben, die Obergrenze anheben, oder die Ziele neben ihm verschieben</translation>
    </message>
    <message>
        <source>the tour has to go up to {:.0f} m MSL ({:.0f} ft), where {} hardly climbs in this air; set a lower ceiling or leave out the highest targets</source>
        <translation>die Tour muss auf %1 m MSL (%2 ft) hinauf, wo %3 in dieser Luft kaum noch steigt; eine tiefere Obergrenze setzen oder die höchsten Ziele weglassen</translation>
    </message>
    <message>
        <source>stopped while looking for ways around unknown terrain</source>
        <translation>beim Suchen von Wegen um unbekanntes Gelände angehalten</translation>
    </message>
    <message>
        <source>stopped while looking for ways around airspace</source>
        <translation>beim Suchen von Wegen um Lufträume angehalten</translation>
    </message>
    <message>
        <source>a limit in words</source>
        <translation>Grenze in Worten</translation>
    </message>
    <message>
        <source>home {} lies inside {}, which the mission forbids to the tour and so to its departure and arrival; allow the airspace (Mission &gt; Airspace), choose another runway, or plan without a home</source>
        <translation>Heimatpiste %1 liegt im Luftraum %2, den die Mission der Tour und damit auch den Wegen von und zu der Heimatpiste verbietet; den Luftraum erlauben (Mission &gt; Luftraum), eine andere Piste wählen, oder ohne Heimatpiste planen</translation>
    </message>
    <message>
        <source>stopped while planning the ways from and to the home runway</source>
        <translation>beim Planen der Wege von und zu der Heimatpiste angehalten</translation>
    </message>
    <message>
        <source>home {}: no way {} it keeps a glide to a runway within the limits of climb, descent and ceiling{}; choose another runway, raise the ceiling, or plan without a home</source>
        <translation>Heimatpiste %1: kein Weg %2 ihr behält einen Gleitweg zu einer Piste, innerhalb der Grenzen für Steigen, Sinken und Obergrenze%3; eine andere Piste wählen, die Obergrenze anheben, oder ohne Heimatpiste planen</translation>
    </message>
    <message>
        <source>from the circles over</source>
        <translation>von den Kreisen über</translation>
    </message>
    <message>
        <source>from the tour to</source>
        <translation>von der Tour zu</translation>
    </message>
    <message>
        <source> and out of the airspaces that the mission forbids to the tour</source>
        <translation> und außerhalb der Lufträume, die die Mission der Tour verbietet</translation>
    </message>
    <message>
        <source>home {}: there is no usable landing site of that name; there are {}{}</source>
        <translation>Heimatpiste %1: es gibt keinen verwendbaren Landeplatz dieses Namens; es gibt %2%3</translation>
    </message>
    <message>
        <source>stopped while planning the tour</source>
        <translation>beim Planen der Tour angehalten</translation>
    </message>
    <message>
        <source>target {} lies inside {}, which the mission forbids to the tour: the lowest safe altitude above it is {:.0f} m MSL, so it cannot be visited from below that airspace, nor from above it under the ceiling of the tour; allow the airspace (Mission &gt; Airspace), move the target out of it, or drop the target</source>
        <translation>Ziel %1 liegt im Luftraum %2, den die Mission der Tour verbietet: die tiefste sichere Höhe darüber ist %3 m MSL, daher kann das Ziel weder von unter diesem Luftraum angeflogen werden noch von über ihm unter der Obergrenze der Tour; den Luftraum erlauben (Mission &gt; Luftraum), das Ziel aus ihm hinaus verschieben, oder das Ziel weglassen</translation>
    </message>
    <message>
        <source>{} and {} more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>every target can be joined to a neighbour, but no closed tour over all of them stays within glide of a runway, below the ceiling and out of the airspaces that the mission forbids to the tour; between the targets lie {}; allow one of them (Mission &gt; Airspace), raise the ceiling, or drop the targets behind it</source>
        <translation>jedes Ziel lässt sich mit einem Nachbarn verbinden, aber keine geschlossene Tour über alle bleibt im Gleitbereich einer Piste, unter der Obergrenze und außerhalb der Lufträume, die die Mission der Tour verbietet; zwischen den Zielen liegt Luftraum: %1; einen davon erlauben (Mission &gt; Luftraum), die Obergrenze anheben, oder die Ziele dahinter weglassen</translation>
    </message>
    <message>
        <source>every target can be joined to a neighbour, but no closed tour over all of them stays over known terrain, below the ceiling and within glide of a runway; move targets that lie beside gaps in the terrain or below high ground, raise the ceiling, or drop targets that are hard to reach</source>
        <translation>jedes Ziel lässt sich mit einem Nachbarn verbinden, aber keine geschlossene Tour über alle bleibt über bekanntem Gelände, unter der Obergrenze und im Gleitbereich einer Piste; Ziele verschieben, die neben Lücken im Gelände oder unter hohem Boden liegen, die Obergrenze anheben, oder schwer erreichbare Ziele weglassen</translation>
    </message>
    <message>
        <source>target {}: its legs to the nearest targets find no way below, above or around {}, which the mission forbids to the tour; allow that airspace (Mission &gt; Airspace), raise the ceiling, or move or drop the target</source>
        <translation>Ziel %1: die Teilstrecken zu den nächsten Zielen finden keinen Weg unter, über oder um Luftraum, den die Mission der Tour verbietet: %2; diesen Luftraum erlauben (Mission &gt; Luftraum), die Obergrenze anheben, oder das Ziel verschieben oder weglassen</translation>
    </message>
    <message>
        <source>the airspace beside it</source>
        <translation>der Luftraum daneben</translation>
    </message>
    <message>
        <source>target {}: the legs to its nearest targets leave known terrain or have points without any glide to a landing site; load more terrain or drop the target</source>
        <translation>Ziel %1: die Teilstrecken zu seinen nächsten Zielen verlassen das bekannte Gelände oder haben Punkte ohne jeden Gleitweg zu einem Landeplatz; mehr Gelände laden oder das Ziel weglassen</translation>
    </message>
    <message>
        <source>target {}: the legs to its nearest targets must climb to {:.0f} m MSL to stay within glide of a runway, {:.0f} m above the ceiling of {:.0f} m; raise the ceiling, add a landing site, or drop the target</source>
        <translation>Ziel %1: die Teilstrecken zu seinen nächsten Zielen müssen auf %2 m MSL steigen, um im Gleitbereich einer Piste zu bleiben, %3 m über der Obergrenze von %4 m; die Obergrenze anheben, einen Landeplatz hinzufügen, oder das Ziel weglassen</translation>
    </message>
    <message>
        <source>the mission has no targets; add at least one</source>
        <translation>die Mission hat keine Ziele; mindestens eines hinzufügen</translation>
    </message>
    <message>
        <source>target {}: the terrain has no data there; move the target or load terrain that covers it</source>
        <translation>Ziel %1: das Gelände hat dort keine Daten; das Ziel verschieben oder Gelände laden, das es abdeckt</translation>
    </message>
    <message>
        <source>target {}: no glide from above it reaches any of the {} landing sites over known terrain; add landing sites or terrain around it, or drop the target</source>
        <translation>Ziel %1: kein Gleitweg von über ihm erreicht über bekanntem Gelände einen der Landeplätze (%2); Landeplätze oder Gelände um es herum hinzufügen, oder das Ziel weglassen</translation>
    </message>
    <message>
        <source>target {}: the lowest safe altitude above it is {:.0f} m MSL ({:.0f} ft), {:.0f} m above the ceiling of {:.0f} m; raise the ceiling by {:.0f} m, add a landing site nearer to it, or drop the target</source>
        <translation>Ziel %1: die tiefste sichere Höhe darüber ist %2 m MSL (%3 ft), %4 m über der Obergrenze von %5 m; die Obergrenze um %6 m anheben, einen näheren Landeplatz hinzufügen, oder das Ziel weglassen</translation>
    </message>
    <message>
        <source>joined into one loop within the pitch limits the tour climbs to {:.0f} m MSL, {:.0f} m above the ceiling of {:.0f} m; raise the ceiling</source>
        <translation>zu einer Runde verbunden steigt die Tour innerhalb der Steig- und Sinkgrenzen auf %1 m MSL, %2 m über der Obergrenze von %3 m; die Obergrenze anheben</translation>
    </message>
    <message>
        <source>the tour before leaves no safe place for what changed</source>
        <translation>die vorige Tour lässt keinen sicheren Platz für das, was sich geändert hat</translation>
    </message>
    <message>
        <source>stopped while refining the tour</source>
        <translation>beim Verfeinern der Tour angehalten</translation>
    </message>
    <message>
        <source>refined to {:.0f} m</source>
        <translation>verfeinert auf %1 m</translation>
    </message>
    <message>
        <source>the mission has no targets</source>
        <translation>die Mission hat keine Ziele</translation>
    </message>
    <message>
        <source>{}: {} of {} visits</source>
        <translation>%1: %2 von %3 Überflügen</translation>
    </message>
    <message>
        <source>no safe circle over the only target</source>
        <translation>kein sicherer Kreis über dem einzigen Ziel</translation>
    </message>
    <message>
        <source>safe segments</source>
        <translation>sichere Teilstrecken</translation>
    </message>
    <message>
        <source>lazy round {}: cost {:.0f} m, {} safe segments</source>
        <translation>Lazy-Runde %1: Kosten %2 m, %3 sichere Teilstrecken</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>stehend</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>behind {}</source>
        <translation>nach %1</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>zu</translation>
    </message>
    <message>
        <source>windmilling</source>
        <translation>drehend</translation>
    </message>
    <message>
        <source>windmill</source>
        <translation>dreht</translation>
    </message>
    <message>
        <source>warmer</source>
        <translation>wärmer</translation>
    </message>
    <message>
        <source>colder</source>
        <translation>kälter</translation>
    </message>
    <message>
        <source>departure</source>
        <translation>Abflug</translation>
    </message>
    <message>
        <source>arrival</source>
        <translation>Anflug</translation>
    </message>
    <message>
        <source>tailwind</source>
        <translation>Rückenwind</translation>
    </message>
    <message>
        <source>crosswind</source>
        <translation>Seitenwind</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>latitude</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>longitude</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>Water.</source>
        <translation>Wasser.</translation>
    </message>
    <message>
        <source>Lighted.</source>
        <translation>Befeuert.</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>row {}</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>line {}</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>{}, line {:d}</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>, {} sea</source>
        <translation>, %1 Meer</translation>
    </message>
    <message>
        <source>{:.0f} m wide.</source>
        <translation>%1 m breit.</translation>
    </message>
    <message>
        <source>{:g} to {:g}</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>{:g} to {:g} {}</source>
        <translation>%1 bis %2 %3</translation>
    </message>
    <message>
        <source>{:d} bytes</source>
        <translation>%1 Bytes</translation>
    </message>
    <message>
        <source>{:g} K {} than</source>
        <translation>%1 K %2 als</translation>
    </message>
    <message>
        <source>{} point {:d}</source>
        <translation>%1, Punkt %2</translation>
    </message>
    <message>
        <source>aircraft {}: {}</source>
        <translation>Flugzeug %1: %2</translation>
    </message>
    <message>
        <source> Exception: {}.</source>
        <translation> Ausnahme: %1.</translation>
    </message>
    <message>
        <source>east</source>
        <translation>Ost</translation>
    </message>
    <message>
        <source>west</source>
        <translation>West</translation>
    </message>
    <message>
        <source>the plan has {} holds before {}, so it is not clear which one is flown</source>
        <translation>der Plan hat %1 Warteräume vor %2, daher ist nicht klar, welcher geflogen wird</translation>
    </message>
</context>
<context>
    <name>DocumentFiles</name>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>The plan beside the mission was not opened: %1</source>
        <translation>Der Plan neben der Mission wurde nicht geöffnet: %1</translation>
    </message>
    <message>
        <source>The plan beside the mission was made over other terrain and was not opened.</source>
        <translation>Der Plan neben der Mission wurde über anderem Gelände gemacht und nicht geöffnet.</translation>
    </message>
    <message>
        <source>the saved copy of unsaved work is damaged; it cannot be restored</source>
        <translation>die Sicherungskopie der nicht gespeicherten Arbeit ist beschädigt; sie kann nicht wiederhergestellt werden</translation>
    </message>
    <message>
        <source>the copy was written by a newer Volplane; open it there</source>
        <translation>die Kopie wurde von einem neueren Volplane geschrieben; dort öffnen</translation>
    </message>
    <message>
        <source>the terrain has changed since the plan was made; plan again before looking at it</source>
        <translation>das Gelände hat sich geändert, seit der Plan gemacht wurde; vor dem Ansehen neu planen</translation>
    </message>
</context>
<context>
    <name>Exports</name>
    <message>
        <source>the folder cannot be made: a file has the name %1; choose another folder</source>
        <translation>der Ordner kann nicht angelegt werden: eine Datei heißt %1; anderen Ordner wählen</translation>
    </message>
    <message>
        <source>the folder cannot be made: %1</source>
        <translation>der Ordner kann nicht angelegt werden: %1</translation>
    </message>
    <message>
        <source>the file that is there could not be copied to a backup; nothing was overwritten</source>
        <translation>die vorhandene Datei konnte nicht gesichert werden; nichts wurde überschrieben</translation>
    </message>
    <message>
        <source>the file that is there cannot be read; nothing was overwritten</source>
        <translation>die vorhandene Datei kann nicht gelesen werden; nichts wurde überschrieben</translation>
    </message>
    <message>
        <source>places to %1 m</source>
        <translation>Orte auf %1 m genau</translation>
    </message>
    <message>
        <source>%1: least margin %2 on the tour, %3 flown from waypoint to waypoint</source>
        <translation>%1: kleinste Reserve %2 auf der Tour, %3 von Wegpunkt zu Wegpunkt geflogen</translation>
    </message>
    <message>
        <source>flown from waypoint to waypoint no least margin is smaller than on the tour</source>
        <translation>von Wegpunkt zu Wegpunkt geflogen ist keine kleinste Reserve kleiner als auf der Tour</translation>
    </message>
    <message>
        <source>plan again with a shorter step between decision points, or export to a format that holds places more finely, such as GPX</source>
        <translation>mit kleinerem Schritt zwischen Entscheidungspunkten neu planen, oder in ein Format exportieren, das Orte feiner speichert, etwa GPX</translation>
    </message>
    <message>
        <source>plan again with a shorter step between decision points</source>
        <translation>mit kleinerem Schritt zwischen Entscheidungspunkten neu planen</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints, %1: flown with fly-by turns of %2 m radius the path is at most %3 m beside and %4 m above the tour, never below it; targets are passed within %5 m</source>
        <translation>
            <numerusform>%n Wegpunkt, %1: mit Fly-by-Kurven von %2 m Radius geflogen liegt der Weg höchstens %3 m neben und %4 m über der Tour, nie darunter; Ziele werden auf %5 m genau überflogen</numerusform>
            <numerusform>%n Wegpunkte, %1: mit Fly-by-Kurven von %2 m Radius geflogen liegt der Weg höchstens %3 m neben und %4 m über der Tour, nie darunter; Ziele werden auf %5 m genau überflogen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: the waypoint route could not be verified</source>
        <translation>%1: die Wegpunktroute konnte nicht geprüft werden</translation>
    </message>
    <message>
        <source>%1: flown from waypoint to waypoint the route is NOT SAFE</source>
        <translation>%1: von Wegpunkt zu Wegpunkt geflogen ist die Route NICHT SICHER</translation>
    </message>
    <message>
        <source>this plan is UNVERIFIED: no one has shown that a glide to a runway exists from every point of it</source>
        <translation>dieser Plan ist UNGEPRÜFT: niemand hat gezeigt, dass von jedem Punkt aus eine Piste im Gleitflug erreichbar ist</translation>
    </message>
    <message numerus="yes">
        <source>%n spirals down to low targets are not part of the waypoints: the route passes above these targets</source>
        <translation>
            <numerusform>%n Spirale hinab zu einem tiefen Ziel ist nicht in den Wegpunkten: die Route führt über dieses Ziel hinweg</numerusform>
            <numerusform>%n Spiralen hinab zu tiefen Zielen sind nicht in den Wegpunkten: die Route führt über diese Ziele hinweg</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 points are more than the %3 that it takes, so there are %4 files, each beginning where the one before ended</source>
        <translation>%1: %2 Punkte sind mehr als die %3, die es aufnimmt, daher gibt es %4 Dateien; jede beginnt, wo die vorige endet</translation>
    </message>
    <message>
        <source>%1: nothing in this file can say that it is unverified; name the file so</source>
        <translation>%1: nichts in dieser Datei kann sagen, dass sie ungeprüft ist; sie so benennen</translation>
    </message>
    <message>
        <source>there is no export format %1</source>
        <translation>es gibt kein Exportformat %1</translation>
    </message>
    <message>
        <source>stopped while exporting; nothing was written</source>
        <translation>beim Exportieren angehalten; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>tour above terrain and clearance</source>
        <translation>Tour über Gelände und Bodenabstand</translation>
    </message>
    <message>
        <source>tour above what the glide needs</source>
        <translation>Tour über dem, was der Gleitweg braucht</translation>
    </message>
    <message>
        <source>climb angle below the steepest allowed</source>
        <translation>Steigwinkel unter dem steilsten erlaubten</translation>
    </message>
    <message>
        <source>descent angle below the steepest allowed</source>
        <translation>Sinkwinkel unter dem steilsten erlaubten</translation>
    </message>
    <message>
        <source>tour below the ceiling</source>
        <translation>Tour unter der Obergrenze</translation>
    </message>
    <message>
        <source>engine-out glides above terrain and clearance</source>
        <translation>Gleitwege bei Motorausfall über Gelände und Bodenabstand</translation>
    </message>
    <message>
        <source>engine-out glides above terrain less what rolling may cost</source>
        <translation>Gleitwege bei Motorausfall über Gelände, abzüglich was das Rollen kosten kann</translation>
    </message>
    <message>
        <source>engine-out glides above the runway on arrival</source>
        <translation>Gleitwege bei Motorausfall über der Piste bei Ankunft</translation>
    </message>
    <message>
        <source>height at which a target is passed above it</source>
        <translation>Höhe, in der ein Ziel überflogen wird</translation>
    </message>
    <message>
        <source>spirals above terrain and clearance</source>
        <translation>Spiralen über Gelände und Bodenabstand</translation>
    </message>
    <message>
        <source>the backup that is there cannot be read; nothing was overwritten</source>
        <translation>die vorhandene Sicherungskopie kann nicht gelesen werden; nichts wurde überschrieben</translation>
    </message>
</context>
<context>
    <name>FileKind</name>
    <message>
        <source>airports without runways; add the runways.csv of the same download together with it</source>
        <translation>Flugplätze ohne Pisten; die Datei runways.csv desselben Downloads mit hinzufügen</translation>
    </message>
    <message>
        <source>runways without airports; add the airports.csv of the same download together with it</source>
        <translation>Pisten ohne Flugplätze; die Datei airports.csv desselben Downloads mit hinzufügen</translation>
    </message>
    <message>
        <source>is neither a table of OurAirports nor one of own fields; its first line lacks their columns (latitude, longitude and course_deg)</source>
        <translation>ist weder eine Tabelle von OurAirports noch eine mit eigenen Feldern; der ersten Zeile fehlen deren Spalten (latitude, longitude und course_deg)</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>es gibt keine solche Datei</translation>
    </message>
    <message>
        <source>is a mission or plan and cannot be added to one; open it instead</source>
        <translation>ist eine Mission oder ein Plan und kann keiner hinzugefügt werden; stattdessen öffnen</translation>
    </message>
    <message>
        <source>reading the files was stopped</source>
        <translation>das Lesen der Dateien wurde angehalten</translation>
    </message>
    <message>
        <source>is part of the mission already</source>
        <translation>gehört schon zur Mission</translation>
    </message>
</context>
<context>
    <name>GlideProfileRenderer</name>
    <message>
        <source> MSL</source>
        <translation> MSL</translation>
    </message>
    <message>
        <source>%1: %2 above on arrival</source>
        <translation>%1: %2 darüber bei Ankunft</translation>
    </message>
</context>
<context>
    <name>Guarantee</name>
    <message>
        <source> Exception: between %1 and %2 at target %3 the tour leaves the safe altitude in a spiral of %4 circles: there the gliding guarantee is suspended.</source>
        <translation> Ausnahme: zwischen %1 und %2 bei Ziel %3 verlässt die Tour die Sicherheitshöhe in einer Spirale von %4 Kreisen: dort ist die Gleitgarantie ausgesetzt.</translation>
    </message>
    <message>
        <source> The same holds on the ways from and to the runway, but for the climb-out: after taking off from %1 it begins %2 past the far end of the runway, at %3 (%4 above the runway), and it ends above the threshold of %5 at %6 (%7 above the runway), from where the landing is the pilot&apos;s.</source>
        <translation> Dasselbe gilt auf den Wegen von und zu der Piste, außer im Abflug: nach dem Start von %1 beginnt es %2 nach dem Pistenende, in %3 (%4 über der Piste), und es endet über der Schwelle von %5 in %6 (%7 über der Piste), von wo die Landung Sache des Piloten ist.</translation>
    </message>
    <message>
        <source> Every glide ends %1.</source>
        <translation> Jeder Gleitweg endet %1.</translation>
    </message>
    <message>
        <source> On that last part it keeps only above %1, where that is less than the clearance.</source>
        <translation> Auf diesem letzten Stück bleibt er nur über %1, wo das weniger als der Bodenabstand ist.</translation>
    </message>
    <message>
        <source> Where each approach begins there is room for circles in which height left over can be lost.</source>
        <translation> Wo jeder Anflug beginnt, ist Platz für Kreise, in denen übrige Höhe abgebaut werden kann.</translation>
    </message>
    <message>
        <source> It holds for masses of %1, each at its best glide speed.</source>
        <translation> Sie gilt für Massen von %1, jede mit ihrer Geschwindigkeit des besten Gleitens.</translation>
    </message>
    <message>
        <source> It holds in air of %1, from the lowest runway up to %2.</source>
        <translation> Sie gilt in Luft mit %1, von der tiefsten Piste bis %2.</translation>
    </message>
    <message>
        <source> It allows for a reaction after the engine stops, with the aircraft flying on: %1.</source>
        <translation> Sie lässt Zeit für eine Reaktion nach dem Motorausfall, während das Flugzeug weiterfliegt: %1.</translation>
    </message>
    <message>
        <source> Drag counts %1 times that of the polar; the glide ratios are with it.</source>
        <translation> Der Widerstand zählt das %1-Fache der Polare; die Gleitzahlen enthalten es.</translation>
    </message>
    <message>
        <source> It holds with the propeller stopped only.</source>
        <translation> Sie gilt nur mit stehendem Propeller.</translation>
    </message>
    <message>
        <source> It holds with the propeller windmilling.</source>
        <translation> Sie gilt mit drehendem Propeller.</translation>
    </message>
    <message>
        <source> The tour is flown at %1.</source>
        <translation> Die Tour wird geflogen mit %1.</translation>
    </message>
    <message>
        <source>glide ratio %1 straight ahead</source>
        <translation>Gleitzahl %1 geradeaus</translation>
    </message>
    <message>
        <source>glide ratio %1 straight ahead in still air, %2 over ground against the strongest wind</source>
        <translation>Gleitzahl %1 geradeaus in ruhiger Luft, %2 über Grund gegen den stärksten Wind</translation>
    </message>
    <message>
        <source>From every point of this tour (%1 decision points and all points between them) the aircraft, its engine stopped and gliding at %2 TAS in %9 with the polar of %3 (%4), can reach %5 on the landing course, at least %6 above the terrain on all the way and at least %7 above the runway on arrival. Terrain is the highest ground of each cell of %8, runways are as listed in the plan; </source>
        <translation>Von jedem Punkt dieser Tour (%1 Entscheidungspunkte und alle Punkte dazwischen) kann das Flugzeug mit stehendem Motor, gleitend mit %2 TAS bei %9 und mit der Polare von %3 (%4), %5 auf dem Landekurs erreichen, auf dem ganzen Weg mindestens %6 über dem Gelände und bei Ankunft mindestens %7 über der Piste. Gelände ist der höchste Boden jeder Zelle von %8, Pisten sind die im Plan aufgeführten; </translation>
    </message>
    <message>
        <source>the one runway end used</source>
        <translation>das eine verwendete Pistenende</translation>
    </message>
    <message>
        <source>one of %1 runway ends</source>
        <translation>eines von %1 Pistenenden</translation>
    </message>
</context>
<context>
    <name>LandingModel</name>
    <message>
        <source>Roadmap</source>
        <translation>Wegenetz</translation>
    </message>
    <message>
        <source>Any-time</source>
        <translation>Jederzeit</translation>
    </message>
    <message>
        <source>One curve</source>
        <translation>Eine Kurve</translation>
    </message>
    <message>
        <source>FMT*</source>
        <translation>FMT*</translation>
    </message>
    <message>
        <source>FMT*, octree</source>
        <translation>FMT*, Octree</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Gradient</translation>
    </message>
    <message>
        <source>Best of all</source>
        <translation>Beste von allen</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>Geradeaus</translation>
    </message>
    <message>
        <source>VG</source>
        <translation>VG</translation>
    </message>
    <message>
        <source>TG</source>
        <translation>TG</translation>
    </message>
    <message>
        <source>LVG</source>
        <translation>LVG</translation>
    </message>
    <message>
        <source>HRM</source>
        <translation>HRM</translation>
    </message>
    <message>
        <source>PRM</source>
        <translation>PRM</translation>
    </message>
    <message>
        <source>VPRM</source>
        <translation>VPRM</translation>
    </message>
    <message>
        <source>DLVG</source>
        <translation>DLVG</translation>
    </message>
    <message>
        <source>DPRM</source>
        <translation>DPRM</translation>
    </message>
    <message>
        <source>DVPRM</source>
        <translation>DVPRM</translation>
    </message>
</context>
<context>
    <name>Language</name>
    <message>
        <source>en</source>
        <comment>code of this language, for the names of months and weekdays</comment>
        <translation>de</translation>
    </message>
</context>
<context>
    <name>PlanSummaryPanel</name>
    <message>
        <source>Tour above terrain and clearance</source>
        <translation>Tour über Gelände und Bodenabstand</translation>
    </message>
    <message>
        <source>Tour above what the glide needs</source>
        <translation>Tour über dem, was der Gleitweg braucht</translation>
    </message>
    <message>
        <source>Climb below the steepest allowed</source>
        <translation>Steigen unter dem steilsten erlaubten</translation>
    </message>
    <message>
        <source>Descent below the steepest allowed</source>
        <translation>Sinken unter dem steilsten erlaubten</translation>
    </message>
    <message>
        <source>Tour below the ceiling</source>
        <translation>Tour unter der Obergrenze</translation>
    </message>
    <message>
        <source>Glides above terrain and clearance</source>
        <translation>Gleitwege über Gelände und Bodenabstand</translation>
    </message>
    <message>
        <source>Glides above terrain less what rolling may cost</source>
        <translation>Gleitwege über Gelände, abzüglich Rollen</translation>
    </message>
    <message>
        <source>Glides above the runway on arrival</source>
        <translation>Gleitwege über der Piste bei Ankunft</translation>
    </message>
    <message>
        <source>Tour above the targets</source>
        <translation>Tour über den Zielen</translation>
    </message>
    <message>
        <source>Spirals above terrain and clearance</source>
        <translation>Spiralen über Gelände und Bodenabstand</translation>
    </message>
</context>
<context>
    <name>PlanningSketch</name>
    <message>
        <source>checking the plan</source>
        <translation>der Plan wird geprüft</translation>
    </message>
    <message numerus="yes">
        <source>Roadmap: %n glides</source>
        <translation>
            <numerusform>Wegenetz: %n Gleitweg</numerusform>
            <numerusform>Wegenetz: %n Gleitwege</numerusform>
        </translation>
    </message>
    <message>
        <source>Round %1: %2 of %3 legs are safe</source>
        <translation>Runde %1: %2 von %3 Teilstrecken sind sicher</translation>
    </message>
</context>
<context>
    <name>ProfileRenderer</name>
    <message>
        <source> MSL</source>
        <translation> MSL</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Tour</translation>
    </message>
    <message>
        <source>Lowest safe altitude</source>
        <translation>Tiefste sichere Höhe</translation>
    </message>
    <message>
        <source>Terrain below</source>
        <translation>Gelände darunter</translation>
    </message>
    <message>
        <source>Highest within %1 m</source>
        <translation>Höchstes im Umkreis von %1 m</translation>
    </message>
    <message>
        <source>Pitch limits only</source>
        <translation>Nur Steig- und Sinkgrenzen</translation>
    </message>
    <message>
        <source>Decision points</source>
        <translation>Entscheidungspunkte</translation>
    </message>
    <message>
        <source>Decision points: zoom in</source>
        <translation>Entscheidungspunkte: näher heran</translation>
    </message>
    <message>
        <source>Wind on course, tail to the right</source>
        <translation>Wind auf Kurs, Rückenwind nach rechts</translation>
    </message>
    <message>
        <source>Too low</source>
        <translation>Zu tief</translation>
    </message>
    <message>
        <source>Unknown terrain</source>
        <translation>Gelände unbekannt</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>bei %1</translation>
    </message>
    <message>
        <source>Least clearance %1 %2</source>
        <translation>Kleinster Bodenabstand %1 %2</translation>
    </message>
    <message>
        <source>Least clearance unknown: no terrain data %1</source>
        <translation>Kleinster Bodenabstand unbekannt: keine Geländedaten %1</translation>
    </message>
    <message>
        <source>Least glide margin %1 %2</source>
        <translation>Kleinste Gleitreserve %1 %2</translation>
    </message>
    <message>
        <source>No safe glide known %1</source>
        <translation>Kein sicherer Gleitweg bekannt %1</translation>
    </message>
    <message>
        <source>Highest ground %1 %2</source>
        <translation>Höchster Boden %1 %2</translation>
    </message>
    <message>
        <source>OUT OF DATE</source>
        <translation>VERALTET</translation>
    </message>
    <message>
        <source>NOT VERIFIED</source>
        <translation>NICHT GEPRÜFT</translation>
    </message>
    <message>
        <source>Planning. The profile appears as soon as the tour is complete.</source>
        <translation>Planung läuft. Das Profil erscheint, sobald die Tour vollständig ist.</translation>
    </message>
    <message>
        <source>Load terrain and airports, then mark targets on the map: the altitude profile of the tour appears here.</source>
        <translation>Gelände und Flugplätze laden, dann Ziele auf der Karte setzen: das Höhenprofil der Tour erscheint hier.</translation>
    </message>
    <message>
        <source>Mark targets on the map and plan the tour: its altitude profile appears here.</source>
        <translation>Ziele auf der Karte setzen und die Tour planen: ihr Höhenprofil erscheint hier.</translation>
    </message>
    <message>
        <source>Plan the tour: its altitude profile appears here.</source>
        <translation>Die Tour planen: ihr Höhenprofil erscheint hier.</translation>
    </message>
    <message>
        <source>%1 tail</source>
        <translation>%1 von hinten</translation>
    </message>
    <message>
        <source>%1 head</source>
        <translation>%1 von vorn</translation>
    </message>
    <message>
        <source>%1 from the left</source>
        <translation>%1 von links</translation>
    </message>
    <message>
        <source>%1 from the right</source>
        <translation>%1 von rechts</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>Windstille</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
</context>
<context>
    <name>SceneProblems</name>
    <message>
        <source>no EGL display without a window could be opened; install the OpenGL driver (Mesa) of this machine</source>
        <translation>ohne Fenster konnte keine EGL-Anzeige geöffnet werden; den OpenGL-Treiber (Mesa) dieses Rechners installieren</translation>
    </message>
    <message>
        <source>the EGL of this machine has no desktop OpenGL</source>
        <translation>das EGL dieses Rechners hat kein Desktop-OpenGL</translation>
    </message>
    <message>
        <source>EGL has no configuration for OpenGL</source>
        <translation>EGL hat keine Konfiguration für OpenGL</translation>
    </message>
    <message>
        <source>no OpenGL context without a window could be made</source>
        <translation>ohne Fenster konnte kein OpenGL-Kontext erzeugt werden</translation>
    </message>
    <message>
        <source>there is no terrain to draw; add a terrain file to the mission</source>
        <translation>es gibt kein Gelände zum Zeichnen; der Mission eine Geländedatei hinzufügen</translation>
    </message>
    <message>
        <source>OpenGL could not draw a picture of this size</source>
        <translation>OpenGL konnte kein Bild dieser Größe zeichnen</translation>
    </message>
</context>
<context>
    <name>SiteText</name>
    <message>
        <source>hard</source>
        <translation>befestigt</translation>
    </message>
    <message>
        <source>gravel</source>
        <translation>Schotter</translation>
    </message>
    <message>
        <source>grass</source>
        <translation>Gras</translation>
    </message>
    <message>
        <source>dirt</source>
        <translation>Erde</translation>
    </message>
    <message>
        <source>water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>snow</source>
        <translation>Schnee</translation>
    </message>
    <message>
        <source>unknown surface</source>
        <translation>Oberfläche unbekannt</translation>
    </message>
    <message>
        <source>Landing course %1</source>
        <translation>Landekurs %1</translation>
    </message>
    <message>
        <source>length %1</source>
        <translation>Länge %1</translation>
    </message>
    <message>
        <source>length unknown</source>
        <translation>Länge unbekannt</translation>
    </message>
    <message>
        <source>elevation %1</source>
        <translation>Platzhöhe %1</translation>
    </message>
    <message>
        <source>partly estimated</source>
        <translation>teils geschätzt</translation>
    </message>
</context>
<context>
    <name>TargetModel</name>
    <message>
        <source>AGL</source>
        <translation>AGL</translation>
    </message>
    <message>
        <source>MSL</source>
        <translation>MSL</translation>
    </message>
</context>
<context>
    <name>Wind</name>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1 bis %2 %3</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>Windstille</translation>
    </message>
    <message>
        <source>%1 from any direction</source>
        <translation>%1 aus jeder Richtung</translation>
    </message>
    <message>
        <source>%1 from %2 degrees</source>
        <translation>%1 aus %2 Grad</translation>
    </message>
    <message>
        <source>%1 from %2 to %3 degrees</source>
        <translation>%1 aus %2 bis %3 Grad</translation>
    </message>
    <message>
        <source>calm air</source>
        <translation>Windstille</translation>
    </message>
    <message>
        <source>every wind between the layers of the forecast (%1; true)</source>
        <translation>jedem Wind zwischen den Schichten der Vorhersage (%1; rechtweisend)</translation>
    </message>
    <message>
        <source>every wind of %1</source>
        <translation>jedem Wind von %1</translation>
    </message>
    <message>
        <source>a wind of %1 true</source>
        <translation>einem Wind von %1 rechtweisend</translation>
    </message>
    <message>
        <source>every wind of %1 true</source>
        <translation>jedem Wind von %1 rechtweisend</translation>
    </message>
    <message>
        <source>still air</source>
        <translation>Windstille</translation>
    </message>
    <message>
        <source>%1 at every height</source>
        <translation>%1 in jeder Höhe</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Plans closed surveillance tours from every point of which the aircraft can glide to a runway.</source>
        <translation>Plant geschlossene Überwachungsflüge, bei denen von jedem Punkt aus eine Piste im Gleitflug erreichbar ist.</translation>
    </message>
    <message>
        <source>A mission (*.vpm) or plan (*.vpp), or terrain and airfields</source>
        <translation>Eine Mission (*.vpm) oder ein Plan (*.vpp), oder Gelände und Flugplätze</translation>
    </message>
    <message>
        <source>Language of the window, instead of that of the preferences: %1.</source>
        <translation>Sprache des Fensters statt jener der Voreinstellungen: %1.</translation>
    </message>
    <message>
        <source>code</source>
        <translation>Kürzel</translation>
    </message>
    <message>
        <source>Print this help and exit.</source>
        <translation>Diese Hilfe ausgeben und enden.</translation>
    </message>
    <message>
        <source>Print version, commit, libraries and data sources with their licences, and exit.</source>
        <translation>Version, Commit, Bibliotheken und Datenquellen mit ihren Lizenzen ausgeben und enden.</translation>
    </message>
</context>
<context>
    <name>vp::about::AboutDialog</name>
    <message>
        <source>About Volplane</source>
        <translation>Über Volplane</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Volplane %1&lt;/h3&gt;%2&lt;p&gt;Plans tours from every point of which the aircraft can glide to a runway if the engine stops.&lt;/p&gt;&lt;p&gt;The promise is as good as its inputs: the wind of the mission, the polar in the aircraft profile, the terrain file and the runway list. The pilot checks those, and remains in command.&lt;/p&gt;&lt;p&gt;Licence: %3. No warranty.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Volplane %1&lt;/h3&gt;%2&lt;p&gt;Plant Touren, bei denen von jedem Punkt aus eine Piste im Gleitflug erreichbar ist, wenn der Motor ausfällt.&lt;/p&gt;&lt;p&gt;Das Versprechen ist so gut wie seine Eingaben: der Wind der Mission, die Polare im Flugzeugprofil, die Geländedatei und die Pistenliste. Der Pilot prüft sie und behält die Verantwortung.&lt;/p&gt;&lt;p&gt;Lizenz: %3. Ohne Gewähr.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Commit %1</source>
        <translation>Commit %1</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>Bibliotheken</translation>
    </message>
    <message>
        <source>&amp;Copy all</source>
        <translation>Alles &amp;kopieren</translation>
    </message>
    <message>
        <source>Version, libraries and data sources as text, for a report of a fault</source>
        <translation>Version, Bibliotheken und Datenquellen als Text, für eine Fehlermeldung</translation>
    </message>
</context>
<context>
    <name>vp::about::Words</name>
    <message>
        <source>terrain, fetched when you ask for it</source>
        <translation>Gelände, auf Verlangen geholt</translation>
    </message>
    <message>
        <source>airfields, fetched when you ask for them</source>
        <translation>Flugplätze, auf Verlangen geholt</translation>
    </message>
    <message>
        <source>public domain</source>
        <translation>gemeinfrei</translation>
    </message>
    <message>
        <source>magnetic variation 2025 to 2029, by NOAA NCEI and the British Geological Survey</source>
        <translation>Missweisung 2025 bis 2029, von NOAA NCEI und dem British Geological Survey</translation>
    </message>
    <message>
        <source>Aircraft profiles</source>
        <translation>Flugzeugprofile</translation>
    </message>
    <message>
        <source>each number with its source in the profile</source>
        <translation>jede Zahl mit ihrer Quelle im Profil</translation>
    </message>
    <message>
        <source>Bundled maps</source>
        <translation>Mitgelieferte Karten</translation>
    </message>
    <message>
        <source>made-up country, the project&apos;s own</source>
        <translation>erfundenes Land, vom Projekt selbst</translation>
    </message>
    <message>
        <source>Licence %1; no warranty. Plans are as good as their inputs: the pilot checks those, and remains in command.</source>
        <translation>Lizenz %1; ohne Gewähr. Pläne sind so gut wie ihre Eingaben: der Pilot prüft sie und behält die Verantwortung.</translation>
    </message>
    <message>
        <source>Libraries:</source>
        <translation>Bibliotheken:</translation>
    </message>
    <message>
        <source>Data:</source>
        <translation>Daten:</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::AircraftDialog</name>
    <message>
        <source>Aircraft</source>
        <translation>Flugzeug</translation>
    </message>
    <message>
        <source>Aircraft profile</source>
        <translation>Flugzeugprofil</translation>
    </message>
    <message>
        <source>&amp;Duplicate and edit</source>
        <translation>&amp;Duplizieren und bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;Save as file…</source>
        <translation>Als Datei &amp;speichern…</translation>
    </message>
    <message>
        <source>%1 (bundled)</source>
        <translation>%1 (mitgeliefert)</translation>
    </message>
    <message>
        <source>in this mission</source>
        <translation>in dieser Mission</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1, copy</source>
        <translation>%1, Kopie</translation>
    </message>
    <message>
        <source>Open aircraft profile</source>
        <translation>Flugzeugprofil öffnen</translation>
    </message>
    <message>
        <source>Aircraft profiles (*.json)</source>
        <translation>Flugzeugprofile (*.json)</translation>
    </message>
    <message>
        <source>Save aircraft profile</source>
        <translation>Flugzeugprofil speichern</translation>
    </message>
    <message>
        <source>This profile is not changed here; duplicate it to make one of your own.</source>
        <translation>Dieses Profil wird hier nicht geändert; für ein eigenes duplizieren.</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>keine Grenze</translation>
    </message>
    <message>
        <source>Runway directions that the wind of the mission may bring more to are not landed on; one step below 0 is no limit</source>
        <translation>Pistenrichtungen, denen der Wind der Mission mehr bringen kann, werden nicht angeflogen; ein Schritt unter 0 ist keine Grenze</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>kg</source>
        <translation>kg</translation>
    </message>
    <message>
        <source>Wing area</source>
        <translation>Flügelfläche</translation>
    </message>
    <message>
        <source>m²</source>
        <translation>m²</translation>
    </message>
    <message>
        <source>Zero-lift drag C_D0</source>
        <translation>Nullwiderstand C_D0</translation>
    </message>
    <message>
        <source>Induced drag factor L</source>
        <translation>Faktor des induzierten Widerstands L</translation>
    </message>
    <message>
        <source>Air density</source>
        <translation>Luftdichte</translation>
    </message>
    <message>
        <source>kg/m³</source>
        <translation>kg/m³</translation>
    </message>
    <message>
        <source>Best glide speed (TAS)</source>
        <translation>Geschwindigkeit des besten Gleitens (TAS)</translation>
    </message>
    <message>
        <source>Where each number comes from, one sentence a line</source>
        <translation>Woher jede Zahl kommt, ein Satz pro Zeile</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Quellen</translation>
    </message>
    <message>
        <source>Bank angles that a glide may choose among in its turns, in degrees, separated by commas</source>
        <translation>Querlagen, unter denen ein Gleitweg in seinen Kurven wählen darf, in Grad, durch Kommas getrennt</translation>
    </message>
    <message>
        <source>Banks in a glide (°)</source>
        <translation>Querlagen im Gleitflug (°)</translation>
    </message>
    <message>
        <source>Bank on the tour</source>
        <translation>Querlage auf der Tour</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Steepest climb</source>
        <translation>Steilstes Steigen</translation>
    </message>
    <message>
        <source>Steepest descent</source>
        <translation>Steilstes Sinken</translation>
    </message>
    <message>
        <source>Stall speed, wings level</source>
        <translation>Überziehgeschwindigkeit, waagerecht</translation>
    </message>
    <message>
        <source>Highest load factor</source>
        <translation>Größtes Lastvielfaches</translation>
    </message>
    <message>
        <source>Ceiling</source>
        <translation>Obergrenze</translation>
    </message>
    <message>
        <source>%1 MSL</source>
        <translation>%1 MSL</translation>
    </message>
    <message>
        <source>Most tailwind on landing</source>
        <translation>Größter Rückenwind bei der Landung</translation>
    </message>
    <message>
        <source>Most crosswind on landing</source>
        <translation>Größter Seitenwind bei der Landung</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>Least mass</source>
        <translation>Kleinste Masse</translation>
    </message>
    <message>
        <source>Plans hold for all masses between the two, each flown at its best glide speed</source>
        <translation>Pläne gelten für alle Massen zwischen den beiden, jede mit ihrer Geschwindigkeit des besten Gleitens geflogen</translation>
    </message>
    <message>
        <source>Greatest mass</source>
        <translation>Größte Masse</translation>
    </message>
    <message>
        <source>C_D0, propeller windmilling</source>
        <translation>C_D0, Propeller drehend</translation>
    </message>
    <message>
        <source>C_D0, propeller stopped</source>
        <translation>C_D0, Propeller stehend</translation>
    </message>
    <message>
        <source>Steepest without engine</source>
        <translation>Steilstes ohne Motor</translation>
    </message>
    <message>
        <source>Steepest steady descent through the air with flaps, brakes or a slip; approaches at a slope of your choice need it</source>
        <translation>Steilstes stetiges Sinken durch die Luft mit Klappen, Bremsen oder Seitengleitflug; Anflüge mit wählbarer Neigung brauchen es</translation>
    </message>
    <message>
        <source>Rate of roll</source>
        <translation>Rollrate</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source>Degrees of bank per second, at least; certificates then say what rolling into turns may cost a glide</source>
        <translation>Grad Querlage pro Sekunde, mindestens; Zertifikate sagen dann, was das Rollen in Kurven einen Gleitweg kosten kann</translation>
    </message>
    <message>
        <source>Never exceed (TAS)</source>
        <translation>Höchstgeschwindigkeit (TAS)</translation>
    </message>
    <message>
        <source>Landing distance</source>
        <translation>Landestrecke</translation>
    </message>
    <message>
        <source>Over 15 m (50 ft) to standstill at the greatest mass: sea level, standard air, no wind, dry hard runway. Runways too short for it on the day are not used</source>
        <translation>Über 15 m (50 ft) bis zum Stillstand bei größter Masse: Meereshöhe, Standardluft, kein Wind, trockene befestigte Piste. Für den Tag zu kurze Pisten werden nicht verwendet</translation>
    </message>
    <message>
        <source>Climb at sea level</source>
        <translation>Steigen auf Meereshöhe</translation>
    </message>
    <message>
        <source>ft/min</source>
        <translation>ft/min</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>Service ceiling</source>
        <translation>Dienstgipfelhöhe</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::AirspaceDialog</name>
    <message>
        <source>Airspace</source>
        <translation>Luftraum</translation>
    </message>
    <message>
        <source>Airspaces by class</source>
        <translation>Lufträume nach Klasse</translation>
    </message>
    <message>
        <source>Class and name</source>
        <translation>Klasse und Name</translation>
    </message>
    <message>
        <source>Ceiling / floor</source>
        <translation>Ober-/Untergrenze</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>&amp;All other classes:</source>
        <translation>&amp;Alle anderen Klassen:</translation>
    </message>
    <message>
        <source>Add airspace &amp;files…</source>
        <translation>Luftraum&amp;dateien hinzufügen…</translation>
    </message>
    <message>
        <source>%1 (not shown)</source>
        <translation>%1 (nicht gezeigt)</translation>
    </message>
    <message>
        <source>Class %1: none near this terrain</source>
        <translation>Klasse %1: keiner nahe diesem Gelände</translation>
    </message>
    <message numerus="yes">
        <source>Class %1: %n airspace(s)</source>
        <translation>
            <numerusform>Klasse %1: %n Luftraum</numerusform>
            <numerusform>Klasse %1: %n Lufträume</numerusform>
        </translation>
    </message>
    <message>
        <source>without a name</source>
        <translation>ohne Namen</translation>
    </message>
    <message>
        <source>As all other classes</source>
        <translation>Wie alle anderen Klassen</translation>
    </message>
    <message>
        <source>As its class</source>
        <translation>Wie seine Klasse</translation>
    </message>
    <message>
        <source>Class %1</source>
        <translation>Klasse %1</translation>
    </message>
    <message>
        <source>No airspaces yet. Add an OpenAir file here, with File &gt; Add airspaces, or drop it on the window.</source>
        <translation>Noch keine Lufträume. Hier eine OpenAir-Datei hinzufügen, mit Datei &gt; Lufträume hinzufügen, oder sie auf das Fenster ziehen.</translation>
    </message>
    <message>
        <source>“Keep the tour out”: planning goes below, above or around, and a plan that enters is refused. “Warn when entered”: the plan is made as if it were not there and the entry is named. Engine-out glides are never kept out, only named: an emergency may enter. Flight levels count in a standard atmosphere (1013.25 hPa).</source>
        <translation>„Tour fernhalten“: die Planung geht darunter, darüber oder außen herum, und ein Plan, der einfliegt, wird abgelehnt. „Bei Einflug warnen“: geplant wird, als gäbe es ihn nicht, und der Einflug wird genannt. Gleitwege bei Motorausfall werden nie ferngehalten, nur genannt: ein Notfall darf einfliegen. Flugflächen zählen in der Standardatmosphäre (1013.25 hPa).</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::BriefingDialog</name>
    <message>
        <source>Briefing</source>
        <translation>Briefing</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Letter</translation>
    </message>
    <message>
        <source>&amp;Paper</source>
        <translation>&amp;Papier</translation>
    </message>
    <message>
        <source>Upright, with room for a clip at the sides.</source>
        <translation>Hochformat, mit Platz für eine Klammer an den Seiten.</translation>
    </message>
    <message>
        <source>Feet, nautical miles, knots</source>
        <translation>Fuß, Seemeilen, Knoten</translation>
    </message>
    <message>
        <source>Metres, kilometres, km/h</source>
        <translation>Meter, Kilometer, km/h</translation>
    </message>
    <message>
        <source>&amp;Units</source>
        <translation>&amp;Einheiten</translation>
    </message>
    <message>
        <source>Of everything but the checker&apos;s findings and warnings.</source>
        <translation>Von allem außer den Befunden und Warnungen der Prüfung.</translation>
    </message>
    <message>
        <source>&amp;Day of flight</source>
        <translation>&amp;Tag des Flugs</translation>
    </message>
    <message>
        <source>Stands on every page and decides the magnetic variation.</source>
        <translation>Steht auf jeder Seite und bestimmt die Missweisung.</translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation>&amp;Karte</translation>
    </message>
    <message>
        <source>&amp;Altitude profile</source>
        <translation>&amp;Höhenprofil</translation>
    </message>
    <message>
        <source>&amp;Legs</source>
        <translation>Tei&amp;lstrecken</translation>
    </message>
    <message>
        <source>&amp;If the engine stops: runways along the tour</source>
        <translation>Wenn der &amp;Motor ausfällt: Pisten entlang der Tour</translation>
    </message>
    <message>
        <source>&amp;Glides from the worst places</source>
        <translation>&amp;Gleitwege von den schlechtesten Stellen</translation>
    </message>
    <message>
        <source>&amp;Targets</source>
        <translation>&amp;Ziele</translation>
    </message>
    <message>
        <source>Pictures in g&amp;reys</source>
        <translation>&amp;Bilder in Grautönen</translation>
    </message>
    <message>
        <source>&amp;Save as PDF…</source>
        <translation>Als PDF &amp;speichern…</translation>
    </message>
    <message>
        <source>&amp;Save all the same…</source>
        <translation>&amp;Trotzdem speichern…</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::ConditionValues</name>
    <message>
        <source>Count with the air of the day</source>
        <translation>Mit der Luft des Tages rechnen</translation>
    </message>
    <message>
        <source>Temperature above the standard atmosphere</source>
        <translation>Temperatur über der Standardatmosphäre</translation>
    </message>
    <message>
        <source> °C from standard</source>
        <translation> °C gegen Standard</translation>
    </message>
    <message>
        <source>QNH</source>
        <translation>QNH</translation>
    </message>
    <message>
        <source> hPa QNH</source>
        <translation> hPa QNH</translation>
    </message>
    <message>
        <source>&amp;Air</source>
        <translation>&amp;Luft</translation>
    </message>
    <message>
        <source>In thin air the same indicated speed is a faster one: turns are wider and landings longer. Standard is 15 °C at sea level, 2 °C less every 1000 ft, and 1013 hPa (29.92 inHg). Without it the density of the aircraft’s polar counts at every height.</source>
        <translation>In dünner Luft ist dieselbe angezeigte Geschwindigkeit eine höhere: Kurven werden weiter und Landungen länger. Standard sind 15 °C auf Meereshöhe, 2 °C weniger je 1000 ft, und 1013 hPa (29.92 inHg). Ohne sie zählt in jeder Höhe die Dichte aus der Polare des Flugzeugs.</translation>
    </message>
    <message>
        <source>As the aircraft’s polar has it</source>
        <translation>Wie in der Polare des Flugzeugs</translation>
    </message>
    <message>
        <source>Windmilling, turned by the air</source>
        <translation>Drehend, vom Fahrtwind getrieben</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Stehend</translation>
    </message>
    <message>
        <source>&amp;Propeller</source>
        <translation>&amp;Propeller</translation>
    </message>
    <message>
        <source>What it does after the engine has stopped. A windmilling propeller brakes most; count on a stopped one only if you know that it stops. What the aircraft’s profile says nothing of cannot be chosen.</source>
        <translation>Was er nach dem Motorausfall tut. Ein drehender Propeller bremst am meisten; mit einem stehenden nur rechnen, wenn sicher ist, dass er stehen bleibt. Was das Flugzeugprofil nicht nennt, kann nicht gewählt werden.</translation>
    </message>
    <message>
        <source>P&amp;ower on the tour</source>
        <translation>L&amp;eistung auf der Tour</translation>
    </message>
    <message>
        <source>The airspeed of the tour between glides: faster is sooner home, but turns are wider and more ground goes by before you react.</source>
        <translation>Die Eigengeschwindigkeit der Tour zwischen Gleitwegen: schneller ist früher zu Hause, aber Kurven sind weiter, und vor einer Reaktion vergeht mehr Strecke.</translation>
    </message>
    <message>
        <source>At the threshold, by any curve</source>
        <translation>An der Schwelle, über jede Kurve</translation>
    </message>
    <message>
        <source>Straight in</source>
        <translation>Direktanflug</translation>
    </message>
    <message>
        <source>From overhead, by a full circle</source>
        <translation>Von über dem Platz, mit Vollkreis</translation>
    </message>
    <message>
        <source>&amp;Glides end</source>
        <translation>&amp;Gleitwege enden</translation>
    </message>
    <message>
        <source>At the threshold is the lowest and the hardest to fly: the last turn may end at the runway. Straight in ends it before. From overhead is the key-point pattern of forced landings: high key above the runway, low key abeam.</source>
        <translation>An der Schwelle ist am tiefsten und am schwersten zu fliegen: die letzte Kurve kann an der Piste enden. Der Direktanflug beendet sie vorher. Von über dem Platz ist das Key-Point-Verfahren der Notlandung: High Key über der Piste, Low Key querab.</translation>
    </message>
    <message>
        <source>Length of the final approach</source>
        <translation>Länge des Endanflugs</translation>
    </message>
    <message>
        <source>&amp;Final</source>
        <translation>Endan&amp;flug</translation>
    </message>
    <message>
        <source>Straight in: length over ground of the last straight on the landing course.</source>
        <translation>Direktanflug: Länge der letzten Geraden auf dem Landekurs, über Grund.</translation>
    </message>
    <message>
        <source>At a slope of my choice</source>
        <translation>Mit wählbarer Neigung</translation>
    </message>
    <message>
        <source>Slope of the final approach</source>
        <translation>Neigung des Endanflugs</translation>
    </message>
    <message>
        <source>&amp;Slope</source>
        <translation>Neig&amp;ung</translation>
    </message>
    <message>
        <source>Straight in: descent over ground with flaps, brakes or a slip; otherwise that of the best glide. Needs an aircraft whose profile has its steepest descent.</source>
        <translation>Direktanflug: Sinken über Grund mit Klappen, Bremsen oder Seitengleitflug; sonst das des besten Gleitens. Braucht ein Flugzeug, dessen Profil sein steilstes Sinken nennt.</translation>
    </message>
    <message>
        <source>High key no lower than</source>
        <translation>High Key nicht tiefer als</translation>
    </message>
    <message>
        <source>Height of high key above the runway</source>
        <translation>Höhe von High Key über der Piste</translation>
    </message>
    <message>
        <source>High &amp;key</source>
        <translation>High &amp;Key</translation>
    </message>
    <message>
        <source>From overhead: height above the runway where the circle begins; otherwise what the circle loses.</source>
        <translation>Von über dem Platz: Höhe über der Piste, in der der Kreis beginnt; sonst so viel, wie der Kreis kostet.</translation>
    </message>
    <message>
        <source>Circles to lose height before each approach</source>
        <translation>Kreise zum Höhenabbau vor jedem Anflug</translation>
    </message>
    <message>
        <source>S&amp;urplus height</source>
        <translation>Übrige &amp;Höhe</translation>
    </message>
    <message>
        <source>Only runways where a circle over the beginning of the approach is clear of terrain: most failures happen higher than the lowest safe altitude, and the rest of the height has to go somewhere.</source>
        <translation>Nur Pisten, bei denen ein Kreis über dem Beginn des Anflugs frei vom Gelände ist: die meisten Ausfälle geschehen höher als die tiefste sichere Höhe, und der Rest der Höhe muss irgendwohin.</translation>
    </message>
    <message>
        <source>Above an obstacle surface instead of the clearance</source>
        <translation>Über einer Hindernisfläche statt des Bodenabstands</translation>
    </message>
    <message>
        <source>Slope of the obstacle surface</source>
        <translation>Neigung der Hindernisfläche</translation>
    </message>
    <message>
        <source> % slope</source>
        <translation> % Neigung</translation>
    </message>
    <message>
        <source>Begin of the obstacle surface before touchdown</source>
        <translation>Beginn der Hindernisfläche vor dem Aufsetzpunkt</translation>
    </message>
    <message>
        <source> before touchdown</source>
        <translation> vor dem Aufsetzpunkt</translation>
    </message>
    <message>
        <source>Obstac&amp;les</source>
        <translation>H&amp;indernisse</translation>
    </message>
    <message>
        <source>Straight in and from overhead, on the last part only: runways are kept clear above such a surface (ICAO: 5 % from 60 m for short ones, 2.5 % for long ones). Runways in narrow valleys then count that the whole clearance would rule out.</source>
        <translation>Direktanflug und von über dem Platz, nur auf dem letzten Stück: Pisten werden über einer solchen Fläche freigehalten (ICAO: 5 % ab 60 m für kurze, 2.5 % für lange). So zählen Pisten in engen Tälern, die der ganze Bodenabstand ausschließen würde.</translation>
    </message>
    <message>
        <source>At best glide speed, %1</source>
        <translation>Mit Geschwindigkeit des besten Gleitens, %1</translation>
    </message>
    <message>
        <source>%1, %2 TAS</source>
        <translation>%1, %2 TAS</translation>
    </message>
    <message>
        <source>%1, which the aircraft lacks</source>
        <translation>%1, das dem Flugzeug fehlt</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::ExportDialog</name>
    <message>
        <source>Formats</source>
        <translation>Formate</translation>
    </message>
    <message>
        <source>%1 (.%2)</source>
        <translation>%1 (.%2)</translation>
    </message>
    <message>
        <source>Nothing of the plan is lost</source>
        <translation>Vom Plan geht nichts verloren</translation>
    </message>
    <message>
        <source>Export the plan</source>
        <translation>Plan exportieren</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>{mission}, {format} and {part} are replaced</source>
        <translation>{mission}, {format} und {part} werden ersetzt</translation>
    </message>
    <message>
        <source>F&amp;older</source>
        <translation>&amp;Ordner</translation>
    </message>
    <message>
        <source>&amp;Names</source>
        <translation>&amp;Namen</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportieren</translation>
    </message>
    <message>
        <source>Folder for the exported files</source>
        <translation>Ordner für die exportierten Dateien</translation>
    </message>
    <message>
        <source> (is there; the old one is kept as %1)</source>
        <translation> (vorhanden; die alte bleibt als %1)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>There is no folder of this name.</source>
        <translation>Einen Ordner dieses Namens gibt es nicht.</translation>
    </message>
    <message>
        <source>Choose at least one format.</source>
        <translation>Mindestens ein Format wählen.</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::ExportReview</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Export: what the waypoints cost</source>
        <translation>Export: was die Wegpunkte kosten</translation>
    </message>
    <message>
        <source>Really export?</source>
        <translation>Wirklich exportieren?</translation>
    </message>
    <message>
        <source>Least margins of the tour, and of the path that fly-by turns from waypoint to waypoint give:</source>
        <translation>Kleinste Reserven der Tour und des Wegs, den Fly-by-Kurven von Wegpunkt zu Wegpunkt ergeben:</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>&amp;Schreiben</translation>
    </message>
    <message>
        <source>Export &amp;anyway</source>
        <translation>&amp;Trotzdem exportieren</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>Reserven</translation>
    </message>
    <message>
        <source>Least margin</source>
        <translation>Kleinste Reserve</translation>
    </message>
    <message>
        <source>Places to</source>
        <translation>Orte auf</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Tour</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>Wegpunkte</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>not known: the waypoints could not be checked</source>
        <translation>nicht bekannt: die Wegpunkte konnten nicht geprüft werden</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::FetchTerrainDialog</name>
    <message>
        <source>no airfields are known yet to look this up; update the airfields first (File menu), or type a position</source>
        <translation>es sind noch keine Flugplätze bekannt, um dies nachzuschlagen; zuerst die Flugplätze aktualisieren (Menü Datei), oder eine Position eingeben</translation>
    </message>
    <message>
        <source>no airfield has this code; correct it, or type a position such as 46.6003 9.9017</source>
        <translation>kein Flugplatz hat diese Kennung; sie berichtigen, oder eine Position wie 46.6003 9.9017 eingeben</translation>
    </message>
    <message>
        <source>Fetch terrain</source>
        <translation>Gelände holen</translation>
    </message>
    <message>
        <source>What the &amp;map shows</source>
        <translation>Was die &amp;Karte zeigt</translation>
    </message>
    <message>
        <source>&amp;Around an airfield or position</source>
        <translation>&amp;Um einen Flugplatz oder eine Position</translation>
    </message>
    <message>
        <source>LSZS, or 46.534 9.884</source>
        <translation>LSZS, oder 46.534 9.884</translation>
    </message>
    <message>
        <source>Airfield or position</source>
        <translation>Flugplatz oder Position</translation>
    </message>
    <message>
        <source> km</source>
        <translation> km</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>Ask for the size first. Tiles that have been fetched once stay on this machine and need no network.</source>
        <translation>Zuerst nach der Größe fragen. Einmal geholte Kacheln bleiben auf diesem Rechner und brauchen kein Netz.</translation>
    </message>
    <message>
        <source>Ask for &amp;size</source>
        <translation>Nach &amp;Größe fragen</translation>
    </message>
    <message>
        <source>&amp;Fetch</source>
        <translation>&amp;Holen</translation>
    </message>
    <message>
        <source>&amp;Radius</source>
        <translation>&amp;Radius</translation>
    </message>
    <message>
        <source>&amp;Write to</source>
        <translation>&amp;Schreiben nach</translation>
    </message>
    <message>
        <source>&amp;Server</source>
        <translation>Ser&amp;ver</translation>
    </message>
    <message>
        <source>Write terrain to</source>
        <translation>Gelände schreiben nach</translation>
    </message>
    <message>
        <source>Ask for the size again.</source>
        <translation>Noch einmal nach der Größe fragen.</translation>
    </message>
    <message>
        <source>%1. Copernicus GLO-30 from %2</source>
        <translation>%1. Copernicus GLO-30 von %2</translation>
    </message>
    <message>
        <source>Say where the terrain is to be written.</source>
        <translation>Angeben, wohin das Gelände geschrieben werden soll.</translation>
    </message>
    <message>
        <source>Stopped. What came so far is kept and will be continued.</source>
        <translation>Angehalten. Was bisher kam, bleibt und wird fortgesetzt.</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::ImportTargetsDialog</name>
    <message>
        <source>Import targets from %1</source>
        <translation>Ziele aus %1 importieren</translation>
    </message>
    <message>
        <source>Points, corners of lines and waypoints become targets. Areas become parallel survey lines; the ends of the lines are targets.</source>
        <translation>Punkte, Ecken von Linien und Wegpunkte werden zu Zielen. Flächen werden zu parallelen Vermessungslinien; die Enden der Linien sind Ziele.</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importieren</translation>
    </message>
    <message>
        <source>those of the file where they are flown at, else %1</source>
        <translation>jene der Datei, wo sie Flughöhen sind, sonst %1</translation>
    </message>
    <message>
        <source>elevations of the file (.cup, GPX, Little Navmap) too</source>
        <translation>auch Ortshöhen der Datei (.cup, GPX, Little Navmap)</translation>
    </message>
    <message>
        <source>one height above ground (AGL)</source>
        <translation>eine Höhe über Grund (AGL)</translation>
    </message>
    <message>
        <source>one altitude above mean sea level (MSL)</source>
        <translation>eine Höhe über dem Meeresspiegel (MSL)</translation>
    </message>
    <message>
        <source>along the &amp;longest side of each area</source>
        <translation>entlang der &amp;längsten Seite jeder Fläche</translation>
    </message>
    <message>
        <source>Points of &amp;tracks too</source>
        <translation>Auch Punkte von &amp;Tracks</translation>
    </message>
    <message>
        <source>&amp;Heights</source>
        <translation>&amp;Höhen</translation>
    </message>
    <message>
        <source>H&amp;eight</source>
        <translation>Hö&amp;he</translation>
    </message>
    <message>
        <source>&amp;Spacing of survey lines</source>
        <translation>&amp;Abstand der Vermessungslinien</translation>
    </message>
    <message>
        <source>Lines run</source>
        <translation>Linien verlaufen</translation>
    </message>
    <message>
        <source>True &amp;course of lines</source>
        <translation>&amp;Rechtweisender Kurs der Linien</translation>
    </message>
    <message>
        <source>Targets of the file</source>
        <translation>Ziele der Datei</translation>
    </message>
    <message>
        <source>Search names</source>
        <translation>Namen suchen</translation>
    </message>
    <message>
        <source>Choose &amp;all</source>
        <translation>A&amp;lle wählen</translation>
    </message>
    <message>
        <source>Chooses all targets that the search shows</source>
        <translation>Wählt alle Ziele, die die Suche zeigt</translation>
    </message>
    <message>
        <source>Choose &amp;none</source>
        <translation>&amp;Keine wählen</translation>
    </message>
    <message>
        <source>Leaves out all targets that the search shows</source>
        <translation>Lässt alle Ziele weg, die die Suche zeigt</translation>
    </message>
    <message>
        <source>Reading the file again…</source>
        <translation>Die Datei wird neu gelesen…</translation>
    </message>
    <message>
        <source>All places of this file are points of tracks; choose “Points of tracks too” to take them.</source>
        <translation>Alle Orte dieser Datei sind Punkte von Tracks; „Auch Punkte von Tracks“ wählen, um sie zu nehmen.</translation>
    </message>
    <message>
        <source>Choose at least one target to import.</source>
        <translation>Mindestens ein Ziel zum Importieren wählen.</translation>
    </message>
    <message>
        <source>At most %1 targets are imported at once; choose fewer.</source>
        <translation>Höchstens %1 Ziele werden auf einmal importiert; weniger wählen.</translation>
    </message>
    <message>
        <source>%1 of %2 chosen</source>
        <translation>%1 von %2 gewählt</translation>
    </message>
    <message>
        <source>%1 of %2 chosen; the search shows %3</source>
        <translation>%1 von %2 gewählt; die Suche zeigt %3</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::JumpDialog</name>
    <message>
        <source>There is no terrain yet: add a terrain file first, then places on it can be shown.</source>
        <translation>Es gibt noch kein Gelände: zuerst eine Geländedatei hinzufügen, dann können Orte darauf gezeigt werden.</translation>
    </message>
    <message>
        <source>Type a position, the ident of an airfield or the name of a target.</source>
        <translation>Eine Position, die Kennung eines Flugplatzes oder den Namen eines Ziels eingeben.</translation>
    </message>
    <message>
        <source>“%1” is no target or airfield here, and not a position such as 46.6003 9.9017 or 46°36.02′ N 9°54.10′ E.</source>
        <translation>„%1“ ist hier weder Ziel noch Flugplatz, und keine Position wie 46.6003 9.9017 oder 46°36.02′ N 9°54.10′ E.</translation>
    </message>
    <message>
        <source>%1 lies outside the terrain that is loaded.</source>
        <translation>%1 liegt außerhalb des geladenen Geländes.</translation>
    </message>
    <message>
        <source>Jump to</source>
        <translation>Springen zu</translation>
    </message>
    <message>
        <source>&amp;Position, airfield or target</source>
        <translation>&amp;Position, Flugplatz oder Ziel</translation>
    </message>
    <message>
        <source>Position, airfield or target</source>
        <translation>Position, Flugplatz oder Ziel</translation>
    </message>
    <message>
        <source>Degrees, degrees and minutes, or degrees, minutes and seconds, with N, S, E, W or latitude first: 46.6003 9.9017, N46 36.02 E9 54.10, 46°36′01″ N 9°54′06″ E.</source>
        <translation>Grad, Grad und Minuten oder Grad, Minuten und Sekunden, mit N, S, E, W oder die Breite zuerst: 46.6003 9.9017, N46 36.02 E9 54.10, 46°36′01″ N 9°54′06″ E.</translation>
    </message>
    <message>
        <source>&amp;Jump</source>
        <translation>&amp;Springen</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::MessageBanner</name>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::MissionFilesDialog</name>
    <message>
        <source>Files of the mission</source>
        <translation>Dateien der Mission</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>&amp;Remove from mission</source>
        <translation>Aus der Mission &amp;entfernen</translation>
    </message>
    <message>
        <source>Add &amp;terrain…</source>
        <translation>&amp;Gelände hinzufügen…</translation>
    </message>
    <message>
        <source>Add &amp;airfields…</source>
        <translation>Flug&amp;plätze hinzufügen…</translation>
    </message>
    <message>
        <source>Add air&amp;spaces…</source>
        <translation>&amp;Lufträume hinzufügen…</translation>
    </message>
    <message>
        <source>Add &amp;population…</source>
        <translation>Be&amp;völkerung hinzufügen…</translation>
    </message>
    <message>
        <source>Remove from mission (Del)</source>
        <translation>Aus der Mission entfernen (Entf)</translation>
    </message>
    <message>
        <source>not there!</source>
        <translation>fehlt!</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Gelände</translation>
    </message>
    <message>
        <source>Airfields</source>
        <translation>Flugplätze</translation>
    </message>
    <message>
        <source>Airspaces</source>
        <translation>Lufträume</translation>
    </message>
    <message>
        <source>Population</source>
        <translation>Bevölkerung</translation>
    </message>
    <message>
        <source>No files yet. Add terrain, airfields, airspaces and population here, or drop them on the window.</source>
        <translation>Noch keine Dateien. Gelände, Flugplätze, Lufträume und Bevölkerung hier hinzufügen oder auf das Fenster ziehen.</translation>
    </message>
    <message>
        <source>Removing takes a file out of the mission; the file itself stays where it is, and Undo brings it back. A plan that was made with it is then out of date, but not by population, which only landing now looks at.</source>
        <translation>Entfernen nimmt eine Datei aus der Mission; die Datei selbst bleibt, wo sie ist, und Rückgängig holt sie zurück. Ein Plan, der mit ihr gemacht wurde, ist dann veraltet, nicht aber durch die Bevölkerung, die nur für die Sofortlandung zählt.</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::MissionSettingsDialog</name>
    <message>
        <source>Mission settings</source>
        <translation>Einstellungen der Mission</translation>
    </message>
    <message>
        <source>These values belong to the open mission and are saved with it.</source>
        <translation>Diese Werte gehören zur offenen Mission und werden mit ihr gespeichert.</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>nowhere: the tour alone</source>
        <translation>nirgends: nur die Tour</translation>
    </message>
    <message>
        <source>Runway to start at</source>
        <translation>Piste für den Start</translation>
    </message>
    <message>
        <source>where it starts</source>
        <translation>wo er beginnt</translation>
    </message>
    <message>
        <source>Runway to end at</source>
        <translation>Piste für das Ende</translation>
    </message>
    <message>
        <source>end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Start</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Approach</source>
        <translation>Anflug</translation>
    </message>
    <message>
        <source>Air and engine</source>
        <translation>Luft und Motor</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>Planung</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::MissionValues</name>
    <message>
        <source>Terrain &amp;clearance</source>
        <translation>&amp;Bodenabstand</translation>
    </message>
    <message>
        <source>Kept above the highest terrain post everywhere, on the tour and on every landing glide; includes the height that rolling into turns costs. Raise it for coarse terrain data, turbulence or an aircraft that you do not know well.</source>
        <translation>Wird überall über dem höchsten Geländepunkt gehalten, auf der Tour und auf jedem Gleitweg; enthält die Höhe, die das Rollen in Kurven kostet. Erhöhen bei groben Geländedaten, Turbulenz oder einem wenig vertrauten Flugzeug.</translation>
    </message>
    <message>
        <source>&amp;Arrival height</source>
        <translation>&amp;Ankunftshöhe</translation>
    </message>
    <message>
        <source>Height above the runway that every glide must still have at the touchdown point. Raise it to keep room for a circuit; 0 trusts the glide to the last metre.</source>
        <translation>Höhe über der Piste, die jeder Gleitweg am Aufsetzpunkt noch haben muss. Erhöhen, um Platz für eine Platzrunde zu haben; 0 vertraut dem Gleitweg bis auf den letzten Meter.</translation>
    </message>
    <message>
        <source>Pass above at the safe altitude</source>
        <translation>In Sicherheitshöhe darüber fliegen</translation>
    </message>
    <message>
        <source>Descend to the target in a spiral</source>
        <translation>In einer Spirale zum Ziel sinken</translation>
    </message>
    <message>
        <source>&amp;Low targets</source>
        <translation>&amp;Tiefe Ziele</translation>
    </message>
    <message>
        <source>For targets below the lowest safe altitude. In a spiral the gliding guarantee is suspended, and the certificate says so: choose it only where the sensor needs the height.</source>
        <translation>Für Ziele unter der tiefsten sicheren Höhe. In einer Spirale ist die Gleitgarantie ausgesetzt, und das Zertifikat sagt es: nur wählen, wo der Sensor die Höhe braucht.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Rea&amp;ction time</source>
        <translation>&amp;Reaktionszeit</translation>
    </message>
    <message>
        <source>After the engine stops the aircraft flies on for so long before it turns. Pilots take about 4 seconds (FAA-H-8083-3) when they expect it, and much longer when they do not.</source>
        <translation>So lange fliegt das Flugzeug nach dem Motorausfall weiter, bevor es dreht. Piloten brauchen etwa 4 Sekunden (FAA-H-8083-3), wenn sie damit rechnen, und viel länger, wenn nicht.</translation>
    </message>
    <message>
        <source>Height &amp;lost in it</source>
        <translation>&amp;Höhenverlust darin</translation>
    </message>
    <message>
        <source>Until the glide is established, beyond what gliding loses: slowing down or speeding up, a wrong first turn. Try it with an instructor at a safe height.</source>
        <translation>Bis der Gleitflug eingenommen ist, über das Gleiten hinaus: langsamer oder schneller werden, eine falsche erste Kurve. Mit einem Fluglehrer in sicherer Höhe ausprobieren.</translation>
    </message>
    <message>
        <source>× </source>
        <translation>× </translation>
    </message>
    <message>
        <source>&amp;Drag</source>
        <translation>&amp;Widerstand</translation>
    </message>
    <message>
        <source>What your glides cost more than the aircraft’s profile says: speed and bank not held exactly, an aircraft that is no longer new. 1.1 makes a glide of 9 : 1 one of about 8 : 1.</source>
        <translation>Was die eigenen Gleitflüge mehr kosten, als das Flugzeugprofil sagt: Geschwindigkeit und Querlage nicht genau gehalten, ein nicht mehr neues Flugzeug. 1.1 macht aus einem Gleiten von 9 : 1 eines von etwa 8 : 1.</translation>
    </message>
    <message>
        <source>Limit the tour&apos;s altitude</source>
        <translation>Höhe der Tour begrenzen</translation>
    </message>
    <message>
        <source>Ceiling above mean sea level</source>
        <translation>Obergrenze über dem Meeresspiegel</translation>
    </message>
    <message>
        <source>C&amp;eiling</source>
        <translation>&amp;Obergrenze</translation>
    </message>
    <message>
        <source>The aircraft&apos;s own ceiling counts as well; the lower of the two limits the tour. Set it for airspace, cloud or oxygen.</source>
        <translation>Die Gipfelhöhe des Flugzeugs zählt auch; die tiefere der beiden begrenzt die Tour. Setzen wegen Luftraum, Wolken oder Sauerstoff.</translation>
    </message>
    <message>
        <source>&amp;Headings per target</source>
        <translation>&amp;Kurse je Ziel</translation>
    </message>
    <message>
        <source>Directions that each target may be passed in. More give shorter tours and take longer; lower it for quick looks at many targets.</source>
        <translation>Richtungen, in denen jedes Ziel überflogen werden darf. Mehr ergeben kürzere Touren und dauern länger; für einen schnellen Blick auf viele Ziele verringern.</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>&amp;Distance between decision points</source>
        <translation>&amp;Abstand der Entscheidungspunkte</translation>
    </message>
    <message>
        <source>Each decision point has its own landing glide; between them the aircraft glides on to the next. Shorter steps allow lower tours over rough ground and take longer.</source>
        <translation>Jeder Entscheidungspunkt hat seinen eigenen Gleitweg; dazwischen gleitet das Flugzeug zum nächsten weiter. Kleinere Schritte erlauben tiefere Touren über rauem Gelände und dauern länger.</translation>
    </message>
    <message>
        <source>Cost of passing &amp;above targets</source>
        <translation>Kosten des Überflugs &amp;über Zielen</translation>
    </message>
    <message>
        <source>Metres of detour that one metre above a target is worth; at least 2. Raise it if targets must be seen from close by.</source>
        <translation>Meter Umweg, die ein Meter über einem Ziel wert ist; mindestens 2. Erhöhen, wenn Ziele aus der Nähe gesehen werden müssen.</translation>
    </message>
    <message>
        <source>Lazy: proves only the legs that matter</source>
        <translation>Lazy: beweist nur die wichtigen Teilstrecken</translation>
    </message>
    <message>
        <source>Base: computes every leg (slow)</source>
        <translation>Base: berechnet jede Teilstrecke (langsam)</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>&amp;Methode</translation>
    </message>
    <message>
        <source>Both end with the same tour. Base is for comparing.</source>
        <translation>Beide enden mit derselben Tour. Base ist zum Vergleichen.</translation>
    </message>
    <message>
        <source>Turn headings and try other orders around the tour</source>
        <translation>Kurse drehen und andere Reihenfolgen versuchen</translation>
    </message>
    <message>
        <source>Re&amp;finement</source>
        <translation>Ver&amp;feinerung</translation>
    </message>
    <message>
        <source>Makes the tour cheaper, most in steep country; takes a fraction of a second for twenty targets. Without it the tour is that of the source paper.</source>
        <translation>Macht die Tour günstiger, am meisten in steilem Gelände; dauert bei zwanzig Zielen Bruchteile einer Sekunde. Ohne sie ist die Tour jene des zugrunde liegenden Aufsatzes.</translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation>Startwer&amp;t</translation>
    </message>
    <message>
        <source>The same seed gives the same plan. Try another one if a plan looks odd.</source>
        <translation>Derselbe Startwert ergibt denselben Plan. Einen anderen versuchen, wenn ein Plan seltsam aussieht.</translation>
    </message>
    <message>
        <source>Random samples (RRT*) instead of a lattice</source>
        <translation>Zufällige Proben (RRT*) statt eines Gitters</translation>
    </message>
    <message>
        <source>Number of random samples</source>
        <translation>Zahl der zufälligen Proben</translation>
    </message>
    <message>
        <source>&amp;Roadmap</source>
        <translation>&amp;Wegenetz</translation>
    </message>
    <message>
        <source>The lattice is faster and finds lower safe altitudes. Random samples are the method of the source paper, for comparing; more of them find lower altitudes and take longer.</source>
        <translation>Das Gitter ist schneller und findet tiefere sichere Höhen. Zufällige Proben sind das Verfahren des zugrunde liegenden Aufsatzes, zum Vergleichen; mehr davon finden tiefere Höhen und dauern länger.</translation>
    </message>
    <message>
        <source> MSL</source>
        <translation> MSL</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::PolarPreview</name>
    <message>
        <source>Glide performance</source>
        <translation>Gleitleistung</translation>
    </message>
    <message>
        <source>Straight glide ratio %1</source>
        <translation>Gleitzahl geradeaus %1</translation>
    </message>
    <message>
        <source>Mass, wing area, drag, density and speed must be positive.</source>
        <translation>Masse, Flügelfläche, Widerstand, Dichte und Geschwindigkeit müssen positiv sein.</translation>
    </message>
    <message>
        <source>Glide ratio %1 : 1 (%2) at %3, wings level</source>
        <translation>Gleitzahl %1 : 1 (%2) bei %3, ohne Querlage</translation>
    </message>
    <message>
        <source>Bank angle</source>
        <translation>Querlage</translation>
    </message>
    <message>
        <source>Height lost in a half turn</source>
        <translation>Höhenverlust in einem Halbkreis</translation>
    </message>
    <message>
        <source>stalls</source>
        <translation>überzogen</translation>
    </message>
    <message>
        <source>%1, r %2</source>
        <translation>%1, r %2</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Voreinstellungen</translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation>Allgeme&amp;in</translation>
    </message>
    <message>
        <source>New missions: &amp;safety</source>
        <translation>Neue Missionen: &amp;Sicherheit</translation>
    </message>
    <message>
        <source>New missions: &amp;planner</source>
        <translation>Neue Missionen: &amp;Planung</translation>
    </message>
    <message>
        <source>&amp;3D view</source>
        <translation>&amp;3D-Ansicht</translation>
    </message>
    <message>
        <source>Changes apply at once and are remembered.</source>
        <translation>Änderungen gelten sofort und bleiben gespeichert.</translation>
    </message>
    <message>
        <source>&amp;Defaults of this page</source>
        <translation>Standardwerte &amp;dieser Seite</translation>
    </message>
    <message>
        <source>Aviation: ft, NM, kt, ft/min</source>
        <translation>Luftfahrt: ft, NM, kt, ft/min</translation>
    </message>
    <message>
        <source>Metric: m, km, km/h, m/s</source>
        <translation>Metrisch: m, km, km/h, m/s</translation>
    </message>
    <message>
        <source>&amp;Units</source>
        <translation>&amp;Einheiten</translation>
    </message>
    <message>
        <source>How heights, distances and speeds are shown and typed everywhere. Files keep their own units; heights always say whether they are above mean sea level (MSL) or above ground (AGL).</source>
        <translation>Wie Höhen, Entfernungen und Geschwindigkeiten überall gezeigt und eingegeben werden. Dateien behalten ihre eigenen Einheiten; bei Höhen steht immer, ob sie über dem Meeresspiegel (MSL) oder über Grund (AGL) sind.</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>Aussehe&amp;n</translation>
    </message>
    <message>
        <source>Light for daylight and print, dark for dim rooms and night briefings. “As the desktop” takes what the desktop had when Volplane was started.</source>
        <translation>Hell für Tageslicht und Druck, dunkel für dunkle Räume und Nachtbriefings. „Wie der Desktop“ nimmt, was der Desktop beim Start von Volplane hatte.</translation>
    </message>
    <message>
        <source>That of the system</source>
        <translation>Die des Systems</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>Sp&amp;rache</translation>
    </message>
    <message>
        <source>Of the window and of briefings written from it, from the next start on. Messages about files and findings of the checker are in English.</source>
        <translation>Des Fensters und der daraus geschriebenen Briefings, ab dem nächsten Start. Meldungen über Dateien und Befunde der Prüfung sind englisch.</translation>
    </message>
    <message>
        <source>New missions start with these values. The open mission, “%1”, keeps its own.</source>
        <translation>Neue Missionen beginnen mit diesen Werten. Die offene Mission „%1“ behält ihre eigenen.</translation>
    </message>
    <message>
        <source>&amp;Open mission’s settings…</source>
        <translation>Einstellungen der &amp;offenen Mission…</translation>
    </message>
    <message>
        <source>× </source>
        <translation>× </translation>
    </message>
    <message>
        <source>&amp;Heights drawn</source>
        <translation>Überhöhun&amp;g</translation>
    </message>
    <message>
        <source>1 is true to scale. More makes gentle relief visible; the picture then says so, because slopes and glides look steeper than they are.</source>
        <translation>1 ist maßstäblich. Mehr macht sanftes Relief sichtbar; das Bild sagt es dann, weil Hänge und Gleitwege steiler aussehen, als sie sind.</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Tour</translation>
    </message>
    <message>
        <source>Curtain down to the ground</source>
        <translation>Vorhang bis zum Boden</translation>
    </message>
    <message>
        <source>Shows where the tour is over the terrain. Take it away if it hides what is behind.</source>
        <translation>Zeigt, wo die Tour über dem Gelände liegt. Wegnehmen, wenn er verdeckt, was dahinter ist.</translation>
    </message>
    <message>
        <source>G&amp;lides</source>
        <translation>G&amp;leitwege</translation>
    </message>
    <message>
        <source>Of every decision point</source>
        <translation>Von jedem Entscheidungspunkt</translation>
    </message>
    <message>
        <source>All landing glides at once instead of the one from the point that is looked at. Slower on plans with thousands of points.</source>
        <translation>Alle Gleitwege zugleich statt nur jener vom betrachteten Punkt. Langsamer bei Plänen mit Tausenden von Punkten.</translation>
    </message>
    <message>
        <source>&amp;Runways</source>
        <translation>Pist&amp;en</translation>
    </message>
    <message>
        <source>Runways that may be used</source>
        <translation>Pisten, die verwendet werden dürfen</translation>
    </message>
    <message>
        <source>Drawn to scale on the terrain.</source>
        <translation>Maßstäblich auf das Gelände gezeichnet.</translation>
    </message>
    <message>
        <source>E&amp;xcluded</source>
        <translation>Ausges&amp;chlossen</translation>
    </message>
    <message>
        <source>Runways that the filter leaves out</source>
        <translation>Pisten, die der Filter weglässt</translation>
    </message>
    <message>
        <source>Drawn weaker, to see what is being given up.</source>
        <translation>Schwächer gezeichnet, um zu sehen, worauf verzichtet wird.</translation>
    </message>
    <message>
        <source>&amp;Names</source>
        <translation>&amp;Namen</translation>
    </message>
    <message>
        <source>Of targets and runways</source>
        <translation>Von Zielen und Pisten</translation>
    </message>
    <message>
        <source>Take them away for pictures.</source>
        <translation>Für Bilder wegnehmen.</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::SafeAltitudeDialog</name>
    <message>
        <source>Lowest safe altitude map</source>
        <translation>Karte der tiefsten sicheren Höhe</translation>
    </message>
    <message>
        <source>Any course, and each course by itself</source>
        <translation>Jeder Kurs, und jeder Kurs für sich</translation>
    </message>
    <message>
        <source>Any course (the worst counts)</source>
        <translation>Jeder Kurs (der schlechteste zählt)</translation>
    </message>
    <message>
        <source>The best course at each place</source>
        <translation>Der beste Kurs an jedem Ort</translation>
    </message>
    <message>
        <source>One course</source>
        <translation>Ein Kurs</translation>
    </message>
    <message>
        <source>° true</source>
        <translation>° rechtweisend</translation>
    </message>
    <message>
        <source>as fine as sensible</source>
        <translation>so fein wie sinnvoll</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>From every place of a cell, at its altitude or above, engine off and in the mission&apos;s wind, a glide reaches a runway. GeoTIFF (.tif) holds the values, KML and GeoPackage (.kml, .gpkg) hold contours: between two lines the higher one counts.</source>
        <translation>Von jedem Ort einer Zelle, in ihrer Höhe oder darüber, mit stehendem Motor und beim Wind der Mission, erreicht ein Gleitweg eine Piste. GeoTIFF (.tif) enthält die Werte, KML und GeoPackage (.kml, .gpkg) enthalten Höhenlinien: zwischen zwei Linien zählt die höhere.</translation>
    </message>
    <message>
        <source>&amp;Write to…</source>
        <translation>&amp;Schreiben nach…</translation>
    </message>
    <message>
        <source>&amp;For</source>
        <translation>&amp;Für</translation>
    </message>
    <message>
        <source>C&amp;ourse</source>
        <translation>&amp;Kurs</translation>
    </message>
    <message>
        <source>&amp;Cells</source>
        <translation>&amp;Zellen</translation>
    </message>
    <message>
        <source>Contours &amp;every</source>
        <translation>&amp;Linien alle</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::TargetChoiceModel</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::TargetDialog</name>
    <message>
        <source>Target %1</source>
        <translation>Ziel %1</translation>
    </message>
    <message>
        <source>above ground (AGL)</source>
        <translation>über Grund (AGL)</translation>
    </message>
    <message>
        <source>above mean sea level (MSL)</source>
        <translation>über dem Meeresspiegel (MSL)</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>&amp;Position</source>
        <translation>&amp;Position</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>&amp;Measured</source>
        <translation>&amp;Gemessen</translation>
    </message>
    <message>
        <source>A target needs a name.</source>
        <translation>Ein Ziel braucht einen Namen.</translation>
    </message>
    <message>
        <source>Another target is called %1 already.</source>
        <translation>Ein anderes Ziel heißt schon %1.</translation>
    </message>
    <message>
        <source>This is not a position; write for example 46.6003 9.9017 or 46°36.02′ N 9°54.10′ E.</source>
        <translation>Das ist keine Position; zum Beispiel 46.6003 9.9017 oder 46°36.02′ N 9°54.10′ E schreiben.</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::WeatherDialog</name>
    <message>
        <source>from the &amp;ground</source>
        <translation>ab &amp;Boden</translation>
    </message>
    <message>
        <source>&amp;unlimited</source>
        <translation>&amp;unbegrenzt</translation>
    </message>
    <message>
        <source> % for each %1</source>
        <translation> % je %1</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>&amp;Floor</source>
        <translation>U&amp;ntergrenze</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Obergrenze</translation>
    </message>
    <message>
        <source>&amp;Coming through</source>
        <translation>&amp;Durchkommen</translation>
    </message>
    <message>
        <source>How likely a flight is to come through so much of it. A guess in round figures will do: planners of landings keep out of weather where they can, and say how likely the rest is.</source>
        <translation>Wie wahrscheinlich ein Flug durch so viel davon hindurchkommt. Eine runde Schätzung genügt: die Landeplanung meidet Wetter, wo sie kann, und sagt, wie wahrscheinlich der Rest ist.</translation>
    </message>
    <message>
        <source>The top must be above the floor.</source>
        <translation>Die Obergrenze muss über der Untergrenze liegen.</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::WeatherListDialog</name>
    <message>
        <source>Weather of the mission</source>
        <translation>Wetter der Mission</translation>
    </message>
    <message>
        <source>&amp;Draw</source>
        <translation>&amp;Zeichnen</translation>
    </message>
    <message>
        <source>&amp;Edit…</source>
        <translation>&amp;Bearbeiten…</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>&amp;Add from file…</source>
        <translation>Aus Datei &amp;hinzufügen…</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportieren…</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Untergrenze</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Obergrenze</translation>
    </message>
    <message>
        <source>Coming through</source>
        <translation>Durchkommen</translation>
    </message>
    <message>
        <source>per</source>
        <translation>je</translation>
    </message>
    <message>
        <source>“%1” is no probability; give a number above 0 up to 100, in percent for each %2.</source>
        <translation>„%1“ ist keine Wahrscheinlichkeit; eine Zahl über 0 bis 100 angeben, in Prozent für jede %2.</translation>
    </message>
    <message>
        <source>“%1” does not fit; give an altitude in %2 above mean sea level, the top above the floor, or GND and UNL.</source>
        <translation>„%1“ passt nicht; eine Höhe in %2 über dem Meeresspiegel angeben, die Obergrenze über der Untergrenze, oder GND und UNL.</translation>
    </message>
    <message>
        <source>No weather yet. Draw it on the map, add a file here, or drop one on the window.</source>
        <translation>Noch kein Wetter. Auf der Karte zeichnen, hier eine Datei hinzufügen oder eine auf das Fenster ziehen.</translation>
    </message>
    <message>
        <source>Planners of landings keep out of weather where they can and tell how likely the rest is. The tour and its certificate know nothing of weather.</source>
        <translation>Die Landeplanung meidet Wetter, wo sie kann, und sagt, wie wahrscheinlich der Rest ist. Die Tour und ihr Zertifikat wissen nichts von Wetter.</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::WindDialog</name>
    <message>
        <source>Wind</source>
        <translation>Wind</translation>
    </message>
    <message>
        <source>Layers of wind</source>
        <translation>Windschichten</translation>
    </message>
    <message>
        <source>Altitude MSL</source>
        <translation>Höhe MSL</translation>
    </message>
    <message>
        <source>From, true</source>
        <translation>Aus, rechtweisend</translation>
    </message>
    <message>
        <source>± direction</source>
        <translation>± Richtung</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>± speed</source>
        <translation>± Stärke</translation>
    </message>
    <message>
        <source>&amp;Add layer</source>
        <translation>Schicht &amp;hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Remove layer</source>
        <translation>Schicht &amp;entfernen</translation>
    </message>
    <message>
        <source>&amp;Still air</source>
        <translation>&amp;Windstille</translation>
    </message>
    <message>
        <source>Read &amp;from text</source>
        <translation>&amp;Aus Text lesen</translation>
    </message>
    <message>
        <source>270±20/15±5kt, a METAR, or 2000ft 270/15kt; 6000ft 290/25kt</source>
        <translation>270±20/15±5kt, ein METAR, oder 2000ft 270/15kt; 6000ft 290/25kt</translation>
    </message>
    <message>
        <source>Rea&amp;d</source>
        <translation>&amp;Lesen</translation>
    </message>
    <message>
        <source>The plan will hold for: </source>
        <translation>Der Plan wird gelten bei: </translation>
    </message>
    <message>
        <source>Between the layers, everything between their winds.</source>
        <translation>Zwischen den Schichten alles zwischen ihren Winden.</translation>
    </message>
</context>
<context>
    <name>vp::document::DocumentLock</name>
    <message>
        <source>%1 on %2 (%3, process %4) since %5</source>
        <translation>%1 auf %2 (%3, Prozess %4) seit %5</translation>
    </message>
    <message>
        <source>somebody</source>
        <translation>jemand</translation>
    </message>
    <message>
        <source>an unknown computer</source>
        <translation>einem unbekannten Rechner</translation>
    </message>
</context>
<context>
    <name>vp::document::MissionDocument</name>
    <message>
        <source>Untitled mission</source>
        <translation>Unbenannte Mission</translation>
    </message>
</context>
<context>
    <name>vp::document::WeatherWords</name>
    <message>
        <source>Weather %1</source>
        <translation>Wetter %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 per %2</source>
        <comment>probability of coming through a unit of distance</comment>
        <translation>%1 je %2</translation>
    </message>
</context>
<context>
    <name>vp::document::Words</name>
    <message>
        <source>Hide</source>
        <translation>Verbergen</translation>
    </message>
    <message>
        <source>Show only</source>
        <translation>Nur zeigen</translation>
    </message>
    <message>
        <source>Warn when entered</source>
        <translation>Bei Einflug warnen</translation>
    </message>
    <message>
        <source>Keep the tour out</source>
        <translation>Tour fernhalten</translation>
    </message>
</context>
<context>
    <name>vp::gui::AutosaveKeeper</name>
    <message>
        <source>Work of a session that ended unexpectedly was found but cannot be read: %1 It stays in %2.</source>
        <translation>Arbeit einer unerwartet beendeten Sitzung wurde gefunden, kann aber nicht gelesen werden: %1 Sie bleibt in %2.</translation>
    </message>
    <message>
        <source>The last session ended unexpectedly. Its work on “%1” is here again; save it to keep it.</source>
        <translation>Die letzte Sitzung endete unerwartet. Ihre Arbeit an „%1“ ist wieder da; speichern, um sie zu behalten.</translation>
    </message>
    <message>
        <source>Discard it</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Unsaved work cannot be kept for the case of a crash; save the mission yourself. %1</source>
        <translation>Nicht gespeicherte Arbeit kann für den Fall eines Absturzes nicht aufbewahrt werden; die Mission selbst speichern. %1</translation>
    </message>
    <message>
        <source>%1 has been written after this copy was kept: compare before you save over it.</source>
        <translation>%1 wurde geschrieben, nachdem diese Kopie aufbewahrt wurde: vor dem Überschreiben vergleichen.</translation>
    </message>
</context>
<context>
    <name>vp::gui::BriefingController</name>
    <message>
        <source>the plan could not be verified again, so no briefing was written; plan the tour again, or look at the findings</source>
        <translation>der Plan konnte nicht noch einmal geprüft werden, daher wurde kein Briefing geschrieben; die Tour neu planen oder die Befunde ansehen</translation>
    </message>
    <message>
        <source>This plan is UNVERIFIED: nobody has shown that a glide to a runway exists from every point of it. Every page will say so.</source>
        <translation>Dieser Plan ist UNGEPRÜFT: niemand hat gezeigt, dass von jedem Punkt aus eine Piste im Gleitflug erreichbar ist. Jede Seite wird es sagen.</translation>
    </message>
    <message>
        <source>This plan is out of date: the mission has been changed since it was made. The briefing is that of the old plan.</source>
        <translation>Dieser Plan ist veraltet: die Mission wurde geändert, seit er gemacht wurde. Das Briefing ist das des alten Plans.</translation>
    </message>
    <message>
        <source>%1-briefing.pdf</source>
        <translation>%1-briefing.pdf</translation>
    </message>
    <message>
        <source>There is no plan to brief; plan the tour first.</source>
        <translation>Es gibt keinen Plan für ein Briefing; zuerst die Tour planen.</translation>
    </message>
    <message>
        <source>Save briefing</source>
        <translation>Briefing speichern</translation>
    </message>
    <message>
        <source>Briefing of %1 pages written to %2</source>
        <translation>Briefing mit %1 Seiten nach %2 geschrieben</translation>
    </message>
    <message>
        <source>UNVERIFIED briefing of %1 pages written to %2</source>
        <translation>UNGEPRÜFTES Briefing mit %1 Seiten nach %2 geschrieben</translation>
    </message>
</context>
<context>
    <name>vp::gui::EditController</name>
    <message>
        <source>Add target %1</source>
        <translation>Ziel %1 hinzufügen</translation>
    </message>
    <message>
        <source>Move target %1</source>
        <translation>Ziel %1 verschieben</translation>
    </message>
    <message>
        <source>Delete target %1</source>
        <translation>Ziel %1 löschen</translation>
    </message>
    <message>
        <source>Rename target</source>
        <translation>Ziel umbenennen</translation>
    </message>
    <message>
        <source>Name of target %1</source>
        <translation>Name von Ziel %1</translation>
    </message>
    <message>
        <source>Edit target %1</source>
        <translation>Ziel %1 bearbeiten</translation>
    </message>
    <message>
        <source>Reorder targets</source>
        <translation>Ziele umordnen</translation>
    </message>
    <message>
        <source>Plan without a home runway</source>
        <translation>Ohne Heimatpiste planen</translation>
    </message>
    <message>
        <source>Start and end at %1</source>
        <translation>Start und Ende auf %1</translation>
    </message>
    <message>
        <source>Start at %1, end at %2</source>
        <translation>Start auf %1, Ende auf %2</translation>
    </message>
    <message>
        <source>Exclude runway %1</source>
        <translation>Piste %1 ausschließen</translation>
    </message>
    <message>
        <source>Include runway %1</source>
        <translation>Piste %1 einschließen</translation>
    </message>
    <message>
        <source>class %1</source>
        <translation>Klasse %1</translation>
    </message>
    <message>
        <source>Airspace %1: %2</source>
        <translation>Luftraum %1: %2</translation>
    </message>
    <message>
        <source>Change airspace rules</source>
        <translation>Luftraumregeln ändern</translation>
    </message>
    <message>
        <source>Change runway filter</source>
        <translation>Pistenfilter ändern</translation>
    </message>
    <message>
        <source>Land %1 one way only</source>
        <translation>%1 nur in einer Richtung landen</translation>
    </message>
    <message>
        <source>Land both ways of %1</source>
        <translation>%1 in beiden Richtungen landen</translation>
    </message>
    <message>
        <source>Note on runway %1</source>
        <translation>Notiz zu Piste %1</translation>
    </message>
    <message>
        <source>Include excluded runways</source>
        <translation>Ausgeschlossene Pisten einschließen</translation>
    </message>
    <message>
        <source>Allow passing above targets</source>
        <translation>Überflug über Zielen erlauben</translation>
    </message>
    <message>
        <source>Raise ceiling</source>
        <translation>Obergrenze anheben</translation>
    </message>
    <message>
        <source>Remove ceiling</source>
        <translation>Obergrenze aufheben</translation>
    </message>
    <message>
        <source>Change mission settings</source>
        <translation>Einstellungen der Mission ändern</translation>
    </message>
    <message>
        <source>Change aircraft</source>
        <translation>Flugzeug ändern</translation>
    </message>
    <message>
        <source>Change wind</source>
        <translation>Wind ändern</translation>
    </message>
    <message>
        <source>Remove terrain %1</source>
        <translation>Gelände %1 entfernen</translation>
    </message>
    <message>
        <source>Remove airspaces %1</source>
        <translation>Lufträume %1 entfernen</translation>
    </message>
    <message>
        <source>Remove population %1</source>
        <translation>Bevölkerung %1 entfernen</translation>
    </message>
    <message>
        <source>Remove airfields %1</source>
        <translation>Flugplätze %1 entfernen</translation>
    </message>
</context>
<context>
    <name>vp::gui::ExportController</name>
    <message>
        <source>Picture of the map…</source>
        <translation>Bild der Karte…</translation>
    </message>
    <message>
        <source>Picture of the profile…</source>
        <translation>Bild des Profils…</translation>
    </message>
    <message>
        <source>Picture of the 3D view…</source>
        <translation>Bild der 3D-Ansicht…</translation>
    </message>
    <message>
        <source>There is no plan to export; plan the tour first.</source>
        <translation>Es gibt keinen Plan zum Exportieren; zuerst die Tour planen.</translation>
    </message>
    <message>
        <source>This plan is UNVERIFIED: nobody has shown that a glide to a runway exists from every point of it.</source>
        <translation>Dieser Plan ist UNGEPRÜFT: niemand hat gezeigt, dass von jedem Punkt aus eine Piste im Gleitflug erreichbar ist.</translation>
    </message>
    <message>
        <source>This plan is out of date: the mission has been changed since it was made.</source>
        <translation>Dieser Plan ist veraltet: die Mission wurde geändert, seit er gemacht wurde.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Export it all the same?</source>
        <translation>Trotzdem exportieren?</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>Trotzdem exportieren</translation>
    </message>
    <message>
        <source>note: %1</source>
        <translation>Hinweis: %1</translation>
    </message>
    <message>
        <source>Written to %1</source>
        <translation>Nach %1 geschrieben</translation>
    </message>
    <message numerus="yes">
        <source>%n files written to %1</source>
        <translation>
            <numerusform>%n Datei nach %1 geschrieben</numerusform>
            <numerusform>%n Dateien nach %1 geschrieben</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vp::gui::FetchController</name>
    <message>
        <source>%1 %: %2</source>
        <translation>%1 %: %2</translation>
    </message>
    <message>
        <source>Terrain fetched and added to the mission: %1.</source>
        <translation>Gelände geholt und der Mission hinzugefügt: %1.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>The ones here are of %1.</source>
        <translation>Die hiesigen sind vom %1.</translation>
    </message>
    <message>
        <source>None are here yet.</source>
        <translation>Hier sind noch keine.</translation>
    </message>
    <message>
        <source>Update airfields</source>
        <translation>Flugplätze aktualisieren</translation>
    </message>
    <message>
        <source>Fetch the airfields of the world from OurAirports?</source>
        <translation>Die Flugplätze der Welt von OurAirports holen?</translation>
    </message>
    <message>
        <source>About 17 MB are fetched, less if nothing is new.</source>
        <translation>Etwa 17 MB werden geholt, weniger, wenn nichts neu ist.</translation>
    </message>
    <message>
        <source>Fetch</source>
        <translation>Holen</translation>
    </message>
    <message>
        <source>Fetching the airfields…</source>
        <translation>Die Flugplätze werden geholt…</translation>
    </message>
    <message>
        <source>The airfields are up to date.</source>
        <translation>Die Flugplätze sind aktuell.</translation>
    </message>
    <message>
        <source>Airfields of %1: %L2 landing sites in the world.</source>
        <translation>Flugplätze vom %1: %L2 Landeplätze in der Welt.</translation>
    </message>
    <message>
        <source>Open the mission again to use them.</source>
        <translation>Die Mission neu öffnen, um sie zu verwenden.</translation>
    </message>
    <message>
        <source>The landing glides are not known yet: the mission needs terrain and runways, and a moment to compute.</source>
        <translation>Die Gleitwege sind noch nicht bekannt: die Mission braucht Gelände und Pisten, und einen Moment zum Rechnen.</translation>
    </message>
    <message>
        <source>Write lowest safe altitudes to</source>
        <translation>Tiefste sichere Höhen schreiben nach</translation>
    </message>
    <message>
        <source>Computing the lowest safe altitudes…</source>
        <translation>Die tiefsten sicheren Höhen werden berechnet…</translation>
    </message>
    <message>
        <source>Written to %1: cells of %2 m, %3 % of the area has a lowest safe altitude.</source>
        <translation>Nach %1 geschrieben: Zellen von %2 m, %3 % der Fläche haben eine tiefste sichere Höhe.</translation>
    </message>
</context>
<context>
    <name>vp::gui::FileController</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>“%1” has changes that are not saved.</source>
        <translation>„%1“ hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Save them first?</source>
        <translation>Zuerst speichern?</translation>
    </message>
    <message>
        <source>Open mission or plan</source>
        <translation>Mission oder Plan öffnen</translation>
    </message>
    <message>
        <source>Missions and plans (*.vpm *.vpp);;All files (*)</source>
        <translation>Missionen und Pläne (*.vpm *.vpp);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Nicht gespeichert</translation>
    </message>
    <message>
        <source>Save mission</source>
        <translation>Mission speichern</translation>
    </message>
    <message>
        <source>Missions (*.vpm)</source>
        <translation>Missionen (*.vpm)</translation>
    </message>
    <message>
        <source>Planning is running</source>
        <translation>Planung läuft</translation>
    </message>
    <message>
        <source>A plan is being made. Stop it and close?</source>
        <translation>Ein Plan wird gerade gemacht. Anhalten und schließen?</translation>
    </message>
    <message>
        <source>Add terrain</source>
        <translation>Gelände hinzufügen</translation>
    </message>
    <message>
        <source>Add airfields</source>
        <translation>Flugplätze hinzufügen</translation>
    </message>
    <message>
        <source>Airfields: OurAirports csv (both files), X-Plane apt.dat, SeeYou cup, own csv or GeoJSON (*.csv *.csv.gz *.cup *.dat *.dat.gz *.geojson *.json);;All files (*)</source>
        <translation>Flugplätze: OurAirports csv (beide Dateien), X-Plane apt.dat, SeeYou cup, eigene csv oder GeoJSON (*.csv *.csv.gz *.cup *.dat *.dat.gz *.geojson *.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Add airspaces</source>
        <translation>Lufträume hinzufügen</translation>
    </message>
    <message>
        <source>Airspaces: OpenAir (*.txt *.air *.txt.gz *.air.gz);;All files (*)</source>
        <translation>Lufträume: OpenAir (*.txt *.air *.txt.gz *.air.gz);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Add weather</source>
        <translation>Wetter hinzufügen</translation>
    </message>
    <message>
        <source>Polygons of weather (*.geojson *.json *.shp *.gpkg *.kml *.kmz);;All files (*)</source>
        <translation>Wetterflächen (*.geojson *.json *.shp *.gpkg *.kml *.kmz);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Add population</source>
        <translation>Bevölkerung hinzufügen</translation>
    </message>
    <message>
        <source>Polygons with people in them (*.geojson *.json *.shp *.gpkg *.kml *.kmz);;All files (*)</source>
        <translation>Flächen mit Bevölkerung (*.geojson *.json *.shp *.gpkg *.kml *.kmz);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Import targets</source>
        <translation>Ziele importieren</translation>
    </message>
    <message>
        <source>Targets: SeeYou, GPX, KML, table, GeoJSON, QGroundControl, Little Navmap (*.cup *.gpx *.kml *.kmz *.csv *.geojson *.json *.plan *.lnmpln);;All files (*)</source>
        <translation>Ziele: SeeYou, GPX, KML, Tabelle, GeoJSON, QGroundControl, Little Navmap (*.cup *.gpx *.kml *.kmz *.csv *.geojson *.json *.plan *.lnmpln);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open one mission or plan at a time, and terrain and airfields after it.</source>
        <translation>Nur eine Mission oder einen Plan auf einmal öffnen, und Gelände und Flugplätze danach.</translation>
    </message>
    <message>
        <source>Airfields or targets?</source>
        <translation>Flugplätze oder Ziele?</translation>
    </message>
    <message>
        <source>%1 can be taken for airfields or for targets.</source>
        <translation>%1 kann für Flugplätze oder für Ziele genommen werden.</translation>
    </message>
    <message>
        <source>&amp;Airfields</source>
        <translation>&amp;Flugplätze</translation>
    </message>
    <message>
        <source>&amp;Targets</source>
        <translation>&amp;Ziele</translation>
    </message>
    <message>
        <source>&amp;Leave it out</source>
        <translation>&amp;Weglassen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message numerus="yes">
        <source>%n target(s) imported from %1.</source>
        <translation>
            <numerusform>%n Ziel aus %1 importiert.</numerusform>
            <numerusform>%n Ziele aus %1 importiert.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of them cannot be planned on this terrain: %1.</source>
        <translation>
            <numerusform>%n davon kann auf diesem Gelände nicht geplant werden: %1.</numerusform>
            <numerusform>%n davon können auf diesem Gelände nicht geplant werden: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n weather cell(s) added from %1.</source>
        <translation>
            <numerusform>%n Wetterzelle aus %1 hinzugefügt.</numerusform>
            <numerusform>%n Wetterzellen aus %1 hinzugefügt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>And %n more note(s).</source>
        <translation>
            <numerusform>Und %n weiterer Hinweis.</numerusform>
            <numerusform>Und %n weitere Hinweise.</numerusform>
        </translation>
    </message>
    <message>
        <source>Elevation rasters (*.tif *.tiff *.hgt *.dt0 *.dt1 *.dt2 *.asc *.img *.bil);;All files (*)</source>
        <translation>Höhenraster (*.tif *.tiff *.hgt *.dt0 *.dt1 *.dt2 *.asc *.img *.bil);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>“%1” is open elsewhere: %2. This is a copy of it; save it under another name.</source>
        <translation>„%1“ ist anderswo geöffnet: %2. Dies ist eine Kopie davon; unter einem anderen Namen speichern.</translation>
    </message>
    <message>
        <source>Open elsewhere</source>
        <translation>Anderswo geöffnet</translation>
    </message>
    <message>
        <source>“%1” is open elsewhere: %2.</source>
        <translation>„%1“ ist anderswo geöffnet: %2.</translation>
    </message>
    <message>
        <source>Whether that window still runs cannot be told from here.</source>
        <translation>Ob jenes Fenster noch läuft, lässt sich von hier nicht sagen.</translation>
    </message>
    <message>
        <source>A copy can be changed and saved under another name. If both save the same file, the later one wins.</source>
        <translation>Eine Kopie kann geändert und unter einem anderen Namen gespeichert werden. Speichern beide dieselbe Datei, gilt die spätere.</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>Kopie öffnen</translation>
    </message>
    <message>
        <source>Open anyway</source>
        <translation>Trotzdem öffnen</translation>
    </message>
    <message>
        <source>“%1” has been changed on disk since it was opened here, at %2.</source>
        <translation>„%1“ wurde auf der Platte geändert, seit es hier geöffnet wurde, um %2.</translation>
    </message>
    <message>
        <source>Save this work under another name, or overwrite what is there?</source>
        <translation>Diese Arbeit unter einem anderen Namen speichern, oder das Vorhandene überschreiben?</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Überschreiben</translation>
    </message>
</context>
<context>
    <name>vp::gui::MainWindow</name>
    <message>
        <source>Targets</source>
        <translation>Ziele</translation>
    </message>
    <message>
        <source>Runways</source>
        <translation>Pisten</translation>
    </message>
    <message>
        <source>Engine out</source>
        <translation>Motorausfall</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Landing now</source>
        <translation>Sofortlandung</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Decision points</source>
        <translation>Entscheidungspunkte</translation>
    </message>
    <message>
        <source>%1 % – %2</source>
        <translation>%1 % – %2</translation>
    </message>
    <message>
        <source>Plan !</source>
        <translation>Plan !</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;New mission</source>
        <translation>&amp;Neue Mission</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Open &amp;example</source>
        <translation>&amp;Beispiel öffnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Add &amp;terrain…</source>
        <translation>&amp;Gelände hinzufügen…</translation>
    </message>
    <message>
        <source>Add air&amp;fields…</source>
        <translation>Flug&amp;plätze hinzufügen…</translation>
    </message>
    <message>
        <source>Add airs&amp;paces…</source>
        <translation>&amp;Lufträume hinzufügen…</translation>
    </message>
    <message>
        <source>Add popu&amp;lation…</source>
        <translation>Be&amp;völkerung hinzufügen…</translation>
    </message>
    <message>
        <source>Add &amp;weather…</source>
        <translation>&amp;Wetter hinzufügen…</translation>
    </message>
    <message>
        <source>Fetch terrain for t&amp;his area…</source>
        <translation>Gelände für dieses Gebiet &amp;holen…</translation>
    </message>
    <message>
        <source>&amp;Update airfields…</source>
        <translation>Flugplätze &amp;aktualisieren…</translation>
    </message>
    <message>
        <source>&amp;Import targets…</source>
        <translation>Ziele i&amp;mportieren…</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>&amp;Exportieren</translation>
    </message>
    <message>
        <source>&amp;Several formats…</source>
        <translation>&amp;Mehrere Formate…</translation>
    </message>
    <message>
        <source>Lowest safe altitude map…</source>
        <translation>Karte der tiefsten sicheren Höhe…</translation>
    </message>
    <message>
        <source>&amp;Briefing…</source>
        <translation>B&amp;riefing…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Been&amp;den</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Edit &amp;target…</source>
        <translation>&amp;Ziel bearbeiten…</translation>
    </message>
    <message>
        <source>Re&amp;name target…</source>
        <translation>Ziel &amp;umbenennen…</translation>
    </message>
    <message>
        <source>&amp;Delete target</source>
        <translation>Ziel &amp;löschen</translation>
    </message>
    <message>
        <source>Mo&amp;ve target up</source>
        <translation>Ziel nach &amp;oben</translation>
    </message>
    <message>
        <source>Move target d&amp;own</source>
        <translation>Ziel nach u&amp;nten</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Voreinstellungen…</translation>
    </message>
    <message>
        <source>&amp;Mission</source>
        <translation>&amp;Mission</translation>
    </message>
    <message>
        <source>&amp;Files…</source>
        <translation>&amp;Dateien…</translation>
    </message>
    <message>
        <source>&amp;Aircraft…</source>
        <translation>&amp;Flugzeug…</translation>
    </message>
    <message>
        <source>&amp;Wind…</source>
        <translation>W&amp;ind…</translation>
    </message>
    <message>
        <source>Airs&amp;pace…</source>
        <translation>&amp;Luftraum…</translation>
    </message>
    <message>
        <source>&amp;Draw weather</source>
        <translation>Wetter &amp;zeichnen</translation>
    </message>
    <message>
        <source>Weat&amp;her…</source>
        <translation>&amp;Wetter…</translation>
    </message>
    <message>
        <source>E&amp;xport weather…</source>
        <translation>Wetter e&amp;xportieren…</translation>
    </message>
    <message>
        <source>Mission &amp;settings…</source>
        <translation>&amp;Einstellungen der Mission…</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>&amp;Planung</translation>
    </message>
    <message>
        <source>&amp;Plan tour</source>
        <translation>&amp;Tour planen</translation>
    </message>
    <message>
        <source>Plan tour</source>
        <translation>Tour planen</translation>
    </message>
    <message>
        <source>&amp;Stop planning</source>
        <translation>Planung an&amp;halten</translation>
    </message>
    <message>
        <source>Show &amp;worst point</source>
        <translation>Schlechteste Stelle &amp;zeigen</translation>
    </message>
    <message>
        <source>&amp;Land now from the chosen point</source>
        <translation>&amp;Sofortlandung vom gewählten Punkt</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;3D view</source>
        <translation>&amp;3D-Ansicht</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>&amp;Alles zeigen</translation>
    </message>
    <message>
        <source>Previous view</source>
        <translation>Vorige Ansicht</translation>
    </message>
    <message>
        <source>Next view</source>
        <translation>Nächste Ansicht</translation>
    </message>
    <message>
        <source>&amp;Full-screen map</source>
        <translation>Karte im &amp;Vollbild</translation>
    </message>
    <message>
        <source>Centre the &amp;plan</source>
        <translation>&amp;Plan zentrieren</translation>
    </message>
    <message>
        <source>&amp;Jump to…</source>
        <translation>&amp;Springen zu…</translation>
    </message>
    <message>
        <source>&amp;Range rings from the middle of the map</source>
        <translation>Entfernungs&amp;ringe um die Kartenmitte</translation>
    </message>
    <message>
        <source>Remove all range rings</source>
        <translation>Alle Entfernungsringe entfernen</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation>&amp;Erste Schritte</translation>
    </message>
    <message>
        <source>&amp;Keyboard and mouse</source>
        <translation>&amp;Tastatur und Maus</translation>
    </message>
    <message>
        <source>&amp;About Volplane</source>
        <translation>Ü&amp;ber Volplane</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Select and move</source>
        <translation>Wählen und verschieben</translation>
    </message>
    <message>
        <source>Add targets</source>
        <translation>Ziele hinzufügen</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>&amp;Overlays</source>
        <translation>&amp;Ebenen</translation>
    </message>
    <message>
        <source>What the map shows beside terrain, runways and tour</source>
        <translation>Was die Karte außer Gelände, Pisten und Tour zeigt</translation>
    </message>
    <message>
        <source>&amp;Lowest safe altitude</source>
        <translation>&amp;Tiefste sichere Höhe</translation>
    </message>
    <message>
        <source>…for the &amp;course</source>
        <translation>…für den &amp;Kurs</translation>
    </message>
    <message>
        <source>Worst of all courses</source>
        <translation>Schlechtester aller Kurse</translation>
    </message>
    <message>
        <source>&amp;Where a runway is in reach from…</source>
        <translation>&amp;Wo eine Piste erreichbar ist aus…</translation>
    </message>
    <message>
        <source>Glide range</source>
        <translation>Gleitbereich</translation>
    </message>
    <message>
        <source>Altitude of the aircraft (%1 MSL)</source>
        <translation>Höhe des Flugzeugs (%1 MSL)</translation>
    </message>
    <message>
        <source>Glide &amp;margin along the tour</source>
        <translation>&amp;Gleitreserve entlang der Tour</translation>
    </message>
    <message>
        <source>&amp;Decision points</source>
        <translation>&amp;Entscheidungspunkte</translation>
    </message>
    <message>
        <source>&amp;All landing glides</source>
        <translation>&amp;Alle Gleitwege</translation>
    </message>
    <message>
        <source>W&amp;eather</source>
        <translation>Wette&amp;r</translation>
    </message>
    <message>
        <source>&amp;Population</source>
        <translation>Be&amp;völkerung</translation>
    </message>
    <message>
        <source>Terrain con&amp;tours</source>
        <translation>&amp;Höhenlinien</translation>
    </message>
    <message>
        <source>E&amp;xcluded runways</source>
        <translation>Au&amp;sgeschlossene Pisten</translation>
    </message>
    <message>
        <source>Le&amp;gend</source>
        <translation>&amp;Legende</translation>
    </message>
    <message>
        <source>&amp;Units</source>
        <translation>E&amp;inheiten</translation>
    </message>
    <message>
        <source>&amp;Aviation: ft, NM, kt, ft/min</source>
        <translation>&amp;Luftfahrt: ft, NM, kt, ft/min</translation>
    </message>
    <message>
        <source>&amp;Metric: m, km, km/h, m/s</source>
        <translation>&amp;Metrisch: m, km, km/h, m/s</translation>
    </message>
    <message>
        <source>Appearan&amp;ce</source>
        <translation>A&amp;ussehen</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>Wie der &amp;Desktop</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>Da&amp;rk</source>
        <translation>D&amp;unkel</translation>
    </message>
    <message>
        <source>This is an example over made-up Alps, already planned. Your own in three steps:  1  New mission, add terrain and airfields (or drop the files here).  2  Press A and click targets on the map.  3  Press Plan tour. Then move along the magenta route to see the glide from each point.</source>
        <translation>Dies ist ein Beispiel über erfundenen Alpen, schon geplant. Eigenes in drei Schritten:  1  Neue Mission, Gelände und Flugplätze hinzufügen (oder die Dateien hierher ziehen).  2  A drücken und Ziele auf der Karte anklicken.  3  „Tour planen“ drücken. Dann entlang der magentafarbenen Route fahren, um den Gleitweg von jedem Punkt zu sehen.</translation>
    </message>
    <message>
        <source>New mission</source>
        <translation>Neue Mission</translation>
    </message>
    <message>
        <source>Worst point</source>
        <translation>Schlechteste Stelle</translation>
    </message>
    <message>
        <source>Wheel, + and −, Page Up and Down</source>
        <translation>Mausrad, + und −, Bild auf und Bild ab</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>vergrößern, verkleinern</translation>
    </message>
    <message>
        <source>Drag, arrows</source>
        <translation>Ziehen, Pfeiltasten</translation>
    </message>
    <message>
        <source>move the map; with the middle button or Space in any tool</source>
        <translation>die Karte verschieben; mit der mittleren Taste oder der Leertaste in jedem Werkzeug</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>zoom to the target or runway</source>
        <translation>Ziel oder Piste vergrößern</translation>
    </message>
    <message>
        <source>A, V, M, W</source>
        <translation>A, V, M, W</translation>
    </message>
    <message>
        <source>add targets, select and move, measure, draw weather</source>
        <translation>Ziele hinzufügen, wählen und verschieben, messen, Wetter zeichnen</translation>
    </message>
    <message>
        <source>Double click, Return, Backspace</source>
        <translation>Doppelklick, Eingabe, Rücktaste</translation>
    </message>
    <message>
        <source>drawing weather: close the outline, take the last corner back</source>
        <translation>Wetter zeichnen: Umriss schließen, letzte Ecke zurücknehmen</translation>
    </message>
    <message>
        <source>Ctrl+click</source>
        <translation>Strg+Klick</translation>
    </message>
    <message>
        <source>measure from there</source>
        <translation>von dort messen</translation>
    </message>
    <message>
        <source>Shift+click</source>
        <translation>Umschalt+Klick</translation>
    </message>
    <message>
        <source>range rings; on their middle: remove them</source>
        <translation>Entfernungsringe; auf ihrer Mitte: entfernen</translation>
    </message>
    <message>
        <source>R, Shift+R</source>
        <translation>R, Umschalt+R</translation>
    </message>
    <message>
        <source>range rings from the middle of the map, remove all</source>
        <translation>Entfernungsringe um die Kartenmitte, alle entfernen</translation>
    </message>
    <message>
        <source>Ctrl+Alt+click, Shift+Alt+click</source>
        <translation>Strg+Alt+Klick, Umschalt+Alt+Klick</translation>
    </message>
    <message>
        <source>add a target into the nearest leg, at the end</source>
        <translation>ein Ziel in die nächste Teilstrecke, am Ende hinzufügen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Strg+Umschalt+H</translation>
    </message>
    <message>
        <source>list of the weather</source>
        <translation>Liste des Wetters</translation>
    </message>
    <message>
        <source>Del, Ctrl+E, Ctrl+Up, Ctrl+Down</source>
        <translation>Entf, Strg+E, Strg+Auf, Strg+Ab</translation>
    </message>
    <message>
        <source>delete, edit, move up, move down the selected target</source>
        <translation>gewähltes Ziel löschen, bearbeiten, nach oben, nach unten</translation>
    </message>
    <message>
        <source>Ctrl+Z, Ctrl+Y</source>
        <translation>Strg+Z, Strg+Y</translation>
    </message>
    <message>
        <source>undo, redo</source>
        <translation>rückgängig, wiederholen</translation>
    </message>
    <message>
        <source>Ctrl+Enter, Ctrl+.</source>
        <translation>Strg+Eingabe, Strg+.</translation>
    </message>
    <message>
        <source>plan, stop planning</source>
        <translation>planen, Planung anhalten</translation>
    </message>
    <message>
        <source>Ctrl+W</source>
        <translation>Strg+W</translation>
    </message>
    <message>
        <source>worst point of the tour</source>
        <translation>schlechteste Stelle der Tour</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Strg+L</translation>
    </message>
    <message>
        <source>lowest safe altitude</source>
        <translation>tiefste sichere Höhe</translation>
    </message>
    <message>
        <source>Pointer on the route</source>
        <translation>Zeiger auf der Route</translation>
    </message>
    <message>
        <source>the glide from there, in all views; a click keeps it</source>
        <translation>der Gleitweg von dort, in allen Ansichten; ein Klick hält ihn fest</translation>
    </message>
    <message>
        <source>Left, Right in the profile</source>
        <translation>Links, Rechts im Profil</translation>
    </message>
    <message>
        <source>previous, next decision point</source>
        <translation>voriger, nächster Entscheidungspunkt</translation>
    </message>
    <message>
        <source>Ctrl+Home, Ctrl+Page Down</source>
        <translation>Strg+Pos1, Strg+Bild ab</translation>
    </message>
    <message>
        <source>show all, centre the plan</source>
        <translation>alles zeigen, Plan zentrieren</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Home</source>
        <translation>Strg+Umschalt+Pos1</translation>
    </message>
    <message>
        <source>jump to a position, an airfield or a target</source>
        <translation>zu Position, Flugplatz oder Ziel springen</translation>
    </message>
    <message>
        <source>Alt+Left, Alt+Right</source>
        <translation>Alt+Links, Alt+Rechts</translation>
    </message>
    <message>
        <source>previous, next view</source>
        <translation>vorige, nächste Ansicht</translation>
    </message>
    <message>
        <source>F2 … F8, F11</source>
        <translation>F2 … F8, F11</translation>
    </message>
    <message>
        <source>targets, runways, 3D, profile, engine out, decision points, plan; full-screen map</source>
        <translation>Ziele, Pisten, 3D, Profil, Motorausfall, Entscheidungspunkte, Plan; Karte im Vollbild</translation>
    </message>
    <message>
        <source>Ctrl+P</source>
        <translation>Strg+P</translation>
    </message>
    <message>
        <source>briefing for the kneeboard</source>
        <translation>Briefing für das Kniebrett</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F, Alt+Enter</source>
        <translation>Strg+Umschalt+F, Alt+Eingabe</translation>
    </message>
    <message>
        <source>files and settings of the mission</source>
        <translation>Dateien und Einstellungen der Mission</translation>
    </message>
    <message>
        <source>Ctrl+Shift+,</source>
        <translation>Strg+Umschalt+,</translation>
    </message>
    <message>
        <source>preferences</source>
        <translation>Voreinstellungen</translation>
    </message>
    <message>
        <source>In 3D: drag, middle drag, right drag</source>
        <translation>In 3D: ziehen, mit mittlerer, mit rechter Taste</translation>
    </message>
    <message>
        <source>move, orbit, zoom; 1 to 4 are fixed views, Space is home</source>
        <translation>verschieben, drehen, vergrößern; 1 bis 4 sind feste Ansichten, Leertaste ist Ausgangslage</translation>
    </message>
    <message>
        <source>Keyboard and mouse</source>
        <translation>Tastatur und Maus</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>F1</source>
        <translation>F1</translation>
    </message>
    <message>
        <source>the page of the manual for the view or dialog in front</source>
        <translation>die Handbuchseite zur vorderen Ansicht oder zum vorderen Dialog</translation>
    </message>
</context>
<context>
    <name>vp::gui::PlanningController</name>
    <message>
        <source>Include excluded runways</source>
        <translation>Ausgeschlossene Pisten einschließen</translation>
    </message>
    <message>
        <source>The plan in this file could not be checked and counts as unverified: %1</source>
        <translation>Der Plan in dieser Datei konnte nicht geprüft werden und gilt als ungeprüft: %1</translation>
    </message>
    <message>
        <source>Planning was stopped; the mission is as it was.</source>
        <translation>Die Planung wurde angehalten; die Mission ist, wie sie war.</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Neu planen</translation>
    </message>
    <message>
        <source>Verified: from every point of this %1 tour the aircraft can glide to a runway.</source>
        <translation>Geprüft: von jedem Punkt dieser Tour von %1 ist eine Piste im Gleitflug erreichbar.</translation>
    </message>
    <message numerus="yes">
        <source>Verified, but for the spirals down to %n target(s), in which the gliding guarantee is suspended; this tour is %1 long.</source>
        <translation>
            <numerusform>Geprüft, außer in der Spirale hinab zu %n Ziel, in der die Gleitgarantie ausgesetzt ist; diese Tour ist %1 lang.</numerusform>
            <numerusform>Geprüft, außer in den Spiralen hinab zu %n Zielen, in denen die Gleitgarantie ausgesetzt ist; diese Tour ist %1 lang.</numerusform>
        </translation>
    </message>
    <message>
        <source>Planned in %1 s.</source>
        <translation>In %1 s geplant.</translation>
    </message>
    <message>
        <source>Your edit was placed into the tour before; planning once more searches the whole anew.</source>
        <translation>Die Änderung wurde in die vorige Tour eingefügt; noch einmal planen sucht das Ganze neu.</translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s) to read in the plan panel.</source>
        <translation>
            <numerusform>%n Warnung im Planfenster zu lesen.</numerusform>
            <numerusform>%n Warnungen im Planfenster zu lesen.</numerusform>
        </translation>
    </message>
    <message>
        <source>The independent checker refuses this plan; do not fly it. %1</source>
        <translation>Die unabhängige Prüfung lehnt diesen Plan ab; nicht fliegen. %1</translation>
    </message>
    <message>
        <source>Allow passing above</source>
        <translation>Überflug erlauben</translation>
    </message>
    <message>
        <source>Planning failed.</source>
        <translation>Die Planung ist gescheitert.</translation>
    </message>
    <message>
        <source>the mission&apos;s ceiling of %1</source>
        <translation>der Obergrenze der Mission von %1</translation>
    </message>
    <message>
        <source>the aircraft&apos;s ceiling of %1</source>
        <translation>der Gipfelhöhe des Flugzeugs von %1</translation>
    </message>
    <message>
        <source>%1, to which the air is reckoned as neither mission nor aircraft has a ceiling</source>
        <translation>%1, bis wohin die Luft gerechnet wird, da weder Mission noch Flugzeug eine Obergrenze hat</translation>
    </message>
    <message>
        <source>No safe tour joins all targets below %1; how much is missing is not known.</source>
        <translation>Keine sichere Tour verbindet alle Ziele unter %1; wie viel fehlt, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>No safe tour: to stay within glide of a runway it must climb to %1, which is %2 above %3.</source>
        <translation>Keine sichere Tour: um im Gleitbereich einer Piste zu bleiben, muss sie auf %1 steigen, das ist %2 über %3.</translation>
    </message>
    <message>
        <source>No safe tour over target %1: to stay within glide of a runway it must climb to at least %2 there, which is %3 above %4.</source>
        <translation>Keine sichere Tour über Ziel %1: um im Gleitbereich einer Piste zu bleiben, muss sie dort auf mindestens %2 steigen, das ist %3 über %4.</translation>
    </message>
    <message>
        <source>Aircraft…</source>
        <translation>Flugzeug…</translation>
    </message>
    <message>
        <source>Raise ceiling by %1</source>
        <translation>Obergrenze um %1 anheben</translation>
    </message>
    <message>
        <source>No ceiling</source>
        <translation>Keine Obergrenze</translation>
    </message>
    <message>
        <source>Delete target %1</source>
        <translation>Ziel %1 löschen</translation>
    </message>
</context>
<context>
    <name>vp::gui::StatusLine</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Stop planning (Esc)</source>
        <translation>Planung anhalten (Esc)</translation>
    </message>
    <message>
        <source>Stop planning</source>
        <translation>Planung anhalten</translation>
    </message>
    <message>
        <source>Where the tour has the least height above what its glide needs; a click shows the place</source>
        <translation>Wo die Tour am wenigsten Höhe über dem hat, was ihr Gleitweg braucht; ein Klick zeigt den Ort</translation>
    </message>
    <message>
        <source>Where the tour is lowest above the ground; a click shows the place</source>
        <translation>Wo die Tour am tiefsten über dem Boden liegt; ein Klick zeigt den Ort</translation>
    </message>
    <message>
        <source>Ground that the map shows from left to right</source>
        <translation>Strecke am Boden, die die Karte von links nach rechts zeigt</translation>
    </message>
    <message>
        <source>Place under the pointer</source>
        <translation>Ort unter dem Zeiger</translation>
    </message>
    <message>
        <source>Least glide margin %1 at %2</source>
        <translation>Kleinste Gleitreserve %1 bei %2</translation>
    </message>
    <message>
        <source>Margin %1</source>
        <translation>Reserve %1</translation>
    </message>
    <message>
        <source> (old plan)</source>
        <translation> (alter Plan)</translation>
    </message>
    <message>
        <source>Least clearance %1 at %2</source>
        <translation>Kleinster Bodenabstand %1 bei %2</translation>
    </message>
    <message>
        <source>Clearance %1</source>
        <translation>Bodenabstand %1</translation>
    </message>
    <message>
        <source>Ground %1</source>
        <translation>Boden %1</translation>
    </message>
    <message>
        <source>Ground unknown</source>
        <translation>Boden unbekannt</translation>
    </message>
    <message>
        <source>Lowest safe %1</source>
        <translation>Tiefste sichere %1</translation>
    </message>
    <message>
        <source>Var %1</source>
        <translation>Missw. %1</translation>
    </message>
    <message>
        <source>No compass here</source>
        <translation>Hier kein Kompass</translation>
    </message>
    <message>
        <source>Map %1 wide</source>
        <translation>Karte %1 breit</translation>
    </message>
</context>
<context>
    <name>vp::gui::WeatherController</name>
    <message>
        <source>Draw weather %1</source>
        <translation>Wetter %1 zeichnen</translation>
    </message>
    <message>
        <source>Edit weather %1</source>
        <translation>Wetter %1 bearbeiten</translation>
    </message>
    <message>
        <source>Delete weather %1</source>
        <translation>Wetter %1 löschen</translation>
    </message>
    <message>
        <source>Move a corner of weather %1</source>
        <translation>Eine Ecke von Wetter %1 verschieben</translation>
    </message>
    <message>
        <source>Export weather</source>
        <translation>Wetter exportieren</translation>
    </message>
    <message>
        <source>GeoJSON (*.geojson)</source>
        <translation>GeoJSON (*.geojson)</translation>
    </message>
    <message numerus="yes">
        <source>%n weather cell(s) written to %1.</source>
        <translation>
            <numerusform>%n Wetterzelle nach %1 geschrieben.</numerusform>
            <numerusform>%n Wetterzellen nach %1 geschrieben.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vp::help::ManualWindow</name>
    <message>
        <source>Volplane manual</source>
        <translation>Volplane-Handbuch</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>Seite des Handbuchs</translation>
    </message>
    <message>
        <source>Contents of the manual</source>
        <translation>Inhalt des Handbuchs</translation>
    </message>
    <message>
        <source>The manual was not found: %1. Install Volplane again, or set VOLPLANE_RESOURCES to the folder that holds it.</source>
        <translation>Das Handbuch wurde nicht gefunden: %1. Volplane neu installieren, oder VOLPLANE_RESOURCES auf den Ordner setzen, der es enthält.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Search in this page</source>
        <translation>Auf dieser Seite suchen</translation>
    </message>
    <message>
        <source>Not in this page.</source>
        <translation>Nicht auf dieser Seite.</translation>
    </message>
</context>
<context>
    <name>vp::jobs::FileIntake</name>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message numerus="yes">
        <source>Reading %n file(s)</source>
        <translation>
            <numerusform>%n Datei wird gelesen</numerusform>
            <numerusform>%n Dateien werden gelesen</numerusform>
        </translation>
    </message>
    <message>
        <source>Left out: %1</source>
        <translation>Weggelassen: %1</translation>
    </message>
    <message>
        <source>Add weather from %1</source>
        <translation>Wetter aus %1 hinzufügen</translation>
    </message>
    <message>
        <source>Import targets from %1</source>
        <translation>Ziele aus %1 importieren</translation>
    </message>
</context>
<context>
    <name>vp::jobs::JobRunner</name>
    <message>
        <source>no further thread could be started; close other programs and try again</source>
        <translation>es konnte kein weiterer Thread gestartet werden; andere Programme schließen und noch einmal versuchen</translation>
    </message>
    <message>
        <source>there is not enough memory for this; close other programs or use a smaller terrain</source>
        <translation>dafür reicht der Speicher nicht; andere Programme schließen oder ein kleineres Gelände verwenden</translation>
    </message>
    <message>
        <source>a defect in the program stopped this work, nothing was changed: %1</source>
        <translation>ein Fehler im Programm hat diese Arbeit beendet, nichts wurde geändert: %1</translation>
    </message>
    <message>
        <source>a defect in the program stopped this work, nothing was changed</source>
        <translation>ein Fehler im Programm hat diese Arbeit beendet, nichts wurde geändert</translation>
    </message>
</context>
<context>
    <name>vp::jobs::LandingDesk</name>
    <message>
        <source>there is no terrain to glide over; add a terrain file first</source>
        <translation>es gibt kein Gelände, über dem zu gleiten wäre; zuerst eine Geländedatei hinzufügen</translation>
    </message>
    <message>
        <source>no runway may be used here; add airfields or let more runways count first</source>
        <translation>hier darf keine Piste verwendet werden; zuerst Flugplätze hinzufügen oder mehr Pisten gelten lassen</translation>
    </message>
    <message>
        <source>there is no planner called %1</source>
        <translation>es gibt kein Planungsverfahren namens %1</translation>
    </message>
</context>
<context>
    <name>vp::jobs::Workspace</name>
    <message>
        <source>a plan is being made already; stop it first</source>
        <translation>es wird schon ein Plan gemacht; ihn zuerst anhalten</translation>
    </message>
    <message>
        <source>no terrain is loaded; add a terrain file first</source>
        <translation>es ist kein Gelände geladen; zuerst eine Geländedatei hinzufügen</translation>
    </message>
    <message>
        <source>the terrain files have changed and are read again; plan again in a moment</source>
        <translation>die Geländedateien haben sich geändert und werden neu gelesen; gleich noch einmal planen</translation>
    </message>
    <message>
        <source>terrain and airfields are still being read; plan again in a moment</source>
        <translation>Gelände und Flugplätze werden noch gelesen; gleich noch einmal planen</translation>
    </message>
    <message>
        <source>no usable runway lies inside the terrain; add airfields, or include runways that the filter leaves out</source>
        <translation>keine verwendbare Piste liegt im Gelände; Flugplätze hinzufügen, oder Pisten einschließen, die der Filter weglässt</translation>
    </message>
    <message>
        <source>the mission has no targets; press A and click at least one on the map</source>
        <translation>die Mission hat keine Ziele; A drücken und mindestens eines auf der Karte anklicken</translation>
    </message>
    <message>
        <source>Add terrain</source>
        <translation>Gelände hinzufügen</translation>
    </message>
    <message>
        <source>Add airfields</source>
        <translation>Flugplätze hinzufügen</translation>
    </message>
    <message>
        <source>Add airspaces</source>
        <translation>Lufträume hinzufügen</translation>
    </message>
    <message>
        <source>Add population</source>
        <translation>Bevölkerung hinzufügen</translation>
    </message>
    <message numerus="yes">
        <source>Add %n file(s)</source>
        <translation>
            <numerusform>%n Datei hinzufügen</numerusform>
            <numerusform>%n Dateien hinzufügen</numerusform>
        </translation>
    </message>
    <message>
        <source>terrain: shading</source>
        <translation>Gelände: Schattierung</translation>
    </message>
    <message>
        <source>reading the population was stopped</source>
        <translation>das Lesen der Bevölkerung wurde angehalten</translation>
    </message>
</context>
<context>
    <name>vp::map::MapView</name>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Terrain, runways, targets and tour. Arrow keys pan, Page Up and Page Down zoom, Ctrl+Home shows everything, the menu key offers what can be done with the object in the middle or the selected target.</source>
        <translation>Gelände, Pisten, Ziele und Tour. Pfeiltasten verschieben, Bild auf und Bild ab vergrößern und verkleinern, Strg+Pos1 zeigt alles, die Menütaste bietet, was mit dem Objekt in der Mitte oder dem gewählten Ziel getan werden kann.</translation>
    </message>
    <message>
        <source>No runways yet: drop an airfield file here, or choose File &gt; Add airfields…</source>
        <translation>Noch keine Pisten: eine Flugplatzdatei hierher ziehen, oder Datei &gt; Flugplätze hinzufügen…</translation>
    </message>
    <message>
        <source>No targets yet: right-click the map, or use the add-target tool and click</source>
        <translation>Noch keine Ziele: Rechtsklick auf die Karte, oder das Zielwerkzeug wählen und klicken</translation>
    </message>
    <message>
        <source>Drop a terrain file here, or choose File &gt; Add terrain…</source>
        <translation>Eine Geländedatei hierher ziehen, oder Datei &gt; Gelände hinzufügen…</translation>
    </message>
</context>
<context>
    <name>vp::map::Words</name>
    <message>
        <source>N</source>
        <comment>north on the map&apos;s arrow</comment>
        <translation>N</translation>
    </message>
    <message>
        <source>on course %1</source>
        <translation>auf Kurs %1</translation>
    </message>
    <message>
        <source>on the worst course</source>
        <translation>auf dem schlechtesten Kurs</translation>
    </message>
    <message>
        <source>Lowest safe altitude %1, %2 MSL</source>
        <translation>Tiefste sichere Höhe %1, %2 MSL</translation>
    </message>
    <message>
        <source>No glide from any altitude</source>
        <translation>Aus keiner Höhe ein Gleitweg</translation>
    </message>
    <message>
        <source>Runway reachable from %1</source>
        <translation>Piste erreichbar aus %1</translation>
    </message>
    <message>
        <source>Glide margin %1 or more</source>
        <translation>Gleitreserve %1 oder mehr</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>weniger als %1</translation>
    </message>
    <message>
        <source>none: no glide arrives</source>
        <translation>keine: kein Gleitweg kommt an</translation>
    </message>
    <message>
        <source>Weather: the closer the lines, the less likely to come through</source>
        <translation>Wetter: je dichter die Linien, desto unwahrscheinlicher das Durchkommen</translation>
    </message>
    <message>
        <source>People per km²</source>
        <translation>Menschen je km²</translation>
    </message>
    <message>
        <source>Decision points, not all at this scale</source>
        <translation>Entscheidungspunkte, in diesem Maßstab nicht alle</translation>
    </message>
    <message>
        <source>Decision points</source>
        <translation>Entscheidungspunkte</translation>
    </message>
    <message>
        <source>Leg proved safe</source>
        <translation>Teilstrecke als sicher bewiesen</translation>
    </message>
    <message>
        <source>Leg not yet checked</source>
        <translation>Teilstrecke noch nicht geprüft</translation>
    </message>
    <message>
        <source>Glides to the runways</source>
        <translation>Gleitwege zu den Pisten</translation>
    </message>
    <message>
        <source>margin %1</source>
        <translation>Reserve %1</translation>
    </message>
    <message>
        <source>Move %1…</source>
        <translation>%1 verschieben…</translation>
    </message>
    <message>
        <source>Rename %1…</source>
        <translation>%1 umbenennen…</translation>
    </message>
    <message>
        <source>Edit height of %1…</source>
        <translation>Höhe von %1 bearbeiten…</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>Start and end at %1</source>
        <translation>Start und Ende auf %1</translation>
    </message>
    <message>
        <source>Start at %1, end at %2</source>
        <translation>Start auf %1, Ende auf %2</translation>
    </message>
    <message>
        <source>Plan the tour alone, without a home runway</source>
        <translation>Nur die Tour planen, ohne Heimatpiste</translation>
    </message>
    <message>
        <source>Exclude runway %1</source>
        <translation>Piste %1 ausschließen</translation>
    </message>
    <message>
        <source>Exclude all runways of %1</source>
        <translation>Alle Pisten von %1 ausschließen</translation>
    </message>
    <message>
        <source>Use runway %1 again</source>
        <translation>Piste %1 wieder verwenden</translation>
    </message>
    <message>
        <source>Airspace %1</source>
        <translation>Luftraum %1</translation>
    </message>
    <message>
        <source>All of class %1</source>
        <translation>Alle der Klasse %1</translation>
    </message>
    <message>
        <source>Airspace rules…</source>
        <translation>Luftraumregeln…</translation>
    </message>
    <message>
        <source>Zoom in here</source>
        <translation>Hier vergrößern</translation>
    </message>
    <message>
        <source>Zoom to %1</source>
        <translation>%1 vergrößern</translation>
    </message>
    <message>
        <source>Show an engine failure here</source>
        <translation>Motorausfall hier zeigen</translation>
    </message>
    <message>
        <source>Insert target before %1</source>
        <translation>Ziel vor %1 einfügen</translation>
    </message>
    <message>
        <source>Edit weather %1…</source>
        <translation>Wetter %1 bearbeiten…</translation>
    </message>
    <message>
        <source>Delete weather %1</source>
        <translation>Wetter %1 löschen</translation>
    </message>
    <message>
        <source>Add target at %1</source>
        <translation>Ziel bei %1 hinzufügen</translation>
    </message>
    <message>
        <source>Engine out here: where to?</source>
        <translation>Motorausfall hier: wohin?</translation>
    </message>
    <message>
        <source>Measure from here</source>
        <translation>Von hier messen</translation>
    </message>
    <message>
        <source>Remove the range rings here</source>
        <translation>Die Entfernungsringe hier entfernen</translation>
    </message>
    <message>
        <source>Range rings from here</source>
        <translation>Entfernungsringe um diesen Ort</translation>
    </message>
    <message>
        <source>Centre here</source>
        <translation>Hier zentrieren</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>nicht verwendet</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>target %1</source>
        <translation>Ziel %1</translation>
    </message>
    <message>
        <source>%1 AGL</source>
        <translation>%1 AGL</translation>
    </message>
    <message>
        <source>insert before %1</source>
        <translation>vor %1 einfügen</translation>
    </message>
    <message>
        <source>Click to add a target, on the tour to insert it there; Esc when done</source>
        <translation>Klicken fügt ein Ziel hinzu, auf der Tour dort hinein; Esc, wenn fertig</translation>
    </message>
    <message>
        <source>Weather needs three corners or more; click where the next one is.</source>
        <translation>Wetter braucht drei Ecken oder mehr; die nächste anklicken.</translation>
    </message>
    <message>
        <source>Click the corners of the weather one after the other; Esc when done</source>
        <translation>Die Ecken des Wetters der Reihe nach anklicken; Esc, wenn fertig</translation>
    </message>
    <message>
        <source>Click the next corner; Backspace takes the last one back</source>
        <translation>Die nächste Ecke anklicken; die Rücktaste nimmt die letzte zurück</translation>
    </message>
    <message>
        <source>Double click or Return closes the outline; Backspace takes the last corner back, Esc drops it</source>
        <translation>Doppelklick oder Eingabe schließt den Umriss; die Rücktaste nimmt die letzte Ecke zurück, Esc verwirft ihn</translation>
    </message>
    <message>
        <source>start: %1</source>
        <translation>Start: %1</translation>
    </message>
    <message>
        <source>end: %1</source>
        <translation>Ende: %1</translation>
    </message>
    <message>
        <source>Click where to measure to</source>
        <translation>Anklicken, bis wohin gemessen wird</translation>
    </message>
    <message>
        <source>Click where to measure from; Esc when done</source>
        <translation>Anklicken, von wo gemessen wird; Esc, wenn fertig</translation>
    </message>
    <message>
        <source>Click where %1 shall be; Esc or right click to leave it</source>
        <translation>Anklicken, wo %1 sein soll; Esc oder Rechtsklick lässt es</translation>
    </message>
    <message>
        <source>ground %1</source>
        <translation>Boden %1</translation>
    </message>
    <message>
        <source>ground unknown</source>
        <translation>Boden unbekannt</translation>
    </message>
    <message>
        <source>Release to place the corner; Esc or right click to leave it where it was</source>
        <translation>Loslassen setzt die Ecke; Esc oder Rechtsklick lässt sie, wo sie war</translation>
    </message>
    <message>
        <source>Release to place the target; Esc or right click to leave it where it was</source>
        <translation>Loslassen setzt das Ziel; Esc oder Rechtsklick lässt es, wo es war</translation>
    </message>
    <message>
        <source>NOT VERIFIED</source>
        <translation>NICHT GEPRÜFT</translation>
    </message>
    <message>
        <source>OUT OF DATE</source>
        <translation>VERALTET</translation>
    </message>
</context>
<context>
    <name>vp::panels::AlternativesModel</name>
    <message>
        <source>not reachable</source>
        <translation>nicht erreichbar</translation>
    </message>
    <message>
        <source>only around terrain</source>
        <translation>nur um Gelände herum</translation>
    </message>
    <message>
        <source>reachable</source>
        <translation>erreichbar</translation>
    </message>
    <message>
        <source>Runway</source>
        <translation>Piste</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Reserve</translation>
    </message>
    <message>
        <source>Needs</source>
        <translation>Braucht</translation>
    </message>
    <message>
        <source>Glide</source>
        <translation>Gleitweg</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
</context>
<context>
    <name>vp::panels::DecisionModel</name>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>no glide</source>
        <translation>kein Gleitweg</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Entfernung</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Safe altitude</source>
        <translation>Sicherheitshöhe</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Reserve</translation>
    </message>
    <message>
        <source>Runway</source>
        <translation>Piste</translation>
    </message>
    <message>
        <source>Glide</source>
        <translation>Gleitweg</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
</context>
<context>
    <name>vp::panels::DecisionTable</name>
    <message>
        <source>Decision points</source>
        <translation>Entscheidungspunkte</translation>
    </message>
    <message>
        <source>Filter by target, runway or number</source>
        <translation>Nach Ziel, Piste oder Nummer filtern</translation>
    </message>
    <message>
        <source>Filter of decision points</source>
        <translation>Filter der Entscheidungspunkte</translation>
    </message>
    <message>
        <source>No plan yet</source>
        <translation>Noch kein Plan</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n Punkt</numerusform>
            <numerusform>%n Punkte</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 von %2 Punkten</translation>
    </message>
</context>
<context>
    <name>vp::panels::EngineOutPanel</name>
    <message>
        <source>Engine out</source>
        <translation>Motorausfall</translation>
    </message>
    <message>
        <source>On the tour</source>
        <translation>Auf der Tour</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Glide distance</source>
        <translation>Gleitstrecke</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Altitude margin</source>
        <translation>Höhenreserve</translation>
    </message>
    <message>
        <source>On arrival</source>
        <translation>Bei Ankunft</translation>
    </message>
    <message>
        <source>Least clearance</source>
        <translation>Kleinster Bodenabstand</translation>
    </message>
    <message>
        <source>Time to touchdown</source>
        <translation>Zeit bis zum Aufsetzen</translation>
    </message>
    <message>
        <source>From here to touchdown</source>
        <translation>Von hier bis zum Aufsetzen</translation>
    </message>
    <message>
        <source>If this runway were closed</source>
        <translation>Wenn diese Piste gesperrt wäre</translation>
    </message>
    <message>
        <source>Next-best runways</source>
        <translation>Nächstbeste Pisten</translation>
    </message>
    <message>
        <source>only around terrain</source>
        <translation>nur um Gelände herum</translation>
    </message>
    <message>
        <source>Previous decision point</source>
        <translation>Voriger Entscheidungspunkt</translation>
    </message>
    <message>
        <source>Point of the tour</source>
        <translation>Punkt der Tour</translation>
    </message>
    <message>
        <source>Next decision point</source>
        <translation>Nächster Entscheidungspunkt</translation>
    </message>
    <message>
        <source>Fly along the tour</source>
        <translation>Die Tour abfliegen</translation>
    </message>
    <message>
        <source>Worst point</source>
        <translation>Schlechteste Stelle</translation>
    </message>
    <message>
        <source>Go to the point with the least glide margin</source>
        <translation>Zum Punkt mit der kleinsten Gleitreserve gehen</translation>
    </message>
    <message>
        <source>Plan a tour, then choose a point of it to see the glide that would be flown if the engine stopped there.</source>
        <translation>Eine Tour planen, dann einen ihrer Punkte wählen, um den Gleitweg zu sehen, der bei einem Motorausfall dort geflogen würde.</translation>
    </message>
    <message>
        <source>No point chosen</source>
        <translation>Kein Punkt gewählt</translation>
    </message>
    <message>
        <source>Move along the tour on the map, in the profile or with the slider below.</source>
        <translation>Auf der Karte, im Profil oder mit dem Schieber unten entlang der Tour fahren.</translation>
    </message>
    <message>
        <source>Comparing other runways.</source>
        <translation>Andere Pisten werden verglichen.</translation>
    </message>
    <message>
        <source>No glide is known from here</source>
        <translation>Von hier ist kein Gleitweg bekannt</translation>
    </message>
    <message>
        <source>not reachable</source>
        <translation>nicht erreichbar</translation>
    </message>
    <message>
        <source>%1 after %2</source>
        <translation>%1 nach %2</translation>
    </message>
    <message>
        <source>unknown: the glide crosses ground without data</source>
        <translation>unbekannt: der Gleitweg quert Boden ohne Daten</translation>
    </message>
    <message>
        <source>%1 to lose by circling</source>
        <translation>%1 durch Kreisen abzubauen</translation>
    </message>
    <message>
        <source>nothing to spare</source>
        <translation>nichts übrig</translation>
    </message>
    <message>
        <source>The runways have changed since this plan was made; plan again to compare them.</source>
        <translation>Die Pisten haben sich geändert, seit dieser Plan gemacht wurde; neu planen, um sie zu vergleichen.</translation>
    </message>
    <message>
        <source>If %1 were closed: no other runway has a glide from here.</source>
        <translation>Wäre %1 gesperrt: zu keiner anderen Piste führt von hier ein Gleitweg.</translation>
    </message>
    <message>
        <source>If %1 were closed: still %2 to %3.</source>
        <translation>Wäre %1 gesperrt: noch %2 bis %3.</translation>
    </message>
    <message>
        <source>If %1 were closed: %2 missing to the next best, %3.</source>
        <translation>Wäre %1 gesperrt: %2 fehlen bis zur nächstbesten, %3.</translation>
    </message>
</context>
<context>
    <name>vp::panels::GlidePicture</name>
    <message>
        <source>Profile of the glide</source>
        <translation>Profil des Gleitwegs</translation>
    </message>
</context>
<context>
    <name>vp::panels::LandingAnswers</name>
    <message>
        <source>Answers of the planners</source>
        <translation>Antworten der Planungsverfahren</translation>
    </message>
    <message>
        <source>Planners</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Runways</source>
        <translation>Pisten</translation>
    </message>
    <message>
        <source>Terms of the answers, side by side</source>
        <translation>Anteile der Antworten, nebeneinander</translation>
    </message>
    <message>
        <source>Terms</source>
        <translation>Anteile</translation>
    </message>
    <message>
        <source>Every runway by total risk: the way there, its length and surface, wind, people under the approach</source>
        <translation>Jede Piste nach Gesamtrisiko: der Weg dorthin, ihre Länge und Oberfläche, Wind, Menschen unter dem Anflug</translation>
    </message>
    <message>
        <source>Runways by total risk</source>
        <translation>Pisten nach Gesamtrisiko</translation>
    </message>
    <message>
        <source>Why this runway stands where it does</source>
        <translation>Warum diese Piste dort steht, wo sie steht</translation>
    </message>
    <message>
        <source>Comes after the planners&apos; answers.</source>
        <translation>Kommt nach den Antworten der Verfahren.</translation>
    </message>
    <message>
        <source>Not ranked: planning was stopped before, or no way can be asked for.</source>
        <translation>Nicht gereiht: die Planung wurde vorher angehalten, oder es kann kein Weg erfragt werden.</translation>
    </message>
</context>
<context>
    <name>vp::panels::LandingModel</name>
    <message>
        <source>no runway</source>
        <translation>keine Piste</translation>
    </message>
    <message>
        <source>not a runway</source>
        <translation>keine Landebahn</translation>
    </message>
    <message>
        <source>checked</source>
        <translation>geprüft</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>nicht geprüft</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Runway</source>
        <translation>Piste</translation>
    </message>
    <message>
        <source>In hand</source>
        <translation>Übrig</translation>
    </message>
    <message>
        <source>Weather</source>
        <translation>Wetter</translation>
    </message>
    <message>
        <source>Glide</source>
        <translation>Gleitweg</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>Tiefster</translation>
    </message>
</context>
<context>
    <name>vp::panels::LandingPanel</name>
    <message>
        <source>Landing now</source>
        <translation>Sofortlandung</translation>
    </message>
    <message>
        <source>What this landing is</source>
        <translation>Was für eine Landung das ist</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Each general planner; where there is weather, also the two that keep out of it best</source>
        <translation>Jedes allgemeine Verfahren; bei Wetter auch die zwei, die es am besten meiden</translation>
    </message>
    <message>
        <source>All %1, side by side</source>
        <translation>Alle %1, nebeneinander</translation>
    </message>
    <message>
        <source>Weather: %1</source>
        <translation>Wetter: %1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Course over ground</source>
        <translation>Kurs über Grund</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Time for each</source>
        <translation>Zeit für jedes</translation>
    </message>
    <message>
        <source>Right-click a place on the map, or a point of the tour, and choose &quot;Engine out here&quot; to see where the aircraft can land from there, at any altitude and on any course.</source>
        <translation>Rechtsklick auf einen Ort der Karte oder einen Punkt der Tour und „Motorausfall hier“ wählen, um zu sehen, wo das Flugzeug von dort landen kann, aus jeder Höhe und auf jedem Kurs.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>over ground of unknown height</source>
        <translation>über Boden unbekannter Höhe</translation>
    </message>
    <message>
        <source>Looking for a way down.</source>
        <translation>Ein Weg hinab wird gesucht.</translation>
    </message>
    <message>
        <source>No planner has been asked.</source>
        <translation>Kein Verfahren wurde gefragt.</translation>
    </message>
    <message>
        <source>%1: %2 in hand at the beginning of the approach.</source>
        <translation>%1: %2 übrig zu Beginn des Anflugs.</translation>
    </message>
    <message>
        <source>Comes through the weather with a probability of %1.</source>
        <translation>Kommt mit einer Wahrscheinlichkeit von %1 durch das Wetter.</translation>
    </message>
    <message>
        <source>Keeps out of the weather.</source>
        <translation>Meidet das Wetter.</translation>
    </message>
    <message>
        <source>The checker has not confirmed this path: do not rely on it.</source>
        <translation>Die Prüfung hat diesen Weg nicht bestätigt: nicht darauf verlassen.</translation>
    </message>
    <message>
        <source>NOT A RUNWAY: the best that can be had is %1 of glide over ground that stays clear.</source>
        <translation>KEINE PISTE: das Beste, was zu haben ist, sind %1 Gleitweg über freiem Boden.</translation>
    </message>
    <message>
        <source>%1 of height are missing.</source>
        <translation>%1 Höhe fehlen.</translation>
    </message>
</context>
<context>
    <name>vp::panels::PlanSummaryPanel</name>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Altitudes</source>
        <translation>Höhen</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Kosten</translation>
    </message>
    <message>
        <source>Could be shorter by</source>
        <translation>Könnte kürzer sein um</translation>
    </message>
    <message>
        <source>Checked</source>
        <translation>Geprüft</translation>
    </message>
    <message>
        <source>Least margins</source>
        <translation>Kleinste Reserven</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Reserve</translation>
    </message>
    <message>
        <source>Warnings and findings</source>
        <translation>Warnungen und Befunde</translation>
    </message>
    <message>
        <source>No plan yet</source>
        <translation>Noch kein Plan</translation>
    </message>
    <message>
        <source>Load terrain and airports, mark targets, then plan the tour.</source>
        <translation>Gelände und Flugplätze laden, Ziele setzen, dann die Tour planen.</translation>
    </message>
    <message>
        <source>VERIFIED</source>
        <translation>GEPRÜFT</translation>
    </message>
    <message>
        <source>UNVERIFIED</source>
        <translation>UNGEPRÜFT</translation>
    </message>
    <message>
        <source>The checker has not confirmed that a runway can be reached from every point. Do not fly this plan.</source>
        <translation>Die Prüfung hat nicht bestätigt, dass von jedem Punkt aus eine Piste erreichbar ist. Diesen Plan nicht fliegen.</translation>
    </message>
    <message>
        <source>OUT OF DATE</source>
        <translation>VERALTET</translation>
    </message>
    <message>
        <source>An input has changed since this plan was made. Plan again, or undo the change. The figures below are those of the old plan.</source>
        <translation>Eine Eingabe hat sich geändert, seit dieser Plan gemacht wurde. Neu planen oder die Änderung rückgängig machen. Die Zahlen unten sind die des alten Plans.</translation>
    </message>
    <message>
        <source>%1, %2 over ground</source>
        <translation>%1, %2 über Grund</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1, of which %2 for passing above targets</source>
        <translation>%1, davon %2 für den Überflug über Zielen</translation>
    </message>
    <message>
        <source>nothing: proved best over these headings and glides</source>
        <translation>nichts: bewiesen die beste über diese Kurse und Gleitwege</translation>
    </message>
    <message>
        <source>refined: %1 % below the tour over sampled headings, which need at least %2</source>
        <translation>verfeinert: %1 % unter der Tour über gewählte Kurse, die mindestens %2 braucht</translation>
    </message>
    <message>
        <source>at most %1 %, at least %2 is needed</source>
        <translation>höchstens %1 %, mindestens %2 ist nötig</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>%1; at most %2 % above the best of all safe tours</source>
        <translation>%1; höchstens %2 % über der besten aller sicheren Touren</translation>
    </message>
    <message>
        <source>%1 points, %2 glides</source>
        <translation>%1 Punkte, %2 Gleitwege</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>%1: %2 at %3. Click to go there.</source>
        <translation>%1: %2 bei %3. Ein Klick geht dorthin.</translation>
    </message>
    <message>
        <source>Why the plan was refused</source>
        <translation>Warum der Plan abgelehnt wurde</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
</context>
<context>
    <name>vp::panels::RankingLinesModel</name>
    <message>
        <source>%1%2 %</source>
        <translation>%1%2 %</translation>
    </message>
    <message>
        <source>Costs</source>
        <translation>Kostet</translation>
    </message>
    <message>
        <source>Because</source>
        <translation>Weil</translation>
    </message>
</context>
<context>
    <name>vp::panels::RankingModel</name>
    <message>
        <source>not reached</source>
        <translation>nicht erreicht</translation>
    </message>
    <message>
        <source>%1. %2, %3</source>
        <translation>%1. %2, %3</translation>
    </message>
    <message>
        <source>How likely way and landing go well, all lines below together; to compare runways, not to fly by</source>
        <translation>Wie wahrscheinlich Weg und Landung gut gehen, alle Zeilen unten zusammen; um Pisten zu vergleichen, nicht um danach zu fliegen</translation>
    </message>
    <message>
        <source>Runway</source>
        <translation>Piste</translation>
    </message>
    <message>
        <source>Goes well</source>
        <translation>Geht gut</translation>
    </message>
    <message>
        <source>In hand</source>
        <translation>Übrig</translation>
    </message>
    <message>
        <source>Glide</source>
        <translation>Gleitweg</translation>
    </message>
</context>
<context>
    <name>vp::panels::SiteModel</name>
    <message>
        <source>excluded</source>
        <translation>ausgeschlossen</translation>
    </message>
    <message>
        <source>left out by the filter</source>
        <translation>vom Filter weggelassen</translation>
    </message>
    <message>
        <source>estimated: %1</source>
        <translation>geschätzt: %1</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>lit</source>
        <translation>befeuert</translation>
    </message>
    <message>
        <source>one way</source>
        <translation>eine Richtung</translation>
    </message>
    <message>
        <source>Use runway</source>
        <translation>Piste verwenden</translation>
    </message>
    <message>
        <source>Airport</source>
        <translation>Flugplatz</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Platzhöhe</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Entfernung</translation>
    </message>
    <message>
        <source>This way only</source>
        <translation>Nur diese Richtung</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
</context>
<context>
    <name>vp::panels::SitePanel</name>
    <message>
        <source>Runways</source>
        <translation>Pisten</translation>
    </message>
    <message>
        <source>Find a runway or airport</source>
        <translation>Piste oder Flugplatz suchen</translation>
    </message>
    <message>
        <source>unknown surface</source>
        <translation>Oberfläche unbekannt</translation>
    </message>
    <message>
        <source>lit</source>
        <translation>befeuert</translation>
    </message>
    <message>
        <source>Notes on the airfields</source>
        <translation>Hinweise zu den Flugplätzen</translation>
    </message>
    <message>
        <source>No runways yet: load airfields</source>
        <translation>Noch keine Pisten: Flugplätze laden</translation>
    </message>
    <message>
        <source>%1 of %2 used</source>
        <translation>%1 von %2 verwendet</translation>
    </message>
    <message>
        <source>%1 found</source>
        <translation>%1 gefunden</translation>
    </message>
</context>
<context>
    <name>vp::panels::SiteRules</name>
    <message>
        <source>&amp;Shortest runway</source>
        <translation>&amp;Kürzeste Piste</translation>
    </message>
    <message>
        <source>any length</source>
        <translation>jede Länge</translation>
    </message>
    <message>
        <source>Shortest runway that is used</source>
        <translation>Kürzeste Piste, die verwendet wird</translation>
    </message>
    <message>
        <source>&amp;Narrowest runway</source>
        <translation>&amp;Schmalste Piste</translation>
    </message>
    <message>
        <source>any width</source>
        <translation>jede Breite</translation>
    </message>
    <message>
        <source>Narrowest runway that is used</source>
        <translation>Schmalste Piste, die verwendet wird</translation>
    </message>
    <message>
        <source>Within, of a tar&amp;get</source>
        <translation>Im &amp;Umkreis eines Ziels</translation>
    </message>
    <message>
        <source>any distance</source>
        <translation>jede Entfernung</translation>
    </message>
    <message>
        <source>Longest distance of a runway from the nearest target</source>
        <translation>Größte Entfernung einer Piste vom nächsten Ziel</translation>
    </message>
    <message>
        <source>S&amp;urfaces</source>
        <translation>&amp;Oberflächen</translation>
    </message>
    <message>
        <source>Use runways whose position is &amp;estimated</source>
        <translation>Pisten mit g&amp;eschätzter Lage</translation>
    </message>
    <message>
        <source>Use &amp;closed runways</source>
        <translation>&amp;Gesperrte Pisten</translation>
    </message>
    <message>
        <source>Use &amp;water</source>
        <translation>&amp;Wasser</translation>
    </message>
    <message>
        <source>&amp;Lighted runways only</source>
        <translation>Nur &amp;befeuerte Pisten</translation>
    </message>
    <message>
        <source>Surfaces that may be landed on</source>
        <translation>Oberflächen, auf denen gelandet werden darf</translation>
    </message>
    <message>
        <source>any surface</source>
        <translation>jede Oberfläche</translation>
    </message>
</context>
<context>
    <name>vp::panels::TargetDelegate</name>
    <message>
        <source>Height of the target</source>
        <translation>Höhe des Ziels</translation>
    </message>
    <message>
        <source>Datum of the height</source>
        <translation>Bezug der Höhe</translation>
    </message>
</context>
<context>
    <name>vp::panels::TargetModel</name>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>A target needs a name.</source>
        <translation>Ein Ziel braucht einen Namen.</translation>
    </message>
    <message>
        <source>There is a target %1 already; give another name.</source>
        <translation>Ein Ziel %1 gibt es schon; einen anderen Namen geben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no position. Write for example 46°36.02′ N 009°54.10′ E or 46.6003, 9.9017.</source>
        <translation>„%1“ ist keine Position. Zum Beispiel 46°36.02′ N 009°54.10′ E oder 46.6003, 9.9017 schreiben.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Über</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Höhe MSL</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
</context>
<context>
    <name>vp::panels::TargetPanel</name>
    <message>
        <source>Targets</source>
        <translation>Ziele</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Move target up (Ctrl+Up)</source>
        <translation>Ziel nach oben (Strg+Auf)</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Ab</translation>
    </message>
    <message>
        <source>Move target down (Ctrl+Down)</source>
        <translation>Ziel nach unten (Strg+Ab)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove target (Del)</source>
        <translation>Ziel entfernen (Entf)</translation>
    </message>
    <message>
        <source>No targets yet. Click on the map with the target tool to add one.</source>
        <translation>Noch keine Ziele. Mit dem Zielwerkzeug auf die Karte klicken, um eines hinzuzufügen.</translation>
    </message>
    <message>
        <source>One target cannot be planned; its row says why.</source>
        <translation>Ein Ziel kann nicht geplant werden; seine Zeile sagt, warum.</translation>
    </message>
    <message>
        <source>%1 targets cannot be planned; their rows say why.</source>
        <translation>%1 Ziele können nicht geplant werden; ihre Zeilen sagen, warum.</translation>
    </message>
</context>
<context>
    <name>vp::panels::TermsModel</name>
    <message>
        <source>This planner does not tell it.</source>
        <translation>Dieses Verfahren sagt es nicht.</translation>
    </message>
    <message>
        <source>%1, kept low by this planner</source>
        <translation>%1, von diesem Verfahren klein gehalten</translation>
    </message>
    <message>
        <source>Term</source>
        <translation>Anteil</translation>
    </message>
</context>
<context>
    <name>vp::profile::ProfileView</name>
    <message>
        <source>Altitude profile of the tour</source>
        <translation>Höhenprofil der Tour</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Entfernung</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Above ground</source>
        <translation>Über Grund</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Safe altitude</source>
        <translation>Sicherheitshöhe</translation>
    </message>
    <message>
        <source>none known</source>
        <translation>keine bekannt</translation>
    </message>
    <message>
        <source>Glide margin</source>
        <translation>Gleitreserve</translation>
    </message>
    <message>
        <source>no glide</source>
        <translation>kein Gleitweg</translation>
    </message>
    <message>
        <source>Glide to</source>
        <translation>Gleitweg zu</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Wind</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
</context>
<context>
    <name>vp::scene3d::GlSceneWidget</name>
    <message>
        <source>The 3D view failed: %1</source>
        <translation>Die 3D-Ansicht ist ausgefallen: %1</translation>
    </message>
</context>
<context>
    <name>vp::scene3d::ImageSceneWidget</name>
    <message>
        <source>There is no 3D view on this machine:
%1.
Map and profile show the same flight.</source>
        <translation>Auf diesem Rechner gibt es keine 3D-Ansicht:
%1.
Karte und Profil zeigen denselben Flug.</translation>
    </message>
    <message>
        <source>There is no 3D view: OpenGL could not draw a picture of this size.</source>
        <translation>Es gibt keine 3D-Ansicht: OpenGL konnte kein Bild dieser Größe zeichnen.</translation>
    </message>
</context>
<context>
    <name>vp::scene3d::SceneData</name>
    <message>
        <source>no terrain here</source>
        <translation>kein Gelände hier</translation>
    </message>
    <message>
        <source>glide %1</source>
        <translation>Gleitweg %1</translation>
    </message>
</context>
<context>
    <name>vp::scene3d::SceneOverlay</name>
    <message>
        <source>Turn the view north</source>
        <translation>Ansicht nach Norden drehen</translation>
    </message>
    <message>
        <source>Compass</source>
        <translation>Kompass</translation>
    </message>
    <message>
        <source>Wind that the plan holds for</source>
        <translation>Wind, für den der Plan gilt</translation>
    </message>
    <message>
        <source>Colours of altitudes</source>
        <translation>Farben der Höhen</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Contours %1</source>
        <translation>Höhenlinien %1</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Heights drawn %1×</source>
        <translation>Höhen %1× gezeichnet</translation>
    </message>
</context>
<context>
    <name>vp::scene3d::SceneToolBar</name>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>From straight above, north up (1)</source>
        <translation>Senkrecht von oben, Norden oben (1)</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Norden</translation>
    </message>
    <message>
        <source>All of the tour, looking north (2)</source>
        <translation>Die ganze Tour, Blick nach Norden (2)</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Entlang</translation>
    </message>
    <message>
        <source>Behind the aircraft, along the tour (3)</source>
        <translation>Hinter dem Flugzeug, entlang der Tour (3)</translation>
    </message>
    <message>
        <source>Runway</source>
        <translation>Piste</translation>
    </message>
    <message>
        <source>From the runway, towards where the glide comes from (4)</source>
        <translation>Von der Piste, dorthin, woher der Gleitweg kommt (4)</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Keep the chosen point of the tour in the middle (F)</source>
        <translation>Den gewählten Punkt der Tour in der Mitte halten (F)</translation>
    </message>
    <message>
        <source>Fly</source>
        <translation>Fliegen</translation>
    </message>
    <message>
        <source>Fly along the tour; Esc ends it</source>
        <translation>Die Tour abfliegen; Esc beendet es</translation>
    </message>
    <message>
        <source>Speed of the flight, times that of the aircraft</source>
        <translation>Geschwindigkeit des Flugs, als Vielfaches jener des Flugzeugs</translation>
    </message>
    <message>
        <source>%1× speed</source>
        <translation>%1× schnell</translation>
    </message>
    <message>
        <source>Curtain</source>
        <translation>Vorhang</translation>
    </message>
    <message>
        <source>Surface between the tour and the ground, coloured by altitude</source>
        <translation>Fläche zwischen Tour und Boden, nach Höhe gefärbt</translation>
    </message>
    <message>
        <source>All glides</source>
        <translation>Alle Gleitwege</translation>
    </message>
    <message>
        <source>The glide of every decision point, coloured by altitude</source>
        <translation>Der Gleitweg jedes Entscheidungspunkts, nach Höhe gefärbt</translation>
    </message>
    <message>
        <source>How much larger heights are drawn than distances</source>
        <translation>Wie viel größer Höhen gezeichnet werden als Entfernungen</translation>
    </message>
    <message>
        <source>Heights %1×</source>
        <translation>Höhen %1×</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>More of the 3D view&apos;s controls</source>
        <translation>Mehr Bedienelemente der 3D-Ansicht</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
</context>
<context>
    <name>vp::scene3d::SceneView</name>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Terrain, tour and glides in three dimensions. Space shows all, keys 1 to 4 change the view.</source>
        <translation>Gelände, Tour und Gleitwege in drei Dimensionen. Leertaste zeigt alles, Tasten 1 bis 4 ändern die Ansicht.</translation>
    </message>
    <message>
        <source>No terrain yet.
Add a terrain file to see it in three dimensions.</source>
        <translation>Noch kein Gelände.
Eine Geländedatei hinzufügen, um es in drei Dimensionen zu sehen.</translation>
    </message>
    <message>
        <source>This terrain is too small to be drawn.</source>
        <translation>Dieses Gelände ist zu klein zum Zeichnen.</translation>
    </message>
    <message>
        <source>Preparing the terrain…</source>
        <translation>Das Gelände wird vorbereitet…</translation>
    </message>
</context>
<context>
    <name>vp::style::WindFigure</name>
    <message>
        <source>from anywhere</source>
        <comment>wind</comment>
        <translation>aus jeder Richtung</translation>
    </message>
    <message>
        <source>still air</source>
        <translation>ruhige Luft</translation>
    </message>
</context>
</TS>
