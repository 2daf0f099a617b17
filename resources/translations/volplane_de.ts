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
