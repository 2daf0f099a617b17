<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="cs" sourcelanguage="en">
<context>
    <name>Briefing</name>
    <message>
        <source>d MMM yyyy</source>
        <comment>date, as QDate::toString takes it</comment>
        <translation>d. M. yyyy</translation>
    </message>
    <message>
        <source>, %1 kg</source>
        <translation>, %1 kg</translation>
    </message>
    <message>
        <source>NOT ENOUGH: %1</source>
        <translation>NESTAČÍ: %1</translation>
    </message>
    <message>
        <source>%1 TAS, glide ratio %2 straight ahead (%3 down, %4); polar: drag coefficient %5 + %6 × lift coefficient², wing %7 m², air %8 kg/m³</source>
        <translation>%1 TAS, klouzavost %2 přímo (úhel %3, %4); polára: součinitel odporu %5 + %6 × součinitel vztlaku², křídlo %7 m², vzduch %8 kg/m³</translation>
    </message>
    <message>
        <source>%1 in still air and %2 over ground against the strongest wind,</source>
        <translation>%1 v klidném vzduchu a %2 nad zemí proti nejsilnějšímu větru,</translation>
    </message>
    <message>
        <source>%1° of bank: radius %2, a half turn loses %3</source>
        <translation>náklon %1°: poloměr %2, polovina kruhu stojí %3</translation>
    </message>
    <message>
        <source>at most %1° of bank: radius over ground %2, a half turn loses up to %3</source>
        <translation>náklon nejvýše %1°: poloměr nad zemí %2, polovina kruhu stojí až %3</translation>
    </message>
    <message>
        <source>none set</source>
        <translation>není nastaven</translation>
    </message>
    <message>
        <source>calm assumed: wind, up- and downdrafts are not in the figures</source>
        <translation>předpokládá se bezvětří: vítr, stoupavé a klesavé proudy v číslech nejsou</translation>
    </message>
    <message>
        <source>%1 (directions true). The glides hold in every such wind with the track over ground kept; up- and downdrafts are not in the figures</source>
        <translation>%1 (směry zeměpisné). Klouzání platí při každém takovém větru, pokud se dodrží trať nad zemí; stoupavé a klesavé proudy v číslech nejsou</translation>
    </message>
    <message>
        <source>Calm air. A headwind on the glide, or sinking air, costs height that is nowhere in the figures. With wind, keep more height or do not rely on this plan.</source>
        <translation>Bezvětří. Protivítr při klouzání nebo klesající vzduch stojí výšku, která v žádném čísle není. Za větru držte větší výšku, nebo se na tento plán nespoléhejte.</translation>
    </message>
    <message>
        <source>The glides hold in %1, if the track over ground is kept by crabbing and by banking with the ground speed. Stronger wind, wind from elsewhere, gusts and sinking air cost height that is nowhere in the figures.</source>
        <translation>Klouzání platí za %1, pokud se trať nad zemí dodrží snosem a náklonem podle rychlosti vůči zemi. Silnější vítr, vítr z jiného směru, poryvy a klesající vzduch stojí výšku, která v žádném čísle není.</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Trasa</translation>
    </message>
    <message>
        <source>%1 targets, %2, %3 at %7 in %6, between %4 and %5</source>
        <translation>%1 cílů, %2, %3 při %7 za %6, ve výškách %4 až %5</translation>
    </message>
    <message>
        <source>calm air</source>
        <translation>bezvětří</translation>
    </message>
    <message>
        <source>the middle of the forecast wind</source>
        <translation>středního předpovězeného větru</translation>
    </message>
    <message>
        <source>%1 TAS</source>
        <translation>%1 TAS</translation>
    </message>
    <message>
        <source>the glide speed</source>
        <translation>rychlosti klouzání</translation>
    </message>
    <message>
        <source>Flight</source>
        <translation>Let</translation>
    </message>
    <message>
        <source>Aircraft</source>
        <translation>Letadlo</translation>
    </message>
    <message>
        <source>Best glide</source>
        <translation>Nejlepší klouzání</translation>
    </message>
    <message>
        <source>Glide turns</source>
        <translation>Zatáčky v klouzání</translation>
    </message>
    <message>
        <source>Tour limits</source>
        <translation>Meze trasy</translation>
    </message>
    <message>
        <source>%1° of bank (radius %2), climb %3°, descent %4°</source>
        <translation>náklon %1° (poloměr %2), stoupání %3°, klesání %4°</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Domov</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vítr</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Odstup od terénu</translation>
    </message>
    <message>
        <source>%1 above the ground on tour and glides, what the glide model leaves out included</source>
        <translation>%1 nad terénem na trase i při klouzání, včetně toho, co model klouzání vynechává</translation>
    </message>
    <message>
        <source>On arrival</source>
        <translation>Při příletu</translation>
    </message>
    <message>
        <source>at least %1 above the runway</source>
        <translation>nejméně %1 nad dráhou</translation>
    </message>
    <message>
        <source>Ceiling</source>
        <translation>Strop</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Vytvořil</translation>
    </message>
    <message>
        <source>plan: %1; briefing: %2</source>
        <translation>plán: %1; briefing: %2</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Zdroje</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Soubor</translation>
    </message>
    <message>
        <source>Last changed</source>
        <translation>Poslední změna</translation>
    </message>
    <message>
        <source>SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>not here</source>
        <translation>není zde</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>není známo</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Terén</translation>
    </message>
    <message>
        <source>Airfields</source>
        <translation>Letiště</translation>
    </message>
    <message>
        <source>now: </source>
        <translation>nyní: </translation>
    </message>
    <message>
        <source>in the mission itself</source>
        <translation>v misi samotné</translation>
    </message>
    <message>
        <source>Terrain is used in cells of %1 m, each with the highest ground inside it. Runways are as the plan holds them; check them against current publications.</source>
        <translation>Terén se používá v buňkách po %1 m, každá s nejvyšším místem v ní. Dráhy jsou podle plánu; porovnejte je s platnými publikacemi.</translation>
    </message>
    <message>
        <source>VERIFIED SAFE</source>
        <translation>OVĚŘENO, BEZPEČNÉ</translation>
    </message>
    <message>
        <source>UNVERIFIED – DO NOT FLY</source>
        <translation>NEOVĚŘENO – NELÉTEJTE</translation>
    </message>
    <message>
        <source>The independent checker refused this plan: %1 findings, listed below. No one has shown that a glide to a runway exists from every point of it, and the figures in this briefing may be wrong.</source>
        <translation>Nezávislá kontrola tento plán odmítla: %1 nálezů, viz níže. Nikdo neukázal, že z každého bodu lze doklouzat na dráhu, a čísla v tomto briefingu mohou být chybná.</translation>
    </message>
    <message>
        <source>Tour above ground and clearance</source>
        <translation>Trasa nad terénem a odstupem</translation>
    </message>
    <message>
        <source>Tour above what the glides need</source>
        <translation>Trasa nad tím, co klouzání potřebuje</translation>
    </message>
    <message>
        <source>Glides above ground and clearance</source>
        <translation>Klouzání nad terénem a odstupem</translation>
    </message>
    <message>
        <source>Glides above ground less what rolling may cost</source>
        <translation>Klouzání nad terénem po odečtení ceny překlápění</translation>
    </message>
    <message>
        <source>Glides above what is asked for on arrival</source>
        <translation>Klouzání nad tím, co se žádá při příletu</translation>
    </message>
    <message>
        <source>Climb below the steepest allowed</source>
        <translation>Stoupání pod nejstrmějším dovoleným</translation>
    </message>
    <message>
        <source>Descent below the steepest allowed</source>
        <translation>Klesání pod nejstrmějším dovoleným</translation>
    </message>
    <message>
        <source>Tour below the ceiling</source>
        <translation>Trasa pod stropem</translation>
    </message>
    <message>
        <source>Tour above the targets</source>
        <translation>Trasa nad cíli</translation>
    </message>
    <message>
        <source>Spirals above ground and clearance</source>
        <translation>Spirály nad terénem a odstupem</translation>
    </message>
    <message>
        <source>Least margins of the whole plan</source>
        <translation>Nejmenší rezervy celého plánu</translation>
    </message>
    <message>
        <source>As the independent checker found them: what is left beyond the requirement.</source>
        <translation>Jak je zjistila nezávislá kontrola: co zbývá nad požadavek.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Co</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Rezerva</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Kde</translation>
    </message>
    <message>
        <source>whole plan</source>
        <translation>celý plán</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>v %1</translation>
    </message>
    <message>
        <source>leg %1→%2, %3</source>
        <translation>úsek %1→%2, %3</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Nálezy</translation>
    </message>
    <message>
        <source>What the checker wants a pilot to know; in its own words, heights in metres.</source>
        <translation>Co má pilot podle kontroly vědět; jejími slovy (anglicky), výšky v metrech.</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Závažnost</translation>
    </message>
    <message>
        <source>VIOLATED</source>
        <translation>PORUŠENO</translation>
    </message>
    <message>
        <source>UNKNOWN</source>
        <translation>NEZNÁMO</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Varování</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Poznámka</translation>
    </message>
    <message>
        <source>Airspaces</source>
        <translation>Vzdušné prostory</translation>
    </message>
    <message>
        <source>Those near the tour that the mission keeps the tour out of or warns of. A glide after an engine failure may enter any of them.</source>
        <translation>Prostory poblíž trasy, kterým se trasa podle mise vyhýbá nebo před nimiž mise varuje. Klouzání po vysazení motoru může vést kterýmkoli z nich.</translation>
    </message>
    <message>
        <source>Airspace</source>
        <translation>Vzdušný prostor</translation>
    </message>
    <message>
        <source>Ceiling / floor</source>
        <translation>Horní / dolní mez</translation>
    </message>
    <message>
        <source>The tour</source>
        <translation>Trasa</translation>
    </message>
    <message>
        <source>keeps out</source>
        <translation>zůstává mimo</translation>
    </message>
    <message>
        <source>may enter; a warning</source>
        <translation>smí vletět; varování</translation>
    </message>
    <message>
        <source>Magnetic tracks are true tracks corrected by the %1, for %2; iron in the ground and in the aircraft comes on top.</source>
        <translation>Magnetické kurzy jsou zeměpisné kurzy opravené podle %1, pro %2; k tomu přistupuje železo v zemi a v letadle.</translation>
    </message>
    <message>
        <source>The magnetic model is not made for this date: its rates were carried on, so expect errors of some degrees.</source>
        <translation>Magnetický model není pro toto datum vytvořen: jeho změny byly prodlouženy, počítejte s chybou několika stupňů.</translation>
    </message>
    <message>
        <source>So near a magnetic pole compasses are unreliable: fly true tracks. Where no magnetic track is given, a compass is of no use at all.</source>
        <translation>Tak blízko magnetického pólu jsou kompasy nespolehlivé: leťte zeměpisné kurzy. Kde magnetický kurz není uveden, je kompas k ničemu.</translation>
    </message>
    <message>
        <source>A simulated Cessna 172 that flew such glides ended up to %1 lower at 30° of bank and %2 at 45°: that part of the clearance is spoken for. A worse polar than the one on the first page (propeller windmilling, dirty wing, flaps, wrong speed) costs more: 35 % more sink ended up to %3 lower per %4 of glide.</source>
        <translation>Simulovaná Cessna 172, která takto klouzala, skončila při náklonu 30° až o %1 níže a při 45° až o %2: tato část odstupu je již vyčerpána. Horší polára než na první straně (točící se vrtule, znečištěné křídlo, klapky, nesprávná rychlost) stojí více: o 35 % větší klesání skončilo až o %3 níže na %4 klouzání.</translation>
    </message>
    <message>
        <source>Between two decision points the aircraft first glides on along the tour to the next one, then turns for the runway: at most %1 further.</source>
        <translation>Mezi dvěma rozhodovacími body letadlo nejprve klouže po trase k dalšímu a pak zatočí k dráze: nejvýše o %1 dále.</translation>
    </message>
    <message>
        <source>Ground is the highest of each terrain cell, from the file named on the first page. Masts, cables, trees, buildings and errors of that file are in it only if the file has them.</source>
        <translation>Terén je nejvyšší místo každé buňky ze souboru uvedeného na první straně. Stožáry, lana, stromy, budovy a chyby onoho souboru jsou v něm, jen když je soubor obsahuje.</translation>
    </message>
    <message>
        <source>Spirals down to low targets suspend the guarantee from the moment they are entered until the tour&apos;s altitude is reached again.</source>
        <translation>Spirály dolů k nízkým cílům záruku přerušují, od začátku spirály až do návratu do výšky trasy.</translation>
    </message>
    <message>
        <source>The pilot in command decides. This briefing replaces no official source.</source>
        <translation>Rozhoduje velitel letadla. Tento briefing nenahrazuje žádný úřední zdroj.</translation>
    </message>
    <message>
        <source>MSL</source>
        <translation>MSL</translation>
    </message>
    <message>
        <source>above mean sea level</source>
        <translation>nad střední hladinou moře</translation>
    </message>
    <message>
        <source>AGL</source>
        <translation>AGL</translation>
    </message>
    <message>
        <source>above ground level: the highest ground of the terrain cell below</source>
        <translation>nad zemí: nad nejvyšším místem buňky terénu pod letadlem</translation>
    </message>
    <message>
        <source>°T, °M</source>
        <translation>°T, °M</translation>
    </message>
    <message>
        <source>true and magnetic degrees; magnetic = true − east variation, + west variation</source>
        <translation>stupně zeměpisné (T) a magnetické (M); magnetický = zeměpisný − východní deklinace, + západní deklinace</translation>
    </message>
    <message>
        <source>Var.</source>
        <translation>Dekl.</translation>
    </message>
    <message>
        <source>magnetic variation, E east, W west</source>
        <translation>magnetická deklinace, E východní, W západní</translation>
    </message>
    <message>
        <source>TAS</source>
        <translation>TAS</translation>
    </message>
    <message>
        <source>true airspeed</source>
        <translation>pravá vzdušná rychlost</translation>
    </message>
    <message>
        <source>1→2</source>
        <translation>1→2</translation>
    </message>
    <message>
        <source>leg from target 1 to target 2</source>
        <translation>úsek od cíle 1 k cíli 2</translation>
    </message>
    <message>
        <source>Safe</source>
        <translation>Bezp.</translation>
    </message>
    <message>
        <source>lowest altitude from which the plan&apos;s glides work, on a whole leg</source>
        <translation>nejmenší výška, ze které je klouzání plánu možné, na celém úseku</translation>
    </message>
    <message>
        <source>height above the lowest from which the glide works</source>
        <translation>výška nad nejmenší, ze které je klouzání možné</translation>
    </message>
    <message>
        <source>Clear.</source>
        <translation>Odst.</translation>
    </message>
    <message>
        <source>clearance: height above the highest ground of the cells below</source>
        <translation>odstup: výška nad nejvyšším místem buněk terénu pod letadlem</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>the airfield file does not say</source>
        <translation>soubor letišť to neuvádí</translation>
    </message>
    <message>
        <source>out, in</source>
        <translation>tam, zpět</translation>
    </message>
    <message>
        <source>way from the home runway to the tour, way from the tour to the home runway</source>
        <translation>cesta z domovské dráhy na trasu, cesta z trasy na domovskou dráhu</translation>
    </message>
    <message>
        <source>Unnamed mission</source>
        <translation>Nepojmenovaná mise</translation>
    </message>
    <message>
        <source>briefing: terrain</source>
        <translation>briefing: terén</translation>
    </message>
    <message>
        <source>the plan is damaged and cannot be briefed: %1</source>
        <translation>plán je poškozen a briefing z něj nelze udělat: %1</translation>
    </message>
    <message>
        <source>start</source>
        <translation>start</translation>
    </message>
    <message>
        <source>all</source>
        <translation>vše</translation>
    </message>
    <message>
        <source>Runways that the glides lead to</source>
        <translation>Dráhy, na které vede klouzání</translation>
    </message>
    <message>
        <source>Letters as on the map, in the order in which the tour needs them. “Serves” is the length of tour from which the glides lead here. What is approximate stands under Findings.</source>
        <translation>Písmena jako na mapě, v pořadí, v jakém je trasa potřebuje. „Slouží“ je délka trasy, ze které klouzání vede sem. Co je jen přibližné, je uvedeno v nálezech.</translation>
    </message>
    <message>
        <source>Runway</source>
        <translation>Dráha</translation>
    </message>
    <message>
        <source>Airfield</source>
        <translation>Letiště</translation>
    </message>
    <message>
        <source>Elev.
%1 MSL</source>
        <translation>Výška
%1 MSL</translation>
    </message>
    <message>
        <source>Lands
°T</source>
        <translation>Přistává
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
        <translation>Délka
%1</translation>
    </message>
    <message>
        <source>Width
%1</source>
        <translation>Šířka
%1</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Povrch</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Světla</translation>
    </message>
    <message>
        <source>Serves
%1</source>
        <translation>Slouží
%1</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Poznámky</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ano</translation>
    </message>
    <message>
        <source>no</source>
        <translation>ne</translation>
    </message>
    <message>
        <source>approximate</source>
        <translation>přibližně</translation>
    </message>
    <message>
        <source>SPIRAL %1, turns down: %2 to %3, up: %4. NO GLIDE GUARANTEE inside it</source>
        <translation>SPIRÁLA %1, kruhy dolů: %2 až %3, nahoru: %4. V NÍ NENÍ ZÁRUKA DOKLOUZÁNÍ</translation>
    </message>
    <message>
        <source>left</source>
        <translation>vlevo</translation>
    </message>
    <message>
        <source>right</source>
        <translation>vpravo</translation>
    </message>
    <message>
        <source>Targets in the order of the tour</source>
        <translation>Cíle v pořadí trasy</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Č.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Cíl</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Poloha</translation>
    </message>
    <message>
        <source>Asked for</source>
        <translation>Žádáno</translation>
    </message>
    <message>
        <source>Passed at
%1 MSL</source>
        <translation>Přelet
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
        <translation>Nad
žádaným, %1</translation>
    </message>
    <message>
        <source>At
%1</source>
        <translation>V
%1</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>Úseky</translation>
    </message>
    <message>
        <source>Track: of the longest straight part; i: the leg is all turns, heading at its start. Time in %1. “Safe”: fly at or above it and the glides of the whole leg work; it is the highest that any point of the leg needs.</source>
        <translation>Kurz: nejdelší přímé části; i: úsek je samá zatáčka, kurz na jeho začátku. Čas za %1. „Bezp.“: v této výšce nebo nad ní platí klouzání z celého úseku; je to nejvyšší výška, kterou některý bod úseku potřebuje.</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Úsek</translation>
    </message>
    <message>
        <source>To target</source>
        <translation>K cíli</translation>
    </message>
    <message>
        <source>Track
°T</source>
        <translation>Kurz
°T</translation>
    </message>
    <message>
        <source>Dist.
%1</source>
        <translation>Vzdál.
%1</translation>
    </message>
    <message>
        <source>Time
min</source>
        <translation>Čas
min</translation>
    </message>
    <message>
        <source>Start
%1 MSL</source>
        <translation>Začátek
%1 MSL</translation>
    </message>
    <message>
        <source>Highest
%1 MSL</source>
        <translation>Nejvýše
%1 MSL</translation>
    </message>
    <message>
        <source>End
%1 MSL</source>
        <translation>Konec
%1 MSL</translation>
    </message>
    <message>
        <source>Least
%1 AGL</source>
        <translation>Nejméně
%1 AGL</translation>
    </message>
    <message>
        <source>Safe
%1 MSL</source>
        <translation>Bezp.
%1 MSL</translation>
    </message>
    <message>
        <source>Least
margin %1</source>
        <translation>Nejmenší
rezerva %1</translation>
    </message>
    <message>
        <source>at
%1</source>
        <translation>v
%1</translation>
    </message>
    <message>
        <source>tour</source>
        <translation>trasa</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>součet</translation>
    </message>
    <message>
        <source>sum, once around</source>
        <translation>součet, jedno kolo</translation>
    </message>
    <message>
        <source>out</source>
        <translation>tam</translation>
    </message>
    <message>
        <source>climb-out, NO GLIDE GUARANTEE</source>
        <translation>vzlet, BEZ ZÁRUKY DOKLOUZÁNÍ</translation>
    </message>
    <message>
        <source>the tour, on leg %1</source>
        <translation>trasa, na úseku %1</translation>
    </message>
    <message>
        <source>in</source>
        <translation>zpět</translation>
    </message>
    <message>
        <source>above %1, from leg %2</source>
        <translation>nad %1, z úseku %2</translation>
    </message>
    <message>
        <source>If the engine stops</source>
        <translation>Když vysadí motor</translation>
    </message>
    <message>
        <source>From every place on the stretch the glides lead to this runway end. Glide and time: shortest and longest, best-glide speed, %1, to the touchdown point without the spiral that loses height left over. Margin: least height above the lowest from which the glide works. Clearance: least above the ground on all glides of the row. Bold: the worst places, drawn further on: least margin, and among margins alike within a metre the longest glide.</source>
        <translation>Z každého místa úseku vede klouzání na tento konec dráhy. Klouzání a čas: nejkratší a nejdelší, rychlostí nejlepšího klouzání, %1, do bodu dotyku bez spirály, která ztrácí přebytečnou výšku. Rezerva: nejmenší výška nad nejmenší, ze které je klouzání možné. Odstup: nejmenší nad terénem při všech klouzáních řádku. Tučně: nejhorší místa, nakreslená dále: nejmenší rezerva, a při rezervách shodných na metr nejdelší klouzání.</translation>
    </message>
    <message>
        <source>the slowest wind of the forecast</source>
        <translation>nejpomalejší vítr předpovědi</translation>
    </message>
    <message>
        <source>“out” and “in”: the ways from and to the home runway; the stretches of “out” are counted from where the guarantee begins. Before that there is no glide to brief.</source>
        <translation>„tam“ a „zpět“: cesty z domovské dráhy a na ni; úseky „tam“ se počítají od místa, kde začíná záruka. Před ním není žádné klouzání k popisu.</translation>
    </message>
    <message>
        <source>Stretch
%1</source>
        <translation>Úsek
%1</translation>
    </message>
    <message>
        <source>Glide
%1</source>
        <translation>Klouzání
%1</translation>
    </message>
    <message>
        <source>Margin
%1</source>
        <translation>Rezerva
%1</translation>
    </message>
    <message>
        <source>Clear.
%1 AGL</source>
        <translation>Odst.
%1 AGL</translation>
    </message>
    <message>
        <source>Arrives
%1 above</source>
        <translation>Přílet
%1 nad</translation>
    </message>
    <message>
        <source>Worst place %1: leg %2, %3 from its start, to runway %4 (%5)</source>
        <translation>Nejhorší místo %1: úsek %2, %3 od jeho začátku, na dráhu %4 (%5)</translation>
    </message>
    <message>
        <source>glide</source>
        <translation>klouzání</translation>
    </message>
    <message>
        <source>least clearance</source>
        <translation>nejmenší odstup</translation>
    </message>
    <message>
        <source>arrives</source>
        <translation>přilétá</translation>
    </message>
    <message>
        <source>%1 above the runway</source>
        <translation>%1 nad dráhou</translation>
    </message>
    <message>
        <source>lands</source>
        <translation>přistává</translation>
    </message>
    <message>
        <source>%1° T, %2° M</source>
        <translation>%1° T, %2° M</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>výška dráhy</translation>
    </message>
    <message>
        <source>windmilling, turned by the air</source>
        <translation>protáčí se proudem vzduchu</translation>
    </message>
    <message>
        <source>stopped: the glides hold only if it is</source>
        <translation>stojí: klouzání platí, jen když stojí</translation>
    </message>
    <message>
        <source>%1; on that last part only above %2, where that is less than the clearance</source>
        <translation>%1; v této poslední části jen nad %2, kde je to méně než odstup</translation>
    </message>
    <message>
        <source>Masses</source>
        <translation>Hmotnosti</translation>
    </message>
    <message>
        <source>%1, each at its best glide speed, which goes with the root of the mass</source>
        <translation>%1, každá při své rychlosti nejlepšího klouzání, která roste s odmocninou hmotnosti</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Vzduch</translation>
    </message>
    <message>
        <source>Altimeter</source>
        <translation>Výškoměr</translation>
    </message>
    <message>
        <source>Reaction</source>
        <translation>Reakce</translation>
    </message>
    <message>
        <source>%1; the aircraft flies on meanwhile, then the glide is established</source>
        <translation>%1; letadlo mezitím letí dál, pak je klouzání ustáleno</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Odpor</translation>
    </message>
    <message>
        <source>%1 times that of the polar; the glide ratios are with it</source>
        <translation>%1násobek odporu poláry; klouzavosti s ním počítají</translation>
    </message>
    <message>
        <source>Propeller</source>
        <translation>Vrtule</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Výkon</translation>
    </message>
    <message>
        <source>Approach</source>
        <translation>Přiblížení</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Vyčkávání</translation>
    </message>
    <message>
        <source>The engine fails and the aircraft is at best-glide speed and in the right turn at once. Reaction and slowing down are not modelled; they have to be paid from the clearance of %1. What is modelled: %2.</source>
        <translation>Motor vysadí a letadlo okamžitě letí rychlostí nejlepšího klouzání a správnou zatáčkou. Reakce a zpomalení se nepočítají; jdou na vrub odstupu %1. Počítá se: %2.</translation>
    </message>
    <message>
        <source>The engine fails and the aircraft flies on (%1); then it is at best-glide speed. A longer reaction is not modelled; it has to be paid from the clearance of %2. What is modelled: %3.</source>
        <translation>Motor vysadí a letadlo letí dál (%1); pak letí rychlostí nejlepšího klouzání. Delší reakce se nepočítá; jde na vrub odstupu %2. Počítá se: %3.</translation>
    </message>
    <message>
        <source>The engine fails and the aircraft is at best-glide speed and in the right turn at once. Reaction, slowing down and rolling into turns are not modelled; they have to be paid from the clearance of %1.</source>
        <translation>Motor vysadí a letadlo okamžitě letí rychlostí nejlepšího klouzání a správnou zatáčkou. Reakce, zpomalení a překlápění do zatáček se nepočítají; jdou na vrub odstupu %1.</translation>
    </message>
    <message>
        <source>The engine fails and the aircraft flies on (%1); then it is at best-glide speed and in the right turn at once. A longer reaction and rolling into turns are not modelled; they have to be paid from the clearance of %2.</source>
        <translation>Motor vysadí a letadlo letí dál (%1); pak letí rychlostí nejlepšího klouzání a správnou zatáčkou. Delší reakce a překlápění do zatáček se nepočítají; jdou na vrub odstupu %2.</translation>
    </message>
    <message>
        <source>lost in a spiral above the runway</source>
        <translation>se ztratí ve spirále nad dráhou</translation>
    </message>
    <message>
        <source>lost in the circles of the line “Holds”, where the approach begins</source>
        <translation>se ztratí v kruzích řádku „Vyčkávání“, kde začíná přiblížení</translation>
    </message>
    <message>
        <source>The glide ends over the touchdown point on the landing course, with the height in the column “Arrives”. What is more than needed is %1; traffic, obstacles, surface state and closures are not known to the program.</source>
        <translation>Klouzání končí nad bodem dotyku na přistávacím kurzu, s výškou ve sloupci „Přílet“. Co je navíc, %1; provoz, překážky, stav povrchu a uzavírky program nezná.</translation>
    </message>
    <message>
        <source>Altitudes are above mean sea level in the datum of the terrain file, not pressure altitudes: a warm or cold day or a wrong QNH shifts them.</source>
        <translation>Výšky jsou nad střední hladinou moře ve výškovém systému souboru terénu, nejsou to tlakové výšky: teplý nebo chladný den či chybné QNH je posune.</translation>
    </message>
    <message>
        <source>Altitudes are above mean sea level in the datum of the terrain file, not what an altimeter shows: the line “Altimeter” says by how much it is wrong in the air of the plan; a colder day or a wrong QNH shifts them more.</source>
        <translation>Výšky jsou nad střední hladinou moře ve výškovém systému souboru terénu, ne to, co ukazuje výškoměr: řádek „Výškoměr“ říká, o kolik se ve vzduchu plánu mýlí; chladnější den nebo chybné QNH je posune více.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source> (NO GLIDE GUARANTEE on the first %1, up to %2)</source>
        <translation> (na prvních %1, do %2, NENÍ ZÁRUKA DOKLOUZÁNÍ)</translation>
    </message>
    <message>
        <source>none: the plan is the tour alone; the guarantee holds on the tour only</source>
        <translation>žádný: plán je jen trasa; záruka platí jen na trase</translation>
    </message>
    <message>
        <source>from %1; to %2. In the tables the ways from and to it are called “out” and “in”</source>
        <translation>z %1; na %2. V tabulkách se cesty z ní a na ni nazývají „tam“ a „zpět“</translation>
    </message>
    <message>
        <source>After taking off from %1 there is NO gliding guarantee on the first %2 of flight past the far end of the runway, up to %3 (%4 above the runway): if the engine stops there, this plan has no glide, and the aircraft lands ahead as after any takeoff. The guarantee ends above the threshold of %5 at %6; from there the landing is the pilot&apos;s.</source>
        <translation>Po vzletu z %1 NENÍ na prvních %2 letu za koncem dráhy, do %3 (%4 nad dráhou), záruka doklouzání: vysadí-li motor tam, tento plán žádné klouzání nemá a letadlo přistane před sebou jako po každém vzletu. Záruka končí nad prahem dráhy %5 v %6; odtud je přistání na pilotovi.</translation>
    </message>
    <message>
        <source>%1, continued</source>
        <translation>%1, pokračování</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Strana %1 z %2</translation>
    </message>
    <message>
        <source>briefing: glides</source>
        <translation>briefing: klouzání</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>zastaveno</translation>
    </message>
    <message>
        <source>Engine-out briefing, %1</source>
        <translation>Briefing pro vysazení motoru, %1</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>Targets by their numbers in the tour. A bar across the tour: from here on the glides lead to another runway, whose letter stands on the stretch.</source>
        <translation>Cíle podle čísel na trase. Čárka napříč trasou: odtud klouzání vede na jinou dráhu, jejíž písmeno stojí u úseku.</translation>
    </message>
    <message>
        <source>Altitude profile</source>
        <translation>Výškový profil</translation>
    </message>
    <message>
        <source>What these figures assume, and where they end</source>
        <translation>Co tato čísla předpokládají a kde končí</translation>
    </message>
    <message>
        <source>Abbreviations</source>
        <translation>Zkratky</translation>
    </message>
    <message>
        <source>%1 · %2 · altitudes above mean sea level</source>
        <translation>%1 · %2 · výšky nad střední hladinou moře</translation>
    </message>
    <message>
        <source>calm air assumed</source>
        <translation>předpokládá se bezvětří</translation>
    </message>
    <message>
        <source>wind as on the first page</source>
        <translation>vítr jako na první straně</translation>
    </message>
    <message>
        <source>UNVERIFIED – DO NOT FLY – no one has shown that a glide to a runway exists</source>
        <translation>NEOVĚŘENO – NELÉTEJTE – nikdo neukázal, že lze doklouzat na dráhu</translation>
    </message>
    <message>
        <source>the PDF could not be made</source>
        <translation>PDF se nepodařilo vytvořit</translation>
    </message>
    <message>
        <source>briefing: pages</source>
        <translation>briefing: strany</translation>
    </message>
</context>
<context>
    <name>Conditions</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 až %2</translation>
    </message>
    <message>
        <source>%1 to %2 kg</source>
        <translation>%1 až %2 kg</translation>
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
        <translation>%1, přitom se ztratí %2</translation>
    </message>
    <message>
        <source>%1 lost at once</source>
        <translation>okamžitě se ztratí %1</translation>
    </message>
    <message>
        <source>rolling into turns and out of them, at %1° per second, at its worst leaves every glide from the tour at least %2 above the ground</source>
        <translation>překlápění do zatáček a z nich, rychlostí %1° za sekundu, ponechá každému klouzání z trasy v nejhorším případě nejméně %2 nad terénem</translation>
    </message>
    <message>
        <source>rolling into turns is not modelled and is covered by the clearance only</source>
        <translation>překlápění do zatáček se nepočítá a kryje je jen odstup</translation>
    </message>
    <message>
        <source>after a straight of %1 on the landing course</source>
        <translation>po přímé délky %1 na přistávacím kurzu</translation>
    </message>
    <message>
        <source>%1, descending %2 over ground</source>
        <translation>%1, s klesáním %2 nad zemí</translation>
    </message>
    <message>
        <source>by a full circle from overhead, at least %1 above the runway where it begins</source>
        <translation>celým kruhem z místa nad letištěm, který začíná nejméně %1 nad dráhou</translation>
    </message>
    <message>
        <source>by a full circle from overhead</source>
        <translation>celým kruhem z místa nad letištěm</translation>
    </message>
    <message>
        <source>at the threshold on the landing course, by whatever curve leads there</source>
        <translation>u prahu na přistávacím kurzu, jakoukoli zatáčkou</translation>
    </message>
    <message>
        <source>an obstacle surface that begins %1 before the touchdown point and rises by %2 %</source>
        <translation>překážkovou plochou, která začíná %1 před bodem dotyku a stoupá o %2 %</translation>
    </message>
    <message>
        <source>%1: %2 TAS, %3 per hour</source>
        <translation>%1: %2 TAS, %3 za hodinu</translation>
    </message>
    <message>
        <source>%1, %2 of climb</source>
        <translation>%1, stoupání %2</translation>
    </message>
    <message>
        <source>%1 with the ways from and to home</source>
        <translation>%1 s cestami z domova a domů</translation>
    </message>
    <message>
        <source> of %1 usable</source>
        <translation> z %1 využitelných</translation>
    </message>
    <message>
        <source>the flight takes %1, and %2 are usable</source>
        <translation>let spotřebuje %1, využitelných je %2</translation>
    </message>
    <message>
        <source>%1: %2 circles of %3 radius, no lower than %4</source>
        <translation>%1: kruhy %2 o poloměru %3, ne níže než %4</translation>
    </message>
    <message>
        <source>left</source>
        <translation>vlevo</translation>
    </message>
    <message>
        <source>right</source>
        <translation>vpravo</translation>
    </message>
    <message>
        <source>in this cold air it shows up to %1 too much at %2 and %3 at %4, set to the QNH of a runway at %5: fly so much higher than the altitudes of this briefing say</source>
        <translation>v tomto chladném vzduchu ukazuje, nastaven na QNH dráhy v %5, až o %1 více v %2 a o %3 v %4: leťte o tolik výše, než udávají výšky tohoto briefingu</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>X-Plane 11/12 flight plan (1100)</source>
        <translation>letový plán X-Plane 11/12 (1100)</translation>
    </message>
    <message>
        <source>X-Plane 10 flight plan (version 3)</source>
        <translation>letový plán X-Plane 10 (verze 3)</translation>
    </message>
    <message>
        <source>Garmin flight plan (G1000, GTN)</source>
        <translation>letový plán Garmin (G1000, GTN)</translation>
    </message>
    <message>
        <source>Garmin user waypoints</source>
        <translation>uživatelské body Garmin</translation>
    </message>
    <message>
        <source>Microsoft Flight Simulator flight plan</source>
        <translation>letový plán Microsoft Flight Simulator</translation>
    </message>
    <message>
        <source>Little Navmap flight plan</source>
        <translation>letový plán Little Navmap</translation>
    </message>
    <message>
        <source>QGroundControl plan</source>
        <translation>plán QGroundControl</translation>
    </message>
    <message>
        <source>SeeYou waypoints and tasks</source>
        <translation>otočné body a úlohy SeeYou</translation>
    </message>
    <message>
        <source>GPX route and track</source>
        <translation>trasa a stopa GPX</translation>
    </message>
    <message>
        <source>KML for Google Earth</source>
        <translation>KML pro Google Earth</translation>
    </message>
    <message>
        <source>KMZ for Google Earth</source>
        <translation>KMZ pro Google Earth</translation>
    </message>
    <message>
        <source>FlightGear flight plan</source>
        <translation>letový plán FlightGear</translation>
    </message>
    <message>
        <source>GeoJSON for maps and GIS</source>
        <translation>GeoJSON pro mapy a GIS</translation>
    </message>
    <message>
        <source>GeoPackage for GIS</source>
        <translation>GeoPackage pro GIS</translation>
    </message>
    <message>
        <source>Table of waypoints and decision points</source>
        <translation>tabulka traťových a rozhodovacích bodů</translation>
    </message>
    <message>
        <source>turns are fly-by turns of the navigator, altitudes are rounded up to whole feet and some readers replace all by the highest, glides and margins are left out</source>
        <translation>zatáčky jsou zatáčky fly-by navigačního přístroje, výšky se zaokrouhlují nahoru na celé stopy a některé čtečky nahradí všechny nejvyšší, klouzání a rezervy chybějí</translation>
    </message>
    <message>
        <source>altitudes and home runways are in the comments alone, a second runway of the home airport is a user waypoint, glides and margins are left out</source>
        <translation>výšky a domovské dráhy jsou jen v komentářích, druhá dráha domovského letiště je uživatelský bod, klouzání a rezervy chybějí</translation>
    </message>
    <message>
        <source>altitudes are in the names alone, the order is that of the rows, glides and margins are left out</source>
        <translation>výšky jsou jen ve jménech, pořadí je dáno řádky, klouzání a rezervy chybějí</translation>
    </message>
    <message>
        <source>targets beyond ten letters are shortened, glides and margins are left out</source>
        <translation>jména cílů nad deset písmen se zkracují, klouzání a rezervy chybějí</translation>
    </message>
    <message>
        <source>its reader moves places by up to half a metre, glides and margins are left out</source>
        <translation>jeho čtečka posouvá místa až o půl metru, klouzání a rezervy chybějí</translation>
    </message>
    <message>
        <source>names are left out, rally points stand for runways, glides and margins are left out</source>
        <translation>jména chybějí, dráhy zastupují body rally, klouzání a rezervy chybějí</translation>
    </message>
    <message>
        <source>places are rounded to 1.85 m, a task has no altitudes: they are in the names and in the elevation column, glides and margins are left out</source>
        <translation>místa se zaokrouhlují na 1.85 m, úloha nemá výšky: jsou ve jménech a ve sloupci nadmořské výšky, klouzání a rezervy chybějí</translation>
    </message>
    <message>
        <source>glides and margins are left out</source>
        <translation>klouzání a rezervy chybějí</translation>
    </message>
    <message>
        <source>turns are those of its autopilot, glides and margins are left out</source>
        <translation>zatáčky jsou zatáčky jeho autopilota, klouzání a rezervy chybějí</translation>
    </message>
    <message>
        <source>the paths of the glides are left out</source>
        <translation>průběhy klouzání chybějí</translation>
    </message>
    <message>
        <source>weather</source>
        <translation>počasí</translation>
    </message>
    <message>
        <source>success probability in weather</source>
        <translation>pravděpodobnost průletu počasím</translation>
    </message>
    <message>
        <source>overflown population risk</source>
        <translation>riziko pro přelétané obyvatelstvo</translation>
    </message>
    <message>
        <source>people under the path</source>
        <translation>lidé pod cestou</translation>
    </message>
    <message>
        <source>height lost to the approach</source>
        <translation>ztráta výšky do přiblížení</translation>
    </message>
    <message>
        <source>approach higher than the lowest in range</source>
        <translation>přiblížení nad nejnižším dosažitelným</translation>
    </message>
    <message>
        <source>manoeuvres</source>
        <translation>manévry</translation>
    </message>
    <message>
        <source>how far away it ends</source>
        <translation>jak daleko končí</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>vzdálenost</translation>
    </message>
    <message>
        <source>time</source>
        <translation>čas</translation>
    </message>
    <message>
        <source>airfields</source>
        <translation>letiště</translation>
    </message>
    <message>
        <source>asking for sizes</source>
        <translation>zjišťují se velikosti</translation>
    </message>
    <message>
        <source>contours</source>
        <translation>vrstevnice</translation>
    </message>
    <message>
        <source>joining the tiles</source>
        <translation>spojují se dlaždice</translation>
    </message>
    <message>
        <source>lowest safe altitudes</source>
        <translation>nejmenší bezpečné výšky</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>naplánováno</translation>
    </message>
    <message>
        <source>reading the airfields</source>
        <translation>čtou se letiště</translation>
    </message>
    <message>
        <source>terrain: read</source>
        <translation>terén: načten</translation>
    </message>
    <message>
        <source>terrain: reading heights</source>
        <translation>terén: čtou se výšky</translation>
    </message>
    <message>
        <source>terrain: warping to the local frame</source>
        <translation>terén: převod do místní soustavy</translation>
    </message>
    <message>
        <source>waiting for another program that fetches the same</source>
        <translation>čeká se na jiný program, který stahuje totéž</translation>
    </message>
    <message>
        <source>{}: a turn at {:.0f} degrees of bank needs load factor {:.2f}, but at the glide speed of {:.1f} m/s the aircraft stalls above {:.2f} ({:.0f} degrees of bank); plan with a profile of less bank before flying this</source>
        <translation>%1: zatáčka s náklonem %2 stupňů potřebuje násobek zatížení %3, ale při rychlosti klouzání %4 m/s letadlo nad násobkem %5 (náklon %6 stupňů) přechází do pádu; než takto poletíte, plánujte s profilem o menším náklonu</translation>
    </message>
    <message>
        <source>{}: a turn at {:.0f} degrees of bank needs load factor {:.2f}, above the structural limit of {:.2f}</source>
        <translation>%1: zatáčka s náklonem %2 stupňů potřebuje násobek zatížení %3, což je nad pevnostní mezí %4</translation>
    </message>
    <message>
        <source>{} of up to {:.0f} kt, the aircraft&apos;s limit is {:.0f} kt</source>
        <translation>%1 až %2 kt, mez letadla je %3 kt</translation>
    </message>
    <message>
        <source>the wind&apos;s altitude of {} is not between {:.0f} and {:.0f} ft</source>
        <translation>výška větru %1 není mezi %2 a %3 ft</translation>
    </message>
    <message>
        <source>the wind{} blows from {} degrees, but a direction lies between 0 and 360</source>
        <translation>vítr%1 vane ze směru %2 stupňů, směr ale leží mezi 0 a 360</translation>
    </message>
    <message>
        <source>the wind{} varies by {} degrees to each side, but a spread lies between 0 and 180</source>
        <translation>vítr%1 kolísá o %2 stupňů na každou stranu, rozptyl ale leží mezi 0 a 180</translation>
    </message>
    <message>
        <source>the wind{} has a speed of {}, but a speed lies between 0 and {}</source>
        <translation>rychlost větru%1 je %2, rychlost ale leží mezi 0 a %3</translation>
    </message>
    <message>
        <source>the greatest speed of the wind{}, {}, is below its least, {}</source>
        <translation>největší rychlost větru%1, %2, je pod jeho nejmenší, %3</translation>
    </message>
    <message>
        <source>the wind at {} is given twice; give one for each altitude</source>
        <translation>vítr v %1 je zadán dvakrát; pro každou výšku zadejte jeden</translation>
    </message>
    <message>
        <source>the wind at {} comes after the one at {}; give the lowest layer first</source>
        <translation>vítr v %1 následuje až po větru v %2; nejnižší vrstvu zadejte první</translation>
    </message>
    <message>
        <source>the wind may change by {} between {} and {}; sinking through that the aircraft makes no way in a steep turn</source>
        <translation>vítr se mezi %2 a %3 může změnit o %1; při klesání touto vrstvou letadlo v ostré zatáčce nepostoupí vpřed</translation>
    </message>
    <message>
        <source>, that of the lightest aircraft in the densest air</source>
        <translation>, kterou má nejlehčí letadlo v nejhustším vzduchu</translation>
    </message>
    <message>
        <source>the wind of {} at {} is not below the gliding speed of {}{}; no glide makes way against it</source>
        <translation>vítr %1 v %2 není slabší než rychlost klouzání %3%4; žádné klouzání proti němu nepostoupí vpřed</translation>
    </message>
    <message>
        <source>the wind of {} at {} is not below the {} over ground that the aircraft glides at in a steep turn in still air; it makes no way against it</source>
        <translation>vítr %1 v %2 není slabší než rychlost %3 nad zemí, kterou letadlo klouže v ostré zatáčce v klidném vzduchu; proti němu nepostoupí vpřed</translation>
    </message>
    <message>
        <source>internal error: expected </source>
        <translation>vnitřní chyba: očekává se </translation>
    </message>
    <message>
        <source>there is no such file; check the name and the folder it is relative to</source>
        <translation>takový soubor neexistuje; zkontrolujte jméno a složku, vůči které je udáno</translation>
    </message>
    <message>
        <source>this is a folder, not a file</source>
        <translation>toto je složka, ne soubor</translation>
    </message>
    <message>
        <source>this is a device or pipe, not a file; copy what is to be read into a file</source>
        <translation>toto je zařízení nebo roura, ne soubor; zkopírujte, co se má číst, do souboru</translation>
    </message>
    <message>
        <source>this is an address, and only files of this computer are read; download the file and name the copy</source>
        <translation>toto je adresa, a čtou se jen soubory tohoto počítače; stáhněte soubor a uveďte jeho kopii</translation>
    </message>
    <message>
        <source>larger than </source>
        <translation>větší než </translation>
    </message>
    <message>
        <source>; this is no file that the program reads</source>
        <translation>; takový soubor program nečte</translation>
    </message>
    <message>
        <source>the name says what to write: .tif for values, .kml or .gpkg for contours</source>
        <translation>název určuje, co se zapíše: .tif pro hodnoty, .kml nebo .gpkg pro vrstevnice</translation>
    </message>
    <message>
        <source>No glide to any of the {} runway ends that are near enough stays clear of the ground, of {} that were tried.</source>
        <translation>Žádné klouzání na konce drah, které jsou dost blízko (%1), nezůstává volné od terénu; vyzkoušených klouzání: %2.</translation>
    </message>
    <message>
        <source>No path leaves more height in hand by half a metre or more.</source>
        <translation>Žádná cesta neponechá nazbyt výšku, která by byla větší o půl metru nebo více.</translation>
    </message>
    <message>
        <source>The planner {} ended with an error of its own: {}.</source>
        <translation>Plánovač %1 skončil vlastní chybou: %2.</translation>
    </message>
    <message>
        <source>There was not enough time to find and verify a glide: give a later deadline.</source>
        <translation>Na nalezení a ověření klouzání nebylo dost času: dejte delší lhůtu.</translation>
    </message>
    <message>
        <source>{}: {:.0f} m in hand.</source>
        <translation>%1: nazbyt %2 m.</translation>
    </message>
    <message>
        <source>This planner keeps height and looks at no risk: its risk is told, not kept low.</source>
        <translation>Tento plánovač šetří výšku a na riziko nehledí: riziko cesty se uvádí, ale nedrží se malé.</translation>
    </message>
    <message>
        <source>No glide to any of the {} runway ends that are near enough stays clear of the ground, of {} ways that were tried.</source>
        <translation>Žádné klouzání na konce drah, které jsou dost blízko (%1), nezůstává volné od terénu; vyzkoušených cest: %2.</translation>
    </message>
    <message>
        <source>The aircraft comes to the approach {:.0f} m too high: lose that in circles before it.</source>
        <translation>Letadlo přilétá k přiblížení o %1 m příliš vysoko: ztraťte tuto výšku před ním v kruzích.</translation>
    </message>
    <message>
        <source>No way of turns and straights from here arrives at a runway clear of the ground within the deadline: try another planner.</source>
        <translation>Ve lhůtě se nenašla žádná cesta ze zatáček a přímých úseků, která odtud dosáhne dráhy a zůstane volná od terénu: zkuste jiný plánovač.</translation>
    </message>
    <message>
        <source>A turn, a straight and a turn, or an S-turn.</source>
        <translation>Zatáčka, přímý úsek a zatáčka, nebo esovitá zatáčka.</translation>
    </message>
    <message>
        <source>Fallback to </source>
        <translation>Náhradní cesta na </translation>
    </message>
    <message>
        <source>: a turn, a straight and a turn, or an S-turn.</source>
        <translation>: zatáčka, přímý úsek a zatáčka, nebo esovitá zatáčka.</translation>
    </message>
    <message>
        <source>Gradient-guided search to {}{}.</source>
        <translation>Gradientem vedené hledání cesty na %1%2.</translation>
    </message>
    <message>
        <source>, height lost in circles first</source>
        <translation>, výška se nejprve ztratí v kruzích</translation>
    </message>
    <message>
        <source>No runway is in range: the closest is {}, {:.1f} km away, and even straight there the glide would have to begin {:.0f} m higher.</source>
        <translation>V dosahu není žádná dráha: nejbližší je %1, vzdálená %2 km, a i přímo tam by klouzání muselo začít o %3 m výše.</translation>
    </message>
    <message>
        <source>No runway can be landed on: {}.</source>
        <translation>Na žádné dráze nelze přistát: %1.</translation>
    </message>
    <message>
        <source>The path is NOT to a runway: of the glides that keep the clearance it gets farthest.</source>
        <translation>Cesta NEVEDE na dráhu: z klouzání, která drží odstup, doletí nejdále.</translation>
    </message>
    <message>
        <source>The path is NOT to a runway: of the glides that keep the clearance and get far it is the one of least risk to people.</source>
        <translation>Cesta NEVEDE na dráhu: z klouzání, která drží odstup a doletí daleko, má nejmenší riziko pro lidi.</translation>
    </message>
    <message>
        <source>A deadline of zero leaves no time for any answer: give at least a few milliseconds, for example 1s.</source>
        <translation>Nulová lhůta nenechává čas na žádnou odpověď: dejte alespoň několik milisekund, například 1s.</translation>
    </message>
    <message>
        <source>The aircraft&apos;s position, course and altitude must be finite numbers: give longitude, latitude, altitude and true course.</source>
        <translation>Poloha, kurz a výška letadla musí být konečná čísla: zadejte zeměpisnou délku, zeměpisnou šířku, výšku a zeměpisný kurz.</translation>
    </message>
    <message>
        <source>The aircraft is outside the terrain of the mission, where nothing is known about the ground: give a place on the map, or add terrain that covers this one.</source>
        <translation>Letadlo je mimo terén mise, kde se o zemi nic neví: zadejte místo na mapě, nebo přidejte terén, který toto místo pokrývá.</translation>
    </message>
    <message>
        <source>The terrain has no data at the aircraft&apos;s place, so nothing is known about the ground: give another place, or terrain without this gap.</source>
        <translation>Terén nemá v místě letadla data, takže se o zemi nic neví: zadejte jiné místo, nebo terén bez této mezery.</translation>
    </message>
    <message>
        <source>The aircraft would be below the ground: {:.0f} m MSL where the terrain is up to {:.0f} m MSL; give an altitude above that.</source>
        <translation>Letadlo by bylo pod zemí: %1 m MSL tam, kde terén sahá až do %2 m MSL; zadejte výšku nad tím.</translation>
    </message>
    <message>
        <source>The aircraft is at {:.0f} m MSL, above the ceiling of {:.0f} m MSL up to which the mission&apos;s figures hold: give a lower altitude, or raise the ceiling of mission and aircraft.</source>
        <translation>Letadlo je v %1 m MSL, nad stropem %2 m MSL, do kterého platí čísla mise: zadejte menší výšku, nebo zvyšte strop mise a dostup letadla.</translation>
    </message>
    <message>
        <source>The mission has no landing site at all: add airfields to it.</source>
        <translation>Mise nemá vůbec žádné přistávací místo: přidejte k ní letiště.</translation>
    </message>
    <message>
        <source>The octree of free space was stopped.</source>
        <translation>Tvorba oktalového stromu volného prostoru byla zastavena.</translation>
    </message>
    <message>
        <source>There was not enough time to build the roadmap of landing glides: give a later deadline.</source>
        <translation>Na vytvoření sítě cest pro klouzání na dráhy nebylo dost času: dejte delší lhůtu.</translation>
    </message>
    <message>
        <source>There is no roadmap of landing glides: {}.</source>
        <translation>Síť cest pro klouzání na dráhy není: %1.</translation>
    </message>
    <message>
        <source>The roadmap knows no glide from here to a runway, from any height.</source>
        <translation>Síť cest odtud nezná žádné klouzání na dráhu, z žádné výšky.</translation>
    </message>
    <message>
        <source>The lowest glide that the roadmap knows from here is to another runway: ask another planner.</source>
        <translation>Nejnižší klouzání, které síť cest odtud zná, vede na jinou dráhu: zeptejte se jiného plánovače.</translation>
    </message>
    <message>
        <source>There is no approach to the runway of the roadmap: {}.</source>
        <translation>Na dráhu ze sítě cest není přiblížení: %1.</translation>
    </message>
    <message>
        <source>The lowest glide that the roadmap knows from here, to {}, has to begin at {:.0f} m MSL: {:.0f} m are missing.</source>
        <translation>Nejnižší klouzání, které síť cest odtud zná, na %1, musí začít v %2 m MSL: chybí %3 m.</translation>
    </message>
    <message>
        <source>ceiling and visibility</source>
        <translation>základna oblačnosti a dohlednost</translation>
    </message>
    <message>
        <source>Ceiling and visibility there are not known.</source>
        <translation>Základna oblačnosti a dohlednost tam nejsou známy.</translation>
    </message>
    <message>
        <source>emergency services</source>
        <translation>záchranné služby</translation>
    </message>
    <message>
        <source>Fire and rescue services there are not known.</source>
        <translation>Hasičské a záchranné služby tam nejsou známy.</translation>
    </message>
    <message>
        <source>weather on the way</source>
        <translation>počasí na cestě</translation>
    </message>
    <message>
        <source>Weather on the way is not known.</source>
        <translation>Počasí na cestě není známo.</translation>
    </message>
    <message>
        <source>Weather on the way does not count, as there is no way.</source>
        <translation>Počasí na cestě se nepočítá, protože cesta není.</translation>
    </message>
    <message>
        <source>{}{:.1f} km of {}</source>
        <translation>%1%2 km skrz %3</translation>
    </message>
    <message>
        <source>No bad weather on the way.</source>
        <translation>Na cestě není špatné počasí.</translation>
    </message>
    <message>
        <source>Through {}: {:.0f} % come through.</source>
        <translation>Cesta vede %1: proletí %2 %.</translation>
    </message>
    <message>
        <source>height in hand</source>
        <translation>výška nazbyt</translation>
    </message>
    <message>
        <source>Not reached: </source>
        <translation>Nedosažena: </translation>
    </message>
    <message>
        <source>Reached with {:.0f} m of height in hand.</source>
        <translation>Dosažena s výškou nazbyt %1 m.</translation>
    </message>
    <message>
        <source>runway length</source>
        <translation>délka dráhy</translation>
    </message>
    <message>
        <source>The length of the runway is not known.</source>
        <translation>Délka dráhy není známa.</translation>
    </message>
    <message>
        <source>{:.0f} m long; what the aircraft needs is not known.</source>
        <translation>Délka %1 m; kolik letadlo potřebuje, není známo.</translation>
    </message>
    <message>
        <source>{:.0f} m long, {:.0f} m needed{}.</source>
        <translation>Délka %1 m, potřeba %2 m%3.</translation>
    </message>
    <message>
        <source>: too short</source>
        <translation>: příliš krátká</translation>
    </message>
    <message>
        <source>runway width</source>
        <translation>šířka dráhy</translation>
    </message>
    <message>
        <source>The width of the runway is not known.</source>
        <translation>Šířka dráhy není známa.</translation>
    </message>
    <message>
        <source>A hard surface.</source>
        <translation>Zpevněný povrch.</translation>
    </message>
    <message>
        <source>A gravel surface.</source>
        <translation>Štěrkový povrch.</translation>
    </message>
    <message>
        <source>A grass surface.</source>
        <translation>Travnatý povrch.</translation>
    </message>
    <message>
        <source>A dirt surface.</source>
        <translation>Hliněný povrch.</translation>
    </message>
    <message>
        <source>A surface of snow.</source>
        <translation>Sněhový povrch.</translation>
    </message>
    <message>
        <source>The surface is not known.</source>
        <translation>Povrch není znám.</translation>
    </message>
    <message>
        <source>The wind there is not known; the way is planned in still air.</source>
        <translation>Vítr tam není znám; cesta je plánována pro bezvětří.</translation>
    </message>
    <message>
        <source>Up to {:.0f} kt of crosswind, {}.</source>
        <translation>Boční vítr až %1 kt, %2.</translation>
    </message>
    <message>
        <source>up to {:.0f} kt of tailwind</source>
        <translation>zadní vítr až %1 kt</translation>
    </message>
    <message>
        <source>at least {:.0f} kt of headwind</source>
        <translation>čelní vítr nejméně %1 kt</translation>
    </message>
    <message>
        <source>people under the final approach</source>
        <translation>lidé pod konečným přiblížením</translation>
    </message>
    <message>
        <source>How many people live under the final approach is not known.</source>
        <translation>Kolik lidí žije pod konečným přiblížením, není známo.</translation>
    </message>
    <message>
        <source>{:.0f} people live under the last {:.0f} NM of the final course.</source>
        <translation>Počet lidí žijících pod posledními %2 NM přistávacího kurzu: %1.</translation>
    </message>
    <message>
        <source>Not known to be lighted.</source>
        <translation>Není známo, že by byla osvětlená.</translation>
    </message>
    <message>
        <source>There was not enough time to look for a way there: give a later deadline.</source>
        <translation>Na hledání cesty tam nebylo dost času: dejte delší lhůtu.</translation>
    </message>
    <message>
        <source>Rolling into its turns and out of them may cost this way up to {:.0f} m, more than the clearance of {:.0f} m.</source>
        <translation>Překlápění do zatáček a z nich může tuto cestu stát až %1 m, více než odstup %2 m.</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>důvod není uveden</translation>
    </message>
    <message>
        <source>A path was found, but the checker did not accept it: {}.</source>
        <translation>Cesta se našla, ale kontrola ji nepřijala: %1.</translation>
    </message>
    <message>
        <source>No glide to any of the {} runway ends that are near enough stays clear of the ground, of {} ways that were flown.</source>
        <translation>Žádné klouzání na konce drah, které jsou dost blízko (%1), nezůstává volné od terénu; proletěných cest: %2.</translation>
    </message>
    <message>
        <source>the server sends no table of OurAirports; check the address, and whether the network wants a login first</source>
        <translation>server neposílá tabulku OurAirports; zkontrolujte adresu a zda síť nechce nejprve přihlášení</translation>
    </message>
    <message>
        <source>the server has no such file; check the address</source>
        <translation>server takový soubor nemá; zkontrolujte adresu</translation>
    </message>
    <message>
        <source>what the server sent holds no landing site; the files from before stay</source>
        <translation>co server poslal, neobsahuje žádné přistávací místo; dřívější soubory zůstávají</translation>
    </message>
    <message>
        <source>what the server sent is no table of OurAirports, the files from before stay: </source>
        <translation>co server poslal, není tabulka OurAirports, dřívější soubory zůstávají: </translation>
    </message>
    <message>
        <source>there is no airfield &quot;{}&quot;; check the code, or give latitude,longitude instead</source>
        <translation>letiště „%1“ neexistuje; zkontrolujte kód, nebo místo něj zadejte zeměpisnou polohu jako šířka,délka</translation>
    </message>
    <message>
        <source>the header has no column &quot;{}&quot;; name airports.csv of OurAirports or a .cup file</source>
        <translation>hlavička nemá sloupec &quot;%1&quot;; uveďte airports.csv od OurAirports nebo soubor .cup</translation>
    </message>
    <message>
        <source>neither XDG_CACHE_HOME nor HOME is set, so there is no place for the cache; name a folder</source>
        <translation>není nastaveno XDG_CACHE_HOME ani HOME, takže pro mezipaměť není místo; uveďte složku</translation>
    </message>
    <message>
        <source>this is no address of a server; it begins with https:// and has neither spaces nor ?</source>
        <translation>toto není adresa serveru; ta začíná https:// a nemá mezery ani ?</translation>
    </message>
    <message>
        <source>the server does not send parts of files (HTTP range requests), so a broken download could not be continued; choose another server</source>
        <translation>server neposílá části souborů (HTTP range requests), takže by v přerušeném stahování nešlo pokračovat; zvolte jiný server</translation>
    </message>
    <message>
        <source>the server refuses access (HTTP {}); check the address, or the proxy&apos;s settings</source>
        <translation>server odmítá přístup (HTTP %1); zkontrolujte adresu nebo nastavení proxy</translation>
    </message>
    <message>
        <source>the connection breaks off again and again; try again later, what came so far is kept</source>
        <translation>spojení se stále znovu přerušuje; zkuste to později, co dosud přišlo, zůstává</translation>
    </message>
    <message>
        <source>the server answers with HTTP {}; try again later, or check the address</source>
        <translation>server odpovídá HTTP %1; zkuste to později, nebo zkontrolujte adresu</translation>
    </message>
    <message>
        <source>the file on the server was changed while it was fetched; fetch it again</source>
        <translation>soubor na serveru byl během stahování změněn; stáhněte jej znovu</translation>
    </message>
    <message>
        <source>the file on the server is empty; try again later, or choose another server</source>
        <translation>soubor na serveru je prázdný; zkuste to později, nebo zvolte jiný server</translation>
    </message>
    <message>
        <source>the proxy that the environment names cannot be found; correct http_proxy or https_proxy</source>
        <translation>proxy, kterou uvádí prostředí, nelze najít; opravte http_proxy nebo https_proxy</translation>
    </message>
    <message>
        <source>the server&apos;s name cannot be found; check the network and the address, what was fetched before works without</source>
        <translation>jméno serveru nelze najít; zkontrolujte síť a adresu, co bylo staženo dříve, funguje i bez sítě</translation>
    </message>
    <message>
        <source>no server answers there; check the network and the address, what was fetched before works without</source>
        <translation>žádný server tam neodpovídá; zkontrolujte síť a adresu, co bylo staženo dříve, funguje i bez sítě</translation>
    </message>
    <message>
        <source>the server does not answer in time; try again later, what came so far is kept</source>
        <translation>server neodpovídá včas; zkuste to později, co dosud přišlo, zůstává</translation>
    </message>
    <message>
        <source>no secure connection to the server could be made; check the system&apos;s date and certificates</source>
        <translation>nepodařilo se navázat zabezpečené spojení se serverem; zkontrolujte datum a certifikáty systému</translation>
    </message>
    <message>
        <source>the connection failed; check the network and the address</source>
        <translation>spojení selhalo; zkontrolujte síť a adresu</translation>
    </message>
    <message>
        <source>fetching was stopped; what came so far is kept and will be continued</source>
        <translation>stahování bylo zastaveno; co dosud přišlo, zůstává a bude se pokračovat</translation>
    </message>
    <message>
        <source>the GDAL library of this system was built without network access</source>
        <translation>knihovna GDAL tohoto systému byla sestavena bez přístupu k síti</translation>
    </message>
    <message>
        <source>cannot be written: </source>
        <translation>nelze zapsat: </translation>
    </message>
    <message>
        <source>stopped while another program fetches the same file</source>
        <translation>zastaveno, zatímco týž soubor stahuje jiný program</translation>
    </message>
    <message>
        <source>the folder cannot be made: </source>
        <translation>složku nelze vytvořit: </translation>
    </message>
    <message>
        <source>a folder has this name; choose another file name</source>
        <translation>toto jméno má složka; zvolte jiné jméno souboru</translation>
    </message>
    <message>
        <source>the file is write-protected; remove the protection or choose another name</source>
        <translation>soubor je chráněn proti zápisu; zrušte ochranu, nebo zvolte jiné jméno</translation>
    </message>
    <message>
        <source>the raster could not be made</source>
        <translation>rastr se nepodařilo vytvořit</translation>
    </message>
    <message>
        <source>the raster was not taken</source>
        <translation>rastr nebyl přijat</translation>
    </message>
    <message>
        <source>the tile cannot be read</source>
        <translation>dlaždici nelze přečíst</translation>
    </message>
    <message>
        <source>; remove it and fetch it again</source>
        <translation>; odstraňte ji a stáhněte ji znovu</translation>
    </message>
    <message>
        <source>the tile is damaged</source>
        <translation>dlaždice je poškozena</translation>
    </message>
    <message>
        <source>fetching was stopped; the tiles that are here stay</source>
        <translation>stahování bylo zastaveno; dlaždice, které zde jsou, zůstávají</translation>
    </message>
    <message>
        <source>the area holds no post of the terrain; choose a larger one</source>
        <translation>oblast neobsahuje žádný bod terénu; zvolte větší</translation>
    </message>
    <message>
        <source>no terrain on the server for {}: taken as sea, flat at 0 m</source>
        <translation>pro %1 není na serveru terén: bere se jako moře, rovina v 0 m</translation>
    </message>
    <message>
        <source>no terrain is published for {}: nothing is known there, so nothing counts as safe there</source>
        <translation>pro %1 není zveřejněn terén: nic se tam neví, proto tam nic neplatí za bezpečné</translation>
    </message>
    <message>
        <source>1 tile: {} on this machine, {} to fetch</source>
        <translation>1 dlaždice: na tomto počítači %1, ke stažení %2</translation>
    </message>
    <message>
        <source>{} tiles: {} on this machine, {} to fetch</source>
        <translation>dlaždice: %1, z toho na tomto počítači %2, ke stažení %3</translation>
    </message>
    <message>
        <source>, {} not published</source>
        <translation>, nezveřejněno %1</translation>
    </message>
    <message>
        <source>the area crosses a parallel where the spacing of posts changes, so it is in several files; a mission needs all of them</source>
        <translation>oblast přechází rovnoběžku, na které se mění rozestup bodů terénu, proto je ve více souborech; mise potřebuje všechny</translation>
    </message>
    <message>
        <source>the area is not on earth; give west, south, east, north in degrees, -180 to 180 and -90 to 90</source>
        <translation>oblast není na Zemi; zadejte západ, jih, východ, sever ve stupních, -180 až 180 a -90 až 90</translation>
    </message>
    <message>
        <source>west lies east of east; exchange them, and fetch an area across the 180th meridian in two parts</source>
        <translation>západ leží na východ od východu; vyměňte je, a oblast přes 180. poledník stáhněte ve dvou částech</translation>
    </message>
    <message>
        <source>the area is empty or less than 0.001 degrees wide; give west, south, east, north</source>
        <translation>oblast je prázdná nebo užší než 0.001 stupně; zadejte západ, jih, východ, sever</translation>
    </message>
    <message>
        <source>the area covers {} tiles of one degree, at most {} can be fetched at once; choose a smaller area</source>
        <translation>počet jednostupňových dlaždic v oblasti je %1, najednou jich lze stáhnout nejvýše %2; zvolte menší oblast</translation>
    </message>
    <message>
        <source>the radius must be 0.1 to 300 km</source>
        <translation>poloměr musí být 0.1 až 300 km</translation>
    </message>
    <message>
        <source>the circle holds a pole; choose a smaller radius</source>
        <translation>kruh obsahuje pól; zvolte menší poloměr</translation>
    </message>
    <message>
        <source>the area crosses the 180th meridian; fetch it in two parts, each given by its corners</source>
        <translation>oblast přechází 180. poledník; stáhněte ji ve dvou částech, každou zadanou svými rohy</translation>
    </message>
    <message>
        <source>what the server sent is no terrain tile: it must be one band in degrees; choose another server</source>
        <translation>co server poslal, není dlaždice terénu: musí to být jedno pásmo ve stupních; zvolte jiný server</translation>
    </message>
    <message>
        <source>what the server sent lies elsewhere than tile {}; choose another server</source>
        <translation>co server poslal, leží jinde než dlaždice %1; zvolte jiný server</translation>
    </message>
    <message>
        <source>the server sends no GeoTIFF{}; check the address, and whether the network wants a login first</source>
        <translation>server neposílá GeoTIFF%1; zkontrolujte adresu a zda síť nechce nejprve přihlášení</translation>
    </message>
    <message>
        <source> but a web page</source>
        <translation> (je to webová stránka)</translation>
    </message>
    <message>
        <source>what the server sent is no GeoTIFF</source>
        <translation>co server poslal, není GeoTIFF</translation>
    </message>
    <message>
        <source>; try again, or choose another server</source>
        <translation>; zkuste to znovu, nebo zvolte jiný server</translation>
    </message>
    <message>
        <source>what the server sent is damaged</source>
        <translation>co server poslal, je poškozeno</translation>
    </message>
    <message>
        <source>the server&apos;s list of tiles names none; check the address, and whether the network wants a login first</source>
        <translation>seznam dlaždic serveru žádnou neuvádí; zkontrolujte adresu a zda síť nechce nejprve přihlášení</translation>
    </message>
    <message>
        <source>the server&apos;s list of tiles cannot be read; try again later</source>
        <translation>seznam dlaždic serveru nelze přečíst; zkuste to později</translation>
    </message>
    <message>
        <source>the server&apos;s list of tiles was changed while it was read; try again</source>
        <translation>seznam dlaždic serveru byl během čtení změněn; zkuste to znovu</translation>
    </message>
    <message>
        <source>the server has neither a list of tiles (tileList.txt) nor any tile of this area; it may be sea, or the address is wrong</source>
        <translation>server nemá ani seznam dlaždic (tileList.txt), ani žádnou dlaždici této oblasti; může to být moře, nebo je adresa chybná</translation>
    </message>
    <message>
        <source>the server lists this tile and does not have it; try again later, or choose another server</source>
        <translation>server tuto dlaždici uvádí, ale nemá ji; zkuste to později, nebo zvolte jiný server</translation>
    </message>
    <message>
        <source>the server does not have this tile any more; try again later</source>
        <translation>server tuto dlaždici už nemá; zkuste to později</translation>
    </message>
    <message>
        <source>the cached tile {} was damaged (its checksum did not fit) and was made or fetched again</source>
        <translation>dlaždice %1 v mezipaměti byla poškozena (nesouhlasil její kontrolní součet) a byla znovu vytvořena nebo stažena</translation>
    </message>
    <message>
        <source>the cached tile {} is damaged, its checksum does not fit, and it cannot be fetched again: {}</source>
        <translation>dlaždice %1 v mezipaměti je poškozena, její kontrolní součet nesouhlasí a nelze ji znovu stáhnout: %2</translation>
    </message>
    <message>
        <source>The wind or the airspeed is not a number.</source>
        <translation>Vítr nebo vzdušná rychlost není číslo.</translation>
    </message>
    <message>
        <source>The wind is as strong as the airspeed or stronger, so the aircraft cannot fly against it.</source>
        <translation>Vítr je stejně silný jako vzdušná rychlost nebo silnější, takže letadlo proti němu nemůže letět.</translation>
    </message>
    <message>
        <source>A place or heading is not a number.</source>
        <translation>Místo nebo kurz není číslo.</translation>
    </message>
    <message>
        <source>The turn radius is not above zero.</source>
        <translation>Poloměr zatáčky není větší než nula.</translation>
    </message>
    <message>
        <source>The two places are too far apart for so small a turn radius.</source>
        <translation>Obě místa jsou na tak malý poloměr zatáčky příliš daleko od sebe.</translation>
    </message>
    <message>
        <source>No path of three parts connects the two places in this wind.</source>
        <translation>Žádná cesta ze tří částí v tomto větru obě místa nespojuje.</translation>
    </message>
    <message>
        <source>there is no aircraft &quot;{}&quot;: no bundled profiles were found in {}; set VOLPLANE_RESOURCES to their folder</source>
        <translation>letadlo „%1“ neexistuje: v %2 nebyly nalezeny žádné dodané profily; nastavte VOLPLANE_RESOURCES na jejich složku</translation>
    </message>
    <message>
        <source>there is no bundled aircraft &quot;{}&quot;{}; choose one of {}, or name a .json file</source>
        <translation>dodané letadlo „%1“ neexistuje%2; zvolte jedno z těchto: %3, nebo uveďte soubor .json</translation>
    </message>
    <message>
        <source>, is &quot;{}&quot; meant?</source>
        <translation>, je míněno „%1“?</translation>
    </message>
    <message>
        <source>degrees per second</source>
        <translation>stupňů za sekundu</translation>
    </message>
    <message>
        <source>the least mass of {} kg is above the mass of the polar, {} kg</source>
        <translation>nejmenší hmotnost %1 kg je nad hmotností poláry, %2 kg</translation>
    </message>
    <message>
        <source>the greatest mass of {} kg is below the mass of the polar, {} kg</source>
        <translation>největší hmotnost %1 kg je pod hmotností poláry, %2 kg</translation>
    </message>
    <message>
        <source>the speed never to be exceeded, {} m/s, is not above the speed of best glide, {} m/s</source>
        <translation>nepřekročitelná rychlost, %1 m/s, není nad rychlostí nejlepšího klouzání, %2 m/s</translation>
    </message>
    <message>
        <source>the steepest descent of {:.2f} degrees is shallower than the glide, {:.2f} degrees</source>
        <translation>nejstrmější klesání %1 stupňů je plošší než klouzání, %2 stupňů</translation>
    </message>
    <message>
        <source>{} is given twice; names must differ</source>
        <translation>%1 je uvedeno dvakrát; jména se musí lišit</translation>
    </message>
    <message>
        <source>all power settings of an aircraft must count in the same unit</source>
        <translation>všechna nastavení výkonu letadla musí počítat ve stejné jednotce</translation>
    </message>
    <message>
        <source>the airspeed of {}, {} m/s, is not above the stall speed of {} m/s</source>
        <translation>vzdušná rychlost nastavení %1, %2 m/s, není nad pádovou rychlostí %3 m/s</translation>
    </message>
    <message>
        <source>the airspeed of {}, {} m/s, is above the speed never to be exceeded, {} m/s</source>
        <translation>vzdušná rychlost nastavení %1, %2 m/s, je nad nepřekročitelnou rychlostí, %3 m/s</translation>
    </message>
    <message>
        <source>fuel or charge is counted in the unit of the power settings, and there are none; add one, or leave it out</source>
        <translation>palivo nebo náboj baterie se počítá v jednotce nastavení výkonu, a žádné nastavení není; přidejte je, nebo údaj vynechte</translation>
    </message>
    <message>
        <source>with the propeller windmilling drag exceeds weight, no glide exists; check it against zeroLiftDrag</source>
        <translation>s protáčející se vrtulí odpor převyšuje tíhu, klouzání neexistuje; porovnejte údaj se zeroLiftDrag</translation>
    </message>
    <message>
        <source>with the propeller stopped drag exceeds weight, no glide exists; check it against zeroLiftDrag</source>
        <translation>se stojící vrtulí odpor převyšuje tíhu, klouzání neexistuje; porovnejte údaj se zeroLiftDrag</translation>
    </message>
    <message>
        <source>at least one bank angle is needed, a glide must be able to turn</source>
        <translation>je třeba alespoň jeden náklon, v klouzání musí být možné zatáčet</translation>
    </message>
    <message>
        <source>bank angles must ascend and none be given twice</source>
        <translation>náklony musí být vzestupné a žádný nesmí být uveden dvakrát</translation>
    </message>
    <message>
        <source>must be below bestGlideSpeed_mps, or the aircraft stalls in its glide</source>
        <translation>musí být pod bestGlideSpeed_mps, jinak letadlo při klouzání přejde do pádu</translation>
    </message>
    <message>
        <source>at this speed drag exceeds weight, no glide exists; check speed, mass, wing area and polar</source>
        <translation>při této rychlosti odpor převyšuje tíhu, klouzání neexistuje; zkontrolujte rychlost, hmotnost, plochu křídla a poláru</translation>
    </message>
    <message>
        <source>at {:.1f} degrees of bank drag exceeds weight, no glide exists; leave this bank angle out</source>
        <translation>při náklonu %1 stupňů odpor převyšuje tíhu, klouzání neexistuje; tento náklon vynechte</translation>
    </message>
    <message>
        <source>heading in the file differs by {:.0f} degrees from the runway ends; the ends count</source>
        <translation>kurz v souboru se od konců dráhy liší o %1 stupňů; platí konce</translation>
    </message>
    <message>
        <source>length in the file is {:.0f} m but the runway ends are {:.0f} m apart; the shorter counts</source>
        <translation>délka v souboru je %1 m, ale konce dráhy jsou od sebe %2 m; platí kratší</translation>
    </message>
    <message>
        <source>one runway end derived from the other, length and heading</source>
        <translation>jeden konec dráhy odvozen z druhého, z délky a z kurzu</translation>
    </message>
    <message>
        <source>runway length unknown</source>
        <translation>délka dráhy neznámá</translation>
    </message>
    <message>
        <source>runway ends derived from the airport&apos;s position, length and heading</source>
        <translation>konce dráhy odvozeny z polohy letiště, z délky a z kurzu</translation>
    </message>
    <message>
        <source>runway length unknown; the airport&apos;s position is taken as touchdown point</source>
        <translation>délka dráhy neznámá; za bod dotyku se bere poloha letiště</translation>
    </message>
    <message>
        <source>elevation of the airport, not of the threshold</source>
        <translation>nadmořská výška letiště, ne prahu dráhy</translation>
    </message>
    <message>
        <source>elevation of the threshold ({:.0f} m) and of the airport ({:.0f} m) disagree; the higher counts</source>
        <translation>nadmořské výšky prahu (%1 m) a letiště (%2 m) se neshodují; platí vyšší</translation>
    </message>
    <message>
        <source>more than {} landing sites; take the part of the file for the region</source>
        <translation>více přistávacích míst než %1; vezměte část souboru pro danou oblast</translation>
    </message>
    <message>
        <source>displaced threshold negative or beyond the runway</source>
        <translation>posunutí prahu záporné nebo delší než dráha</translation>
    </message>
    <message>
        <source>no elevation in the file, the terrain&apos;s is used</source>
        <translation>v souboru není nadmořská výška, použije se výška terénu</translation>
    </message>
    <message>
        <source>excluded by the mission</source>
        <translation>vyloučeno misí</translation>
    </message>
    <message>
        <source>excluded by the mission: </source>
        <translation>vyloučeno misí: </translation>
    </message>
    <message>
        <source>geometry only approximate, which the mission does not accept</source>
        <translation>geometrie jen přibližná, což mise nepřipouští</translation>
    </message>
    <message>
        <source>shorter than {:.0f} m</source>
        <translation>kratší než %1 m</translation>
    </message>
    <message>
        <source>narrower than {:.0f} m</source>
        <translation>užší než %1 m</translation>
    </message>
    <message>
        <source>surface unknown</source>
        <translation>neznámý povrch</translation>
    </message>
    <message>
        <source>surface not among those that the mission allows</source>
        <translation>povrch není mezi těmi, které mise dovoluje</translation>
    </message>
    <message>
        <source>not lighted, as far as the file says</source>
        <translation>podle souboru bez osvětlení</translation>
    </message>
    <message>
        <source>runway end more than 15 km from its airport</source>
        <translation>konec dráhy více než 15 km od svého letiště</translation>
    </message>
    <message>
        <source>no heading and not both runway ends in the file</source>
        <translation>v souboru není kurz ani oba konce dráhy</translation>
    </message>
    <message>
        <source>length unknown, so the least length that the mission asks for is not assured</source>
        <translation>délka neznámá, takže nejmenší délka, kterou mise žádá, není zaručena</translation>
    </message>
    <message>
        <source>width unknown, so the least width that the mission asks for is not assured</source>
        <translation>šířka neznámá, takže nejmenší šířka, kterou mise žádá, není zaručena</translation>
    </message>
    <message>
        <source>opposite end of a one-way runway</source>
        <translation>opačný konec jednosměrné dráhy</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>vynecháno</translation>
    </message>
    <message>
        <source>an OurAirports file needs its runways file too; add &quot;runways&quot;: &quot;runways.csv&quot; beside it</source>
        <translation>soubor OurAirports potřebuje i svůj soubor drah; přidejte k němu &quot;runways&quot;: &quot;runways.csv&quot;</translation>
    </message>
    <message>
        <source>this is no file of airfields that the program knows: OurAirports .csv, X-Plane apt.dat, SeeYou .cup, or a table or GeoJSON of own fields with the columns latitude, longitude and course_deg</source>
        <translation>toto není soubor letišť, který program zná: OurAirports .csv, X-Plane apt.dat, SeeYou .cup, nebo tabulka či GeoJSON s vlastními poli se sloupci latitude, longitude a course_deg</translation>
    </message>
    <message>
        <source>only the airports file of OurAirports goes with a runways file; this one holds its runways itself, remove &quot;runways&quot;</source>
        <translation>soubor drah patří jen k souboru letišť z OurAirports; tento obsahuje své dráhy sám, odstraňte &quot;runways&quot;</translation>
    </message>
    <message>
        <source>a rule needs either a kind or a name</source>
        <translation>pravidlo potřebuje buď druh (kind), nebo název (name)</translation>
    </message>
    <message>
        <source>must be [longitude, latitude] in degrees</source>
        <translation>musí být [zeměpisná délka, zeměpisná šířka] ve stupních</translation>
    </message>
    <message>
        <source>an airspace needs three corners or more</source>
        <translation>vzdušný prostor potřebuje alespoň tři rohy</translation>
    </message>
    <message>
        <source>{} in line {}</source>
        <translation>%1 na řádku %2</translation>
    </message>
    <message>
        <source>no name</source>
        <translation>bez názvu</translation>
    </message>
    <message>
        <source>floor or ceiling missing</source>
        <translation>chybí dolní nebo horní mez</translation>
    </message>
    <message>
        <source>less than three corners</source>
        <translation>méně než tři rohy</translation>
    </message>
    <message>
        <source>more than {} corners in the file; take the part of it for the region</source>
        <translation>více než %1 rohů v souboru; vezměte z něj část pro danou oblast</translation>
    </message>
    <message>
        <source>too many corners</source>
        <translation>příliš mnoho rohů</translation>
    </message>
    <message>
        <source>, so its airspace</source>
        <translation>, a tím i celý vzdušný prostor</translation>
    </message>
    <message>
        <source>a floor counts as the surface</source>
        <translation>dolní mez se počítá jako povrch země</translation>
    </message>
    <message>
        <source>a ceiling counts as none</source>
        <translation>horní mez se počítá jako žádná</translation>
    </message>
    <message>
        <source>centre is no place</source>
        <translation>střed není platná poloha</translation>
    </message>
    <message>
        <source>corner is no place</source>
        <translation>roh není platná poloha</translation>
    </message>
    <message>
        <source>circle without centre or with a radius that makes no sense</source>
        <translation>kružnice bez středu nebo s poloměrem, který nedává smysl</translation>
    </message>
    <message>
        <source>arc without centre, or with a radius or angles that make no sense</source>
        <translation>oblouk bez středu, nebo s poloměrem či úhly, které nedávají smysl</translation>
    </message>
    <message>
        <source>arc without centre, or between places that are none</source>
        <translation>oblouk bez středu, nebo mezi místy, která nejsou platné polohy</translation>
    </message>
    <message>
        <source>there is no airspace in this file; an OpenAir file has lines that begin with AC, AN, AL, AH and DP</source>
        <translation>v tomto souboru není žádný vzdušný prostor; soubor OpenAir má řádky, které začínají AC, AN, AL, AH a DP</translation>
    </message>
    <message>
        <source>limits given in words</source>
        <translation>× mez zadaná slovy</translation>
    </message>
    <message>
        <source>header of an airport cut short</source>
        <translation>neúplné záhlaví letiště</translation>
    </message>
    <message>
        <source>row of a runway cut short</source>
        <translation>neúplný řádek dráhy</translation>
    </message>
    <message>
        <source>runway outside an airport</source>
        <translation>dráha, která nepatří k žádnému letišti</translation>
    </message>
    <message>
        <source>a value of the runway makes no sense</source>
        <translation>některá hodnota dráhy nedává smysl</translation>
    </message>
    <message>
        <source>runway of a heliport</source>
        <translation>dráha heliportu</translation>
    </message>
    <message>
        <source>more runways than an airport has</source>
        <translation>více drah, než letiště může mít</translation>
    </message>
    <message>
        <source>this is no apt.dat: it begins with I or A, and its second line with the version, for example &quot;1100 Version&quot;</source>
        <translation>toto není apt.dat: ten začíná písmenem I nebo A a jeho druhý řádek verzí, například &quot;1100 Version&quot;</translation>
    </message>
    <message>
        <source>version {:.0f} of apt.dat is not read; 850 to 1299 are</source>
        <translation>verze %1 souboru apt.dat se nečte; čtou se verze 850 až 1299</translation>
    </message>
    <message>
        <source>there is no airport in this apt.dat; the file may be cut short</source>
        <translation>v tomto apt.dat není žádné letiště; soubor je možná neúplný</translation>
    </message>
    <message>
        <source>no file name was given for the output</source>
        <translation>pro výstup nebyl zadán název souboru</translation>
    </message>
    <message>
        <source>this names a folder; add a file name</source>
        <translation>toto je název složky; doplňte název souboru</translation>
    </message>
    <message>
        <source>there is no permission to write there; choose another folder or change its permissions</source>
        <translation>není tam oprávnění k zápisu; zvolte jinou složku, nebo změňte její přístupová práva</translation>
    </message>
    <message>
        <source>the file system is read-only; choose another folder</source>
        <translation>souborový systém je jen pro čtení; zvolte jinou složku</translation>
    </message>
    <message>
        <source>the disk is full; free some space or choose another folder</source>
        <translation>disk je plný; uvolněte místo, nebo zvolte jinou složku</translation>
    </message>
    <message>
        <source>the file would be larger than the system allows</source>
        <translation>soubor by byl větší, než systém dovoluje</translation>
    </message>
    <message>
        <source>there is no such folder; create it first</source>
        <translation>taková složka neexistuje; nejprve ji vytvořte</translation>
    </message>
    <message>
        <source>the file name is too long; choose a shorter one</source>
        <translation>název souboru je příliš dlouhý; zvolte kratší</translation>
    </message>
    <message>
        <source>; choose another place</source>
        <translation>; zvolte jiné místo</translation>
    </message>
    <message>
        <source>{}, row {}, column {}</source>
        <translation>%1, řádek %2, sloupec %3</translation>
    </message>
    <message>
        <source>{}, row {}, column {} ({})</source>
        <translation>%1, řádek %2, sloupec %3 (%4)</translation>
    </message>
    <message>
        <source>a quote is opened here and never closed; add the closing quote</source>
        <translation>zde začíná uvozovka, která není nikde uzavřena; doplňte uzavírací uvozovku</translation>
    </message>
    <message>
        <source>text follows a closing quote; double the quotes inside a field or add the missing comma</source>
        <translation>za uzavírací uvozovkou následuje text; uvozovky uvnitř pole zdvojte, nebo doplňte chybějící čárku</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not a {}; write it like {}</source>
        <translation>„%1“ neplatí jako %2; zapište to jako %3</translation>
    </message>
    <message>
        <source>no usable elevation with a unit</source>
        <translation>chybí použitelná nadmořská výška s jednotkou</translation>
    </message>
    <message>
        <source>no runway direction</source>
        <translation>chybí směr dráhy</translation>
    </message>
    <message>
        <source>runway direction makes no sense</source>
        <translation>směr dráhy nedává smysl</translation>
    </message>
    <message>
        <source>runway direction published to whole degrees at best</source>
        <translation>směr dráhy je uveden přinejlepším na celé stupně</translation>
    </message>
    <message>
        <source>outlanding field, not an aerodrome</source>
        <translation>plocha pro přistání v terénu, ne letiště</translation>
    </message>
    <message>
        <source>elevation 0 in the file, which may stand for unknown</source>
        <translation>nadmořská výška v souboru je 0, což může znamenat neznámou</translation>
    </message>
    <message>
        <source>the header has no column &quot;{}&quot;; a .cup file begins with name,code,country,lat,lon,elev,style,rwdir,rwlen,...</source>
        <translation>v záhlaví není sloupec &quot;%1&quot;; soubor .cup začíná name,code,country,lat,lon,elev,style,rwdir,rwlen,...</translation>
    </message>
    <message>
        <source>no geometry</source>
        <translation>chybí geometrie</translation>
    </message>
    <message>
        <source>geometry without coordinates</source>
        <translation>geometrie bez souřadnic</translation>
    </message>
    <message>
        <source>a geometry of unknown type</source>
        <translation>geometrie neznámého typu</translation>
    </message>
    <message>
        <source>coordinates are no places in degrees of longitude and latitude</source>
        <translation>souřadnice nejsou platné polohy ve stupních zeměpisné délky a šířky</translation>
    </message>
    <message>
        <source>the FeatureCollection has no list &quot;features&quot;</source>
        <translation>FeatureCollection nemá seznam &quot;features&quot;</translation>
    </message>
    <message>
        <source>this is no GeoJSON: it has no &quot;type&quot; of a FeatureCollection, Feature or geometry</source>
        <translation>toto není GeoJSON: nemá &quot;type&quot; pro FeatureCollection, Feature nebo geometrii</translation>
    </message>
    <message>
        <source>there is not enough memory for the file; choose wider cells</source>
        <translation>na soubor nestačí paměť; zvolte větší buňky</translation>
    </message>
    <message>
        <source>the file could not be made</source>
        <translation>soubor nelze vytvořit</translation>
    </message>
    <message>
        <source>there would be more than 2,000 levels of contours; choose a wider interval</source>
        <translation>vrstevnic by bylo více než 2 000 úrovní; zvolte větší interval</translation>
    </message>
    <message>
        <source>the contours could not be drawn</source>
        <translation>vrstevnice nelze vykreslit</translation>
    </message>
    <message>
        <source>the map was stopped; nothing was written</source>
        <translation>výpočet mapy byl zastaven; nic nebylo zapsáno</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>konečné číslo</translation>
    </message>
    <message>
        <source>more than</source>
        <translation>více než</translation>
    </message>
    <message>
        <source>at least</source>
        <translation>nejméně</translation>
    </message>
    <message>
        <source>more than {} and at most {}{}</source>
        <translation>více než %1 a nejvýše %2%3</translation>
    </message>
    <message>
        <source>{}, line {}, column {} ({})</source>
        <translation>%1, řádek %2, sloupec %3 (%4)</translation>
    </message>
    <message>
        <source>must be an object in braces {{...}}, not {}</source>
        <translation>musí být objekt ve složených závorkách {...}, ne %1</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is missing; is {} meant?</source>
        <translation>chybí &quot;%1&quot;; je jím myšleno %2?</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is missing; add it</source>
        <translation>chybí &quot;%1&quot;; doplňte to</translation>
    </message>
    <message>
        <source>must be a number, {}, not {}</source>
        <translation>musí být číslo, %1, ne %2</translation>
    </message>
    <message>
        <source>must be {}, not {}</source>
        <translation>musí být %1, ne %2</translation>
    </message>
    <message>
        <source>at least {}</source>
        <translation>nejméně %1</translation>
    </message>
    <message>
        <source>must be a whole number, {}, not {}</source>
        <translation>musí být celé číslo, %1, ne %2</translation>
    </message>
    <message>
        <source>must be a whole number, 0 to 18446744073709551615, not {}</source>
        <translation>musí být celé číslo, 0 až 18446744073709551615, ne %1</translation>
    </message>
    <message>
        <source>must be true or false, not {}</source>
        <translation>musí být true nebo false, ne %1</translation>
    </message>
    <message>
        <source>must not be empty</source>
        <translation>nesmí být prázdné</translation>
    </message>
    <message>
        <source>must be text in quotes, not {}</source>
        <translation>musí být text v uvozovkách, ne %1</translation>
    </message>
    <message>
        <source>must be a list in brackets [...], not {}</source>
        <translation>musí být seznam v hranatých závorkách [...], ne %1</translation>
    </message>
    <message>
        <source>&quot;{}_deg&quot; is given too; keep one of them</source>
        <translation>je zadáno i &quot;%1_deg&quot;; ponechte jen jedno z nich</translation>
    </message>
    <message>
        <source>must be &quot;{}&quot;, not {}</source>
        <translation>musí být &quot;%1&quot;, ne %2</translation>
    </message>
    <message>
        <source>unknown field {}; remove it</source>
        <translation>neznámé pole %1; odstraňte je</translation>
    </message>
    <message>
        <source>unknown field {}; is &quot;{}&quot; meant?</source>
        <translation>neznámé pole %1; je jím myšleno &quot;%2&quot;?</translation>
    </message>
    <message>
        <source>this is not a {} file: its format is {}</source>
        <translation>toto není soubor formátu %1: jeho formát je %2</translation>
    </message>
    <message>
        <source>written by a newer Volplane (version {} of the format, this program reads up to {}); update Volplane</source>
        <translation>zapsáno novějším Volplane (verze formátu %1, tento program čte nejvýše verzi %2); aktualizujte Volplane</translation>
    </message>
    <message>
        <source>an object has more than {} members; this is no file of this program</source>
        <translation>objekt má více než %1 členů; toto není soubor tohoto programu</translation>
    </message>
    <message>
        <source>{} is given twice; keep one of them</source>
        <translation>%1 je zadáno dvakrát; ponechte jen jedno z nich</translation>
    </message>
    <message>
        <source>nested deeper than {} levels; this is no file of this program</source>
        <translation>vnořeno do více než %1 úrovní; toto není soubor tohoto programu</translation>
    </message>
    <message>
        <source>more than {} values; this is no file of this program</source>
        <translation>více než %1 hodnot; toto není soubor tohoto programu</translation>
    </message>
    <message>
        <source>{}, line {}, column {}</source>
        <translation>%1, řádek %2, sloupec %3</translation>
    </message>
    <message>
        <source>a long text</source>
        <translation>dlouhý text</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>objekt</translation>
    </message>
    <message>
        <source>this is not JSON ({})</source>
        <translation>toto není JSON (%1)</translation>
    </message>
    <message>
        <source>the number {} is too large; write a finite one</source>
        <translation>číslo %1 je příliš velké; zapište konečné číslo</translation>
    </message>
    <message>
        <source>the JSON text ends in the middle; the file is cut short or a closing bracket is missing</source>
        <translation>text JSON končí uprostřed; soubor je neúplný, nebo chybí uzavírací závorka</translation>
    </message>
    <message>
        <source>this is not JSON: {}; near &apos;{}&apos;</source>
        <translation>toto není JSON: %1; u &apos;%2&apos;</translation>
    </message>
    <message>
        <source>{} is no surface; use one of {}</source>
        <translation>%1 není povrch; použijte jeden z těchto: %2</translation>
    </message>
    <message>
        <source>must be {}a profile in braces {{...}}, not {}</source>
        <translation>musí být %1profil ve složených závorkách {...}, ne %2</translation>
    </message>
    <message>
        <source>the name of an aircraft or </source>
        <translation>název letadla nebo </translation>
    </message>
    <message>
        <source>{} are too many; a mission has {} at most</source>
        <translation>%1 je příliš mnoho; mise jich má nejvýše %2</translation>
    </message>
    <message>
        <source>at least one terrain file is needed</source>
        <translation>je třeba alespoň jeden soubor terénu</translation>
    </message>
    <message>
        <source>the file was changed while it was read; try again when nothing writes to it any more</source>
        <translation>soubor byl během čtení změněn; zkuste to znovu, až do něj nic nebude zapisovat</translation>
    </message>
    <message>
        <source>{} left out: farther than {:.1f} km from {}</source>
        <translation>%1 vynecháno: dále než %2 km od %3</translation>
    </message>
    <message>
        <source>the point that the mission gives</source>
        <translation>bodu, který udává mise</translation>
    </message>
    <message>
        <source>every target</source>
        <translation>každého cíle</translation>
    </message>
    <message>
        <source>reading the airfields was stopped</source>
        <translation>čtení letišť bylo zastaveno</translation>
    </message>
    <message>
        <source>{}: elevation {:.0f} m, but the terrain there is {:.0f} m; check both before relying on this site</source>
        <translation>%1: výška dráhy %2 m, ale terén je tam v %3 m; než se na toto přistávací místo spolehnete, ověřte obojí</translation>
    </message>
    <message>
        <source>{} landing sites lie outside the terrain or where it has no data and are not used</source>
        <translation>přistávací místa, která leží mimo terén nebo tam, kde nemá data, a nepoužijí se: %1</translation>
    </message>
    <message>
        <source>not landed on in this wind</source>
        <translation>nepoužito, při tomto větru se tam nepřistává</translation>
    </message>
    <message>
        <source>too short to be landed on that day</source>
        <translation>nepoužito, v daný den příliš krátké k přistání</translation>
    </message>
    <message>
        <source>targets {} and {} are at the same place; remove one of them</source>
        <translation>cíle %1 a %2 jsou na stejném místě; jeden z nich odeberte</translation>
    </message>
    <message>
        <source>siteFilter names {}, but no landing site inside the terrain is called that; correct the name or remove it</source>
        <translation>siteFilter uvádí %1, ale žádné přistávací místo uvnitř terénu se tak nejmenuje; název opravte, nebo odstraňte</translation>
    </message>
    <message>
        <source>target {} at {:.5f}, {:.5f} lies {}; move it or load terrain that covers it</source>
        <translation>cíl %1 v %2, %3 leží %4; přesuňte jej, nebo načtěte terén, který jej pokrývá</translation>
    </message>
    <message>
        <source>outside the terrain</source>
        <translation>mimo terén</translation>
    </message>
    <message>
        <source>where the terrain has no data</source>
        <translation>tam, kde terén nemá data</translation>
    </message>
    <message>
        <source>target {} at {:.0f} m MSL lies below the ground there ({:.0f} m); give a greater height, or one above ground</source>
        <translation>cíl %1 ve výšce %2 m MSL leží pod tamním terénem (%3 m); zadejte větší výšku, nebo výšku nad zemí</translation>
    </message>
    <message>
        <source>reading the airspaces was stopped</source>
        <translation>čtení vzdušných prostorů bylo zastaveno</translation>
    </message>
    <message>
        <source>in this wind the aircraft may land on no runway inside the terrain: {}; wait for less wind, load terrain with other runways, or correct the limits of the aircraft</source>
        <translation>při tomto větru nesmí letadlo přistát na žádné dráze uvnitř terénu: %1; počkejte na slabší vítr, načtěte terén s jinými dráhami, nebo opravte meze letadla</translation>
    </message>
    <message>
        <source>every runway inside the terrain is too short for the aircraft on that day: {}; load terrain with other runways, or correct the landing distance of the aircraft</source>
        <translation>každá dráha uvnitř terénu je pro letadlo v daný den příliš krátká: %1; načtěte terén s jinými dráhami, nebo opravte délku přistání letadla</translation>
    </message>
    <message>
        <source>no usable landing site lies inside the terrain; load terrain that covers a runway, add airfields, or relax the site filter</source>
        <translation>uvnitř terénu neleží žádné použitelné přistávací místo; načtěte terén, který pokrývá nějakou dráhu, přidejte letiště, nebo zmírněte filtr drah</translation>
    </message>
    <message>
        <source>; the plan needs the terrain it was made with to be verified</source>
        <translation>; k ověření potřebuje plán terén, se kterým byl vytvořen</translation>
    </message>
    <message>
        <source>export the file from ourairports.com/data again</source>
        <translation>exportujte soubor z ourairports.com/data znovu</translation>
    </message>
    <message>
        <source>this is an airports file; name runways.csv as &quot;runways&quot;</source>
        <translation>toto je soubor letišť; jako &quot;runways&quot; uveďte runways.csv</translation>
    </message>
    <message>
        <source>this is a runways file; name airports.csv as &quot;airports&quot; and this one as &quot;runways&quot;</source>
        <translation>toto je soubor drah; jako &quot;airports&quot; uveďte airports.csv a tento jako &quot;runways&quot;</translation>
    </message>
    <message>
        <source>the header has no column &quot;{}&quot;; {}</source>
        <translation>v záhlaví není sloupec &quot;%1&quot;; %2</translation>
    </message>
    <message>
        <source>the row has {} fields and the header {}; a comma or a quote is missing or too many</source>
        <translation>počet polí řádku je %1, počet polí záhlaví %2; čárka nebo uvozovka chybí, nebo přebývá</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not a number of degrees; correct it or remove the row</source>
        <translation>„%1“ není číslo ve stupních; opravte to, nebo řádek odstraňte</translation>
    </message>
    <message>
        <source>airport without a usable position</source>
        <translation>letiště bez použitelné polohy</translation>
    </message>
    <message>
        <source>airport closed</source>
        <translation>letiště uzavřeno</translation>
    </message>
    <message>
        <source>seaplane base</source>
        <translation>letiště pro hydroplány</translation>
    </message>
    <message>
        <source>more than {} airports; take the part of the file for the region</source>
        <translation>více než %1 letišť; vezměte ze souboru část pro danou oblast</translation>
    </message>
    <message>
        <source>headings of the two ends are not opposite; the first counts</source>
        <translation>kurzy obou konců nejsou opačné; platí první</translation>
    </message>
    <message>
        <source>heading disagrees with the runway number; the heading counts</source>
        <translation>kurz nesouhlasí s číslem dráhy; platí kurz</translation>
    </message>
    <message>
        <source>runway without a name</source>
        <translation>dráha bez názvu</translation>
    </message>
    <message>
        <source>{} in row {}</source>
        <translation>%1 na řádku %2</translation>
    </message>
    <message>
        <source>opposite end not in the file</source>
        <translation>opačný konec v souboru není</translation>
    </message>
    <message>
        <source>elevation makes no sense</source>
        <translation>nadmořská výška nedává smysl</translation>
    </message>
    <message>
        <source>length makes no sense</source>
        <translation>délka nedává smysl</translation>
    </message>
    <message>
        <source>width makes no sense</source>
        <translation>šířka nedává smysl</translation>
    </message>
    <message>
        <source>displaced threshold makes no sense</source>
        <translation>posunutý práh nedává smysl</translation>
    </message>
    <message>
        <source>lighted, closed and one_way take yes or no</source>
        <translation>hodnotou lighted, closed a one_way je yes nebo no</translation>
    </message>
    <message>
        <source>course is no number of 0 to 360 degrees</source>
        <translation>kurz není číslo 0 až 360 stupňů</translation>
    </message>
    <message>
        <source>neither a course nor the other end nor a runway number</source>
        <translation>chybí kurz, druhý konec i číslo dráhy</translation>
    </message>
    <message>
        <source>latitude and longitude are no place in degrees</source>
        <translation>zeměpisná šířka a délka nejsou platná poloha ve stupních</translation>
    </message>
    <message>
        <source>field of </source>
        <translation>letiště </translation>
    </message>
    <message>
        <source>the header lacks latitude and longitude, or course_deg (or end_latitude and end_longitude, or runway)</source>
        <translation>v záhlaví chybí latitude a longitude, nebo course_deg (případně end_latitude a end_longitude, nebo runway)</translation>
    </message>
    <message>
        <source>neither a point nor a line</source>
        <translation>ani bod, ani čára</translation>
    </message>
    <message>
        <source>must be [metres east, metres north, heading in radians]</source>
        <translation>musí být [metry na východ, metry na sever, kurz v radiánech]</translation>
    </message>
    <message>
        <source>there is no element {} in {}, which has {}</source>
        <translation>prvek %1 není v seznamu %2; počet jeho prvků je %3</translation>
    </message>
    <message>
        <source>the file names no coordinate system and its coordinates are no degrees; add the .prj file that belongs to it</source>
        <translation>soubor neuvádí souřadnicový systém a jeho souřadnice nejsou stupně; přidejte soubor .prj, který k němu patří</translation>
    </message>
    <message>
        <source>the coordinate system of the file is none that the program understands; save it in WGS 84 degrees (EPSG:4326)</source>
        <translation>souřadnicovému systému souboru program nerozumí; uložte jej ve stupních WGS 84 (EPSG:4326)</translation>
    </message>
    <message>
        <source>this is no file of polygons that the program reads (GeoJSON, shapefile, GeoPackage, KML)</source>
        <translation>toto není soubor ploch, který program čte (GeoJSON, shapefile, GeoPackage, KML)</translation>
    </message>
    <message>
        <source>the file has no polygons; </source>
        <translation>soubor nemá žádné plochy; </translation>
    </message>
    <message>
        <source>more than {} areas; cut the file to the region that is flown over</source>
        <translation>více než %1 ploch; ořízněte soubor na oblast, nad kterou se letí</translation>
    </message>
    <message>
        <source>more than {} corners; cut the file to the region that is flown over</source>
        <translation>více než %1 rohů; ořízněte soubor na oblast, nad kterou se letí</translation>
    </message>
    <message>
        <source>population is read from areas with people in them</source>
        <translation>obyvatelstvo se čte z ploch s obyvateli</translation>
    </message>
    <message>
        <source>no field of this file says how many people live in its polygons; call one POPULATION, or DENSITY for people per square kilometre</source>
        <translation>žádné pole tohoto souboru neříká, kolik lidí v jeho plochách žije; pojmenujte jedno POPULATION, nebo DENSITY pro počet lidí na čtvereční kilometr</translation>
    </message>
    <message>
        <source>{}: 1 feature {} left out; nobody is taken to live there.</source>
        <translation>%1: vynechán 1 prvek %2; má se za to, že tam nikdo nežije.</translation>
    </message>
    <message>
        <source>{}: {} features {} left out; nobody is taken to live there.</source>
        <translation>%1: vynechané prvky %3: %2; má se za to, že tam nikdo nežije.</translation>
    </message>
    <message>
        <source>without a polygon</source>
        <translation>bez plochy</translation>
    </message>
    <message>
        <source>without a number of people</source>
        <translation>bez počtu lidí</translation>
    </message>
    <message>
        <source>no feature has both a polygon and a number of people; this is no file of population</source>
        <translation>žádný prvek nemá zároveň plochu a počet lidí; toto není soubor obyvatelstva</translation>
    </message>
    <message>
        <source>heading derived from the runway&apos;s name, a direction of the wind rose</source>
        <translation>kurz odvozen z názvu dráhy, který je směrem větrné růžice</translation>
    </message>
    <message>
        <source>heading derived from the runway number, taken as true: compasses are unreliable here</source>
        <translation>kurz odvozen z čísla dráhy, bráno jako zeměpisné: kompasy jsou zde nespolehlivé</translation>
    </message>
    <message>
        <source>heading derived from the runway number and the magnetic variation of {:.0f} degrees {}</source>
        <translation>kurz odvozen z čísla dráhy a magnetické deklinace %1° (%2)</translation>
    </message>
    <message>
        <source>the header has no column &quot;{}&quot;</source>
        <translation>v záhlaví není sloupec &quot;%1&quot;</translation>
    </message>
    <message>
        <source>lat and lon are no place like 4632.046N 00953.046E</source>
        <translation>lat a lon nejsou poloha jako 4632.046N 00953.046E</translation>
    </message>
    <message>
        <source>reading the targets was stopped</source>
        <translation>čtení cílů bylo zastaveno</translation>
    </message>
    <message>
        <source>the root of this XML is {}, not gpx</source>
        <translation>kořen tohoto XML je %1, ne gpx</translation>
    </message>
    <message>
        <source>lat and lon are no place in degrees</source>
        <translation>lat a lon nejsou platná poloha ve stupních</translation>
    </message>
    <message>
        <source>link to another file, which is not followed</source>
        <translation>odkaz na jiný soubor, který se nesleduje</translation>
    </message>
    <message>
        <source>a coordinate is no place in degrees</source>
        <translation>souřadnice není platná poloha ve stupních</translation>
    </message>
    <message>
        <source>polygon of less than three corners</source>
        <translation>plocha s méně než třemi rohy</translation>
    </message>
    <message>
        <source>this is no Little Navmap flight plan: LittleNavmap/Flightplan/Waypoints is missing</source>
        <translation>toto není letový plán Little Navmap: chybí LittleNavmap/Flightplan/Waypoints</translation>
    </message>
    <message>
        <source>airport of the flight plan</source>
        <translation>letiště letového plánu</translation>
    </message>
    <message>
        <source>Pos is no place in degrees</source>
        <translation>Pos není platná poloha ve stupních</translation>
    </message>
    <message>
        <source>complex item without a polygon of places</source>
        <translation>položka ComplexItem bez plochy z platných poloh</translation>
    </message>
    <message>
        <source>no waypoint (take-off, landing or another command)</source>
        <translation>není to traťový bod (vzlet, přistání nebo jiný příkaz)</translation>
    </message>
    <message>
        <source>waypoint without a place</source>
        <translation>traťový bod bez polohy</translation>
    </message>
    <message>
        <source>height of a waypoint whose reference is unknown; the usual height is taken</source>
        <translation>výška traťového bodu, u níž není známo, k čemu se vztahuje; použije se obvyklá výška</translation>
    </message>
    <message>
        <source>this is no QGroundControl plan: mission/items is missing</source>
        <translation>toto není plán QGroundControl: chybí mission/items</translation>
    </message>
    <message>
        <source>survey lines need an area of three corners or more and a spacing above zero</source>
        <translation>průzkumné čáry potřebují plochu s alespoň třemi rohy a rozestup větší než nula</translation>
    </message>
    <message>
        <source>a spacing of {:.1f} m gives {:.0f} survey lines; choose a wider one</source>
        <translation>rozestup %1 m dá průzkumných čar %2; zvolte větší</translation>
    </message>
    <message>
        <source>height makes no sense (metres, or with a unit; reference agl or msl)</source>
        <translation>výška nedává smysl (v metrech, nebo s jednotkou; reference agl nebo msl)</translation>
    </message>
    <message>
        <source>the header has no columns latitude and longitude</source>
        <translation>v záhlaví nejsou sloupce latitude a longitude</translation>
    </message>
    <message>
        <source>at the place of another target</source>
        <translation>na místě jiného cíle</translation>
    </message>
    <message>
        <source>height out of range</source>
        <translation>výška mimo dovolený rozsah</translation>
    </message>
    <message>
        <source>more than {} corners of areas; simplify them</source>
        <translation>více než %1 rohů ploch; zjednodušte je</translation>
    </message>
    <message>
        <source>area without extent</source>
        <translation>plocha bez rozlohy</translation>
    </message>
    <message>
        <source>this is no file of targets that the program knows: SeeYou .cup, GPX, KML or KMZ, a table with the columns latitude and longitude, GeoJSON, QGroundControl .plan, Little Navmap .lnmpln</source>
        <translation>toto není soubor cílů, který program zná: SeeYou .cup, GPX, KML nebo KMZ, tabulka se sloupci latitude a longitude, GeoJSON, QGroundControl .plan, Little Navmap .lnmpln</translation>
    </message>
    <message>
        <source>holds {} places; at most {} targets are imported at once, so take a part of them</source>
        <translation>obsahuje %1 míst; najednou se importuje nejvýše %2 cílů, vezměte z nich tedy jen část</translation>
    </message>
    <message>
        <source>gives {} targets or more; at most {} are imported at once, so choose a wider spacing</source>
        <translation>dá %1 cílů nebo více; najednou se importuje nejvýše %2, zvolte tedy větší rozestup</translation>
    </message>
    <message>
        <source>{} survey lines; their ends are targets, which the tour visits in the order that is shortest</source>
        <translation>průzkumné čáry: %1; jejich konce jsou cíle, které trasa navštíví v nejkratším pořadí</translation>
    </message>
    <message>
        <source>{} points of tracks were not taken</source>
        <translation>body stop, které nebyly převzaty: %1</translation>
    </message>
    <message>
        <source>there are no places for targets in this file</source>
        <translation>v tomto souboru nejsou žádná místa pro cíle</translation>
    </message>
    <message>
        <source>the XML is larger than {} MiB; split it</source>
        <translation>XML je větší než %1 MiB; rozdělte je</translation>
    </message>
    <message>
        <source>the XML cannot be read here ({}); the file is damaged or cut short</source>
        <translation>XML zde nelze přečíst (%1); soubor je poškozen nebo neúplný</translation>
    </message>
    <message>
        <source>there is no XML element in this file</source>
        <translation>v tomto souboru není žádný prvek XML</translation>
    </message>
    <message>
        <source>the zip archive is damaged or cut short; save it again</source>
        <translation>archiv zip je poškozen nebo neúplný; uložte jej znovu</translation>
    </message>
    <message>
        <source>unpacks to more than 64 MiB; this is no file that the program reads</source>
        <translation>po rozbalení má více než 64 MiB; takový soubor program nečte</translation>
    </message>
    <message>
        <source>cannot be unpacked: out of memory</source>
        <translation>nelze rozbalit: nestačí paměť</translation>
    </message>
    <message>
        <source>the zip archive is damaged or cut short, or has no </source>
        <translation>archiv zip je poškozen nebo neúplný, nebo soubor </translation>
    </message>
    <message>
        <source> in it</source>
        <translation> v něm není</translation>
    </message>
    <message>
        <source>the archive is encrypted or packed in a way that is not read; save it again</source>
        <translation>archiv je zašifrován nebo zabalen způsobem, který program nečte; uložte jej znovu</translation>
    </message>
    <message>
        <source>holds more than 64 MiB; this is no file that the program reads</source>
        <translation>obsahuje více než 64 MiB; takový soubor program nečte</translation>
    </message>
    <message>
        <source>larger than {} MiB; this is no file that the program reads</source>
        <translation>větší než %1 MiB; takový soubor program nečte</translation>
    </message>
    <message>
        <source>cannot be read: </source>
        <translation>nelze přečíst: </translation>
    </message>
    <message>
        <source>; check its permissions</source>
        <translation>; zkontrolujte přístupová práva</translation>
    </message>
    <message>
        <source>the gzip file is damaged or cut short; download it again</source>
        <translation>soubor gzip je poškozen nebo neúplný; stáhněte jej znovu</translation>
    </message>
    <message>
        <source>cannot be read; check that it exists and its permissions</source>
        <translation>nelze přečíst; zkontrolujte, zda existuje, a jeho přístupová práva</translation>
    </message>
    <message>
        <source>the text is UTF-16; save it as UTF-8</source>
        <translation>text je v UTF-16; uložte jej jako UTF-8</translation>
    </message>
    <message>
        <source>this is not a text file; check that the right file was named</source>
        <translation>toto není textový soubor; zkontrolujte, zda byl uveden správný soubor</translation>
    </message>
    <message>
        <source>feature {}{}: {} is &quot;{}&quot;; {}</source>
        <translation>prvek %1%2: %3 je „%4“; %5</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>zadejte číslo</translation>
    </message>
    <message>
        <source>give it with its unit, for example 3000 m, 25000 ft or FL250, or call the field FLOOR_M or TOP_FT</source>
        <translation>zadejte to s jednotkou, například 3000 m, 25000 ft nebo FL250, nebo pole nazvěte FLOOR_M nebo TOP_FT</translation>
    </message>
    <message>
        <source>weather is read from areas</source>
        <translation>počasí se čte z ploch</translation>
    </message>
    <message>
        <source>no feature has a polygon; this is no file of weather</source>
        <translation>žádný prvek nemá plochu; toto není soubor počasí</translation>
    </message>
    <message>
        <source>feature without a polygon is left out; no weather is taken to be there.</source>
        <translation>prvek bez plochy je vynechán; bere se, že tam žádné počasí není.</translation>
    </message>
    <message>
        <source>features without a polygon are left out; no weather is taken to be there.</source>
        <translation>× prvek bez plochy, vynecháno; bere se, že tam žádné počasí není.</translation>
    </message>
    <message>
        <source>cell does not say how likely it is to come through (SUCCESS); 0.9 for a nautical mile is taken.</source>
        <translation>buňka neuvádí, jak pravděpodobný je průlet (SUCCESS); použije se 0.9 na námořní míli.</translation>
    </message>
    <message>
        <source>cells do not say how likely it is to come through (SUCCESS); 0.9 for a nautical mile is taken.</source>
        <translation>× buňka neuvádí, jak pravděpodobný je průlet (SUCCESS); použije se 0.9 na námořní míli.</translation>
    </message>
    <message>
        <source>cell has a hole, which counts as weather too.</source>
        <translation>buňka má díru, která se také počítá jako počasí.</translation>
    </message>
    <message>
        <source>cells have holes, which count as weather too.</source>
        <translation>× buňka má díru; i díry se počítají jako počasí.</translation>
    </message>
    <message>
        <source>weather {} has a number that is not finite; correct it before it is saved</source>
        <translation>počasí %1 má číslo, které není konečné; před uložením je opravte</translation>
    </message>
    <message>
        <source>a weather cell needs three corners or more</source>
        <translation>buňka počasí potřebuje alespoň tři rohy</translation>
    </message>
    <message>
        <source>the top must be above the floor</source>
        <translation>horní mez musí být nad dolní</translation>
    </message>
    <message>
        <source>a wind such as 270/15kt, 27015G25KT, 270+-20/10-20kt, VRB05KT or calm is expected</source>
        <translation>očekává se vítr jako 270/15kt, 27015G25KT, 270+-20/10-20kt, VRB05KT nebo calm</translation>
    </message>
    <message>
        <source>kt, mps or km/h</source>
        <translation>kt, mps nebo km/h</translation>
    </message>
    <message>
        <source>{} is no unit of speed here; {} is expected</source>
        <translation>%1 zde není jednotka rychlosti; očekává se %2</translation>
    </message>
    <message>
        <source>the unit of the speed is expected, {}</source>
        <translation>očekává se jednotka rychlosti, %1</translation>
    </message>
    <message>
        <source>the wind should end here</source>
        <translation>zde by měl vítr končit</translation>
    </message>
    <message>
        <source>the speed is above 200 kt; a wind of 0 to 200 kt is expected</source>
        <translation>rychlost je nad 200 kt; očekává se vítr 0 až 200 kt</translation>
    </message>
    <message>
        <source>P stands for more than the speed after it, and a wind without an upper limit cannot be planned for</source>
        <translation>P znamená více než rychlost, která za ním následuje, a pro vítr bez horní meze nelze plánovat</translation>
    </message>
    <message>
        <source>a speed of two or three digits is expected</source>
        <translation>očekává se rychlost o dvou nebo třech číslicích</translation>
    </message>
    <message>
        <source>gusts must be stronger than the wind before them</source>
        <translation>poryvy musí být silnější než vítr uvedený před nimi</translation>
    </message>
    <message>
        <source>direction 000 stands for calm, 00000KT; a wind from the north is written 360</source>
        <translation>směr 000 znamená bezvětří, 00000KT; vítr od severu se píše 360</translation>
    </message>
    <message>
        <source>a speed cannot be below zero</source>
        <translation>rychlost nemůže být menší než nula</translation>
    </message>
    <message>
        <source>a speed is expected, such as 15, 10-20, 15G25 or 15+-5</source>
        <translation>očekává se rychlost, například 15, 10-20, 15G25 nebo 15+-5</translation>
    </message>
    <message>
        <source>a number is expected here</source>
        <translation>zde se očekává číslo</translation>
    </message>
    <message>
        <source>the lower speed goes first</source>
        <translation>menší rychlost se píše jako první</translation>
    </message>
    <message>
        <source>the speed would go below zero; write the range, such as 0-15kt</source>
        <translation>rychlost by klesla pod nulu; zapište rozsah, například 0-15kt</translation>
    </message>
    <message>
        <source>degrees to each side of the direction are expected, such as 270+-20/15kt</source>
        <translation>očekávají se stupně na každou stranu od směru, například 270+-20/15kt</translation>
    </message>
    <message>
        <source>a spread of 0 to 180 degrees to each side is expected</source>
        <translation>očekává se rozptyl 0 až 180 stupňů na každou stranu</translation>
    </message>
    <message>
        <source>a slash and a speed are expected after the direction, such as 270/15kt</source>
        <translation>za směrem se očekává lomítko a rychlost, například 270/15kt</translation>
    </message>
    <message>
        <source>four digits are a wind of a winds-aloft forecast, which needs its line of altitudes; else a direction of three digits and a speed are expected, such as 270/15kt</source>
        <translation>čtyři číslice jsou vítr z předpovědi výškového větru, ke které patří její řádek výšek; jinak se očekává směr o třech číslicích a rychlost, například 270/15kt</translation>
    </message>
    <message>
        <source>a direction of three digits is expected, such as 027 or 270, and a speed, such as 270/15kt</source>
        <translation>očekává se směr o třech číslicích, například 027 nebo 270, a rychlost, například 270/15kt</translation>
    </message>
    <message>
        <source>the direction is above 360; 000 to 360 degrees are expected</source>
        <translation>směr je nad 360; očekává se 000 až 360 stupňů</translation>
    </message>
    <message>
        <source>a range of directions is expected, such as 240V300</source>
        <translation>očekává se rozsah směrů, například 240V300</translation>
    </message>
    <message>
        <source>the direction of the wind does not lie in this range, which goes clockwise</source>
        <translation>směr větru neleží v tomto rozsahu, který se počítá po směru hodinových ručiček</translation>
    </message>
    <message>
        <source>the direction is missing here; 000 to 360 degrees or VRB are expected</source>
        <translation>zde chybí směr; očekává se 000 až 360 stupňů nebo VRB</translation>
    </message>
    <message>
        <source>a wind has either speed_mps or leastSpeed_mps and mostSpeed_mps</source>
        <translation>vítr má buď speed_mps, nebo leastSpeed_mps a mostSpeed_mps</translation>
    </message>
    <message>
        <source>peak wind </source>
        <translation>nejsilnější vítr </translation>
    </message>
    <message>
        <source>the wind of the report is measured near the ground and is taken for all heights</source>
        <translation>vítr z hlášení je měřen u země a použije se pro všechny výšky</translation>
    </message>
    <message>
        <source>other winds of the report are not taken: </source>
        <translation>jiné větry z hlášení se nepoužijí: </translation>
    </message>
    <message>
        <source>a wind of a winds-aloft forecast is expected, such as 2715, 2725+00 or 283045</source>
        <translation>očekává se vítr z předpovědi výškového větru, například 2715, 2725+00 nebo 283045</translation>
    </message>
    <message>
        <source>the first two digits are a direction in tens of degrees: 01 to 36, or 51 to 86 from 100 kt on</source>
        <translation>první dvě číslice jsou směr v desítkách stupňů: 01 až 36, nebo 51 až 86 od 100 kt výše</translation>
    </message>
    <message>
        <source>this stands for 199 kt or more, and a wind without an upper limit cannot be planned for</source>
        <translation>toto znamená 199 kt nebo více a s větrem bez horní meze nelze plánovat</translation>
    </message>
    <message>
        <source>{} winds for {} altitudes; take out the altitudes that have none, or keep each wind below its altitude</source>
        <translation>počet větrů %1 neodpovídá počtu výšek %2; vyřaďte výšky, které vítr nemají, nebo ponechte každý vítr pod jeho výškou</translation>
    </message>
    <message>
        <source>a station and its winds are expected after the altitudes, such as BRL 2715 2725+00</source>
        <translation>za výškami se očekává stanice a její větry, například BRL 2715 2725+00</translation>
    </message>
    <message>
        <source>the winds of one station are expected; take out the others</source>
        <translation>očekávají se větry jediné stanice; ostatní vyřaďte</translation>
    </message>
    <message>
        <source>the winds of the station are expected, such as 2715 2725+00</source>
        <translation>očekávají se větry stanice, například 2715 2725+00</translation>
    </message>
    <message>
        <source>what stands before the altitudes is ignored: check that the forecast is valid for the flight</source>
        <translation>co stojí před výškami, se nebere v úvahu: zkontrolujte, zda předpověď pro let platí</translation>
    </message>
    <message>
        <source>temperatures are ignored</source>
        <translation>teploty se neberou v úvahu</translation>
    </message>
    <message>
        <source>station {}: below {} ft its lowest wind is taken</source>
        <translation>stanice %1: pod %2 ft se bere její nejnižší vítr</translation>
    </message>
    <message>
        <source>altitudes from 18000 ft up are flight levels and are taken as heights above mean sea level</source>
        <translation>výšky od 18000 ft výše jsou letové hladiny a berou se jako výšky nad střední hladinou moře</translation>
    </message>
    <message>
        <source>the wind of the report is expected here, such as 27015KT</source>
        <translation>zde se očekává vítr hlášení, například 27015KT</translation>
    </message>
    <message>
        <source>one report is expected; take out the others</source>
        <translation>očekává se jediné hlášení; ostatní vyřaďte</translation>
    </message>
    <message>
        <source>an altitude in whole hundreds of feet, or the station behind the altitudes, is expected</source>
        <translation>očekává se výška v celých stovkách stop, nebo za výškami stanice</translation>
    </message>
    <message>
        <source>wind {} at character {}: {}</source>
        <translation>vítr %1 u znaku %2: %3</translation>
    </message>
    <message>
        <source>a wind, or an altitude in whole hundreds of feet or with its unit, ft or m, is expected</source>
        <translation>očekává se vítr, nebo výška v celých stovkách stop či s jednotkou, ft nebo m</translation>
    </message>
    <message>
        <source>a flight level of two or three digits is expected, such as FL095</source>
        <translation>očekává se letová hladina o dvou nebo třech číslicích, například FL095</translation>
    </message>
    <message>
        <source>the wind should end here, or a semicolon and the next layer follow</source>
        <translation>zde má vítr končit, nebo má následovat středník a další vrstva</translation>
    </message>
    <message>
        <source>with several layers each needs its altitude, such as 5000ft 290/25kt</source>
        <translation>při více vrstvách potřebuje každá svou výšku, například 5000ft 290/25kt</translation>
    </message>
    <message>
        <source>flight levels are taken as heights above mean sea level</source>
        <translation>letové hladiny se berou jako výšky nad střední hladinou moře</translation>
    </message>
    <message>
        <source>any direction</source>
        <translation>jakéhokoli směru</translation>
    </message>
    <message>
        <source>the wind is empty; write for example 270/15kt, 27015G25KT, 0ft 270/15kt; 5000ft 290/25kt, or calm</source>
        <translation>vítr je prázdný; napište například 270/15kt, 27015G25KT, 0ft 270/15kt; 5000ft 290/25kt, nebo calm</translation>
    </message>
    <message>
        <source>still air</source>
        <translation>bezvětří</translation>
    </message>
    <message>
        <source> at every height</source>
        <translation> v každé výšce</translation>
    </message>
    <message>
        <source>calm air</source>
        <translation>bezvětří</translation>
    </message>
    <message>
        <source>every wind</source>
        <translation>každého větru</translation>
    </message>
    <message>
        <source>every wind between the layers of the forecast ({}; true)</source>
        <translation>každého větru mezi vrstvami předpovědi (%1; zeměpisně)</translation>
    </message>
    <message>
        <source>World Magnetic Model {} (NOAA NCEI, BGS), valid {:.0f} to {:.0f}</source>
        <translation>World Magnetic Model %1 (NOAA NCEI, BGS), platnost %2 až %3</translation>
    </message>
    <message>
        <source>stopped while bounding the safe altitudes</source>
        <translation>zastaveno při výpočtu dolních mezí bezpečných výšek</translation>
    </message>
    <message>
        <source>the glide makes no way against the wind on its approach</source>
        <translation>klouzání při přiblížení nepostupuje proti větru vpřed</translation>
    </message>
    <message>
        <source>the aircraft&apos;s profile has no steepest descent, which an approach of a chosen slope needs</source>
        <translation>profil letadla neuvádí nejstrmější klesání, které přiblížení se zvoleným sklonem potřebuje</translation>
    </message>
    <message>
        <source>its approach of {:.1f} degrees cannot be held, as the glide descends at {:.1f} degrees there</source>
        <translation>přiblížení se sklonem %1° nelze dodržet, protože klouzání tam klesá pod úhlem %2°</translation>
    </message>
    <message>
        <source>its approach of {:.1f} degrees cannot be held, as the aircraft descends at no more than {:.1f} degrees there</source>
        <translation>přiblížení se sklonem %1° nelze dodržet, protože letadlo tam klesá nejvýše pod úhlem %2°</translation>
    </message>
    <message>
        <source>the ground under its approach is of unknown height</source>
        <translation>terén pod přiblížením má neznámou výšku</translation>
    </message>
    <message>
        <source>there is no room for a holding circle over known ground at the beginning of its approach</source>
        <translation>na začátku přiblížení není nad známým terénem místo pro vyčkávací kruh</translation>
    </message>
    <message>
        <source>no landing site lies on terrain with known height; load terrain that covers at least one runway of the airfield list</source>
        <translation>žádné přistávací místo neleží na terénu známé výšky; načtěte terén, který pokrývá alespoň jednu dráhu ze seznamu letišť</translation>
    </message>
    <message>
        <source>, and neither do the {} others have theirs</source>
        <translation>, a své nemůže mít ani žádné z ostatních (počet: %1)</translation>
    </message>
    <message>
        <source>no landing site can have the approach that the mission asks for: {}{}</source>
        <translation>žádné přistávací místo nemůže mít přiblížení, které mise žádá: %1%2</translation>
    </message>
    <message>
        <source>roadmap: {} glides</source>
        <translation>síť cest: %1 klouzání</translation>
    </message>
    <message>
        <source>stopped while building the roadmap of landing glides</source>
        <translation>zastaveno při vytváření sítě cest pro klouzání na dráhy</translation>
    </message>
    <message>
        <source>the area for the roadmap of landing glides is empty</source>
        <translation>oblast pro síť cest pro klouzání na dráhy je prázdná</translation>
    </message>
    <message>
        <source>roadmap: {} of {} glides</source>
        <translation>síť cest: %1 z %2 klouzání</translation>
    </message>
    <message>
        <source>the map needs an area, cells of at least 10 m and a course</source>
        <translation>mapa potřebuje oblast, buňky o velikosti nejméně 10 m a kurz</translation>
    </message>
    <message>
        <source>the map would have more than four million values; choose wider cells or fewer courses</source>
        <translation>mapa by měla více než čtyři miliony hodnot; zvolte větší buňky nebo méně kurzů</translation>
    </message>
    <message>
        <source>stopped while looking for other runways</source>
        <translation>zastaveno při hledání jiných drah</translation>
    </message>
    <message>
        <source>other runways: {}</source>
        <translation>jiné dráhy: %1</translation>
    </message>
    <message>
        <source>{:.0f} m long, {:.0f} m needed</source>
        <translation>délka %1 m, potřeba %2 m</translation>
    </message>
    <message>
        <source>more than {} and at most {}</source>
        <translation>větší než %1 a nejvýše %2</translation>
    </message>
    <message>
        <source>between {} and {}</source>
        <translation>mezi %1 a %2</translation>
    </message>
    <message>
        <source>the {} of {}{} is not {}{}</source>
        <translation>%1: hodnota %2%3 není %4%5</translation>
    </message>
    <message>
        <source>temperature offset</source>
        <translation>odchylka teploty</translation>
    </message>
    <message>
        <source>final approach</source>
        <translation>konečné přiblížení</translation>
    </message>
    <message>
        <source>start of the obstacle surface</source>
        <translation>začátek překážkové plochy</translation>
    </message>
    <message>
        <source>approach slope</source>
        <translation>sklon přiblížení</translation>
    </message>
    <message>
        <source>slope of the obstacle surface</source>
        <translation>sklon překážkové plochy</translation>
    </message>
    <message>
        <source>height at high key</source>
        <translation>výška v horním klíčovém bodě</translation>
    </message>
    <message>
        <source>the profile of {} does not say what the drag is with the propeller {}; take the propeller as in its polar, or another profile</source>
        <translation>profil letadla %1 neuvádí, jaký je odpor s vrtulí v tomto stavu: %2; zvolte vrtuli, jak je v poláře letadla, nebo jiný profil</translation>
    </message>
    <message>
        <source>{} has no power setting &quot;{}&quot;; {}</source>
        <translation>letadlo %1 nemá nastavení výkonu „%2“; %3</translation>
    </message>
    <message>
        <source>its profile has none</source>
        <translation>jeho profil žádné nemá</translation>
    </message>
    <message>
        <source>it has </source>
        <translation>má </translation>
    </message>
    <message>
        <source>an approach slope of {} degrees needs a profile that says how steeply the aircraft can descend, and that of {} does not; leave the slope to the best glide</source>
        <translation>sklon přiblížení %1° potřebuje profil, který udává, jak strmě může letadlo klesat, a profil letadla %2 to neudává; ponechte sklon nejlepšímu klouzání</translation>
    </message>
    <message>
        <source>the approach slope of {} degrees is steeper than {} can descend, {} degrees</source>
        <translation>sklon přiblížení %1° je strmější, než jak může klesat letadlo %2, %3°</translation>
    </message>
    <message>
        <source>with a drag factor of {} drag exceeds the weight of {}{}, and no glide exists</source>
        <translation>při činiteli odporu %1 je odpor větší než tíha letadla %2%3 a klouzání neexistuje</translation>
    </message>
    <message>
        <source> in turns of {} degrees of bank</source>
        <translation> v zatáčkách s náklonem %1°</translation>
    </message>
    <message>
        <source>reaction time</source>
        <translation>doba reakce</translation>
    </message>
    <message>
        <source>height lost in the reaction</source>
        <translation>ztráta výšky při reakci</translation>
    </message>
    <message>
        <source>drag factor</source>
        <translation>činitel odporu</translation>
    </message>
    <message>
        <source>person s/ha</source>
        <translation>osobo-s/ha</translation>
    </message>
    <message>
        <source>a polygon has fewer than three different corners; correct it or leave the feature out</source>
        <translation>polygon má méně než tři různé rohy; opravte jej, nebo prvek vynechte</translation>
    </message>
    <message>
        <source>a corner is no place on Earth; correct it or leave the feature out</source>
        <translation>roh není místem na Zemi; opravte jej, nebo prvek vynechte</translation>
    </message>
    <message>
        <source>sides of the polygon cross each other at {}; draw the outline without the loop, for example with QGIS &gt; Fix geometries</source>
        <translation>strany polygonu se navzájem kříží v %1; nakreslete obrys bez smyčky, například pomocí QGIS &gt; Fix geometries</translation>
    </message>
    <message>
        <source>a hole lies outside its polygon at {}; make it a polygon of its own or leave it out</source>
        <translation>díra leží mimo svůj polygon v %1; udělejte z ní samostatný polygon, nebo ji vynechte</translation>
    </message>
    <message>
        <source>{} is {:g}, which cannot be; correct it or leave the feature out</source>
        <translation>%1 je %2, což není možné; opravte to, nebo prvek vynechte</translation>
    </message>
    <message>
        <source>the number of people</source>
        <translation>počet lidí</translation>
    </message>
    <message>
        <source>the number of people per square kilometre</source>
        <translation>počet lidí na kilometr čtvereční</translation>
    </message>
    <message>
        <source>it covers no ground that people could live on; correct its outline or leave the feature out</source>
        <translation>nepokrývá žádnou plochu, na které by mohli žít lidé; opravte obrys, nebo prvek vynechte</translation>
    </message>
    <message>
        <source>a probability of {:g} to come through cannot be; give one above 0 and up to 1, for example 0.95</source>
        <translation>pravděpodobnost průletu %1 není možná; zadejte hodnotu nad 0 a nejvýše 1, například 0.95</translation>
    </message>
    <message>
        <source>its probability holds for {:g} m, which is no distance; give one above 0, for example 1852 m</source>
        <translation>pravděpodobnost platí na %1 m, což není vzdálenost; zadejte vzdálenost nad 0, například 1852 m</translation>
    </message>
    <message>
        <source>its floor or its top is no finite number; give metres above mean sea level, or leave it out</source>
        <translation>dolní nebo horní mez není konečné číslo; zadejte metry nad střední hladinou moře, nebo ji vynechte</translation>
    </message>
    <message>
        <source>its floor at {:.0f} m MSL is not below its top at {:.0f} m MSL; exchange or correct them</source>
        <translation>dolní mez %1 m MSL není pod horní mezí %2 m MSL; zaměňte je, nebo je opravte</translation>
    </message>
    <message>
        <source>its outline has fewer than three different corners; add corners or leave the cell out</source>
        <translation>obrys má méně než tři různé rohy; přidejte rohy, nebo buňku vynechte</translation>
    </message>
    <message>
        <source>a corner is no place on Earth; correct it or leave the cell out</source>
        <translation>roh není místem na Zemi; opravte jej, nebo buňku vynechte</translation>
    </message>
    <message>
        <source>sides of its outline cross each other at {}; draw it without the loop, or as two cells</source>
        <translation>strany obrysu se navzájem kříží v %1; nakreslete jej bez smyčky, nebo jako dvě buňky</translation>
    </message>
    <message>
        <source>the plan has no tour to export; plan a mission with at least one target</source>
        <translation>plán nemá trasu, která by se exportovala; naplánujte misi s alespoň jedním cílem</translation>
    </message>
    <message>
        <source>the ways from and to the home runway do not fit the plan; plan the mission again</source>
        <translation>cesty z domovské dráhy a na ni se k plánu nehodí; naplánujte misi znovu</translation>
    </message>
    <message>
        <source>the turns of the tour follow each other too closely to be flown from waypoint to waypoint</source>
        <translation>zatáčky trasy následují za sebou příliš těsně, než aby se daly letět z bodu do bodu</translation>
    </message>
    <message>
        <source>takeoff: no gliding guarantee yet</source>
        <translation>vzlet: záruka doklouzání ještě neplatí</translation>
    </message>
    <message>
        <source>far end of the runway: no gliding guarantee yet</source>
        <translation>vzdálený konec dráhy: záruka doklouzání ještě neplatí</translation>
    </message>
    <message>
        <source>no gliding guarantee yet</source>
        <translation>záruka doklouzání ještě neplatí</translation>
    </message>
    <message>
        <source>gliding guarantee begins</source>
        <translation>záruka doklouzání začíná</translation>
    </message>
    <message>
        <source>above the threshold: gliding guarantee ends</source>
        <translation>nad prahem: záruka doklouzání končí</translation>
    </message>
    <message>
        <source>landing: no gliding guarantee any more</source>
        <translation>přistání: záruka doklouzání již neplatí</translation>
    </message>
    <message>
        <source>Nothing is known of gliding guarantees on this route.</source>
        <translation>O záruce doklouzání na této trati není nic známo.</translation>
    </message>
    <message>
        <source>The gliding guarantee begins {:.0f} m of flight past the far end of the runway of {}, at {} ft MSL, at or before SAFE-BEGIN, and ends above the threshold of {} at {} ft MSL; before and after that no glide to a runway is guaranteed.</source>
        <translation>Záruka doklouzání začíná po %1 m letu za vzdáleným koncem dráhy %2, v %3 ft MSL, v bodě SAFE-BEGIN nebo před ním, a končí nad prahem dráhy %4 v %5 ft MSL; předtím a potom není zaručeno žádné klouzání na dráhu.</translation>
    </message>
    <message>
        <source>the turns where the way </source>
        <translation>zatáčky, kde se cesta </translation>
    </message>
    <message>
        <source> home meets the tour follow each other too closely to be flown from waypoint to waypoint</source>
        <translation> letiště (domov) setkává s trasou, následují za sebou příliš těsně, než aby se daly letět z bodu do bodu</translation>
    </message>
    <message>
        <source>{:.1f} km from {} ({})</source>
        <translation>%1 km od cíle %2 (%3)</translation>
    </message>
    <message>
        <source>stopped while checking the waypoints</source>
        <translation>zastaveno při kontrole traťových bodů</translation>
    </message>
    <message>
        <source>flown from waypoint to waypoint the path comes over ground of unknown height </source>
        <translation>při letu z bodu do bodu vede dráha letu nad terén neznámé výšky </translation>
    </message>
    <message>
        <source>flown from waypoint to waypoint no glide reaches a landing site from the place </source>
        <translation>při letu z bodu do bodu nedosáhne žádné klouzání přistávacího místa z místa </translation>
    </message>
    <message>
        <source>the surface</source>
        <translation>povrch země</translation>
    </message>
    <message>
        <source>{:.0f} m above ground</source>
        <translation>%1 m nad zemí</translation>
    </message>
    <message>
        <source>FL {:.0f} (taken as {:.0f} m MSL: standard atmosphere, QNH 1013.25 hPa)</source>
        <translation>FL %1 (bere se jako %2 m MSL: standardní atmosféra, QNH 1013.25 hPa)</translation>
    </message>
    <message>
        <source>a limit in words (NOTAM)</source>
        <translation>mez daná slovy (NOTAM)</translation>
    </message>
    <message>
        <source>{} (class {}, {} to {})</source>
        <translation>%1 (třída %2, %3 až %4)</translation>
    </message>
    <message>
        <source>an airspace without a name</source>
        <translation>vzdušný prostor bez názvu</translation>
    </message>
    <message>
        <source>in the spiral at target {}</source>
        <translation>ve spirále u cíle %1</translation>
    </message>
    <message>
        <source>the tour flies {:.0f} m inside {}, first {}</source>
        <translation>trasa vede v délce %1 m vzdušným prostorem: %2, poprvé %3</translation>
    </message>
    <message>
        <source>; the mission keeps the tour out of it: plan again, or allow it (Mission &gt; Airspace)</source>
        <translation>; mise drží trasu mimo něj: plánujte znovu, nebo jej povolte (Mise &gt; Vzdušný prostor)</translation>
    </message>
    <message>
        <source>after an engine failure the glides from {} points, the first from {}, enter {}, which an emergency may</source>
        <translation>po vysazení motoru vletí klouzání z bodů (počet: %1, první: %2) do vzdušného prostoru: %3, což se v nouzi smí</translation>
    </message>
    <message>
        <source>airspace {}: its outline or limits are no places and heights on Earth</source>
        <translation>vzdušný prostor %1: jeho obrys nebo meze nejsou místa a výšky na Zemi</translation>
    </message>
    <message>
        <source>the approach to {} at {:.2f} degrees is flatter than the glide there, which needs up to {:.2f} degrees</source>
        <translation>přiblížení na %1 se sklonem %2° je plošší než tamní klouzání, které potřebuje až %3°</translation>
    </message>
    <message>
        <source>the approach to {} at {:.2f} degrees is steeper than the aircraft can descend there, {:.2f} degrees with the wind from behind</source>
        <translation>přiblížení na %1 se sklonem %2° je strmější, než jak tam může letadlo klesat, %3° s větrem zezadu</translation>
    </message>
    <message>
        <source>the hold before {} has a radius of {:.2f} m to the {}, the aircraft needs {:.2f} m to one side</source>
        <translation>vyčkávání před %1 má poloměr %2 m (strana: %3), letadlo potřebuje %4 m na jednu stranu</translation>
    </message>
    <message>
        <source>the hold before {} crosses ground of unknown height</source>
        <translation>vyčkávání před %1 vede nad terénem neznámé výšky</translation>
    </message>
    <message>
        <source>the hold before {} goes down to {:.1f} m MSL, but its ground of {:.1f} m and the approach need {:.1f} m</source>
        <translation>vyčkávání před %1 klesá do %2 m MSL, ale terén pod ním (%3 m) a přiblížení vyžadují %4 m</translation>
    </message>
    <message>
        <source>after the last whole circle of the hold before {} up to {:.0f} m above the runway may be left, and the steepest descent on the final approach loses {:.0f} m: lose the rest in S-turns or on a part of a circle</source>
        <translation>po posledním celém kruhu vyčkávání před %1 může zbývat až %2 m nad dráhou a nejstrmější klesání na konečném přiblížení ztratí %3 m: zbytek ztraťte v esovitých zatáčkách nebo na části kruhu</translation>
    </message>
    <message>
        <source>glides end at {}, which is {:.0f} m long, but the aircraft needs {:.0f} m to land there</source>
        <translation>klouzání končí na %1 s délkou %2 m, letadlo tam však k přistání potřebuje %3 m</translation>
    </message>
    <message>
        <source>the mission asks for one hold before each landing site that a glide ends at, but the plan has {} before {}</source>
        <translation>mise žádá jedno vyčkávání před každým přistávacím místem, na kterém některé klouzání končí, plán jich však má %1 před %2</translation>
    </message>
    <message>
        <source>landing site {} is approximate: {}</source>
        <translation>přistávací místo %1 je jen přibližné: %2</translation>
    </message>
    <message>
        <source>landing site {} is given at {:.0f} m MSL, but the terrain there is at most {:.0f} m: check both heights</source>
        <translation>přistávací místo %1 je udáno v %2 m MSL, terén tam však má nejvýše %3 m: zkontrolujte obě výšky</translation>
    </message>
    <message>
        <source>the clearance of {:.0f} m leaves no room for what the glide model leaves out (rolling into turns: up to {:.0f} m)</source>
        <translation>odstup %1 m neponechává rezervu na to, co model klouzání vynechává (překlápění do zatáček: až %2 m)</translation>
    </message>
    <message>
        <source>rolling into turns is not modelled and is covered by the clearance only</source>
        <translation>překlápění do zatáček se nepočítá a kryje je pouze odstup</translation>
    </message>
    <message>
        <source>rolling into turns and out of them, at {:.10g} degrees per second, may cost up to {:.0f} m, for which every glide has the height above the ground</source>
        <translation>překlápění do zatáček a z nich rychlostí %1°/s může stát až %2 m a každé klouzání má na to dost výšky nad terénem</translation>
    </message>
    <message>
        <source>the one runway end used</source>
        <translation>jediného použitého konce dráhy</translation>
    </message>
    <message>
        <source>one of {} runway ends</source>
        <translation>jednoho z konců drah (celkem %1)</translation>
    </message>
    <message>
        <source> in still air, {:.1f} against the strongest wind</source>
        <translation> v klidném vzduchu, %1 proti nejsilnějšímu větru</translation>
    </message>
    <message>
        <source>From every point of this tour ({} decision points and all points between them) the aircraft, its engine stopped and gliding at {} m/s in {} with the polar of {} (glide ratio {:.1f} straight ahead{}), can reach {} on the landing course, at least {} m above the terrain on all the way and at least {} m above the runway on arrival. Terrain is the highest ground of each cell of {:.1f} m, runways are as listed in the plan; {}.</source>
        <translation>Z každého bodu této trasy (%1 rozhodovacích bodů a všechny body mezi nimi) může letadlo se zastaveným motorem, klouzající rychlostí %2 m/s za %3 s polárou %4 (klouzavost %5 přímo%6), dosáhnout %7 na přistávacím kurzu, po celé cestě nejméně %8 m nad terénem a při příletu nejméně %9 m nad dráhou. Terén je nejvyšší místo každé buňky po %10 m, dráhy jsou podle plánu; %11.</translation>
    </message>
    <message>
        <source>the check was stopped before it was done; nothing is known about the plan</source>
        <translation>kontrola byla zastavena před dokončením; o plánu není nic známo</translation>
    </message>
    <message>
        <source>as warm as</source>
        <translation>stejně teplý jako</translation>
    </message>
    <message>
        <source> It holds from {:.0f} to {:.0f} m MSL in air {} the standard atmosphere under a QNH of {:.10g} hPa, at the true airspeeds that the indicated best glide speed has there.</source>
        <translation> Platí od %1 do %2 m MSL ve vzduchu, který je %3 standardní atmosféra, při QNH %4 hPa a při pravých vzdušných rychlostech, které tam odpovídají indikované rychlosti nejlepšího klouzání.</translation>
    </message>
    <message>
        <source> It holds for every mass from {:.10g} to {:.10g} kg, at the best glide speed of the mass.</source>
        <translation> Platí pro každou hmotnost od %1 do %2 kg, při rychlosti nejlepšího klouzání dané hmotnosti.</translation>
    </message>
    <message>
        <source> The propeller is taken to {} after the failure.</source>
        <translation> Po vysazení motoru se počítá s vrtulí v tomto stavu: %1.</translation>
    </message>
    <message>
        <source>stand still</source>
        <translation>stojí</translation>
    </message>
    <message>
        <source> The drag is counted as {:.10g} times that of the polar.</source>
        <translation> Odpor se počítá jako %1násobek odporu poláry.</translation>
    </message>
    <message>
        <source> Under power it climbs nowhere steeper than an aircraft can whose rate of climb falls from {:.10g} m/s at sea level to {} m/s at a density altitude of {:.10g} m.</source>
        <translation> S motorem nikde nestoupá strměji, než může letadlo, jehož stoupavost klesá z %1 m/s u hladiny moře na %2 m/s v hustotní výšce %3 m.</translation>
    </message>
    <message>
        <source> The tour is flown at a true airspeed of {:.1f} m/s ({}).</source>
        <translation> Trasa se letí pravou vzdušnou rychlostí %1 m/s (%2).</translation>
    </message>
    <message>
        <source> After the engine stops the pilot may take {:.10g} s to react: for {:.0f} m every glide follows the tour or goes straight on.</source>
        <translation> Po vysazení motoru může pilotovi reakce trvat %1 s: po %2 m sleduje každé klouzání trasu nebo pokračuje přímo.</translation>
    </message>
    <message>
        <source> Until the glide is established it may lose {:.10g} m of height besides.</source>
        <translation> Než je klouzání ustáleno, může se navíc ztratit %1 m výšky.</translation>
    </message>
    <message>
        <source> Every glide ends in a straight final of {:.10g} m</source>
        <translation> Každé klouzání končí přímým konečným přiblížením o délce %1 m</translation>
    </message>
    <message>
        <source>, flown at {:.10g} degrees.</source>
        <translation>, letěným se sklonem %1°.</translation>
    </message>
    <message>
        <source> Every glide ends in one full circle from above the touchdown point</source>
        <translation> Každé klouzání končí jedním celým kruhem z místa nad bodem dotyku</translation>
    </message>
    <message>
        <source>, begun at least {:.10g} m above it.</source>
        <translation>, zahájeným nejméně %1 m nad ním.</translation>
    </message>
    <message>
        <source> On that last part it may be as low above the terrain as an obstacle surface that begins {:.10g} m before the touchdown point and rises by {:.10g} %.</source>
        <translation> V této poslední části smí být nad terénem tak nízko jako překážková plocha, která začíná %1 m před bodem dotyku a stoupá o %2 %.</translation>
    </message>
    <message>
        <source> Before every approach there is room for a hold, down to its altitude in the plan.</source>
        <translation> Před každým přiblížením je místo pro vyčkávání, dolů až do jeho výšky v plánu.</translation>
    </message>
    <message>
        <source> Runways of known length are long enough for an aircraft that lands in {:.10g} m at sea level, with the day&apos;s air, wind, slope and surface.</source>
        <translation> Dráhy známé délky jsou dost dlouhé pro letadlo, které u hladiny moře přistane na %1 m, se vzduchem a větrem daného dne, sklonem a povrchem.</translation>
    </message>
    <message>
        <source>the tour is flown at {:.1f} m/s and glides at up to {:.1f} m/s: speeding up costs {:.0f} m of height, but only {:.0f} m are counted as lost after an engine failure</source>
        <translation>trasa se letí rychlostí %1 m/s a klouže se rychlostí až %2 m/s: zrychlení stojí %3 m výšky, ale po vysazení motoru se jako ztracené počítají jen %4 m</translation>
    </message>
    <message>
        <source>in air {:.10g} K colder than the standard atmosphere an altimeter set at the lowest landing site shows about {:.0f} m too much at the highest point ({:.0f} m MSL), and about {:.0f} m where the flight is closest to its clearance ({:.0f} m MSL): add as much, or fly by satellite height</source>
        <translation>ve vzduchu o %1 K chladnějším než standardní atmosféra ukazuje výškoměr nastavený na nejnižším přistávacím místě asi o %2 m více, než odpovídá skutečnosti, v nejvyšším bodě (%3 m MSL) a asi o %4 m více tam, kde je let nejblíže svému odstupu (%5 m MSL): připočtěte tolik, nebo leťte podle výšky z družic</translation>
    </message>
    <message>
        <source>{} gives no drag for a {} propeller, so its polar is used as it is</source>
        <translation>%1 neuvádí odpor pro vrtuli v tomto stavu: %2, proto se jeho polára použije, jak je</translation>
    </message>
    <message>
        <source>the plan counts with a true airspeed of {:.1f} m/s at {:.0f} m MSL, above the aircraft&apos;s limit of {:.1f} m/s</source>
        <translation>plán počítá s pravou vzdušnou rychlostí %1 m/s v %2 m MSL, a to je nad mezí letadla %3 m/s</translation>
    </message>
    <message>
        <source>{} more findings of rule {} are not listed, {} in all</source>
        <translation>další neuvedené nálezy pravidla %2: %1, celkem %3</translation>
    </message>
    <message>
        <source>{}: its glide turns with a radius of {:.2f} m, the aircraft needs {:.2f} m</source>
        <translation>%1: klouzání zatáčí s poloměrem %2 m, letadlo potřebuje %3 m</translation>
    </message>
    <message>
        <source>{}: its glide ends {:.2f} m from the touchdown point of {}</source>
        <translation>%1: klouzání končí %2 m od bodu dotyku na %3</translation>
    </message>
    <message>
        <source>{}: its glide arrives {:.2f} degrees off the landing course of {}</source>
        <translation>%1: klouzání přilétá s odchylkou %2° od přistávacího kurzu na %3</translation>
    </message>
    <message>
        <source>{}: the last {:.0f} m of its glide to {} are not straight</source>
        <translation>%1: posledních %2 m klouzání na %3 není přímých</translation>
    </message>
    <message>
        <source>{}: its glide to {} does not end in one full circle from above the touchdown point</source>
        <translation>%1: klouzání na %2 nekončí jedním celým kruhem z místa nad bodem dotyku</translation>
    </message>
    <message>
        <source>{}: its glide is at {:.1f} m MSL at the high key of {}, {:.1f} m below the {:.1f} m required</source>
        <translation>%1: klouzání je v horním klíčovém bodě pro %3 v %2 m MSL, %4 m pod požadovanými %5 m</translation>
    </message>
    <message>
        <source>{}: on its glide from {:.1f} m MSL to {} rolling into turns and out of them may cost {:.1f} m up to a place where it is {:.1f} m above the ground: fly {:.1f} m higher, or glide with fewer turns</source>
        <translation>%1: při klouzání z %2 m MSL na %3 může překlápění do zatáček a z nich stát %4 m až po místo, kde je klouzání %5 m nad terénem: leťte o %6 m výše, nebo klouzejte s méně zatáčkami</translation>
    </message>
    <message>
        <source>{}: the glide from {:.1f} m MSL loses {:.1f} m and arrives at {} at {:.1f} m, {:.1f} m below the {:.1f} m required (runway at {:.1f} m)</source>
        <translation>%1: klouzání z %2 m MSL ztratí %3 m a přilétá na %4 ve výšce %5 m, %6 m pod požadovanými %7 m (dráha v %8 m)</translation>
    </message>
    <message>
        <source>{}: the glide from {:.1f} m MSL to {} is at {:.1f} m over ground of {:.1f} m, {:.1f} m too low for the clearance of {:.0f} m</source>
        <translation>%1: klouzání z %2 m MSL na %3 je ve výšce %4 m, terén pod ním má %5 m: o %6 m příliš nízko pro odstup %7 m</translation>
    </message>
    <message>
        <source>{}: the plan gives {:.1f} m MSL as safe altitude, but its glide needs {:.1f} m</source>
        <translation>%1: plán udává jako bezpečnou výšku %2 m MSL, ale klouzání potřebuje %3 m</translation>
    </message>
    <message>
        <source>{}: the tour is at {:.1f} m MSL, below the safe altitude of {:.1f} m that the plan gives</source>
        <translation>%1: trasa je v %2 m MSL, pod bezpečnou výškou %3 m, kterou udává plán</translation>
    </message>
    <message>
        <source>{}: its glide to {} crosses ground of unknown height</source>
        <translation>%1: klouzání na %2 vede nad terénem neznámé výšky</translation>
    </message>
    <message>
        <source>{} glide {} of {}</source>
        <translation>%1, klouzání %2 z %3</translation>
    </message>
    <message>
        <source>the {} has {} points, runway no. {}, meets the tour at point {} and promises a glide from its point {} on, which does not fit the plan</source>
        <translation>%1: počet bodů %2, dráha č. %3, setkání s trasou v bodě %4, klouzání slíbeno od vlastního bodu %5; to se k plánu nehodí</translation>
    </message>
    <message>
        <source>the {} uses {}, but the mission asks for {}</source>
        <translation>%1 používá %2, mise však žádá %3</translation>
    </message>
    <message>
        <source>the {} meets the tour {:.2f} m beside its point {}, {:.2f} m above it</source>
        <translation>%1 se setkává s trasou %2 m vedle jejího bodu %3, %4 m nad ním</translation>
    </message>
    <message>
        <source>{}: the climb-out crosses ground of unknown height</source>
        <translation>%1: vzlet vede nad terénem neznámé výšky</translation>
    </message>
    <message>
        <source>{}: {:.0f} m after the runway the climb-out is {:.1f} m above ground of {:.1f} m, {:.1f} m are required</source>
        <translation>%1: %2 m za dráhou je vzlet %3 m nad terénem, který má %4 m; požaduje se %5 m</translation>
    </message>
    <message>
        <source>the climb-out starts up to {:.0f} m below the highest ground of the terrain cells within {:.0f} m of the runway, which are no finer than {:.0f} m: look out for obstacles there</source>
        <translation>vzlet začíná až %1 m pod nejvyšším místem buněk terénu do %2 m od dráhy, které nejsou jemnější než %3 m: dejte tam pozor na překážky</translation>
    </message>
    <message>
        <source>the departure begins {:.1f} m from the far end of {} at {:.1f} m MSL, the runway is at {:.1f} m</source>
        <translation>odlet začíná %1 m od vzdáleného konce dráhy %2 v %3 m MSL, dráha je v %4 m</translation>
    </message>
    <message>
        <source>the arrival must lead above the threshold of {} with the glide promised all along; it ends {:.1f} m from it, {:.1f} m above it, promised from its point {} on</source>
        <translation>přílet musí vést nad práh dráhy %1 se slíbeným klouzáním po celé cestě; končí %2 m od prahu, %3 m nad ním, a klouzání je slíbeno až od bodu %4 příletu</translation>
    </message>
    <message>
        <source>The same holds on the ways from and to the runway, but for the climb-out: after taking off from {} it begins {:.0f} m of flight past the far end of the runway, at {:.0f} m MSL ({:.0f} m above the runway), and it ends above the threshold of {} at {:.0f} m MSL ({:.0f} m above the runway), from where the landing is the pilot&apos;s.</source>
        <translation>Totéž platí na cestách z dráhy a na ni, kromě vzletu: po vzletu z %1 začíná po %2 m letu za vzdáleným koncem dráhy, v %3 m MSL (%4 m nad dráhou), a končí nad prahem dráhy %5 v %6 m MSL (%7 m nad dráhou), odkud je přistání na pilotovi.</translation>
    </message>
    <message>
        <source>the mission asks for a home runway, but the plan lacks the way from it or to it</source>
        <translation>mise žádá domovskou dráhu, ale v plánu chybí cesta z ní nebo na ni</translation>
    </message>
    <message>
        <source>the plan has a way from or to a runway that the mission does not ask for</source>
        <translation>plán má cestu z dráhy nebo na dráhu, kterou mise nežádá</translation>
    </message>
    <message>
        <source>landing path</source>
        <translation>cesta k přistání</translation>
    </message>
    <message>
        <source>number of legs</source>
        <translation>počet úseků</translation>
    </message>
    <message>
        <source>altitude at the end of a leg</source>
        <translation>výška na konci úseku</translation>
    </message>
    <message>
        <source>landing path: it leads to landing site no. {}, but {} are given</source>
        <translation>cesta k přistání: vede na přistávací místo č. %1, zadaných míst je však %2</translation>
    </message>
    <message>
        <source>landing path: a leg is neither a straight of radius 0 nor a turn of at most {} full circles, so it cannot be flown</source>
        <translation>cesta k přistání: úsek není ani přímá s poloměrem 0, ani zatáčka o nejvýše %1 celých kruzích, takže jej nelze letět</translation>
    </message>
    <message>
        <source>landing path: leg {} turns with a radius of {:.2f} m, the aircraft needs {:.2f} m: widen the turn</source>
        <translation>cesta k přistání: úsek %1 zatáčí s poloměrem %2 m, letadlo potřebuje %3 m: zatáčku rozšiřte</translation>
    </message>
    <message>
        <source>landing path: leg {} changes altitude by {:.1f} m on the spot</source>
        <translation>cesta k přistání: úsek %1 mění výšku o %2 m na místě</translation>
    </message>
    <message>
        <source>landing path: leg {} goes down by {:.2f} degrees, flatter than the glide there, which needs up to {:.2f} degrees: plan it steeper</source>
        <translation>cesta k přistání: úsek %1 klesá pod úhlem %2°, plošeji než tamní klouzání, které potřebuje až %3°: naplánujte jej strmější</translation>
    </message>
    <message>
        <source>landing path: leg {} goes down by {:.2f} degrees, steeper than the aircraft can descend there, {:.2f} degrees: lose the height in circles, or name a steeper descent in the profile</source>
        <translation>cesta k přistání: úsek %1 klesá pod úhlem %2°, strměji, než jak tam může letadlo klesat, %3°: ztraťte výšku v kruzích, nebo uveďte v profilu strmější klesání</translation>
    </message>
    <message>
        <source>landing path: leg {} is at {:.1f} m MSL over ground of {:.1f} m, {:.1f} m too low for the clearance of {:.0f} m</source>
        <translation>cesta k přistání: úsek %1 je v %2 m MSL, terén pod ním má %3 m: o %4 m příliš nízko pro odstup %5 m</translation>
    </message>
    <message>
        <source>landing path: leg {} crosses ground of unknown height</source>
        <translation>cesta k přistání: úsek %1 vede nad terénem neznámé výšky</translation>
    </message>
    <message>
        <source>landing path: its last {:.0f} m to {} are not straight</source>
        <translation>cesta k přistání: posledních %1 m na %2 není přímých</translation>
    </message>
    <message>
        <source>landing path: it does not end in one full circle from above the touchdown point of {}</source>
        <translation>cesta k přistání: nekončí jedním celým kruhem z místa nad bodem dotyku na %1</translation>
    </message>
    <message>
        <source>landing path: it is at {:.1f} m MSL at the high key of {}, {:.1f} m below the {:.1f} m required</source>
        <translation>cesta k přistání: v horním klíčovém bodě pro %2 je v %1 m MSL, %3 m pod požadovanými %4 m</translation>
    </message>
    <message>
        <source>landing path: it ends {:.2f} m from the touchdown point of {}</source>
        <translation>cesta k přistání: končí %1 m od bodu dotyku %2</translation>
    </message>
    <message>
        <source>landing path: it arrives {:.2f} degrees off the landing course of {}</source>
        <translation>cesta k přistání: přilétá %1° mimo přistávací kurz %2</translation>
    </message>
    <message>
        <source>landing path: it arrives at {} at {:.1f} m MSL, {:.1f} m below the {:.1f} m required (runway at {:.1f} m)</source>
        <translation>cesta k přistání: na %1 přilétá v %2 m MSL, o %3 m níže než požadovaných %4 m (dráha v %5 m)</translation>
    </message>
    <message>
        <source>it is {:.0f} m wide, the mission asks for {:.0f} m</source>
        <translation>je široké %1 m, mise žádá %2 m</translation>
    </message>
    <message>
        <source>its surface is not one that the mission allows</source>
        <translation>jeho povrch není z těch, které mise dovoluje</translation>
    </message>
    <message>
        <source>it is not lighted, which the mission asks for</source>
        <translation>není osvětlené, což mise žádá</translation>
    </message>
    <message>
        <source>it lies {:.1f} km away, the mission allows {:.1f} km</source>
        <translation>je vzdálené %1 km, mise dovoluje %2 km</translation>
    </message>
    <message>
        <source>the wind may blow from behind at {:.1f} m/s, the aircraft allows {:.1f} m/s</source>
        <translation>vítr může vát zezadu rychlostí %1 m/s, letadlo dovoluje %2 m/s</translation>
    </message>
    <message>
        <source>the wind may blow across at {:.1f} m/s, the aircraft allows {:.1f} m/s</source>
        <translation>vítr může vát z boku rychlostí %1 m/s, letadlo dovoluje %2 m/s</translation>
    </message>
    <message>
        <source>the mission excludes {}</source>
        <translation>mise vylučuje %1</translation>
    </message>
    <message>
        <source>the mission allows landings on {} only</source>
        <translation>mise dovoluje přistání jen na %1</translation>
    </message>
    <message>
        <source>the mission names neither this site nor any airfield file it could come from</source>
        <translation>mise neuvádí ani toto místo, ani žádný soubor letišť, ze kterého by mohlo pocházet</translation>
    </message>
    <message>
        <source>its geometry is approximate, which the mission excludes</source>
        <translation>jeho geometrie je jen přibližná, což mise vylučuje</translation>
    </message>
    <message>
        <source>it is water, which the mission excludes</source>
        <translation>je to voda, což mise vylučuje</translation>
    </message>
    <message>
        <source>it is {:.0f} m long, the mission asks for {:.0f} m</source>
        <translation>je dlouhé %1 m, mise žádá %2 m</translation>
    </message>
    <message>
        <source>target {}: the plan has it {:.2f} m away from its own position</source>
        <translation>cíl %1: plán jej má %2 m od jeho vlastní polohy</translation>
    </message>
    <message>
        <source>target {}: the terrain below it is unknown, so its altitude is</source>
        <translation>cíl %1: terén pod ním je neznámý, a proto i jeho výška</translation>
    </message>
    <message>
        <source>target {}: the plan puts it at {:.1f} m MSL, terrain and mission at {:.1f} m</source>
        <translation>cíl %1: plán jej klade do %2 m MSL, podle terénu a mise je v %3 m</translation>
    </message>
    <message>
        <source>landing site {}: the plan uses it {:.2f} m and {:.3f} degrees away from its own position and course</source>
        <translation>přistávací místo %1: plán je používá %2 m a %3° mimo jeho vlastní polohu a kurz</translation>
    </message>
    <message>
        <source>landing site {}: position, elevation or course differ from the mission&apos;s</source>
        <translation>přistávací místo %1: poloha, výška nebo kurz se liší od údajů mise</translation>
    </message>
    <message>
        <source>landing site {} must not be used: {}</source>
        <translation>přistávací místo %1 se nesmí použít: %2</translation>
    </message>
    <message>
        <source>landing site {} is listed twice</source>
        <translation>přistávací místo %1 je uvedeno dvakrát</translation>
    </message>
    <message>
        <source>the mission has two targets named {}</source>
        <translation>mise má dva cíle se jménem %1</translation>
    </message>
    <message>
        <source>target {} of the plan is not as the mission has it (position, height or reference)</source>
        <translation>cíl %1 v plánu není takový, jaký je v misi (poloha, výška nebo její vztažná plocha)</translation>
    </message>
    <message>
        <source>target {} is listed twice in the plan</source>
        <translation>cíl %1 je v plánu uveden dvakrát</translation>
    </message>
    <message>
        <source>target {} of the mission is not in the plan</source>
        <translation>cíl %1 z mise není v plánu</translation>
    </message>
    <message>
        <source>{}: {} is {}, must be between {} and {}</source>
        <translation>%1: %2 je %3, musí být mezi %4 a %5</translation>
    </message>
    <message>
        <source>length of a piece</source>
        <translation>délka části</translation>
    </message>
    <message>
        <source>radius of a piece</source>
        <translation>poloměr části</translation>
    </message>
    <message>
        <source>{}: its glide begins to turn {:.1f} m on, but until the pilot reacts after {:.1f} s the aircraft may have gone on for {:.1f} m</source>
        <translation>%1: jeho klouzání začíná zatáčet po %2 m, ale než pilot po %3 s zareaguje, může letadlo letět dál až %4 m</translation>
    </message>
    <message>
        <source>mass is {} kg, must be positive</source>
        <translation>hmotnost je %1 kg, musí být kladná</translation>
    </message>
    <message>
        <source>wing area is {} m2, must be positive</source>
        <translation>plocha křídla je %1 m2, musí být kladná</translation>
    </message>
    <message>
        <source>zero-lift drag is {}, which no aircraft has</source>
        <translation>odpor při nulovém vztlaku je %1, což nemá žádné letadlo</translation>
    </message>
    <message>
        <source>induced drag is {}, which no aircraft has</source>
        <translation>indukovaný odpor je %1, což nemá žádné letadlo</translation>
    </message>
    <message>
        <source>air density is {} kg/m3, must be between 0.01 and 2</source>
        <translation>hustota vzduchu je %1 kg/m3, musí být mezi 0.01 a 2</translation>
    </message>
    <message>
        <source>glide speed is {} m/s, must be positive</source>
        <translation>rychlost klouzání je %1 m/s, musí být kladná</translation>
    </message>
    <message>
        <source>no bank angle for glides is given</source>
        <translation>není uveden žádný náklon při klouzání</translation>
    </message>
    <message>
        <source>{} is {} degrees, must be between 0 and 90</source>
        <translation>%1 je %2°, musí být mezi 0 a 90</translation>
    </message>
    <message>
        <source>a glide bank</source>
        <translation>náklon při klouzání</translation>
    </message>
    <message>
        <source>tour bank</source>
        <translation>náklon na trase</translation>
    </message>
    <message>
        <source>climb limit</source>
        <translation>mez stoupání</translation>
    </message>
    <message>
        <source>descent limit</source>
        <translation>mez klesání</translation>
    </message>
    <message>
        <source>the steepest descent</source>
        <translation>nejstrmější klesání bez motoru</translation>
    </message>
    <message>
        <source>the ceiling is no altitude</source>
        <translation>strop není výška</translation>
    </message>
    <message>
        <source>its masses range from {} to {} kg, which does not hold its {} kg</source>
        <translation>jeho hmotnosti jsou od %1 do %2 kg, což nezahrnuje jeho %3 kg</translation>
    </message>
    <message>
        <source>its greatest speed of {} m/s is not above its glide speed of {} m/s</source>
        <translation>jeho největší rychlost %1 m/s není nad jeho rychlostí klouzání %2 m/s</translation>
    </message>
    <message>
        <source>its stall speed is no speed</source>
        <translation>jeho pádová rychlost není rychlost</translation>
    </message>
    <message>
        <source>zero-lift drag with the propeller windmilling or stopped is {}, which no aircraft has</source>
        <translation>odpor při nulovém vztlaku s protáčející se nebo stojící vrtulí je %1, což nemá žádné letadlo</translation>
    </message>
    <message>
        <source>its rate of climb is not more at sea level than at its service ceiling</source>
        <translation>jeho rychlost stoupání není u hladiny moře větší než v praktickém dostupu</translation>
    </message>
    <message>
        <source>its rate of roll is {} degrees per second, which no aircraft has</source>
        <translation>jeho rychlost klonění je %1°/s, což nemá žádné letadlo</translation>
    </message>
    <message>
        <source>its landing distance is {} m, must be positive</source>
        <translation>jeho délka přistání je %1 m, musí být kladná</translation>
    </message>
    <message>
        <source>the setting {} is {}, which the safety of a plan cannot be measured against</source>
        <translation>nastavení „%1“: %2; vůči tomu nelze bezpečnost plánu posoudit</translation>
    </message>
    <message>
        <source>temperature of the air</source>
        <translation>teplota vzduchu nad standardní atmosférou</translation>
    </message>
    <message>
        <source>altitude in this air</source>
        <translation>výška v tomto vzduchu</translation>
    </message>
    <message>
        <source>airspeed of the tour</source>
        <translation>vzdušná rychlost na trase</translation>
    </message>
    <message>
        <source>length of the final approach</source>
        <translation>délka konečného přiblížení</translation>
    </message>
    <message>
        <source>slope of the final approach</source>
        <translation>sklon konečného přiblížení</translation>
    </message>
    <message>
        <source>{} degrees while the aircraft names no steepest descent</source>
        <translation>%1°, ale letadlo neuvádí nejstrmější klesání bez motoru</translation>
    </message>
    <message>
        <source>height of the high key</source>
        <translation>výška horního klíčového bodu</translation>
    </message>
    <message>
        <source>turn radii of {} m and {} m are none of an aircraft</source>
        <translation>poloměry zatáček %1 m a %2 m nemá žádné letadlo</translation>
    </message>
    <message>
        <source>the polar gives no glide at a bank angle that the profile allows</source>
        <translation>při některém z náklonů, které profil dovoluje, polára nedává žádné klouzání</translation>
    </message>
    <message>
        <source>arrival margin</source>
        <translation>výška při příletu</translation>
    </message>
    <message>
        <source>height lost on reaction</source>
        <translation>ztráta výšky při reakci</translation>
    </message>
    <message>
        <source>tour point {}</source>
        <translation>bod trasy %1</translation>
    </message>
    <message>
        <source>safe altitude</source>
        <translation>bezpečná výška</translation>
    </message>
    <message>
        <source>number of pieces of the glide</source>
        <translation>počet částí klouzání</translation>
    </message>
    <message>
        <source>length of the glide</source>
        <translation>délka klouzání</translation>
    </message>
    <message>
        <source>landing course</source>
        <translation>přistávací kurz</translation>
    </message>
    <message>
        <source>target of the mission</source>
        <translation>cíl mise</translation>
    </message>
    <message>
        <source>circles down</source>
        <translation>počet kruhů dolů</translation>
    </message>
    <message>
        <source>circles up</source>
        <translation>počet kruhů nahoru</translation>
    </message>
    <message>
        <source>lowest altitude</source>
        <translation>nejmenší výška</translation>
    </message>
    <message>
        <source>lower bound</source>
        <translation>dolní mez</translation>
    </message>
    <message>
        <source>lower bound of any tour</source>
        <translation>dolní mez jakékoli trasy</translation>
    </message>
    <message>
        <source>{}: a piece of the tour or of its glide is neither a straight of radius 0 nor a turn of at most {} full circles, so it cannot be flown</source>
        <translation>%1: část trasy nebo jejího klouzání není ani přímá s poloměrem 0, ani zatáčka o nejvýše %2 celých kruzích, proto ji nelze letět</translation>
    </message>
    <message>
        <source>{}: its glide leads to landing site no. {}, but the plan lists {}</source>
        <translation>%1: jeho klouzání vede na přistávací místo č. %2, ale plán jich uvádí %3</translation>
    </message>
    <message>
        <source>{}: it visits target no. {}, but the plan lists {}</source>
        <translation>%1: vede přes cíl č. %2, ale plán jich uvádí %3</translation>
    </message>
    <message>
        <source>a hold is before landing site no. {}, but the plan lists {}</source>
        <translation>vyčkávání je před přistávacím místem č. %1, ale plán jich uvádí %2</translation>
    </message>
    <message>
        <source>a spiral visits target no. {}, but the plan lists {}</source>
        <translation>spirála vede k cíli č. %1, ale plán jich uvádí %2</translation>
    </message>
    <message>
        <source>the plan was made with {} terrain files, but {} were read</source>
        <translation>počet souborů terénu, se kterými byl plán vytvořen, je %1, ale načteno jich bylo %2</translation>
    </message>
    <message>
        <source>{} is not the terrain that the plan was made with (SHA-256 {} now, {} in the plan)</source>
        <translation>%1 není terén, se kterým byl plán vytvořen (SHA-256 nyní %2, v plánu %3)</translation>
    </message>
    <message>
        <source>the plan was made with terrain cells of {} m, but {} m were read</source>
        <translation>plán byl vytvořen s buňkami terénu po %1 m, ale načteny byly po %2 m</translation>
    </message>
    <message>
        <source>origin of the frame</source>
        <translation>počátek soustavy</translation>
    </message>
    <message>
        <source>landing site</source>
        <translation>přistávací místo</translation>
    </message>
    <message>
        <source>landing site </source>
        <translation>přistávací místo </translation>
    </message>
    <message>
        <source>landing site of the mission</source>
        <translation>přistávací místo mise</translation>
    </message>
    <message>
        <source>the terrain grid ({} x {} cells of {} m) cannot be used</source>
        <translation>mřížku terénu (%1 x %2 buněk po %3 m) nelze použít</translation>
    </message>
    <message>
        <source>the plan has no tour</source>
        <translation>plán nemá trasu</translation>
    </message>
    <message>
        <source>{}: the tour turns with a radius of {:.2f} m, the aircraft needs {:.2f} m at its tour bank</source>
        <translation>%1: trasa zatáčí s poloměrem %2 m, letadlo při svém náklonu na trase potřebuje %3 m</translation>
    </message>
    <message>
        <source>{}: the tour turns with a radius of {:.2f} m, but a glide of this aircraft needs {:.2f} m, so it could not follow the turn after an engine failure in it</source>
        <translation>%1: trasa zatáčí s poloměrem %2 m, ale klouzání tohoto letadla potřebuje %3 m, takže by po vysazení motoru v této zatáčce nemohlo zatáčku sledovat</translation>
    </message>
    <message>
        <source>{}: the next decision point is {:.3f} m on, the mission allows {:.3f} m</source>
        <translation>%1: další rozhodovací bod je po %2 m, mise dovoluje %3 m</translation>
    </message>
    <message>
        <source>{}: the way on ends {:.3f} m and {:.5f} degrees from {}</source>
        <translation>%1: cesta dál nekončí v dalším bodě (%4), ale %2 m a %3° mimo něj</translation>
    </message>
    <message>
        <source>{}: the tour climbs at {:.2f} degrees to {}, the aircraft can climb at {:.2f}</source>
        <translation>%1: trasa k dalšímu bodu (%3) stoupá pod úhlem %2°, letadlo může stoupat pod úhlem %4°</translation>
    </message>
    <message>
        <source>{}: the tour descends at {:.2f} degrees to {}, the aircraft may descend at {:.2f}</source>
        <translation>%1: trasa k dalšímu bodu (%3) klesá pod úhlem %2°, letadlo smí klesat pod úhlem %4°</translation>
    </message>
    <message>
        <source>{}: {:.1f} m MSL is above the ceiling of {:.1f} m</source>
        <translation>%1: %2 m MSL je nad stropem %3 m</translation>
    </message>
    <message>
        <source>{}: after an engine failure behind it the aircraft reaches {} at {:.1f} m MSL, {:.1f} m below the {:.1f} m that the glide from there needs</source>
        <translation>%1: po vysazení motoru za ním letadlo dosáhne dalšího bodu (%2) v %3 m MSL, o %4 m níže než %5 m, které klouzání odtamtud potřebuje</translation>
    </message>
    <message>
        <source>{}: {:.1f} m after it the tour is at {:.1f} m MSL over ground of {:.1f} m, {:.1f} m too low for the clearance of {:.0f} m</source>
        <translation>%1: %2 m za ním je trasa v %3 m MSL nad terénem v %4 m, o %5 m příliš nízko pro odstup %6 m</translation>
    </message>
    <message>
        <source>{}: a glide along the tour from here is at {:.1f} m MSL over ground of {:.1f} m, {:.1f} m on, {:.1f} m too low for the clearance of {:.0f} m</source>
        <translation>%1: klouzání odtud podél trasy je po %4 m v %2 m MSL nad terénem v %3 m, o %5 m příliš nízko pro odstup %6 m</translation>
    </message>
    <message>
        <source>{}: {:.1f} m after it the tour crosses ground of unknown height</source>
        <translation>%1: %2 m za ním vede trasa nad terénem neznámé výšky</translation>
    </message>
    <message>
        <source>{} point {} of {}</source>
        <translation>%1: bod %2 z %3</translation>
    </message>
    <message>
        <source>tour point {}: it should visit target {} but passes {:.2f} m beside it</source>
        <translation>bod trasy %1: má vést přes cíl %2, ale míjí jej o %3 m</translation>
    </message>
    <message>
        <source>tour point {}: it passes target {} at {:.1f} m MSL, below its {:.1f} m</source>
        <translation>bod trasy %1: přelétá cíl %2 v %3 m MSL, pod jeho výškou %4 m</translation>
    </message>
    <message>
        <source>the spiral at target {} goes from {:.1f} m to {:.1f} m MSL in {} + {} circles; it must lead from the tour ({:.1f} m) down, not below the target ({:.1f} m), and back in whole circles to one side</source>
        <translation>spirála u cíle %1 vede z %2 m do %3 m MSL v počtu kruhů %4 + %5; musí vést z trasy (%6 m) dolů, ne pod cíl (%7 m), a zpět, v celých kruzích na jednu stranu</translation>
    </message>
    <message>
        <source>the spiral at target {} turns with a radius of {:.2f} m, the aircraft needs {:.2f} m</source>
        <translation>spirála u cíle %1 zatáčí s poloměrem %2 m, letadlo potřebuje %3 m</translation>
    </message>
    <message>
        <source>the spiral at target {} changes height by {:.1f} m in {} circles down and {} up, which is steeper than the aircraft may fly</source>
        <translation>spirála u cíle %1 mění výšku o %2 m v počtu kruhů %3 dolů a %4 nahoru, což je strměji, než letadlo smí letět</translation>
    </message>
    <message>
        <source>the spiral at target {} crosses ground of unknown height</source>
        <translation>spirála u cíle %1 vede nad terénem neznámé výšky</translation>
    </message>
    <message>
        <source>the spiral at target {} is {:.1f} m too low over ground of {:.1f} m for the clearance of {:.0f} m</source>
        <translation>spirála u cíle %1 je nad terénem v %3 m o %2 m příliš nízko pro odstup %4 m</translation>
    </message>
    <message>
        <source>the plan descends to target {}, but the mission asks to pass above low targets</source>
        <translation>plán klesá k cíli %1, ale mise žádá přelet nad nízkými cíli</translation>
    </message>
    <message>
        <source>between {:.0f} and {:.0f} m MSL at target {} the tour leaves the safe altitude in a spiral of {} circles: there the gliding guarantee is suspended</source>
        <translation>mezi %1 a %2 m MSL u cíle %3 trasa opouští bezpečnou výšku ve spirále o počtu kruhů %4: tam je záruka doklouzání přerušena</translation>
    </message>
    <message>
        <source>the plan gives a {} of {:.1f} m, it is {:.1f} m</source>
        <translation>plán uvádí: %1 %2 m, ve skutečnosti je to %3 m</translation>
    </message>
    <message>
        <source>the plan says that no tour over its headings costs less than {:.1f} m, but {} costs {:.1f} m</source>
        <translation>podle plánu žádná trasa přes jeho kurzy nestojí méně než %1 m, ale %2 stojí %3 m</translation>
    </message>
    <message>
        <source>the one that it was refined from</source>
        <translation>jeho trasa před zjemněním</translation>
    </message>
    <message>
        <source>its own</source>
        <translation>jeho vlastní trasa</translation>
    </message>
    <message>
        <source>the plan says that no tour at all costs less than {:.1f} m, but its own costs {:.1f} m</source>
        <translation>podle plánu vůbec žádná trasa nestojí méně než %1 m, ale jeho vlastní stojí %2 m</translation>
    </message>
    <message>
        <source>the plan says that it was refined from a tour of {:.1f} m, but its own costs {:.1f} m</source>
        <translation>podle plánu vznikl zjemněním trasy, která stojí %1 m, ale jeho vlastní stojí %2 m</translation>
    </message>
    <message>
        <source>target {}: no point of the tour visits it</source>
        <translation>cíl %1: nevede přes něj žádný bod trasy</translation>
    </message>
    <message>
        <source>target {} has two spirals</source>
        <translation>cíl %1 má dvě spirály</translation>
    </message>
    <message>
        <source>target {} is passed above its height without a descent</source>
        <translation>cíl %1 se přelétá nad svou výškou, bez klesání k němu</translation>
    </message>
    <message>
        <source>its altitude is {} m MSL, must be between {} and {}</source>
        <translation>její výška je %1 m MSL, musí být mezi %2 a %3</translation>
    </message>
    <message>
        <source>it blows from {} degrees, must be between 0 and 360</source>
        <translation>vane ze směru %1°, musí být mezi 0 a 360</translation>
    </message>
    <message>
        <source>its direction is uncertain by {} degrees, must be between 0 and 180</source>
        <translation>její směr je nejistý o %1°, musí být mezi 0 a 180</translation>
    </message>
    <message>
        <source>its speeds are {} and {} m/s, which no wind has</source>
        <translation>její rychlosti jsou %1 a %2 m/s, což nemá žádný vítr</translation>
    </message>
    <message>
        <source>its least speed of {} m/s is above its greatest of {} m/s</source>
        <translation>její nejmenší rychlost %1 m/s je nad její největší %2 m/s</translation>
    </message>
    <message>
        <source>{:.10g} degrees true</source>
        <translation>%1° zeměpisně</translation>
    </message>
    <message>
        <source>{:.10g} to {:.10g} degrees true</source>
        <translation>%1 až %2° zeměpisně</translation>
    </message>
    <message>
        <source>from {} at {} kt</source>
        <translation>o rychlosti %2 kt ze směru %1</translation>
    </message>
    <message>
        <source>between the wind layers at {:.0f} and {:.0f} m MSL the wind may change by {:.1f} m/s, too fast for a glide at {:.1f} m/s that sinks through it: give winds that differ less, or layers further apart</source>
        <translation>mezi vrstvami větru v %1 a %2 m MSL se vítr může změnit o %3 m/s, což je příliš rychle pro klouzání rychlostí %4 m/s, které mezi nimi klesá: zadejte větry, které se liší méně, nebo vrstvy dále od sebe</translation>
    </message>
    <message>
        <source>wind layer {}: {}</source>
        <translation>vrstva větru %1: %2</translation>
    </message>
    <message>
        <source>wind layer {}: it is not above the layer before it</source>
        <translation>vrstva větru %1: není nad předchozí vrstvou</translation>
    </message>
    <message>
        <source>aircraft {}: with this drag there is no glide at a bank angle that the profile allows</source>
        <translation>letadlo %1: s tímto odporem není při některém z náklonů, které profil dovoluje, žádné klouzání</translation>
    </message>
    <message>
        <source>the wind may blow at {:.1f} m/s, but the aircraft glides at {:.1f} m/s in its steepest turns, so it could be blown backwards</source>
        <translation>vítr může vát rychlostí %1 m/s, ale letadlo v nejstrmějších zatáčkách klouže rychlostí %2 m/s, takže by mohlo být unášeno pozpátku</translation>
    </message>
    <message>
        <source>the wind may blow at {:.1f} m/s, but the tour is flown at {:.1f} m/s, so it could be blown backwards</source>
        <translation>vítr může vát rychlostí %1 m/s, ale trasa se letí rychlostí %2 m/s, takže by letadlo mohlo být unášeno pozpátku</translation>
    </message>
    <message>
        <source>in this wind the aircraft turns with a radius of {:.0f} m, which is none of an aircraft</source>
        <translation>v tomto větru letadlo zatáčí s poloměrem %1 m, což nemá žádné letadlo</translation>
    </message>
    <message>
        <source>every wind </source>
        <translation>každého větru </translation>
    </message>
    <message>
        <source>every wind that at its height lies between those of the layers next to it, and changes from the one to the other nowhere faster than evenly between those that differ most:</source>
        <translation>každého větru, který ve své výšce leží mezi větry sousedních vrstev a od jednoho k druhému se nikde nemění rychleji než rovnoměrně mezi těmi, které se liší nejvíce:</translation>
    </message>
    <message>
        <source>reading the terrain was stopped</source>
        <translation>čtení terénu bylo zastaveno</translation>
    </message>
    <message>
        <source>this is not a coordinate system that GDAL knows</source>
        <translation>toto není souřadnicový systém, který zná GDAL</translation>
    </message>
    <message>
        <source>its coordinate system names a file of datum shifts; state a system that needs none, for example EPSG:4326</source>
        <translation>jeho souřadnicový systém uvádí soubor posunů geodetického data; uveďte systém, který žádný nepotřebuje, například EPSG:4326</translation>
    </message>
    <message>
        <source>no transformation is known between its coordinate system and WGS 84; state its datum with gdal_edit.py -a_srs</source>
        <translation>mezi jeho souřadnicovým systémem a WGS 84 není známa žádná transformace; uveďte jeho geodetické datum pomocí gdal_edit.py -a_srs</translation>
    </message>
    <message>
        <source>the network is used on command only</source>
        <translation>síť se používá jen na příkaz</translation>
    </message>
    <message>
        <source>this is a VRT, which only names other files; name those files themselves, they are joined</source>
        <translation>toto je VRT, který jen uvádí jiné soubory; uveďte přímo tyto soubory, budou spojeny</translation>
    </message>
    <message>
        <source>the terrain files that join here span {} x {} heights, more than {} million; cut out the part that the mission needs or use coarser files</source>
        <translation>soubory terénu, které zde na sebe navazují, mají %1 x %2 výšek, více než %3 milionů; vyřízněte část, kterou mise potřebuje, nebo použijte hrubší soubory</translation>
    </message>
    <message>
        <source>the file changed while it was being read; try again</source>
        <translation>soubor se během čtení změnil; zkuste to znovu</translation>
    </message>
    <message>
        <source>the raster holds no height at all, only no-data; leave it out or fetch it again</source>
        <translation>rastr neobsahuje vůbec žádnou výšku, jen hodnoty no-data; vynechte jej, nebo jej stáhněte znovu</translation>
    </message>
    <message>
        <source>the file is truncated or damaged; fetch it again</source>
        <translation>soubor je neúplný nebo poškozený; stáhněte jej znovu</translation>
    </message>
    <message>
        <source>there is no such file; correct the path of the terrain file</source>
        <translation>takový soubor neexistuje; opravte cestu k souboru terénu</translation>
    </message>
    <message>
        <source>this is a folder; name the terrain files in it one by one</source>
        <translation>toto je složka; uveďte soubory terénu v ní jeden po druhém</translation>
    </message>
    <message>
        <source>this is not a complete raster in a format that is read; give a GeoTIFF, HGT, DTED or ASCII grid</source>
        <translation>toto není úplný rastr ve formátu, který se čte; zadejte GeoTIFF, HGT, DTED nebo ASCII grid</translation>
    </message>
    <message>
        <source>the raster has no coordinate system; add it, for example with gdal_edit.py -a_srs EPSG:4326, or a .prj file beside it</source>
        <translation>rastr nemá souřadnicový systém; přidejte jej, například pomocí gdal_edit.py -a_srs EPSG:4326, nebo souborem .prj vedle něj</translation>
    </message>
    <message>
        <source>the raster&apos;s coordinate system is not tied to the earth; give one, for example with gdal_edit.py -a_srs</source>
        <translation>souřadnicový systém rastru není vázán na Zemi; zadejte takový, například pomocí gdal_edit.py -a_srs</translation>
    </message>
    <message>
        <source>the raster does not say where on the map its pixels lie; rectify it, for example with gdalwarp</source>
        <translation>rastr neuvádí, kde na mapě leží jeho pixely; převeďte jej do mapy, například pomocí gdalwarp</translation>
    </message>
    <message>
        <source>the raster&apos;s pixels have no extent on the map; its georeference is damaged, fetch it again</source>
        <translation>pixely rastru nemají na mapě žádný rozměr; jeho georeference je poškozena, stáhněte jej znovu</translation>
    </message>
    <message>
        <source>the raster has {} x {} heights, and terrain needs at least 2 x 2</source>
        <translation>rastr má %1 x %2 výšek a terén potřebuje nejméně 2 x 2</translation>
    </message>
    <message>
        <source>the file holds no band of heights; if it is a container, extract the elevation raster with gdal_translate</source>
        <translation>soubor neobsahuje žádné pásmo výšek; je-li to kontejner, vyjměte výškový rastr pomocí gdal_translate</translation>
    </message>
    <message>
        <source>the raster has {} bands where terrain has one; extract the heights with gdal_translate -b</source>
        <translation>počet pásem rastru je %1, terén má jedno; vyjměte výšky pomocí gdal_translate -b</translation>
    </message>
    <message>
        <source>the raster holds colours or complex numbers, not heights; give an elevation raster</source>
        <translation>rastr obsahuje barvy nebo komplexní čísla, ne výšky; zadejte výškový rastr</translation>
    </message>
    <message>
        <source>the raster&apos;s scale {} and offset {} give no heights; correct them with gdal_edit.py</source>
        <translation>měřítko %1 a posun %2 rastru nedávají výšky; opravte je pomocí gdal_edit.py</translation>
    </message>
    <message>
        <source>the raster&apos;s unit &quot;{}&quot; is not one of length that is known here; set it to m or ft with gdal_edit.py -units</source>
        <translation>jednotka rastru „%1“ není jednotka délky, která je zde známa; nastavte ji na m nebo ft pomocí gdal_edit.py -units</translation>
    </message>
    <message>
        <source>there is no such file; correct the path</source>
        <translation>takový soubor neexistuje; opravte cestu</translation>
    </message>
    <message>
        <source>this is not a file; name the file itself</source>
        <translation>toto není soubor; uveďte přímo soubor</translation>
    </message>
    <message>
        <source>the file cannot be opened; check that it may be read</source>
        <translation>soubor nelze otevřít; zkontrolujte, zda se smí číst</translation>
    </message>
    <message>
        <source>the file cannot be read to its end; check the disk and copy it again</source>
        <translation>soubor nelze přečíst do konce; zkontrolujte disk a zkopírujte jej znovu</translation>
    </message>
    <message>
        <source>the raster&apos;s corners do not lie on the earth in its coordinate system; correct the one or the other</source>
        <translation>rohy rastru v jeho souřadnicovém systému neleží na Zemi; opravte jedno nebo druhé</translation>
    </message>
    <message>
        <source>no terrain file is named; give at least one elevation raster</source>
        <translation>není uveden žádný soubor terénu; zadejte alespoň jeden výškový rastr</translation>
    </message>
    <message>
        <source>the raster reaches too far from the mission for its local frame; cut out the part around the mission with gdalwarp -te</source>
        <translation>rastr sahá příliš daleko od mise pro její místní soustavu; vyřízněte část kolem mise pomocí gdalwarp -te</translation>
    </message>
    <message>
        <source>the terrain files together span {:.0f} x {:.0f} km, more than {:.0f} km; load only those around the mission</source>
        <translation>soubory terénu dohromady zabírají %1 x %2 km, více než %3 km; načtěte jen ty kolem mise</translation>
    </message>
    <message>
        <source>a terrain cell of {} m is not possible; give a size above zero</source>
        <translation>buňka terénu %1 m není možná; zadejte velikost nad nulou</translation>
    </message>
    <message>
        <source>terrain cells of {} m over {:.0f} x {:.0f} km would be more than {:.0f}; give a larger cell size</source>
        <translation>buněk terénu po %1 m by na %2 x %3 km bylo více než %4; zadejte větší buňky</translation>
    </message>
    <message>
        <source>stopped while joining the tour</source>
        <translation>zastaveno při spojování trasy</translation>
    </message>
    <message>
        <source>joined into one loop within the pitch limits the tour is too high to pass below {}, which the mission forbids to the tour, and there is no way over it; allow that airspace, raise the ceiling, or move the targets beside it</source>
        <translation>po spojení do jednoho okruhu v mezích stoupání a klesání je trasa příliš vysoko, aby prošla pod prostorem, kam podle mise nesmí, a cesta nad ním není: %1; povolte tento prostor, zvyšte strop, nebo přesuňte cíle, které leží u něj</translation>
    </message>
    <message>
        <source>the tour has to go up to {:.0f} m MSL ({:.0f} ft), where {} hardly climbs in this air; set a lower ceiling or leave out the highest targets</source>
        <translation>trasa musí vystoupat do %1 m MSL (%2 ft), kde letadlo %3 v tomto vzduchu sotva stoupá; nastavte nižší strop, nebo vynechte nejvyšší cíle</translation>
    </message>
    <message>
        <source>stopped while looking for ways around unknown terrain</source>
        <translation>zastaveno při hledání cest kolem neznámého terénu</translation>
    </message>
    <message>
        <source>stopped while looking for ways around airspace</source>
        <translation>zastaveno při hledání cest kolem vzdušných prostorů</translation>
    </message>
    <message>
        <source>a limit in words</source>
        <translation>mez uvedená slovy</translation>
    </message>
    <message>
        <source>home {} lies inside {}, which the mission forbids to the tour and so to its departure and arrival; allow the airspace (Mission &gt; Airspace), choose another runway, or plan without a home</source>
        <translation>domov %1 leží v prostoru, kam trasa podle mise nesmí, a tedy ani její odlet a přílet: %2; povolte prostor (Mise &gt; Vzdušný prostor), zvolte jinou dráhu, nebo plánujte bez domovské dráhy</translation>
    </message>
    <message>
        <source>stopped while planning the ways from and to the home runway</source>
        <translation>zastaveno při plánování cest z domovské dráhy a na ni</translation>
    </message>
    <message>
        <source>home {}: no way {} it keeps a glide to a runway within the limits of climb, descent and ceiling{}; choose another runway, raise the ceiling, or plan without a home</source>
        <translation>domov %1: žádná cesta %2 nezůstává v dosahu klouzání na dráhu v mezích stoupání, klesání a stropu%3; zvolte jinou dráhu, zvyšte strop, nebo plánujte bez domovské dráhy</translation>
    </message>
    <message>
        <source>from the circles over</source>
        <translation>z kruhů nad ním</translation>
    </message>
    <message>
        <source>from the tour to</source>
        <translation>z trasy k němu</translation>
    </message>
    <message>
        <source> and out of the airspaces that the mission forbids to the tour</source>
        <translation> a mimo vzdušné prostory, kam trasa podle mise nesmí</translation>
    </message>
    <message>
        <source>home {}: there is no usable landing site of that name; there are {}{}</source>
        <translation>domov %1: použitelné přistávací místo toho jména neexistuje; jsou zde %2%3</translation>
    </message>
    <message>
        <source>stopped while planning the tour</source>
        <translation>zastaveno při plánování trasy</translation>
    </message>
    <message>
        <source>target {} lies inside {}, which the mission forbids to the tour: the lowest safe altitude above it is {:.0f} m MSL, so it cannot be visited from below that airspace, nor from above it under the ceiling of the tour; allow the airspace (Mission &gt; Airspace), move the target out of it, or drop the target</source>
        <translation>cíl %1 leží v prostoru, kam trasa podle mise nesmí: %2; nejmenší bezpečná výška nad cílem je %3 m MSL, proto přes něj nelze letět pod tímto prostorem, ani nad ním pod stropem trasy; povolte prostor (Mise &gt; Vzdušný prostor), přesuňte cíl mimo něj, nebo cíl vynechte</translation>
    </message>
    <message>
        <source>{} and {} more</source>
        <translation>%1 a ještě %2</translation>
    </message>
    <message>
        <source>every target can be joined to a neighbour, but no closed tour over all of them stays within glide of a runway, below the ceiling and out of the airspaces that the mission forbids to the tour; between the targets lie {}; allow one of them (Mission &gt; Airspace), raise the ceiling, or drop the targets behind it</source>
        <translation>každý cíl lze spojit se sousedním, ale žádná uzavřená trasa přes všechny nezůstává v dosahu klouzání na dráhu, pod stropem a mimo vzdušné prostory, kam trasa podle mise nesmí; mezi cíli leží: %1; povolte jeden z nich (Mise &gt; Vzdušný prostor), zvyšte strop, nebo vynechte cíle za ním</translation>
    </message>
    <message>
        <source>every target can be joined to a neighbour, but no closed tour over all of them stays over known terrain, below the ceiling and within glide of a runway; move targets that lie beside gaps in the terrain or below high ground, raise the ceiling, or drop targets that are hard to reach</source>
        <translation>každý cíl lze spojit se sousedním, ale žádná uzavřená trasa přes všechny nezůstává nad známým terénem, pod stropem a v dosahu klouzání na dráhu; přesuňte cíle, které leží vedle mezer v terénu nebo pod vysokým terénem, zvyšte strop, nebo vynechte těžko dosažitelné cíle</translation>
    </message>
    <message>
        <source>target {}: its legs to the nearest targets find no way below, above or around {}, which the mission forbids to the tour; allow that airspace (Mission &gt; Airspace), raise the ceiling, or move or drop the target</source>
        <translation>cíl %1: jeho úseky k nejbližším cílům nenacházejí cestu pod, nad ani kolem prostorů, kam trasa podle mise nesmí: %2; povolte tento prostor (Mise &gt; Vzdušný prostor), zvyšte strop, nebo cíl přesuňte či vynechte</translation>
    </message>
    <message>
        <source>the airspace beside it</source>
        <translation>vzdušný prostor vedle něj</translation>
    </message>
    <message>
        <source>target {}: the legs to its nearest targets leave known terrain or have points without any glide to a landing site; load more terrain or drop the target</source>
        <translation>cíl %1: úseky k jeho nejbližším cílům opouštějí známý terén nebo mají body bez jakéhokoli klouzání na přistávací místo; načtěte více terénu, nebo cíl vynechte</translation>
    </message>
    <message>
        <source>target {}: the legs to its nearest targets must climb to {:.0f} m MSL to stay within glide of a runway, {:.0f} m above the ceiling of {:.0f} m; raise the ceiling, add a landing site, or drop the target</source>
        <translation>cíl %1: úseky k jeho nejbližším cílům musí vystoupat do %2 m MSL, aby zůstaly v dosahu klouzání na dráhu, což je %3 m nad stropem %4 m; zvyšte strop, přidejte přistávací místo, nebo cíl vynechte</translation>
    </message>
    <message>
        <source>the mission has no targets; add at least one</source>
        <translation>mise nemá cíle; přidejte alespoň jeden</translation>
    </message>
    <message>
        <source>target {}: the terrain has no data there; move the target or load terrain that covers it</source>
        <translation>cíl %1: terén tam nemá data; přesuňte cíl, nebo načtěte terén, který jej pokrývá</translation>
    </message>
    <message>
        <source>target {}: no glide from above it reaches any of the {} landing sites over known terrain; add landing sites or terrain around it, or drop the target</source>
        <translation>cíl %1: žádné klouzání z výšky nad ním nedosáhne nad známým terénem žádného z přistávacích míst (celkem %2); přidejte přistávací místa nebo terén kolem něj, nebo cíl vynechte</translation>
    </message>
    <message>
        <source>target {}: the lowest safe altitude above it is {:.0f} m MSL ({:.0f} ft), {:.0f} m above the ceiling of {:.0f} m; raise the ceiling by {:.0f} m, add a landing site nearer to it, or drop the target</source>
        <translation>cíl %1: nejmenší bezpečná výška nad ním je %2 m MSL (%3 ft), %4 m nad stropem %5 m; zvyšte strop o %6 m, přidejte přistávací místo blíže k němu, nebo cíl vynechte</translation>
    </message>
    <message>
        <source>joined into one loop within the pitch limits the tour climbs to {:.0f} m MSL, {:.0f} m above the ceiling of {:.0f} m; raise the ceiling</source>
        <translation>po spojení do jednoho okruhu v mezích stoupání a klesání trasa stoupá do %1 m MSL, %2 m nad strop %3 m; zvyšte strop</translation>
    </message>
    <message>
        <source>the tour before leaves no safe place for what changed</source>
        <translation>předchozí trasa nenechává bezpečné místo pro to, co se změnilo</translation>
    </message>
    <message>
        <source>stopped while refining the tour</source>
        <translation>zastaveno při zjemňování trasy</translation>
    </message>
    <message>
        <source>refined to {:.0f} m</source>
        <translation>zjemněno na %1 m</translation>
    </message>
    <message>
        <source>the mission has no targets</source>
        <translation>mise nemá cíle</translation>
    </message>
    <message>
        <source>{}: {} of {} visits</source>
        <translation>%1: přelety %2 z %3</translation>
    </message>
    <message>
        <source>no safe circle over the only target</source>
        <translation>nad jediným cílem není bezpečný kruh</translation>
    </message>
    <message>
        <source>safe segments</source>
        <translation>bezpečné úseky</translation>
    </message>
    <message>
        <source>lazy round {}: cost {:.0f} m, {} safe segments</source>
        <translation>lazy, kolo %1: cena %2 m, bezpečných úseků %3</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>stojí</translation>
    </message>
    <message>
        <source>left</source>
        <translation>vlevo</translation>
    </message>
    <message>
        <source>right</source>
        <translation>vpravo</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vpředu</translation>
    </message>
    <message>
        <source>behind {}</source>
        <translation>za %1</translation>
    </message>
    <message>
        <source>from</source>
        <translation>z</translation>
    </message>
    <message>
        <source>to</source>
        <translation>na</translation>
    </message>
    <message>
        <source>windmilling</source>
        <translation>protáčí se</translation>
    </message>
    <message>
        <source>windmill</source>
        <translation>protáčí se</translation>
    </message>
    <message>
        <source>warmer</source>
        <translation>teplejší</translation>
    </message>
    <message>
        <source>colder</source>
        <translation>chladnější</translation>
    </message>
    <message>
        <source>departure</source>
        <translation>odlet</translation>
    </message>
    <message>
        <source>arrival</source>
        <translation>přílet</translation>
    </message>
    <message>
        <source>tailwind</source>
        <translation>vítr do zad</translation>
    </message>
    <message>
        <source>crosswind</source>
        <translation>boční vítr</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>stupně</translation>
    </message>
    <message>
        <source>latitude</source>
        <translation>zeměpisná šířka</translation>
    </message>
    <message>
        <source>longitude</source>
        <translation>zeměpisná délka</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>uzavřeno</translation>
    </message>
    <message>
        <source>water</source>
        <translation>voda</translation>
    </message>
    <message>
        <source>Water.</source>
        <translation>Voda.</translation>
    </message>
    <message>
        <source>Lighted.</source>
        <translation>Osvětlená.</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>seznam</translation>
    </message>
    <message>
        <source>row {}</source>
        <translation>řádek %1</translation>
    </message>
    <message>
        <source>line {}</source>
        <translation>řádek %1</translation>
    </message>
    <message>
        <source>{}, line {:d}</source>
        <translation>%1, řádek %2</translation>
    </message>
    <message>
        <source>, {} sea</source>
        <translation>, moře %1</translation>
    </message>
    <message>
        <source>{:.0f} m wide.</source>
        <translation>Šířka %1 m.</translation>
    </message>
    <message>
        <source>{:g} to {:g}</source>
        <translation>%1 až %2</translation>
    </message>
    <message>
        <source>{:g} to {:g} {}</source>
        <translation>%1 až %2 %3</translation>
    </message>
    <message>
        <source>{:d} bytes</source>
        <translation>%1 bajtů</translation>
    </message>
    <message>
        <source>{:g} K {} than</source>
        <translation>o %1 K %2 než</translation>
    </message>
    <message>
        <source>{} point {:d}</source>
        <translation>%1: bod %2</translation>
    </message>
    <message>
        <source>aircraft {}: {}</source>
        <translation>letadlo %1: %2</translation>
    </message>
    <message>
        <source> Exception: {}.</source>
        <translation> Výjimka: %1.</translation>
    </message>
    <message>
        <source>east</source>
        <translation>východně</translation>
    </message>
    <message>
        <source>west</source>
        <translation>západně</translation>
    </message>
    <message>
        <source>the plan has {} holds before {}, so it is not clear which one is flown</source>
        <translation>počet vyčkávání, která má plán před místem %2, je %1, takže není jasné, které se letí</translation>
    </message>
</context>
<context>
    <name>DocumentFiles</name>
    <message>
        <source>none</source>
        <translation>žádný</translation>
    </message>
    <message>
        <source>The plan beside the mission was not opened: %1</source>
        <translation>Plán vedle mise nebyl otevřen: %1</translation>
    </message>
    <message>
        <source>The plan beside the mission was made over other terrain and was not opened.</source>
        <translation>Plán vedle mise byl vytvořen nad jiným terénem a nebyl otevřen.</translation>
    </message>
    <message>
        <source>the saved copy of unsaved work is damaged; it cannot be restored</source>
        <translation>záložní kopie neuložené práce je poškozena; nelze ji obnovit</translation>
    </message>
    <message>
        <source>the copy was written by a newer Volplane; open it there</source>
        <translation>kopii zapsal novější Volplane; otevřete ji v něm</translation>
    </message>
    <message>
        <source>the terrain has changed since the plan was made; plan again before looking at it</source>
        <translation>terén se od vytvoření plánu změnil; před prohlížením plánujte znovu</translation>
    </message>
</context>
<context>
    <name>Exports</name>
    <message>
        <source>the folder cannot be made: a file has the name %1; choose another folder</source>
        <translation>složku nelze vytvořit: jméno %1 má soubor; zvolte jinou složku</translation>
    </message>
    <message>
        <source>the folder cannot be made: %1</source>
        <translation>složku nelze vytvořit: %1</translation>
    </message>
    <message>
        <source>the file that is there could not be copied to a backup; nothing was overwritten</source>
        <translation>existující soubor se nepodařilo zálohovat; nic nebylo přepsáno</translation>
    </message>
    <message>
        <source>the file that is there cannot be read; nothing was overwritten</source>
        <translation>existující soubor nelze přečíst; nic nebylo přepsáno</translation>
    </message>
    <message>
        <source>places to %1 m</source>
        <translation>místa na %1 m</translation>
    </message>
    <message>
        <source>%1: least margin %2 on the tour, %3 flown from waypoint to waypoint</source>
        <translation>%1: nejmenší rezerva %2 na trase, %3 při letu z bodu do bodu</translation>
    </message>
    <message>
        <source>flown from waypoint to waypoint no least margin is smaller than on the tour</source>
        <translation>při letu z bodu do bodu není žádná nejmenší rezerva menší než na trase</translation>
    </message>
    <message>
        <source>plan again with a shorter step between decision points, or export to a format that holds places more finely, such as GPX</source>
        <translation>plánujte znovu s kratším krokem mezi rozhodovacími body, nebo exportujte do formátu, který místa ukládá jemněji, například GPX</translation>
    </message>
    <message>
        <source>plan again with a shorter step between decision points</source>
        <translation>plánujte znovu s kratším krokem mezi rozhodovacími body</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints, %1: flown with fly-by turns of %2 m radius the path is at most %3 m beside and %4 m above the tour, never below it; targets are passed within %5 m</source>
        <translation>
            <numerusform>%n traťový bod, %1: při zatáčkách fly-by o poloměru %2 m je dráha letu nejvýše %3 m vedle a %4 m nad trasou, nikdy pod ní; cíle se přelétají na %5 m</numerusform>
            <numerusform>%n traťové body, %1: při zatáčkách fly-by o poloměru %2 m je dráha letu nejvýše %3 m vedle a %4 m nad trasou, nikdy pod ní; cíle se přelétají na %5 m</numerusform>
            <numerusform>%n traťových bodů, %1: při zatáčkách fly-by o poloměru %2 m je dráha letu nejvýše %3 m vedle a %4 m nad trasou, nikdy pod ní; cíle se přelétají na %5 m</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: the waypoint route could not be verified</source>
        <translation>%1: trať po bodech se nepodařilo ověřit</translation>
    </message>
    <message>
        <source>%1: flown from waypoint to waypoint the route is NOT SAFE</source>
        <translation>%1: při letu z bodu do bodu trať NENÍ BEZPEČNÁ</translation>
    </message>
    <message>
        <source>this plan is UNVERIFIED: no one has shown that a glide to a runway exists from every point of it</source>
        <translation>tento plán je NEOVĚŘENÝ: nikdo neukázal, že z každého jeho bodu lze doklouzat na dráhu</translation>
    </message>
    <message numerus="yes">
        <source>%n spirals down to low targets are not part of the waypoints: the route passes above these targets</source>
        <translation>
            <numerusform>%n spirála dolů k nízkému cíli není v traťových bodech: trať vede nad tímto cílem</numerusform>
            <numerusform>%n spirály dolů k nízkým cílům nejsou v traťových bodech: trať vede nad těmito cíli</numerusform>
            <numerusform>%n spirál dolů k nízkým cílům není v traťových bodech: trať vede nad těmito cíli</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 points are more than the %3 that it takes, so there are %4 files, each beginning where the one before ended</source>
        <translation>%1: %2 bodů je více než %3, které pojme, proto je souborů %4; každý začíná tam, kde předchozí skončil</translation>
    </message>
    <message>
        <source>%1: nothing in this file can say that it is unverified; name the file so</source>
        <translation>%1: nic v tomto souboru nemůže říci, že je neověřený; uveďte to v jeho jménu</translation>
    </message>
    <message>
        <source>there is no export format %1</source>
        <translation>formát exportu %1 neexistuje</translation>
    </message>
    <message>
        <source>stopped while exporting; nothing was written</source>
        <translation>export byl zastaven; nic nebylo zapsáno</translation>
    </message>
    <message>
        <source>tour above terrain and clearance</source>
        <translation>trasa nad terénem a odstupem</translation>
    </message>
    <message>
        <source>tour above what the glide needs</source>
        <translation>trasa nad tím, co klouzání potřebuje</translation>
    </message>
    <message>
        <source>climb angle below the steepest allowed</source>
        <translation>úhel stoupání pod nejstrmějším dovoleným</translation>
    </message>
    <message>
        <source>descent angle below the steepest allowed</source>
        <translation>úhel klesání pod nejstrmějším dovoleným</translation>
    </message>
    <message>
        <source>tour below the ceiling</source>
        <translation>trasa pod stropem</translation>
    </message>
    <message>
        <source>engine-out glides above terrain and clearance</source>
        <translation>klouzání po vysazení motoru nad terénem a odstupem</translation>
    </message>
    <message>
        <source>engine-out glides above terrain less what rolling may cost</source>
        <translation>klouzání po vysazení motoru nad terénem po odečtení ceny překlápění</translation>
    </message>
    <message>
        <source>engine-out glides above the runway on arrival</source>
        <translation>klouzání po vysazení motoru nad dráhou při příletu</translation>
    </message>
    <message>
        <source>height at which a target is passed above it</source>
        <translation>výška, ve které se cíl přelétá</translation>
    </message>
    <message>
        <source>spirals above terrain and clearance</source>
        <translation>spirály nad terénem a odstupem</translation>
    </message>
    <message>
        <source>the backup that is there cannot be read; nothing was overwritten</source>
        <translation>existující záložní kopii nelze přečíst; nic nebylo přepsáno</translation>
    </message>
</context>
<context>
    <name>FileKind</name>
    <message>
        <source>airports without runways; add the runways.csv of the same download together with it</source>
        <translation>letiště bez drah; přidejte s nimi i runways.csv ze stejného stažení</translation>
    </message>
    <message>
        <source>runways without airports; add the airports.csv of the same download together with it</source>
        <translation>dráhy bez letišť; přidejte s nimi i airports.csv ze stejného stažení</translation>
    </message>
    <message>
        <source>is neither a table of OurAirports nor one of own fields; its first line lacks their columns (latitude, longitude and course_deg)</source>
        <translation>není ani tabulka OurAirports, ani tabulka s vlastními poli; prvnímu řádku chybí jejich sloupce (latitude, longitude a course_deg)</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>takový soubor neexistuje</translation>
    </message>
    <message>
        <source>is a mission or plan and cannot be added to one; open it instead</source>
        <translation>je mise nebo plán a nelze je k jiné misi přidat; otevřete je</translation>
    </message>
    <message>
        <source>reading the files was stopped</source>
        <translation>čtení souborů bylo zastaveno</translation>
    </message>
    <message>
        <source>is part of the mission already</source>
        <translation>je již součástí mise</translation>
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
        <translation>%1: %2 nad ní při příletu</translation>
    </message>
</context>
<context>
    <name>Guarantee</name>
    <message>
        <source> Exception: between %1 and %2 at target %3 the tour leaves the safe altitude in a spiral of %4 circles: there the gliding guarantee is suspended.</source>
        <translation> Výjimka: mezi %1 a %2 u cíle %3 trasa opouští bezpečnou výšku ve spirále o počtu kruhů %4: tam je záruka doklouzání přerušena.</translation>
    </message>
    <message>
        <source> The same holds on the ways from and to the runway, but for the climb-out: after taking off from %1 it begins %2 past the far end of the runway, at %3 (%4 above the runway), and it ends above the threshold of %5 at %6 (%7 above the runway), from where the landing is the pilot&apos;s.</source>
        <translation> Totéž platí na cestách z dráhy a na ni, kromě vzletu: po vzletu z %1 začíná %2 za koncem dráhy, v %3 (%4 nad dráhou), a končí nad prahem dráhy %5 v %6 (%7 nad dráhou), odkud je přistání na pilotovi.</translation>
    </message>
    <message>
        <source> Every glide ends %1.</source>
        <translation> Každé klouzání končí %1.</translation>
    </message>
    <message>
        <source> On that last part it keeps only above %1, where that is less than the clearance.</source>
        <translation> V této poslední části zůstává jen nad %1, kde je to méně než odstup.</translation>
    </message>
    <message>
        <source> Where each approach begins there is room for circles in which height left over can be lost.</source>
        <translation> Kde začíná přiblížení, je místo pro kruhy, v nichž lze ztratit přebytečnou výšku.</translation>
    </message>
    <message>
        <source> It holds for masses of %1, each at its best glide speed.</source>
        <translation> Platí pro hmotnosti %1, každou při její rychlosti nejlepšího klouzání.</translation>
    </message>
    <message>
        <source> It holds in air of %1, from the lowest runway up to %2.</source>
        <translation> Platí ve vzduchu %1, od nejnižší dráhy do %2.</translation>
    </message>
    <message>
        <source> It allows for a reaction after the engine stops, with the aircraft flying on: %1.</source>
        <translation> Počítá s reakcí po vysazení motoru, během níž letadlo letí dál: %1.</translation>
    </message>
    <message>
        <source> Drag counts %1 times that of the polar; the glide ratios are with it.</source>
        <translation> Odpor se počítá jako %1násobek odporu poláry; klouzavosti s ním počítají.</translation>
    </message>
    <message>
        <source> It holds with the propeller stopped only.</source>
        <translation> Platí jen se stojící vrtulí.</translation>
    </message>
    <message>
        <source> It holds with the propeller windmilling.</source>
        <translation> Platí s protáčející se vrtulí.</translation>
    </message>
    <message>
        <source> The tour is flown at %1.</source>
        <translation> Trasa se letí s nastavením %1.</translation>
    </message>
    <message>
        <source>glide ratio %1 straight ahead</source>
        <translation>klouzavost %1 přímo</translation>
    </message>
    <message>
        <source>glide ratio %1 straight ahead in still air, %2 over ground against the strongest wind</source>
        <translation>klouzavost %1 přímo v klidném vzduchu, %2 nad zemí proti nejsilnějšímu větru</translation>
    </message>
    <message>
        <source>From every point of this tour (%1 decision points and all points between them) the aircraft, its engine stopped and gliding at %2 TAS in %9 with the polar of %3 (%4), can reach %5 on the landing course, at least %6 above the terrain on all the way and at least %7 above the runway on arrival. Terrain is the highest ground of each cell of %8, runways are as listed in the plan; </source>
        <translation>Z každého bodu této trasy (%1 rozhodovacích bodů a všechny body mezi nimi) může letadlo se zastaveným motorem, klouzající rychlostí %2 TAS za %9 s polárou %3 (%4), dosáhnout %5 na přistávacím kurzu, po celé cestě nejméně %6 nad terénem a při příletu nejméně %7 nad dráhou. Terén je nejvyšší místo každé buňky po %8, dráhy jsou podle plánu; </translation>
    </message>
    <message>
        <source>the one runway end used</source>
        <translation>jediného použitého konce dráhy</translation>
    </message>
    <message>
        <source>one of %1 runway ends</source>
        <translation>jednoho z konců drah (celkem %1)</translation>
    </message>
</context>
<context>
    <name>LandingModel</name>
    <message>
        <source>Roadmap</source>
        <translation>Síť cest</translation>
    </message>
    <message>
        <source>Any-time</source>
        <translation>Průběžně</translation>
    </message>
    <message>
        <source>One curve</source>
        <translation>Jedna křivka</translation>
    </message>
    <message>
        <source>FMT*</source>
        <translation>FMT*</translation>
    </message>
    <message>
        <source>FMT*, octree</source>
        <translation>FMT*, oktalový strom</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Gradient</translation>
    </message>
    <message>
        <source>Best of all</source>
        <translation>Nejlepší ze všech</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>Přímo</translation>
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
        <translation>cs</translation>
    </message>
</context>
<context>
    <name>PlanSummaryPanel</name>
    <message>
        <source>Tour above terrain and clearance</source>
        <translation>Trasa nad terénem a odstupem</translation>
    </message>
    <message>
        <source>Tour above what the glide needs</source>
        <translation>Trasa nad tím, co klouzání potřebuje</translation>
    </message>
    <message>
        <source>Climb below the steepest allowed</source>
        <translation>Stoupání pod nejstrmějším dovoleným</translation>
    </message>
    <message>
        <source>Descent below the steepest allowed</source>
        <translation>Klesání pod nejstrmějším dovoleným</translation>
    </message>
    <message>
        <source>Tour below the ceiling</source>
        <translation>Trasa pod stropem</translation>
    </message>
    <message>
        <source>Glides above terrain and clearance</source>
        <translation>Klouzání nad terénem a odstupem</translation>
    </message>
    <message>
        <source>Glides above terrain less what rolling may cost</source>
        <translation>Klouzání nad terénem bez ceny překlápění</translation>
    </message>
    <message>
        <source>Glides above the runway on arrival</source>
        <translation>Klouzání nad dráhou při příletu</translation>
    </message>
    <message>
        <source>Tour above the targets</source>
        <translation>Trasa nad cíli</translation>
    </message>
    <message>
        <source>Spirals above terrain and clearance</source>
        <translation>Spirály nad terénem a odstupem</translation>
    </message>
</context>
<context>
    <name>PlanningSketch</name>
    <message>
        <source>checking the plan</source>
        <translation>plán se kontroluje</translation>
    </message>
    <message numerus="yes">
        <source>Roadmap: %n glides</source>
        <translation>
            <numerusform>Síť cest: %n klouzání</numerusform>
            <numerusform>Síť cest: %n klouzání</numerusform>
            <numerusform>Síť cest: %n klouzání</numerusform>
        </translation>
    </message>
    <message>
        <source>Round %1: %2 of %3 legs are safe</source>
        <translation>Kolo %1: bezpečných úseků je %2 z %3</translation>
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
        <translation>Trasa</translation>
    </message>
    <message>
        <source>Lowest safe altitude</source>
        <translation>Nejmenší bezpečná výška</translation>
    </message>
    <message>
        <source>Terrain below</source>
        <translation>Terén pod letadlem</translation>
    </message>
    <message>
        <source>Highest within %1 m</source>
        <translation>Nejvyšší v okruhu %1 m</translation>
    </message>
    <message>
        <source>Pitch limits only</source>
        <translation>Jen meze stoupání a klesání</translation>
    </message>
    <message>
        <source>Decision points</source>
        <translation>Rozhodovací body</translation>
    </message>
    <message>
        <source>Decision points: zoom in</source>
        <translation>Rozhodovací body: přibližte</translation>
    </message>
    <message>
        <source>Wind on course, tail to the right</source>
        <translation>Vítr na kurzu, zadní doprava</translation>
    </message>
    <message>
        <source>Too low</source>
        <translation>Příliš nízko</translation>
    </message>
    <message>
        <source>Unknown terrain</source>
        <translation>Neznámý terén</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>v %1</translation>
    </message>
    <message>
        <source>Least clearance %1 %2</source>
        <translation>Nejmenší odstup %1 %2</translation>
    </message>
    <message>
        <source>Least clearance unknown: no terrain data %1</source>
        <translation>Nejmenší odstup neznámý: chybí data terénu %1</translation>
    </message>
    <message>
        <source>Least glide margin %1 %2</source>
        <translation>Nejmenší rezerva klouzání %1 %2</translation>
    </message>
    <message>
        <source>No safe glide known %1</source>
        <translation>Bezpečné klouzání není známo %1</translation>
    </message>
    <message>
        <source>Highest ground %1 %2</source>
        <translation>Nejvyšší terén %1 %2</translation>
    </message>
    <message>
        <source>OUT OF DATE</source>
        <translation>ZASTARALÉ</translation>
    </message>
    <message>
        <source>NOT VERIFIED</source>
        <translation>NEOVĚŘENO</translation>
    </message>
    <message>
        <source>Planning. The profile appears as soon as the tour is complete.</source>
        <translation>Plánuje se. Profil se objeví, jakmile bude trasa úplná.</translation>
    </message>
    <message>
        <source>Load terrain and airports, then mark targets on the map: the altitude profile of the tour appears here.</source>
        <translation>Načtěte terén a letiště, pak vyznačte cíle na mapě: zde se objeví výškový profil trasy.</translation>
    </message>
    <message>
        <source>Mark targets on the map and plan the tour: its altitude profile appears here.</source>
        <translation>Vyznačte cíle na mapě a naplánujte trasu: zde se objeví její výškový profil.</translation>
    </message>
    <message>
        <source>Plan the tour: its altitude profile appears here.</source>
        <translation>Naplánujte trasu: zde se objeví její výškový profil.</translation>
    </message>
    <message>
        <source>%1 tail</source>
        <translation>%1 zadní</translation>
    </message>
    <message>
        <source>%1 head</source>
        <translation>%1 čelní</translation>
    </message>
    <message>
        <source>%1 from the left</source>
        <translation>%1 zleva</translation>
    </message>
    <message>
        <source>%1 from the right</source>
        <translation>%1 zprava</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>bezvětří</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>asi %1</translation>
    </message>
</context>
<context>
    <name>SceneProblems</name>
    <message>
        <source>no EGL display without a window could be opened; install the OpenGL driver (Mesa) of this machine</source>
        <translation>bez okna se nepodařilo otevřít zobrazení EGL; nainstalujte ovladač OpenGL (Mesa) tohoto počítače</translation>
    </message>
    <message>
        <source>the EGL of this machine has no desktop OpenGL</source>
        <translation>EGL tohoto počítače nemá stolní OpenGL</translation>
    </message>
    <message>
        <source>EGL has no configuration for OpenGL</source>
        <translation>EGL nemá nastavení pro OpenGL</translation>
    </message>
    <message>
        <source>no OpenGL context without a window could be made</source>
        <translation>bez okna se nepodařilo vytvořit kontext OpenGL</translation>
    </message>
    <message>
        <source>there is no terrain to draw; add a terrain file to the mission</source>
        <translation>není terén, který by se kreslil; přidejte k misi soubor terénu</translation>
    </message>
    <message>
        <source>OpenGL could not draw a picture of this size</source>
        <translation>OpenGL nedokázalo nakreslit obrázek této velikosti</translation>
    </message>
</context>
<context>
    <name>SiteText</name>
    <message>
        <source>hard</source>
        <translation>zpevněný</translation>
    </message>
    <message>
        <source>gravel</source>
        <translation>štěrk</translation>
    </message>
    <message>
        <source>grass</source>
        <translation>tráva</translation>
    </message>
    <message>
        <source>dirt</source>
        <translation>hlína</translation>
    </message>
    <message>
        <source>water</source>
        <translation>voda</translation>
    </message>
    <message>
        <source>snow</source>
        <translation>sníh</translation>
    </message>
    <message>
        <source>unknown surface</source>
        <translation>neznámý povrch</translation>
    </message>
    <message>
        <source>Landing course %1</source>
        <translation>Přistávací kurz %1</translation>
    </message>
    <message>
        <source>length %1</source>
        <translation>délka %1</translation>
    </message>
    <message>
        <source>length unknown</source>
        <translation>délka neznámá</translation>
    </message>
    <message>
        <source>elevation %1</source>
        <translation>výška %1</translation>
    </message>
    <message>
        <source>partly estimated</source>
        <translation>zčásti odhadnuto</translation>
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
        <translation>%1 až %2 %3</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>bezvětří</translation>
    </message>
    <message>
        <source>%1 from any direction</source>
        <translation>%1 z jakéhokoli směru</translation>
    </message>
    <message>
        <source>%1 from %2 degrees</source>
        <translation>%1 ze směru %2 stupňů</translation>
    </message>
    <message>
        <source>%1 from %2 to %3 degrees</source>
        <translation>%1 ze směru %2 až %3 stupňů</translation>
    </message>
    <message>
        <source>calm air</source>
        <translation>bezvětří</translation>
    </message>
    <message>
        <source>every wind between the layers of the forecast (%1; true)</source>
        <translation>každého větru mezi vrstvami předpovědi (%1; zeměpisně)</translation>
    </message>
    <message>
        <source>every wind of %1</source>
        <translation>každého větru %1</translation>
    </message>
    <message>
        <source>a wind of %1 true</source>
        <translation>větru %1 zeměpisně</translation>
    </message>
    <message>
        <source>every wind of %1 true</source>
        <translation>každého větru %1 zeměpisně</translation>
    </message>
    <message>
        <source>still air</source>
        <translation>bezvětří</translation>
    </message>
    <message>
        <source>%1 at every height</source>
        <translation>%1 v každé výšce</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Plans closed surveillance tours from every point of which the aircraft can glide to a runway.</source>
        <translation>Plánuje uzavřené průzkumné trasy, z jejichž každého bodu lze doklouzat na dráhu.</translation>
    </message>
    <message>
        <source>A mission (*.vpm) or plan (*.vpp), or terrain and airfields</source>
        <translation>Mise (*.vpm) nebo plán (*.vpp), nebo terén a letiště</translation>
    </message>
    <message>
        <source>Language of the window, instead of that of the preferences: %1.</source>
        <translation>Jazyk okna místo jazyka z předvoleb: %1.</translation>
    </message>
    <message>
        <source>code</source>
        <translation>kód</translation>
    </message>
    <message>
        <source>Print this help and exit.</source>
        <translation>Vypsat tuto nápovědu a skončit.</translation>
    </message>
    <message>
        <source>Print version, commit, libraries and data sources with their licences, and exit.</source>
        <translation>Vypsat verzi, commit, knihovny a zdroje dat s jejich licencemi a skončit.</translation>
    </message>
</context>
<context>
    <name>vp::about::AboutDialog</name>
    <message>
        <source>About Volplane</source>
        <translation>O Volplane</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Volplane %1&lt;/h3&gt;%2&lt;p&gt;Plans tours from every point of which the aircraft can glide to a runway if the engine stops.&lt;/p&gt;&lt;p&gt;The promise is as good as its inputs: the wind of the mission, the polar in the aircraft profile, the terrain file and the runway list. The pilot checks those, and remains in command.&lt;/p&gt;&lt;p&gt;Licence: %3. No warranty.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Volplane %1&lt;/h3&gt;%2&lt;p&gt;Plánuje trasy, z jejichž každého bodu lze po vysazení motoru doklouzat na dráhu.&lt;/p&gt;&lt;p&gt;Slib je tak dobrý, jak jsou dobré vstupy: vítr mise, polára v profilu letadla, soubor terénu a seznam drah. Pilot je kontroluje a zůstává velitelem.&lt;/p&gt;&lt;p&gt;Licence: %3. Bez záruky.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Commit %1</source>
        <translation>Commit %1</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Data</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>Knihovny</translation>
    </message>
    <message>
        <source>&amp;Copy all</source>
        <translation>&amp;Kopírovat vše</translation>
    </message>
    <message>
        <source>Version, libraries and data sources as text, for a report of a fault</source>
        <translation>Verze, knihovny a zdroje dat jako text, pro hlášení chyby</translation>
    </message>
</context>
<context>
    <name>vp::about::Words</name>
    <message>
        <source>terrain, fetched when you ask for it</source>
        <translation>terén, stažený na požádání</translation>
    </message>
    <message>
        <source>airfields, fetched when you ask for them</source>
        <translation>letiště, stažená na požádání</translation>
    </message>
    <message>
        <source>public domain</source>
        <translation>volné dílo</translation>
    </message>
    <message>
        <source>magnetic variation 2025 to 2029, by NOAA NCEI and the British Geological Survey</source>
        <translation>magnetická deklinace 2025 až 2029, od NOAA NCEI a British Geological Survey</translation>
    </message>
    <message>
        <source>Aircraft profiles</source>
        <translation>Profily letadel</translation>
    </message>
    <message>
        <source>each number with its source in the profile</source>
        <translation>každé číslo se zdrojem v profilu</translation>
    </message>
    <message>
        <source>Bundled maps</source>
        <translation>Přiložené mapy</translation>
    </message>
    <message>
        <source>made-up country, the project&apos;s own</source>
        <translation>vymyšlená krajina, vlastní dílo projektu</translation>
    </message>
    <message>
        <source>Licence %1; no warranty. Plans are as good as their inputs: the pilot checks those, and remains in command.</source>
        <translation>Licence %1; bez záruky. Plány jsou tak dobré, jak jsou dobré vstupy: pilot je kontroluje a zůstává velitelem.</translation>
    </message>
    <message>
        <source>Libraries:</source>
        <translation>Knihovny:</translation>
    </message>
    <message>
        <source>Data:</source>
        <translation>Data:</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::AircraftDialog</name>
    <message>
        <source>Aircraft</source>
        <translation>Letadlo</translation>
    </message>
    <message>
        <source>Aircraft profile</source>
        <translation>Profil letadla</translation>
    </message>
    <message>
        <source>&amp;Duplicate and edit</source>
        <translation>&amp;Zdvojit a upravit</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Otevřít…</translation>
    </message>
    <message>
        <source>&amp;Save as file…</source>
        <translation>&amp;Uložit jako soubor…</translation>
    </message>
    <message>
        <source>%1 (bundled)</source>
        <translation>%1 (přiložený)</translation>
    </message>
    <message>
        <source>in this mission</source>
        <translation>v této misi</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1, copy</source>
        <translation>%1, kopie</translation>
    </message>
    <message>
        <source>Open aircraft profile</source>
        <translation>Otevřít profil letadla</translation>
    </message>
    <message>
        <source>Aircraft profiles (*.json)</source>
        <translation>Profily letadel (*.json)</translation>
    </message>
    <message>
        <source>Save aircraft profile</source>
        <translation>Uložit profil letadla</translation>
    </message>
    <message>
        <source>This profile is not changed here; duplicate it to make one of your own.</source>
        <translation>Tento profil se zde nemění; zdvojte jej a vytvořte si vlastní.</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>bez meze</translation>
    </message>
    <message>
        <source>Runway directions that the wind of the mission may bring more to are not landed on; one step below 0 is no limit</source>
        <translation>Na směry drah, kterým může vítr mise přinést více, se nepřistává; o krok níže než 0 je bez meze</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Název</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Hmotnost</translation>
    </message>
    <message>
        <source>kg</source>
        <translation>kg</translation>
    </message>
    <message>
        <source>Wing area</source>
        <translation>Plocha křídla</translation>
    </message>
    <message>
        <source>m²</source>
        <translation>m²</translation>
    </message>
    <message>
        <source>Zero-lift drag C_D0</source>
        <translation>Odpor při nulovém vztlaku C_D0</translation>
    </message>
    <message>
        <source>Induced drag factor L</source>
        <translation>Činitel indukovaného odporu L</translation>
    </message>
    <message>
        <source>Air density</source>
        <translation>Hustota vzduchu</translation>
    </message>
    <message>
        <source>kg/m³</source>
        <translation>kg/m³</translation>
    </message>
    <message>
        <source>Best glide speed (TAS)</source>
        <translation>Rychlost nejlepšího klouzání (TAS)</translation>
    </message>
    <message>
        <source>Where each number comes from, one sentence a line</source>
        <translation>Odkud je které číslo, jedna věta na řádek</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Zdroje</translation>
    </message>
    <message>
        <source>Bank angles that a glide may choose among in its turns, in degrees, separated by commas</source>
        <translation>Náklony, z nichž smí klouzání v zatáčkách volit, ve stupních, oddělené čárkami</translation>
    </message>
    <message>
        <source>Banks in a glide (°)</source>
        <translation>Náklony při klouzání (°)</translation>
    </message>
    <message>
        <source>Bank on the tour</source>
        <translation>Náklon na trase</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Steepest climb</source>
        <translation>Nejstrmější stoupání</translation>
    </message>
    <message>
        <source>Steepest descent</source>
        <translation>Nejstrmější klesání</translation>
    </message>
    <message>
        <source>Stall speed, wings level</source>
        <translation>Pádová rychlost ve vodorovném letu</translation>
    </message>
    <message>
        <source>Highest load factor</source>
        <translation>Největší násobek zatížení</translation>
    </message>
    <message>
        <source>Ceiling</source>
        <translation>Strop</translation>
    </message>
    <message>
        <source>%1 MSL</source>
        <translation>%1 MSL</translation>
    </message>
    <message>
        <source>Most tailwind on landing</source>
        <translation>Největší zadní vítr při přistání</translation>
    </message>
    <message>
        <source>Most crosswind on landing</source>
        <translation>Největší boční vítr při přistání</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>neuvedeno</translation>
    </message>
    <message>
        <source>Least mass</source>
        <translation>Nejmenší hmotnost</translation>
    </message>
    <message>
        <source>Plans hold for all masses between the two, each flown at its best glide speed</source>
        <translation>Plány platí pro všechny hmotnosti mezi oběma, každou při její rychlosti nejlepšího klouzání</translation>
    </message>
    <message>
        <source>Greatest mass</source>
        <translation>Největší hmotnost</translation>
    </message>
    <message>
        <source>C_D0, propeller windmilling</source>
        <translation>C_D0, vrtule se protáčí</translation>
    </message>
    <message>
        <source>C_D0, propeller stopped</source>
        <translation>C_D0, vrtule stojí</translation>
    </message>
    <message>
        <source>Steepest without engine</source>
        <translation>Nejstrmější bez motoru</translation>
    </message>
    <message>
        <source>Steepest steady descent through the air with flaps, brakes or a slip; approaches at a slope of your choice need it</source>
        <translation>Nejstrmější ustálené klesání vzduchem s klapkami, brzdami nebo skluzem; je třeba pro přiblížení se zvoleným sklonem</translation>
    </message>
    <message>
        <source>Rate of roll</source>
        <translation>Rychlost klonění</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source>Degrees of bank per second, at least; certificates then say what rolling into turns may cost a glide</source>
        <translation>Stupňů náklonu za sekundu, nejméně; certifikáty pak říkají, co může překlápění do zatáček klouzání stát</translation>
    </message>
    <message>
        <source>Never exceed (TAS)</source>
        <translation>Nepřekročitelná rychlost (TAS)</translation>
    </message>
    <message>
        <source>Landing distance</source>
        <translation>Délka přistání</translation>
    </message>
    <message>
        <source>Over 15 m (50 ft) to standstill at the greatest mass: sea level, standard air, no wind, dry hard runway. Runways too short for it on the day are not used</source>
        <translation>Přes 15 m (50 ft) do zastavení při největší hmotnosti: hladina moře, standardní vzduch, bezvětří, suchá zpevněná dráha. Dráhy, které jsou v daný den příliš krátké, se nepoužijí</translation>
    </message>
    <message>
        <source>Climb at sea level</source>
        <translation>Stoupání u hladiny moře</translation>
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
        <translation>Praktický dostup</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::AirspaceDialog</name>
    <message>
        <source>Airspace</source>
        <translation>Vzdušný prostor</translation>
    </message>
    <message>
        <source>Airspaces by class</source>
        <translation>Vzdušné prostory podle tříd</translation>
    </message>
    <message>
        <source>Class and name</source>
        <translation>Třída a název</translation>
    </message>
    <message>
        <source>Ceiling / floor</source>
        <translation>Horní / dolní mez</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Co s nimi</translation>
    </message>
    <message>
        <source>&amp;All other classes:</source>
        <translation>&amp;Všechny ostatní třídy:</translation>
    </message>
    <message>
        <source>Add airspace &amp;files…</source>
        <translation>Přidat &amp;soubory prostorů…</translation>
    </message>
    <message>
        <source>%1 (not shown)</source>
        <translation>%1 (nezobrazeno)</translation>
    </message>
    <message>
        <source>Class %1: none near this terrain</source>
        <translation>Třída %1: žádný poblíž tohoto terénu</translation>
    </message>
    <message numerus="yes">
        <source>Class %1: %n airspace(s)</source>
        <translation>
            <numerusform>Třída %1: %n prostor</numerusform>
            <numerusform>Třída %1: %n prostory</numerusform>
            <numerusform>Třída %1: %n prostorů</numerusform>
        </translation>
    </message>
    <message>
        <source>without a name</source>
        <translation>bez názvu</translation>
    </message>
    <message>
        <source>As all other classes</source>
        <translation>Jako všechny ostatní třídy</translation>
    </message>
    <message>
        <source>As its class</source>
        <translation>Jako jeho třída</translation>
    </message>
    <message>
        <source>Class %1</source>
        <translation>Třída %1</translation>
    </message>
    <message>
        <source>No airspaces yet. Add an OpenAir file here, with File &gt; Add airspaces, or drop it on the window.</source>
        <translation>Zatím žádné vzdušné prostory. Přidejte soubor OpenAir zde, přes Soubor &gt; Přidat vzdušné prostory, nebo jej přetáhněte na okno.</translation>
    </message>
    <message>
        <source>“Keep the tour out”: planning goes below, above or around, and a plan that enters is refused. “Warn when entered”: the plan is made as if it were not there and the entry is named. Engine-out glides are never kept out, only named: an emergency may enter. Flight levels count in a standard atmosphere (1013.25 hPa).</source>
        <translation>„Držet trasu mimo“: plánování jde pod, nad nebo kolem a plán, který vletí, se odmítne. „Varovat při vletu“: plánuje se, jako by prostor nebyl, a vlet se uvede. Klouzání po vysazení motoru se nikdy nedrží mimo, jen se uvede: v nouzi se vletět smí. Letové hladiny se počítají ve standardní atmosféře (1013.25 hPa).</translation>
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
        <translation>&amp;Papír</translation>
    </message>
    <message>
        <source>Upright, with room for a clip at the sides.</source>
        <translation>Na výšku, s místem pro sponu po stranách.</translation>
    </message>
    <message>
        <source>Feet, nautical miles, knots</source>
        <translation>Stopy, námořní míle, uzly</translation>
    </message>
    <message>
        <source>Metres, kilometres, km/h</source>
        <translation>Metry, kilometry, km/h</translation>
    </message>
    <message>
        <source>&amp;Units</source>
        <translation>&amp;Jednotky</translation>
    </message>
    <message>
        <source>Of everything but the checker&apos;s findings and warnings.</source>
        <translation>Všeho kromě nálezů a varování kontroly.</translation>
    </message>
    <message>
        <source>&amp;Day of flight</source>
        <translation>&amp;Den letu</translation>
    </message>
    <message>
        <source>Stands on every page and decides the magnetic variation.</source>
        <translation>Stojí na každé straně a určuje magnetickou deklinaci.</translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation>&amp;Mapa</translation>
    </message>
    <message>
        <source>&amp;Altitude profile</source>
        <translation>&amp;Výškový profil</translation>
    </message>
    <message>
        <source>&amp;Legs</source>
        <translation>Úse&amp;ky</translation>
    </message>
    <message>
        <source>&amp;If the engine stops: runways along the tour</source>
        <translation>Když vysadí m&amp;otor: dráhy podél trasy</translation>
    </message>
    <message>
        <source>&amp;Glides from the worst places</source>
        <translation>K&amp;louzání z nejhorších míst</translation>
    </message>
    <message>
        <source>&amp;Targets</source>
        <translation>&amp;Cíle</translation>
    </message>
    <message>
        <source>Pictures in g&amp;reys</source>
        <translation>Obrázky v šed&amp;i</translation>
    </message>
    <message>
        <source>&amp;Save as PDF…</source>
        <translation>&amp;Uložit jako PDF…</translation>
    </message>
    <message>
        <source>&amp;Save all the same…</source>
        <translation>&amp;Přesto uložit…</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Části</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::ConditionValues</name>
    <message>
        <source>Count with the air of the day</source>
        <translation>Počítat se vzduchem daného dne</translation>
    </message>
    <message>
        <source>Temperature above the standard atmosphere</source>
        <translation>Teplota nad standardní atmosférou</translation>
    </message>
    <message>
        <source> °C from standard</source>
        <translation> °C od standardu</translation>
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
        <translation>&amp;Vzduch</translation>
    </message>
    <message>
        <source>In thin air the same indicated speed is a faster one: turns are wider and landings longer. Standard is 15 °C at sea level, 2 °C less every 1000 ft, and 1013 hPa (29.92 inHg). Without it the density of the aircraft’s polar counts at every height.</source>
        <translation>V řídkém vzduchu je táž indikovaná rychlost ve skutečnosti větší: zatáčky jsou širší a přistání delší. Standard je 15 °C u hladiny moře, o 2 °C méně na každých 1000 ft, a 1013 hPa (29.92 inHg). Bez něj platí v každé výšce hustota z poláry letadla.</translation>
    </message>
    <message>
        <source>As the aircraft’s polar has it</source>
        <translation>Jak je v poláře letadla</translation>
    </message>
    <message>
        <source>Windmilling, turned by the air</source>
        <translation>Protáčí se proudem vzduchu</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Stojí</translation>
    </message>
    <message>
        <source>&amp;Propeller</source>
        <translation>V&amp;rtule</translation>
    </message>
    <message>
        <source>What it does after the engine has stopped. A windmilling propeller brakes most; count on a stopped one only if you know that it stops. What the aircraft’s profile says nothing of cannot be chosen.</source>
        <translation>Co dělá po vysazení motoru. Protáčející se vrtule brzdí nejvíce; se stojící počítejte, jen když víte, že se zastaví. Co profil letadla neuvádí, nelze zvolit.</translation>
    </message>
    <message>
        <source>P&amp;ower on the tour</source>
        <translation>Vý&amp;kon na trase</translation>
    </message>
    <message>
        <source>The airspeed of the tour between glides: faster is sooner home, but turns are wider and more ground goes by before you react.</source>
        <translation>Vzdušná rychlost na trase mezi klouzáními: rychleji je dříve doma, ale zatáčky jsou širší a do reakce uběhne více země.</translation>
    </message>
    <message>
        <source>At the threshold, by any curve</source>
        <translation>U prahu, jakoukoli zatáčkou</translation>
    </message>
    <message>
        <source>Straight in</source>
        <translation>Přímé přiblížení</translation>
    </message>
    <message>
        <source>From overhead, by a full circle</source>
        <translation>Z místa nad letištěm, celým kruhem</translation>
    </message>
    <message>
        <source>&amp;Glides end</source>
        <translation>&amp;Klouzání končí</translation>
    </message>
    <message>
        <source>At the threshold is the lowest and the hardest to fly: the last turn may end at the runway. Straight in ends it before. From overhead is the key-point pattern of forced landings: high key above the runway, low key abeam.</source>
        <translation>U prahu je nejníže a letí se nejhůře: poslední zatáčka může končit u dráhy. Přímé přiblížení ji ukončí dříve. Z místa nad letištěm je postup klíčových bodů nouzového přistání: horní klíčový bod nad dráhou, dolní vedle ní.</translation>
    </message>
    <message>
        <source>Length of the final approach</source>
        <translation>Délka konečného přiblížení</translation>
    </message>
    <message>
        <source>&amp;Final</source>
        <translation>K&amp;onečné přiblížení</translation>
    </message>
    <message>
        <source>Straight in: length over ground of the last straight on the landing course.</source>
        <translation>Přímé přiblížení: délka poslední přímé na přistávacím kurzu, nad zemí.</translation>
    </message>
    <message>
        <source>At a slope of my choice</source>
        <translation>Se sklonem podle mé volby</translation>
    </message>
    <message>
        <source>Slope of the final approach</source>
        <translation>Sklon konečného přiblížení</translation>
    </message>
    <message>
        <source>&amp;Slope</source>
        <translation>&amp;Sklon</translation>
    </message>
    <message>
        <source>Straight in: descent over ground with flaps, brakes or a slip; otherwise that of the best glide. Needs an aircraft whose profile has its steepest descent.</source>
        <translation>Přímé přiblížení: klesání nad zemí s klapkami, brzdami nebo skluzem; jinak klesání nejlepšího klouzání. Je třeba letadlo, jehož profil má nejstrmější klesání.</translation>
    </message>
    <message>
        <source>High key no lower than</source>
        <translation>Horní klíčový bod ne níže než</translation>
    </message>
    <message>
        <source>Height of high key above the runway</source>
        <translation>Výška horního klíčového bodu nad dráhou</translation>
    </message>
    <message>
        <source>High &amp;key</source>
        <translation>&amp;Horní klíčový bod</translation>
    </message>
    <message>
        <source>From overhead: height above the runway where the circle begins; otherwise what the circle loses.</source>
        <translation>Z místa nad letištěm: výška nad dráhou, kde kruh začíná; jinak tolik, kolik kruh ztratí.</translation>
    </message>
    <message>
        <source>Circles to lose height before each approach</source>
        <translation>Kruhy pro ztrátu výšky před každým přiblížením</translation>
    </message>
    <message>
        <source>S&amp;urplus height</source>
        <translation>&amp;Přebytečná výška</translation>
    </message>
    <message>
        <source>Only runways where a circle over the beginning of the approach is clear of terrain: most failures happen higher than the lowest safe altitude, and the rest of the height has to go somewhere.</source>
        <translation>Jen dráhy, kde je kruh nad začátkem přiblížení volný od terénu: většina vysazení nastane výše než v nejmenší bezpečné výšce a zbytek výšky musí někam zmizet.</translation>
    </message>
    <message>
        <source>Above an obstacle surface instead of the clearance</source>
        <translation>Nad překážkovou plochou místo odstupu</translation>
    </message>
    <message>
        <source>Slope of the obstacle surface</source>
        <translation>Sklon překážkové plochy</translation>
    </message>
    <message>
        <source> % slope</source>
        <translation> % sklon</translation>
    </message>
    <message>
        <source>Begin of the obstacle surface before touchdown</source>
        <translation>Začátek překážkové plochy před bodem dotyku</translation>
    </message>
    <message>
        <source> before touchdown</source>
        <translation> před bodem dotyku</translation>
    </message>
    <message>
        <source>Obstac&amp;les</source>
        <translation>Př&amp;ekážky</translation>
    </message>
    <message>
        <source>Straight in and from overhead, on the last part only: runways are kept clear above such a surface (ICAO: 5 % from 60 m for short ones, 2.5 % for long ones). Runways in narrow valleys then count that the whole clearance would rule out.</source>
        <translation>Přímé přiblížení a z místa nad letištěm, jen v poslední části: dráhy se drží volné nad takovou plochou (ICAO: 5 % od 60 m pro krátké, 2.5 % pro dlouhé). Pak platí i dráhy v úzkých údolích, které by celý odstup vyloučil.</translation>
    </message>
    <message>
        <source>At best glide speed, %1</source>
        <translation>Rychlostí nejlepšího klouzání, %1</translation>
    </message>
    <message>
        <source>%1, %2 TAS</source>
        <translation>%1, %2 TAS</translation>
    </message>
    <message>
        <source>%1, which the aircraft lacks</source>
        <translation>%1, což letadlo nemá</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::ExportDialog</name>
    <message>
        <source>Formats</source>
        <translation>Formáty</translation>
    </message>
    <message>
        <source>%1 (.%2)</source>
        <translation>%1 (.%2)</translation>
    </message>
    <message>
        <source>Nothing of the plan is lost</source>
        <translation>Z plánu se nic neztratí</translation>
    </message>
    <message>
        <source>Export the plan</source>
        <translation>Exportovat plán</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Procházet…</translation>
    </message>
    <message>
        <source>{mission}, {format} and {part} are replaced</source>
        <translation>{mission}, {format} a {part} se nahradí</translation>
    </message>
    <message>
        <source>F&amp;older</source>
        <translation>S&amp;ložka</translation>
    </message>
    <message>
        <source>&amp;Names</source>
        <translation>&amp;Jména</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportovat</translation>
    </message>
    <message>
        <source>Folder for the exported files</source>
        <translation>Složka pro exportované soubory</translation>
    </message>
    <message>
        <source> (is there; the old one is kept as %1)</source>
        <translation> (existuje; starý zůstane jako %1)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>There is no folder of this name.</source>
        <translation>Složka toho jména neexistuje.</translation>
    </message>
    <message>
        <source>Choose at least one format.</source>
        <translation>Zvolte alespoň jeden formát.</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::ExportReview</name>
    <message>
        <source>none</source>
        <translation>žádná</translation>
    </message>
    <message>
        <source>Export: what the waypoints cost</source>
        <translation>Export: co stojí traťové body</translation>
    </message>
    <message>
        <source>Really export?</source>
        <translation>Opravdu exportovat?</translation>
    </message>
    <message>
        <source>Least margins of the tour, and of the path that fly-by turns from waypoint to waypoint give:</source>
        <translation>Nejmenší rezervy trasy a dráhy letu, kterou dávají zatáčky fly-by z bodu do bodu:</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Poznámky</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>&amp;Zapsat</translation>
    </message>
    <message>
        <source>Export &amp;anyway</source>
        <translation>&amp;Přesto exportovat</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>Rezervy</translation>
    </message>
    <message>
        <source>Least margin</source>
        <translation>Nejmenší rezerva</translation>
    </message>
    <message>
        <source>Places to</source>
        <translation>Místa na</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Trasa</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>Traťové body</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Změna</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>not known: the waypoints could not be checked</source>
        <translation>není známo: traťové body se nepodařilo ověřit</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::FetchTerrainDialog</name>
    <message>
        <source>no airfields are known yet to look this up; update the airfields first (File menu), or type a position</source>
        <translation>zatím nejsou známa žádná letiště, kde by se to dalo vyhledat; nejprve letiště aktualizujte (nabídka Soubor), nebo zadejte polohu</translation>
    </message>
    <message>
        <source>no airfield has this code; correct it, or type a position such as 46.6003 9.9017</source>
        <translation>žádné letiště nemá tento kód; opravte jej, nebo zadejte polohu, například 46.6003 9.9017</translation>
    </message>
    <message>
        <source>Fetch terrain</source>
        <translation>Stáhnout terén</translation>
    </message>
    <message>
        <source>What the &amp;map shows</source>
        <translation>Co ukazuje &amp;mapa</translation>
    </message>
    <message>
        <source>&amp;Around an airfield or position</source>
        <translation>&amp;Kolem letiště nebo polohy</translation>
    </message>
    <message>
        <source>LSZS, or 46.534 9.884</source>
        <translation>LSZS, nebo 46.534 9.884</translation>
    </message>
    <message>
        <source>Airfield or position</source>
        <translation>Letiště nebo poloha</translation>
    </message>
    <message>
        <source> km</source>
        <translation> km</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Procházet…</translation>
    </message>
    <message>
        <source>Ask for the size first. Tiles that have been fetched once stay on this machine and need no network.</source>
        <translation>Nejprve se zeptejte na velikost. Jednou stažené dlaždice zůstávají v tomto počítači a síť nepotřebují.</translation>
    </message>
    <message>
        <source>Ask for &amp;size</source>
        <translation>Zjistit &amp;velikost</translation>
    </message>
    <message>
        <source>&amp;Fetch</source>
        <translation>&amp;Stáhnout</translation>
    </message>
    <message>
        <source>&amp;Radius</source>
        <translation>&amp;Poloměr</translation>
    </message>
    <message>
        <source>&amp;Write to</source>
        <translation>&amp;Zapsat do</translation>
    </message>
    <message>
        <source>&amp;Server</source>
        <translation>S&amp;erver</translation>
    </message>
    <message>
        <source>Write terrain to</source>
        <translation>Zapsat terén do</translation>
    </message>
    <message>
        <source>Ask for the size again.</source>
        <translation>Zeptejte se na velikost znovu.</translation>
    </message>
    <message>
        <source>%1. Copernicus GLO-30 from %2</source>
        <translation>%1. Copernicus GLO-30 z %2</translation>
    </message>
    <message>
        <source>Say where the terrain is to be written.</source>
        <translation>Uveďte, kam se má terén zapsat.</translation>
    </message>
    <message>
        <source>Stopped. What came so far is kept and will be continued.</source>
        <translation>Zastaveno. Co dosud přišlo, zůstává a bude se pokračovat.</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::ImportTargetsDialog</name>
    <message>
        <source>Import targets from %1</source>
        <translation>Import cílů z %1</translation>
    </message>
    <message>
        <source>Points, corners of lines and waypoints become targets. Areas become parallel survey lines; the ends of the lines are targets.</source>
        <translation>Body, vrcholy čar a traťové body se stanou cíli. Plochy se stanou rovnoběžnými průzkumnými čarami; konce čar jsou cíle.</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importovat</translation>
    </message>
    <message>
        <source>those of the file where they are flown at, else %1</source>
        <translation>ty ze souboru, kde jsou letovými výškami, jinak %1</translation>
    </message>
    <message>
        <source>elevations of the file (.cup, GPX, Little Navmap) too</source>
        <translation>i výšky terénu ze souboru (.cup, GPX, Little Navmap)</translation>
    </message>
    <message>
        <source>one height above ground (AGL)</source>
        <translation>jedna výška nad zemí (AGL)</translation>
    </message>
    <message>
        <source>one altitude above mean sea level (MSL)</source>
        <translation>jedna výška nad hladinou moře (MSL)</translation>
    </message>
    <message>
        <source>along the &amp;longest side of each area</source>
        <translation>podél &amp;nejdelší strany každé plochy</translation>
    </message>
    <message>
        <source>Points of &amp;tracks too</source>
        <translation>I body &amp;stop</translation>
    </message>
    <message>
        <source>&amp;Heights</source>
        <translation>&amp;Výšky</translation>
    </message>
    <message>
        <source>H&amp;eight</source>
        <translation>Výš&amp;ka</translation>
    </message>
    <message>
        <source>&amp;Spacing of survey lines</source>
        <translation>&amp;Rozestup průzkumných čar</translation>
    </message>
    <message>
        <source>Lines run</source>
        <translation>Čáry vedou</translation>
    </message>
    <message>
        <source>True &amp;course of lines</source>
        <translation>&amp;Zeměpisný kurz čar</translation>
    </message>
    <message>
        <source>Targets of the file</source>
        <translation>Cíle souboru</translation>
    </message>
    <message>
        <source>Search names</source>
        <translation>Hledat jména</translation>
    </message>
    <message>
        <source>Choose &amp;all</source>
        <translation>Vybrat vš&amp;e</translation>
    </message>
    <message>
        <source>Chooses all targets that the search shows</source>
        <translation>Vybere všechny cíle, které hledání ukazuje</translation>
    </message>
    <message>
        <source>Choose &amp;none</source>
        <translation>Nevybr&amp;at nic</translation>
    </message>
    <message>
        <source>Leaves out all targets that the search shows</source>
        <translation>Vynechá všechny cíle, které hledání ukazuje</translation>
    </message>
    <message>
        <source>Reading the file again…</source>
        <translation>Soubor se čte znovu…</translation>
    </message>
    <message>
        <source>All places of this file are points of tracks; choose “Points of tracks too” to take them.</source>
        <translation>Všechna místa tohoto souboru jsou body stop; zvolte „I body stop“, chcete-li je převzít.</translation>
    </message>
    <message>
        <source>Choose at least one target to import.</source>
        <translation>Vyberte k importu alespoň jeden cíl.</translation>
    </message>
    <message>
        <source>At most %1 targets are imported at once; choose fewer.</source>
        <translation>Najednou se importuje nejvýše %1 cílů; vyberte méně.</translation>
    </message>
    <message>
        <source>%1 of %2 chosen</source>
        <translation>Vybráno %1 z %2</translation>
    </message>
    <message>
        <source>%1 of %2 chosen; the search shows %3</source>
        <translation>Vybráno %1 z %2; hledání ukazuje %3</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::JumpDialog</name>
    <message>
        <source>There is no terrain yet: add a terrain file first, then places on it can be shown.</source>
        <translation>Zatím není terén: nejprve přidejte soubor terénu, pak na něm lze ukázat místa.</translation>
    </message>
    <message>
        <source>Type a position, the ident of an airfield or the name of a target.</source>
        <translation>Zadejte polohu, kód letiště nebo název cíle.</translation>
    </message>
    <message>
        <source>“%1” is no target or airfield here, and not a position such as 46.6003 9.9017 or 46°36.02′ N 9°54.10′ E.</source>
        <translation>„%1“ zde není cíl ani letiště, a není to ani poloha jako 46.6003 9.9017 nebo 46°36.02′ N 9°54.10′ E.</translation>
    </message>
    <message>
        <source>%1 lies outside the terrain that is loaded.</source>
        <translation>%1 leží mimo načtený terén.</translation>
    </message>
    <message>
        <source>Jump to</source>
        <translation>Přejít na</translation>
    </message>
    <message>
        <source>&amp;Position, airfield or target</source>
        <translation>&amp;Poloha, letiště nebo cíl</translation>
    </message>
    <message>
        <source>Position, airfield or target</source>
        <translation>Poloha, letiště nebo cíl</translation>
    </message>
    <message>
        <source>Degrees, degrees and minutes, or degrees, minutes and seconds, with N, S, E, W or latitude first: 46.6003 9.9017, N46 36.02 E9 54.10, 46°36′01″ N 9°54′06″ E.</source>
        <translation>Stupně, stupně a minuty nebo stupně, minuty a vteřiny, s N, S, E, W nebo nejprve šířka: 46.6003 9.9017, N46 36.02 E9 54.10, 46°36′01″ N 9°54′06″ E.</translation>
    </message>
    <message>
        <source>&amp;Jump</source>
        <translation>Př&amp;ejít</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::MessageBanner</name>
    <message>
        <source>Message</source>
        <translation>Zpráva</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Zavřít tuto zprávu</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::MissionFilesDialog</name>
    <message>
        <source>Files of the mission</source>
        <translation>Soubory mise</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Soubor</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Druh</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Velikost</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Složka</translation>
    </message>
    <message>
        <source>&amp;Remove from mission</source>
        <translation>&amp;Odebrat z mise</translation>
    </message>
    <message>
        <source>Add &amp;terrain…</source>
        <translation>Přidat &amp;terén…</translation>
    </message>
    <message>
        <source>Add &amp;airfields…</source>
        <translation>Přidat &amp;letiště…</translation>
    </message>
    <message>
        <source>Add air&amp;spaces…</source>
        <translation>Přidat &amp;prostory…</translation>
    </message>
    <message>
        <source>Add &amp;population…</source>
        <translation>Přidat o&amp;byvatelstvo…</translation>
    </message>
    <message>
        <source>Remove from mission (Del)</source>
        <translation>Odebrat z mise (Del)</translation>
    </message>
    <message>
        <source>not there!</source>
        <translation>chybí!</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Terén</translation>
    </message>
    <message>
        <source>Airfields</source>
        <translation>Letiště</translation>
    </message>
    <message>
        <source>Airspaces</source>
        <translation>Vzdušné prostory</translation>
    </message>
    <message>
        <source>Population</source>
        <translation>Obyvatelstvo</translation>
    </message>
    <message>
        <source>No files yet. Add terrain, airfields, airspaces and population here, or drop them on the window.</source>
        <translation>Zatím žádné soubory. Přidejte terén, letiště, vzdušné prostory a obyvatelstvo zde, nebo je přetáhněte na okno.</translation>
    </message>
    <message>
        <source>Removing takes a file out of the mission; the file itself stays where it is, and Undo brings it back. A plan that was made with it is then out of date, but not by population, which only landing now looks at.</source>
        <translation>Odebrání vyjme soubor z mise; soubor sám zůstane, kde je, a příkaz Zpět jej vrátí. Plán, který s ním byl vytvořen, je pak zastaralý, ne však kvůli obyvatelstvu, které slouží jen okamžitému přistání.</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::MissionSettingsDialog</name>
    <message>
        <source>Mission settings</source>
        <translation>Nastavení mise</translation>
    </message>
    <message>
        <source>These values belong to the open mission and are saved with it.</source>
        <translation>Tyto hodnoty patří otevřené misi a ukládají se s ní.</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Název</translation>
    </message>
    <message>
        <source>nowhere: the tour alone</source>
        <translation>nikde: jen trasa</translation>
    </message>
    <message>
        <source>Runway to start at</source>
        <translation>Dráha pro začátek</translation>
    </message>
    <message>
        <source>where it starts</source>
        <translation>kde začíná</translation>
    </message>
    <message>
        <source>Runway to end at</source>
        <translation>Dráha pro konec</translation>
    </message>
    <message>
        <source>end</source>
        <translation>konec</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Start</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Bezpečnost</translation>
    </message>
    <message>
        <source>Approach</source>
        <translation>Přiblížení</translation>
    </message>
    <message>
        <source>Air and engine</source>
        <translation>Vzduch a motor</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>Plánovač</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::MissionValues</name>
    <message>
        <source>Terrain &amp;clearance</source>
        <translation>&amp;Odstup od terénu</translation>
    </message>
    <message>
        <source>Kept above the highest terrain post everywhere, on the tour and on every landing glide; includes the height that rolling into turns costs. Raise it for coarse terrain data, turbulence or an aircraft that you do not know well.</source>
        <translation>Drží se všude nad nejvyšším bodem terénu, na trase i při každém klouzání; zahrnuje výšku, kterou stojí překlápění do zatáček. Zvyšte jej při hrubých datech terénu, turbulenci nebo s letadlem, které dobře neznáte.</translation>
    </message>
    <message>
        <source>&amp;Arrival height</source>
        <translation>&amp;Výška při příletu</translation>
    </message>
    <message>
        <source>Height above the runway that every glide must still have at the touchdown point. Raise it to keep room for a circuit; 0 trusts the glide to the last metre.</source>
        <translation>Výška nad dráhou, kterou musí každé klouzání mít ještě v bodě dotyku. Zvyšte ji, aby zbylo místo na okruh; 0 věří klouzání na poslední metr.</translation>
    </message>
    <message>
        <source>Pass above at the safe altitude</source>
        <translation>Přeletět v bezpečné výšce</translation>
    </message>
    <message>
        <source>Descend to the target in a spiral</source>
        <translation>Klesnout k cíli ve spirále</translation>
    </message>
    <message>
        <source>&amp;Low targets</source>
        <translation>Nízké &amp;cíle</translation>
    </message>
    <message>
        <source>For targets below the lowest safe altitude. In a spiral the gliding guarantee is suspended, and the certificate says so: choose it only where the sensor needs the height.</source>
        <translation>Pro cíle pod nejmenší bezpečnou výškou. Ve spirále je záruka doklouzání přerušena a certifikát to říká: volte jen tam, kde výšku potřebuje senzor.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Rea&amp;ction time</source>
        <translation>Doba &amp;reakce</translation>
    </message>
    <message>
        <source>After the engine stops the aircraft flies on for so long before it turns. Pilots take about 4 seconds (FAA-H-8083-3) when they expect it, and much longer when they do not.</source>
        <translation>Po vysazení motoru letí letadlo tak dlouho dál, než zatočí. Pilotům to trvá asi 4 sekundy (FAA-H-8083-3), když to čekají, a mnohem déle, když ne.</translation>
    </message>
    <message>
        <source>Height &amp;lost in it</source>
        <translation>&amp;Ztráta výšky přitom</translation>
    </message>
    <message>
        <source>Until the glide is established, beyond what gliding loses: slowing down or speeding up, a wrong first turn. Try it with an instructor at a safe height.</source>
        <translation>Než je klouzání ustáleno, navíc k tomu, co ztrácí klouzání: zpomalení nebo zrychlení, chybná první zatáčka. Vyzkoušejte to s instruktorem v bezpečné výšce.</translation>
    </message>
    <message>
        <source>× </source>
        <translation>× </translation>
    </message>
    <message>
        <source>&amp;Drag</source>
        <translation>O&amp;dpor</translation>
    </message>
    <message>
        <source>What your glides cost more than the aircraft’s profile says: speed and bank not held exactly, an aircraft that is no longer new. 1.1 makes a glide of 9 : 1 one of about 8 : 1.</source>
        <translation>O co vaše klouzání stojí více, než říká profil letadla: nepřesně držená rychlost a náklon, letadlo, které už není nové. 1.1 udělá z klouzavosti 9 : 1 asi 8 : 1.</translation>
    </message>
    <message>
        <source>Limit the tour&apos;s altitude</source>
        <translation>Omezit výšku trasy</translation>
    </message>
    <message>
        <source>Ceiling above mean sea level</source>
        <translation>Strop nad hladinou moře</translation>
    </message>
    <message>
        <source>C&amp;eiling</source>
        <translation>S&amp;trop</translation>
    </message>
    <message>
        <source>The aircraft&apos;s own ceiling counts as well; the lower of the two limits the tour. Set it for airspace, cloud or oxygen.</source>
        <translation>Platí i vlastní dostup letadla; trasu omezuje nižší z obou. Nastavte jej kvůli vzdušnému prostoru, oblačnosti nebo kyslíku.</translation>
    </message>
    <message>
        <source>&amp;Headings per target</source>
        <translation>&amp;Kurzy na cíl</translation>
    </message>
    <message>
        <source>Directions that each target may be passed in. More give shorter tours and take longer; lower it for quick looks at many targets.</source>
        <translation>Směry, ve kterých se smí každý cíl přeletět. Více dává kratší trasy a trvá déle; pro rychlý pohled na mnoho cílů snižte.</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>&amp;Distance between decision points</source>
        <translation>&amp;Vzdálenost rozhodovacích bodů</translation>
    </message>
    <message>
        <source>Each decision point has its own landing glide; between them the aircraft glides on to the next. Shorter steps allow lower tours over rough ground and take longer.</source>
        <translation>Každý rozhodovací bod má své klouzání; mezi nimi letadlo klouže k dalšímu. Kratší kroky dovolí nižší trasy nad členitým terénem a trvají déle.</translation>
    </message>
    <message>
        <source>Cost of passing &amp;above targets</source>
        <translation>Cena pře&amp;letu nad cíli</translation>
    </message>
    <message>
        <source>Metres of detour that one metre above a target is worth; at least 2. Raise it if targets must be seen from close by.</source>
        <translation>Metry oklikou, za které stojí jeden metr nad cílem; nejméně 2. Zvyšte, je-li třeba vidět cíle zblízka.</translation>
    </message>
    <message>
        <source>Lazy: proves only the legs that matter</source>
        <translation>Lazy: dokazuje jen úseky, na kterých záleží</translation>
    </message>
    <message>
        <source>Base: computes every leg (slow)</source>
        <translation>Base: počítá každý úsek (pomalé)</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>&amp;Metoda</translation>
    </message>
    <message>
        <source>Both end with the same tour. Base is for comparing.</source>
        <translation>Obě skončí stejnou trasou. Base je pro srovnání.</translation>
    </message>
    <message>
        <source>Turn headings and try other orders around the tour</source>
        <translation>Otáčet kurzy a zkoušet jiná pořadí trasy</translation>
    </message>
    <message>
        <source>Re&amp;finement</source>
        <translation>&amp;Zjemnění</translation>
    </message>
    <message>
        <source>Makes the tour cheaper, most in steep country; takes a fraction of a second for twenty targets. Without it the tour is that of the source paper.</source>
        <translation>Zlevní trasu, nejvíce ve strmé krajině; u dvaceti cílů trvá zlomek sekundy. Bez něj je trasa ta z výchozího článku.</translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation>&amp;Počáteční číslo</translation>
    </message>
    <message>
        <source>The same seed gives the same plan. Try another one if a plan looks odd.</source>
        <translation>Stejné číslo dá stejný plán. Zkuste jiné, když plán vypadá divně.</translation>
    </message>
    <message>
        <source>Random samples (RRT*) instead of a lattice</source>
        <translation>Náhodné vzorky (RRT*) místo mřížky</translation>
    </message>
    <message>
        <source>Number of random samples</source>
        <translation>Počet náhodných vzorků</translation>
    </message>
    <message>
        <source>&amp;Roadmap</source>
        <translation>&amp;Síť cest</translation>
    </message>
    <message>
        <source>The lattice is faster and finds lower safe altitudes. Random samples are the method of the source paper, for comparing; more of them find lower altitudes and take longer.</source>
        <translation>Mřížka je rychlejší a nachází nižší bezpečné výšky. Náhodné vzorky jsou metodou výchozího článku, pro srovnání; více vzorků najde nižší výšky a trvá déle.</translation>
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
        <translation>Klouzavé vlastnosti</translation>
    </message>
    <message>
        <source>Straight glide ratio %1</source>
        <translation>Klouzavost přímo %1</translation>
    </message>
    <message>
        <source>Mass, wing area, drag, density and speed must be positive.</source>
        <translation>Hmotnost, plocha křídla, odpor, hustota a rychlost musí být kladné.</translation>
    </message>
    <message>
        <source>Glide ratio %1 : 1 (%2) at %3, wings level</source>
        <translation>Klouzavost %1 : 1 (%2) při %3, bez náklonu</translation>
    </message>
    <message>
        <source>Bank angle</source>
        <translation>Náklon</translation>
    </message>
    <message>
        <source>Height lost in a half turn</source>
        <translation>Ztráta výšky v polovině kruhu</translation>
    </message>
    <message>
        <source>stalls</source>
        <translation>pád</translation>
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
        <translation>Předvolby</translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation>Ob&amp;ecné</translation>
    </message>
    <message>
        <source>New missions: &amp;safety</source>
        <translation>Nové mise: &amp;bezpečnost</translation>
    </message>
    <message>
        <source>New missions: &amp;planner</source>
        <translation>Nové mise: &amp;plánovač</translation>
    </message>
    <message>
        <source>&amp;3D view</source>
        <translation>&amp;3D pohled</translation>
    </message>
    <message>
        <source>Changes apply at once and are remembered.</source>
        <translation>Změny platí ihned a zůstanou uloženy.</translation>
    </message>
    <message>
        <source>&amp;Defaults of this page</source>
        <translation>Výchozí &amp;hodnoty této stránky</translation>
    </message>
    <message>
        <source>Aviation: ft, NM, kt, ft/min</source>
        <translation>Letecké: ft, NM, kt, ft/min</translation>
    </message>
    <message>
        <source>Metric: m, km, km/h, m/s</source>
        <translation>Metrické: m, km, km/h, m/s</translation>
    </message>
    <message>
        <source>&amp;Units</source>
        <translation>&amp;Jednotky</translation>
    </message>
    <message>
        <source>How heights, distances and speeds are shown and typed everywhere. Files keep their own units; heights always say whether they are above mean sea level (MSL) or above ground (AGL).</source>
        <translation>Jak se všude ukazují a zadávají výšky, vzdálenosti a rychlosti. Soubory si ponechají své jednotky; u výšek je vždy uvedeno, zda jsou nad hladinou moře (MSL) nebo nad zemí (AGL).</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Podle plochy</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Světlý</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Tmavý</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>V&amp;zhled</translation>
    </message>
    <message>
        <source>Light for daylight and print, dark for dim rooms and night briefings. “As the desktop” takes what the desktop had when Volplane was started.</source>
        <translation>Světlý pro denní světlo a tisk, tmavý pro tmavé místnosti a noční přípravu. „Podle plochy“ převezme, co měla plocha při spuštění Volplane.</translation>
    </message>
    <message>
        <source>That of the system</source>
        <translation>Podle systému</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>Jaz&amp;yk</translation>
    </message>
    <message>
        <source>Of the window and of briefings written from it, from the next start on. Messages about files and findings of the checker are in English.</source>
        <translation>Okna a briefingů z něj zapsaných, od příštího spuštění. Hlášení o souborech a nálezy kontroly jsou anglicky.</translation>
    </message>
    <message>
        <source>New missions start with these values. The open mission, “%1”, keeps its own.</source>
        <translation>Nové mise začínají s těmito hodnotami. Otevřená mise „%1“ si ponechá své.</translation>
    </message>
    <message>
        <source>&amp;Open mission’s settings…</source>
        <translation>&amp;Nastavení otevřené mise…</translation>
    </message>
    <message>
        <source>× </source>
        <translation>× </translation>
    </message>
    <message>
        <source>&amp;Heights drawn</source>
        <translation>&amp;Převýšení</translation>
    </message>
    <message>
        <source>1 is true to scale. More makes gentle relief visible; the picture then says so, because slopes and glides look steeper than they are.</source>
        <translation>1 je ve skutečném měřítku. Více zviditelní mírný reliéf; obrázek to pak uvádí, protože svahy a klouzání vypadají strmější, než jsou.</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Trasa</translation>
    </message>
    <message>
        <source>Curtain down to the ground</source>
        <translation>Závěs až k zemi</translation>
    </message>
    <message>
        <source>Shows where the tour is over the terrain. Take it away if it hides what is behind.</source>
        <translation>Ukazuje, kde je trasa nad terénem. Odeberte jej, když skrývá, co je za ním.</translation>
    </message>
    <message>
        <source>G&amp;lides</source>
        <translation>&amp;Klouzání</translation>
    </message>
    <message>
        <source>Of every decision point</source>
        <translation>Z každého rozhodovacího bodu</translation>
    </message>
    <message>
        <source>All landing glides at once instead of the one from the point that is looked at. Slower on plans with thousands of points.</source>
        <translation>Všechna klouzání najednou místo jednoho z prohlíženého bodu. U plánů s tisíci body pomalejší.</translation>
    </message>
    <message>
        <source>&amp;Runways</source>
        <translation>&amp;Dráhy</translation>
    </message>
    <message>
        <source>Runways that may be used</source>
        <translation>Dráhy, které se smějí použít</translation>
    </message>
    <message>
        <source>Drawn to scale on the terrain.</source>
        <translation>Nakreslené na terénu v měřítku.</translation>
    </message>
    <message>
        <source>E&amp;xcluded</source>
        <translation>V&amp;yloučené</translation>
    </message>
    <message>
        <source>Runways that the filter leaves out</source>
        <translation>Dráhy, které filtr vynechává</translation>
    </message>
    <message>
        <source>Drawn weaker, to see what is being given up.</source>
        <translation>Kreslené slaběji, aby bylo vidět, čeho se vzdáváte.</translation>
    </message>
    <message>
        <source>&amp;Names</source>
        <translation>&amp;Jména</translation>
    </message>
    <message>
        <source>Of targets and runways</source>
        <translation>Cílů a drah</translation>
    </message>
    <message>
        <source>Take them away for pictures.</source>
        <translation>Pro obrázky je odeberte.</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::SafeAltitudeDialog</name>
    <message>
        <source>Lowest safe altitude map</source>
        <translation>Mapa nejmenší bezpečné výšky</translation>
    </message>
    <message>
        <source>Any course, and each course by itself</source>
        <translation>Jakýkoli kurz, a každý kurz zvlášť</translation>
    </message>
    <message>
        <source>Any course (the worst counts)</source>
        <translation>Jakýkoli kurz (platí nejhorší)</translation>
    </message>
    <message>
        <source>The best course at each place</source>
        <translation>Nejlepší kurz v každém místě</translation>
    </message>
    <message>
        <source>One course</source>
        <translation>Jeden kurz</translation>
    </message>
    <message>
        <source>° true</source>
        <translation>° zeměpisně</translation>
    </message>
    <message>
        <source>as fine as sensible</source>
        <translation>tak jemně, jak má smysl</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>From every place of a cell, at its altitude or above, engine off and in the mission&apos;s wind, a glide reaches a runway. GeoTIFF (.tif) holds the values, KML and GeoPackage (.kml, .gpkg) hold contours: between two lines the higher one counts.</source>
        <translation>Z každého místa buňky, v její výšce nebo výše, se zastaveným motorem a při větru mise, vede klouzání na dráhu. GeoTIFF (.tif) obsahuje hodnoty, KML a GeoPackage (.kml, .gpkg) vrstevnice: mezi dvěma čarami platí vyšší.</translation>
    </message>
    <message>
        <source>&amp;Write to…</source>
        <translation>&amp;Zapsat do…</translation>
    </message>
    <message>
        <source>&amp;For</source>
        <translation>&amp;Pro</translation>
    </message>
    <message>
        <source>C&amp;ourse</source>
        <translation>&amp;Kurz</translation>
    </message>
    <message>
        <source>&amp;Cells</source>
        <translation>&amp;Buňky</translation>
    </message>
    <message>
        <source>Contours &amp;every</source>
        <translation>&amp;Vrstevnice po</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::TargetChoiceModel</name>
    <message>
        <source>Name</source>
        <translation>Název</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Poloha</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Výška</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::TargetDialog</name>
    <message>
        <source>Target %1</source>
        <translation>Cíl %1</translation>
    </message>
    <message>
        <source>above ground (AGL)</source>
        <translation>nad zemí (AGL)</translation>
    </message>
    <message>
        <source>above mean sea level (MSL)</source>
        <translation>nad hladinou moře (MSL)</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Název</translation>
    </message>
    <message>
        <source>&amp;Position</source>
        <translation>&amp;Poloha</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Výška</translation>
    </message>
    <message>
        <source>&amp;Measured</source>
        <translation>&amp;Měřeno</translation>
    </message>
    <message>
        <source>A target needs a name.</source>
        <translation>Cíl potřebuje jméno.</translation>
    </message>
    <message>
        <source>Another target is called %1 already.</source>
        <translation>Jiný cíl se již jmenuje %1.</translation>
    </message>
    <message>
        <source>This is not a position; write for example 46.6003 9.9017 or 46°36.02′ N 9°54.10′ E.</source>
        <translation>Toto není poloha; napište například 46.6003 9.9017 nebo 46°36.02′ N 9°54.10′ E.</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::WeatherDialog</name>
    <message>
        <source>from the &amp;ground</source>
        <translation>od &amp;země</translation>
    </message>
    <message>
        <source>&amp;unlimited</source>
        <translation>&amp;neomezeně</translation>
    </message>
    <message>
        <source> % for each %1</source>
        <translation> % na každý %1</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Název</translation>
    </message>
    <message>
        <source>&amp;Floor</source>
        <translation>&amp;Dolní mez</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Horní mez</translation>
    </message>
    <message>
        <source>&amp;Coming through</source>
        <translation>&amp;Průlet</translation>
    </message>
    <message>
        <source>How likely a flight is to come through so much of it. A guess in round figures will do: planners of landings keep out of weather where they can, and say how likely the rest is.</source>
        <translation>Jak pravděpodobně let takovým kusem proletí. Stačí hrubý odhad: plánovače přistání se počasí vyhýbají, kde mohou, a říkají, jak pravděpodobný je zbytek.</translation>
    </message>
    <message>
        <source>The top must be above the floor.</source>
        <translation>Horní mez musí být nad dolní.</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::WeatherListDialog</name>
    <message>
        <source>Weather of the mission</source>
        <translation>Počasí mise</translation>
    </message>
    <message>
        <source>&amp;Draw</source>
        <translation>&amp;Kreslit</translation>
    </message>
    <message>
        <source>&amp;Edit…</source>
        <translation>&amp;Upravit…</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Odebrat</translation>
    </message>
    <message>
        <source>&amp;Add from file…</source>
        <translation>&amp;Přidat ze souboru…</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportovat…</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Název</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Dolní mez</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Horní mez</translation>
    </message>
    <message>
        <source>Coming through</source>
        <translation>Průlet</translation>
    </message>
    <message>
        <source>per</source>
        <translation>na</translation>
    </message>
    <message>
        <source>“%1” is no probability; give a number above 0 up to 100, in percent for each %2.</source>
        <translation>„%1“ není pravděpodobnost; zadejte číslo nad 0 do 100, v procentech na každý %2.</translation>
    </message>
    <message>
        <source>“%1” does not fit; give an altitude in %2 above mean sea level, the top above the floor, or GND and UNL.</source>
        <translation>„%1“ se nehodí; zadejte výšku v %2 nad hladinou moře, horní mez nad dolní, nebo GND a UNL.</translation>
    </message>
    <message>
        <source>No weather yet. Draw it on the map, add a file here, or drop one on the window.</source>
        <translation>Zatím žádné počasí. Nakreslete je na mapě, přidejte zde soubor, nebo jej přetáhněte na okno.</translation>
    </message>
    <message>
        <source>Planners of landings keep out of weather where they can and tell how likely the rest is. The tour and its certificate know nothing of weather.</source>
        <translation>Plánovače přistání se počasí vyhýbají, kde mohou, a říkají, jak pravděpodobný je zbytek. Trasa a její certifikát o počasí nic nevědí.</translation>
    </message>
</context>
<context>
    <name>vp::dialogs::WindDialog</name>
    <message>
        <source>Wind</source>
        <translation>Vítr</translation>
    </message>
    <message>
        <source>Layers of wind</source>
        <translation>Vrstvy větru</translation>
    </message>
    <message>
        <source>Altitude MSL</source>
        <translation>Výška MSL</translation>
    </message>
    <message>
        <source>From, true</source>
        <translation>Odkud, zeměpisně</translation>
    </message>
    <message>
        <source>± direction</source>
        <translation>± směr</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Rychlost</translation>
    </message>
    <message>
        <source>± speed</source>
        <translation>± rychlost</translation>
    </message>
    <message>
        <source>&amp;Add layer</source>
        <translation>&amp;Přidat vrstvu</translation>
    </message>
    <message>
        <source>&amp;Remove layer</source>
        <translation>&amp;Odebrat vrstvu</translation>
    </message>
    <message>
        <source>&amp;Still air</source>
        <translation>&amp;Bezvětří</translation>
    </message>
    <message>
        <source>Read &amp;from text</source>
        <translation>Číst &amp;z textu</translation>
    </message>
    <message>
        <source>270±20/15±5kt, a METAR, or 2000ft 270/15kt; 6000ft 290/25kt</source>
        <translation>270±20/15±5kt, METAR, nebo 2000ft 270/15kt; 6000ft 290/25kt</translation>
    </message>
    <message>
        <source>Rea&amp;d</source>
        <translation>Čí&amp;st</translation>
    </message>
    <message>
        <source>The plan will hold for: </source>
        <translation>Plán bude platit za: </translation>
    </message>
    <message>
        <source>Between the layers, everything between their winds.</source>
        <translation>Mezi vrstvami vše mezi jejich větry.</translation>
    </message>
</context>
<context>
    <name>vp::document::DocumentLock</name>
    <message>
        <source>%1 on %2 (%3, process %4) since %5</source>
        <translation>%1 na %2 (%3, proces %4) od %5</translation>
    </message>
    <message>
        <source>somebody</source>
        <translation>někdo</translation>
    </message>
    <message>
        <source>an unknown computer</source>
        <translation>neznámém počítači</translation>
    </message>
</context>
<context>
    <name>vp::document::MissionDocument</name>
    <message>
        <source>Untitled mission</source>
        <translation>Nepojmenovaná mise</translation>
    </message>
</context>
<context>
    <name>vp::document::WeatherWords</name>
    <message>
        <source>Weather %1</source>
        <translation>Počasí %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 až %2</translation>
    </message>
    <message>
        <source>%1 per %2</source>
        <comment>probability of coming through a unit of distance</comment>
        <translation>%1 na %2</translation>
    </message>
</context>
<context>
    <name>vp::document::Words</name>
    <message>
        <source>Hide</source>
        <translation>Skrýt</translation>
    </message>
    <message>
        <source>Show only</source>
        <translation>Jen ukázat</translation>
    </message>
    <message>
        <source>Warn when entered</source>
        <translation>Varovat při vletu</translation>
    </message>
    <message>
        <source>Keep the tour out</source>
        <translation>Držet trasu mimo</translation>
    </message>
</context>
<context>
    <name>vp::gui::AutosaveKeeper</name>
    <message>
        <source>Work of a session that ended unexpectedly was found but cannot be read: %1 It stays in %2.</source>
        <translation>Byla nalezena práce z nečekaně ukončeného sezení, ale nelze ji přečíst: %1 Zůstává v %2.</translation>
    </message>
    <message>
        <source>The last session ended unexpectedly. Its work on “%1” is here again; save it to keep it.</source>
        <translation>Poslední sezení skončilo nečekaně. Jeho práce na „%1“ je zde znovu; uložte ji, chcete-li ji zachovat.</translation>
    </message>
    <message>
        <source>Discard it</source>
        <translation>Zahodit</translation>
    </message>
    <message>
        <source>Unsaved work cannot be kept for the case of a crash; save the mission yourself. %1</source>
        <translation>Neuloženou práci nelze uchovat pro případ pádu programu; uložte misi sami. %1</translation>
    </message>
    <message>
        <source>%1 has been written after this copy was kept: compare before you save over it.</source>
        <translation>%1 byl zapsán po uchování této kopie: porovnejte, než jej přepíšete.</translation>
    </message>
</context>
<context>
    <name>vp::gui::BriefingController</name>
    <message>
        <source>the plan could not be verified again, so no briefing was written; plan the tour again, or look at the findings</source>
        <translation>plán se nepodařilo znovu ověřit, proto nebyl briefing zapsán; naplánujte trasu znovu, nebo se podívejte na nálezy</translation>
    </message>
    <message>
        <source>This plan is UNVERIFIED: nobody has shown that a glide to a runway exists from every point of it. Every page will say so.</source>
        <translation>Tento plán je NEOVĚŘENÝ: nikdo neukázal, že z každého jeho bodu lze doklouzat na dráhu. Bude to na každé straně.</translation>
    </message>
    <message>
        <source>This plan is out of date: the mission has been changed since it was made. The briefing is that of the old plan.</source>
        <translation>Tento plán je zastaralý: mise byla od jeho vytvoření změněna. Briefing patří ke starému plánu.</translation>
    </message>
    <message>
        <source>%1-briefing.pdf</source>
        <translation>%1-briefing.pdf</translation>
    </message>
    <message>
        <source>There is no plan to brief; plan the tour first.</source>
        <translation>Pro briefing není plán; nejprve naplánujte trasu.</translation>
    </message>
    <message>
        <source>Save briefing</source>
        <translation>Uložit briefing</translation>
    </message>
    <message>
        <source>Briefing of %1 pages written to %2</source>
        <translation>Briefing o %1 stranách zapsán do %2</translation>
    </message>
    <message>
        <source>UNVERIFIED briefing of %1 pages written to %2</source>
        <translation>NEOVĚŘENÝ briefing o %1 stranách zapsán do %2</translation>
    </message>
</context>
<context>
    <name>vp::gui::EditController</name>
    <message>
        <source>Add target %1</source>
        <translation>Přidat cíl %1</translation>
    </message>
    <message>
        <source>Move target %1</source>
        <translation>Přesunout cíl %1</translation>
    </message>
    <message>
        <source>Delete target %1</source>
        <translation>Smazat cíl %1</translation>
    </message>
    <message>
        <source>Rename target</source>
        <translation>Přejmenovat cíl</translation>
    </message>
    <message>
        <source>Name of target %1</source>
        <translation>Název cíle %1</translation>
    </message>
    <message>
        <source>Edit target %1</source>
        <translation>Upravit cíl %1</translation>
    </message>
    <message>
        <source>Reorder targets</source>
        <translation>Změnit pořadí cílů</translation>
    </message>
    <message>
        <source>Plan without a home runway</source>
        <translation>Plánovat bez domovské dráhy</translation>
    </message>
    <message>
        <source>Start and end at %1</source>
        <translation>Začít a skončit na %1</translation>
    </message>
    <message>
        <source>Start at %1, end at %2</source>
        <translation>Začít na %1, skončit na %2</translation>
    </message>
    <message>
        <source>Exclude runway %1</source>
        <translation>Vyloučit dráhu %1</translation>
    </message>
    <message>
        <source>Include runway %1</source>
        <translation>Zahrnout dráhu %1</translation>
    </message>
    <message>
        <source>class %1</source>
        <translation>třída %1</translation>
    </message>
    <message>
        <source>Airspace %1: %2</source>
        <translation>Vzdušný prostor %1: %2</translation>
    </message>
    <message>
        <source>Change airspace rules</source>
        <translation>Změnit pravidla prostorů</translation>
    </message>
    <message>
        <source>Change runway filter</source>
        <translation>Změnit filtr drah</translation>
    </message>
    <message>
        <source>Land %1 one way only</source>
        <translation>Na %1 přistávat jen jedním směrem</translation>
    </message>
    <message>
        <source>Land both ways of %1</source>
        <translation>Na %1 přistávat oběma směry</translation>
    </message>
    <message>
        <source>Note on runway %1</source>
        <translation>Poznámka k dráze %1</translation>
    </message>
    <message>
        <source>Include excluded runways</source>
        <translation>Zahrnout vyloučené dráhy</translation>
    </message>
    <message>
        <source>Allow passing above targets</source>
        <translation>Povolit přelet nad cíli</translation>
    </message>
    <message>
        <source>Raise ceiling</source>
        <translation>Zvýšit strop</translation>
    </message>
    <message>
        <source>Remove ceiling</source>
        <translation>Zrušit strop</translation>
    </message>
    <message>
        <source>Change mission settings</source>
        <translation>Změnit nastavení mise</translation>
    </message>
    <message>
        <source>Change aircraft</source>
        <translation>Změnit letadlo</translation>
    </message>
    <message>
        <source>Change wind</source>
        <translation>Změnit vítr</translation>
    </message>
    <message>
        <source>Remove terrain %1</source>
        <translation>Odebrat terén %1</translation>
    </message>
    <message>
        <source>Remove airspaces %1</source>
        <translation>Odebrat vzdušné prostory %1</translation>
    </message>
    <message>
        <source>Remove population %1</source>
        <translation>Odebrat obyvatelstvo %1</translation>
    </message>
    <message>
        <source>Remove airfields %1</source>
        <translation>Odebrat letiště %1</translation>
    </message>
</context>
<context>
    <name>vp::gui::ExportController</name>
    <message>
        <source>Picture of the map…</source>
        <translation>Obrázek mapy…</translation>
    </message>
    <message>
        <source>Picture of the profile…</source>
        <translation>Obrázek profilu…</translation>
    </message>
    <message>
        <source>Picture of the 3D view…</source>
        <translation>Obrázek 3D pohledu…</translation>
    </message>
    <message>
        <source>There is no plan to export; plan the tour first.</source>
        <translation>Není plán k exportu; nejprve naplánujte trasu.</translation>
    </message>
    <message>
        <source>This plan is UNVERIFIED: nobody has shown that a glide to a runway exists from every point of it.</source>
        <translation>Tento plán je NEOVĚŘENÝ: nikdo neukázal, že z každého jeho bodu lze doklouzat na dráhu.</translation>
    </message>
    <message>
        <source>This plan is out of date: the mission has been changed since it was made.</source>
        <translation>Tento plán je zastaralý: mise byla od jeho vytvoření změněna.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Export it all the same?</source>
        <translation>Přesto exportovat?</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>Přesto exportovat</translation>
    </message>
    <message>
        <source>note: %1</source>
        <translation>poznámka: %1</translation>
    </message>
    <message>
        <source>Written to %1</source>
        <translation>Zapsáno do %1</translation>
    </message>
    <message numerus="yes">
        <source>%n files written to %1</source>
        <translation>
            <numerusform>%n soubor zapsán do %1</numerusform>
            <numerusform>%n soubory zapsány do %1</numerusform>
            <numerusform>%n souborů zapsáno do %1</numerusform>
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
        <translation>Terén stažen a přidán k misi: %1.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Zastavit</translation>
    </message>
    <message>
        <source>The ones here are of %1.</source>
        <translation>Zdejší jsou z %1.</translation>
    </message>
    <message>
        <source>None are here yet.</source>
        <translation>Zde zatím žádná nejsou.</translation>
    </message>
    <message>
        <source>Update airfields</source>
        <translation>Aktualizovat letiště</translation>
    </message>
    <message>
        <source>Fetch the airfields of the world from OurAirports?</source>
        <translation>Stáhnout letiště celého světa z OurAirports?</translation>
    </message>
    <message>
        <source>About 17 MB are fetched, less if nothing is new.</source>
        <translation>Stáhne se asi 17 MB, méně, není-li nic nového.</translation>
    </message>
    <message>
        <source>Fetch</source>
        <translation>Stáhnout</translation>
    </message>
    <message>
        <source>Fetching the airfields…</source>
        <translation>Stahují se letiště…</translation>
    </message>
    <message>
        <source>The airfields are up to date.</source>
        <translation>Letiště jsou aktuální.</translation>
    </message>
    <message>
        <source>Airfields of %1: %L2 landing sites in the world.</source>
        <translation>Letiště z %1: %L2 přistávacích míst na světě.</translation>
    </message>
    <message>
        <source>Open the mission again to use them.</source>
        <translation>Otevřete misi znovu, aby se použila.</translation>
    </message>
    <message>
        <source>The landing glides are not known yet: the mission needs terrain and runways, and a moment to compute.</source>
        <translation>Klouzání zatím není známo: mise potřebuje terén a dráhy a chvíli na výpočet.</translation>
    </message>
    <message>
        <source>Write lowest safe altitudes to</source>
        <translation>Zapsat nejmenší bezpečné výšky do</translation>
    </message>
    <message>
        <source>Computing the lowest safe altitudes…</source>
        <translation>Počítají se nejmenší bezpečné výšky…</translation>
    </message>
    <message>
        <source>Written to %1: cells of %2 m, %3 % of the area has a lowest safe altitude.</source>
        <translation>Zapsáno do %1: buňky po %2 m, nejmenší bezpečnou výšku má %3 % plochy.</translation>
    </message>
</context>
<context>
    <name>vp::gui::FileController</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Neuložené změny</translation>
    </message>
    <message>
        <source>“%1” has changes that are not saved.</source>
        <translation>„%1“ má změny, které nejsou uloženy.</translation>
    </message>
    <message>
        <source>Save them first?</source>
        <translation>Uložit je nejprve?</translation>
    </message>
    <message>
        <source>Open mission or plan</source>
        <translation>Otevřít misi nebo plán</translation>
    </message>
    <message>
        <source>Missions and plans (*.vpm *.vpp);;All files (*)</source>
        <translation>Mise a plány (*.vpm *.vpp);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Čte se %1</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Zapisuje se %1</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Neuloženo</translation>
    </message>
    <message>
        <source>Save mission</source>
        <translation>Uložit misi</translation>
    </message>
    <message>
        <source>Missions (*.vpm)</source>
        <translation>Mise (*.vpm)</translation>
    </message>
    <message>
        <source>Planning is running</source>
        <translation>Plánování běží</translation>
    </message>
    <message>
        <source>A plan is being made. Stop it and close?</source>
        <translation>Vytváří se plán. Zastavit a zavřít?</translation>
    </message>
    <message>
        <source>Add terrain</source>
        <translation>Přidat terén</translation>
    </message>
    <message>
        <source>Add airfields</source>
        <translation>Přidat letiště</translation>
    </message>
    <message>
        <source>Airfields: OurAirports csv (both files), X-Plane apt.dat, SeeYou cup, own csv or GeoJSON (*.csv *.csv.gz *.cup *.dat *.dat.gz *.geojson *.json);;All files (*)</source>
        <translation>Letiště: OurAirports csv (oba soubory), X-Plane apt.dat, SeeYou cup, vlastní csv nebo GeoJSON (*.csv *.csv.gz *.cup *.dat *.dat.gz *.geojson *.json);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Add airspaces</source>
        <translation>Přidat vzdušné prostory</translation>
    </message>
    <message>
        <source>Airspaces: OpenAir (*.txt *.air *.txt.gz *.air.gz);;All files (*)</source>
        <translation>Vzdušné prostory: OpenAir (*.txt *.air *.txt.gz *.air.gz);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Add weather</source>
        <translation>Přidat počasí</translation>
    </message>
    <message>
        <source>Polygons of weather (*.geojson *.json *.shp *.gpkg *.kml *.kmz);;All files (*)</source>
        <translation>Plochy počasí (*.geojson *.json *.shp *.gpkg *.kml *.kmz);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Add population</source>
        <translation>Přidat obyvatelstvo</translation>
    </message>
    <message>
        <source>Polygons with people in them (*.geojson *.json *.shp *.gpkg *.kml *.kmz);;All files (*)</source>
        <translation>Plochy s obyvateli (*.geojson *.json *.shp *.gpkg *.kml *.kmz);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Import targets</source>
        <translation>Importovat cíle</translation>
    </message>
    <message>
        <source>Targets: SeeYou, GPX, KML, table, GeoJSON, QGroundControl, Little Navmap (*.cup *.gpx *.kml *.kmz *.csv *.geojson *.json *.plan *.lnmpln);;All files (*)</source>
        <translation>Cíle: SeeYou, GPX, KML, tabulka, GeoJSON, QGroundControl, Little Navmap (*.cup *.gpx *.kml *.kmz *.csv *.geojson *.json *.plan *.lnmpln);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Open one mission or plan at a time, and terrain and airfields after it.</source>
        <translation>Otevírejte po jedné misi nebo plánu, terén a letiště až po nich.</translation>
    </message>
    <message>
        <source>Airfields or targets?</source>
        <translation>Letiště, nebo cíle?</translation>
    </message>
    <message>
        <source>%1 can be taken for airfields or for targets.</source>
        <translation>%1 lze brát jako letiště nebo jako cíle.</translation>
    </message>
    <message>
        <source>&amp;Airfields</source>
        <translation>&amp;Letiště</translation>
    </message>
    <message>
        <source>&amp;Targets</source>
        <translation>&amp;Cíle</translation>
    </message>
    <message>
        <source>&amp;Leave it out</source>
        <translation>&amp;Vynechat</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Zastavit</translation>
    </message>
    <message numerus="yes">
        <source>%n target(s) imported from %1.</source>
        <translation>
            <numerusform>%n cíl importován z %1.</numerusform>
            <numerusform>%n cíle importovány z %1.</numerusform>
            <numerusform>%n cílů importováno z %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of them cannot be planned on this terrain: %1.</source>
        <translation>
            <numerusform>%n z nich nelze na tomto terénu plánovat: %1.</numerusform>
            <numerusform>%n z nich nelze na tomto terénu plánovat: %1.</numerusform>
            <numerusform>%n z nich nelze na tomto terénu plánovat: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n weather cell(s) added from %1.</source>
        <translation>
            <numerusform>%n buňka počasí přidána z %1.</numerusform>
            <numerusform>%n buňky počasí přidány z %1.</numerusform>
            <numerusform>%n buněk počasí přidáno z %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>And %n more note(s).</source>
        <translation>
            <numerusform>A ještě %n poznámka.</numerusform>
            <numerusform>A ještě %n poznámky.</numerusform>
            <numerusform>A ještě %n poznámek.</numerusform>
        </translation>
    </message>
    <message>
        <source>Elevation rasters (*.tif *.tiff *.hgt *.dt0 *.dt1 *.dt2 *.asc *.img *.bil);;All files (*)</source>
        <translation>Výškové rastry (*.tif *.tiff *.hgt *.dt0 *.dt1 *.dt2 *.asc *.img *.bil);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>“%1” is open elsewhere: %2. This is a copy of it; save it under another name.</source>
        <translation>„%1“ je otevřeno jinde: %2. Toto je jeho kopie; uložte ji pod jiným jménem.</translation>
    </message>
    <message>
        <source>Open elsewhere</source>
        <translation>Otevřeno jinde</translation>
    </message>
    <message>
        <source>“%1” is open elsewhere: %2.</source>
        <translation>„%1“ je otevřeno jinde: %2.</translation>
    </message>
    <message>
        <source>Whether that window still runs cannot be told from here.</source>
        <translation>Zda to okno ještě běží, odtud nelze říci.</translation>
    </message>
    <message>
        <source>A copy can be changed and saved under another name. If both save the same file, the later one wins.</source>
        <translation>Kopii lze změnit a uložit pod jiným jménem. Uloží-li obě okna týž soubor, platí pozdější.</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>Otevřít kopii</translation>
    </message>
    <message>
        <source>Open anyway</source>
        <translation>Přesto otevřít</translation>
    </message>
    <message>
        <source>“%1” has been changed on disk since it was opened here, at %2.</source>
        <translation>„%1“ bylo na disku změněno od svého otevření zde, v %2.</translation>
    </message>
    <message>
        <source>Save this work under another name, or overwrite what is there?</source>
        <translation>Uložit tuto práci pod jiným jménem, nebo přepsat, co tam je?</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Uložit jako…</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Přepsat</translation>
    </message>
</context>
<context>
    <name>vp::gui::MainWindow</name>
    <message>
        <source>Targets</source>
        <translation>Cíle</translation>
    </message>
    <message>
        <source>Runways</source>
        <translation>Dráhy</translation>
    </message>
    <message>
        <source>Engine out</source>
        <translation>Vysazení motoru</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plán</translation>
    </message>
    <message>
        <source>Landing now</source>
        <translation>Okamžité přistání</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Decision points</source>
        <translation>Rozhodovací body</translation>
    </message>
    <message>
        <source>%1 % – %2</source>
        <translation>%1 % – %2</translation>
    </message>
    <message>
        <source>Plan !</source>
        <translation>Plán !</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Soubor</translation>
    </message>
    <message>
        <source>&amp;New mission</source>
        <translation>&amp;Nová mise</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Otevřít…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>N&amp;aposledy otevřené</translation>
    </message>
    <message>
        <source>Open &amp;example</source>
        <translation>Otevřít příkla&amp;d</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Uložit</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Uložit &amp;jako…</translation>
    </message>
    <message>
        <source>Add &amp;terrain…</source>
        <translation>Přidat &amp;terén…</translation>
    </message>
    <message>
        <source>Add air&amp;fields…</source>
        <translation>Přidat &amp;letiště…</translation>
    </message>
    <message>
        <source>Add airs&amp;paces…</source>
        <translation>Přidat &amp;vzdušné prostory…</translation>
    </message>
    <message>
        <source>Add popu&amp;lation…</source>
        <translation>Přidat o&amp;byvatelstvo…</translation>
    </message>
    <message>
        <source>Add &amp;weather…</source>
        <translation>Přidat &amp;počasí…</translation>
    </message>
    <message>
        <source>Fetch terrain for t&amp;his area…</source>
        <translation>&amp;Stáhnout terén pro tuto oblast…</translation>
    </message>
    <message>
        <source>&amp;Update airfields…</source>
        <translation>Aktualizovat l&amp;etiště…</translation>
    </message>
    <message>
        <source>&amp;Import targets…</source>
        <translation>&amp;Importovat cíle…</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>E&amp;xportovat</translation>
    </message>
    <message>
        <source>&amp;Several formats…</source>
        <translation>&amp;Několik formátů…</translation>
    </message>
    <message>
        <source>Lowest safe altitude map…</source>
        <translation>Mapa nejmenší bezpečné výšky…</translation>
    </message>
    <message>
        <source>&amp;Briefing…</source>
        <translation>B&amp;riefing…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>U&amp;končit</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Upravit</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Zpět</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Zn&amp;ovu</translation>
    </message>
    <message>
        <source>Edit &amp;target…</source>
        <translation>Upravit &amp;cíl…</translation>
    </message>
    <message>
        <source>Re&amp;name target…</source>
        <translation>Přej&amp;menovat cíl…</translation>
    </message>
    <message>
        <source>&amp;Delete target</source>
        <translation>&amp;Smazat cíl</translation>
    </message>
    <message>
        <source>Mo&amp;ve target up</source>
        <translation>Cíl &amp;výše</translation>
    </message>
    <message>
        <source>Move target d&amp;own</source>
        <translation>Cíl &amp;níže</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Předvolby…</translation>
    </message>
    <message>
        <source>&amp;Mission</source>
        <translation>&amp;Mise</translation>
    </message>
    <message>
        <source>&amp;Files…</source>
        <translation>&amp;Soubory…</translation>
    </message>
    <message>
        <source>&amp;Aircraft…</source>
        <translation>&amp;Letadlo…</translation>
    </message>
    <message>
        <source>&amp;Wind…</source>
        <translation>&amp;Vítr…</translation>
    </message>
    <message>
        <source>Airs&amp;pace…</source>
        <translation>Vzdušný &amp;prostor…</translation>
    </message>
    <message>
        <source>&amp;Draw weather</source>
        <translation>&amp;Kreslit počasí</translation>
    </message>
    <message>
        <source>Weat&amp;her…</source>
        <translation>P&amp;očasí…</translation>
    </message>
    <message>
        <source>E&amp;xport weather…</source>
        <translation>E&amp;xportovat počasí…</translation>
    </message>
    <message>
        <source>Mission &amp;settings…</source>
        <translation>&amp;Nastavení mise…</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>&amp;Plán</translation>
    </message>
    <message>
        <source>&amp;Plan tour</source>
        <translation>&amp;Naplánovat trasu</translation>
    </message>
    <message>
        <source>Plan tour</source>
        <translation>Naplánovat trasu</translation>
    </message>
    <message>
        <source>&amp;Stop planning</source>
        <translation>&amp;Zastavit plánování</translation>
    </message>
    <message>
        <source>Show &amp;worst point</source>
        <translation>Ukázat nej&amp;horší místo</translation>
    </message>
    <message>
        <source>&amp;Land now from the chosen point</source>
        <translation>&amp;Okamžité přistání z vybraného bodu</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Zobrazení</translation>
    </message>
    <message>
        <source>&amp;3D view</source>
        <translation>&amp;3D pohled</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>Ukázat vš&amp;e</translation>
    </message>
    <message>
        <source>Previous view</source>
        <translation>Předchozí pohled</translation>
    </message>
    <message>
        <source>Next view</source>
        <translation>Další pohled</translation>
    </message>
    <message>
        <source>&amp;Full-screen map</source>
        <translation>Mapa na &amp;celou obrazovku</translation>
    </message>
    <message>
        <source>Centre the &amp;plan</source>
        <translation>Vystředit &amp;plán</translation>
    </message>
    <message>
        <source>&amp;Jump to…</source>
        <translation>Přejít n&amp;a…</translation>
    </message>
    <message>
        <source>&amp;Range rings from the middle of the map</source>
        <translation>Kruhy vzdálenosti &amp;od středu mapy</translation>
    </message>
    <message>
        <source>Remove all range rings</source>
        <translation>Odebrat všechny kruhy vzdálenosti</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Nápověda</translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation>&amp;První kroky</translation>
    </message>
    <message>
        <source>&amp;Keyboard and mouse</source>
        <translation>&amp;Klávesnice a myš</translation>
    </message>
    <message>
        <source>&amp;About Volplane</source>
        <translation>&amp;O Volplane</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Nástroje</translation>
    </message>
    <message>
        <source>Select and move</source>
        <translation>Vybírat a přesouvat</translation>
    </message>
    <message>
        <source>Add targets</source>
        <translation>Přidávat cíle</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Měřit</translation>
    </message>
    <message>
        <source>&amp;Overlays</source>
        <translation>&amp;Vrstvy</translation>
    </message>
    <message>
        <source>What the map shows beside terrain, runways and tour</source>
        <translation>Co mapa ukazuje kromě terénu, drah a trasy</translation>
    </message>
    <message>
        <source>&amp;Lowest safe altitude</source>
        <translation>&amp;Nejmenší bezpečná výška</translation>
    </message>
    <message>
        <source>…for the &amp;course</source>
        <translation>…pro &amp;kurz</translation>
    </message>
    <message>
        <source>Worst of all courses</source>
        <translation>Nejhorší ze všech kurzů</translation>
    </message>
    <message>
        <source>&amp;Where a runway is in reach from…</source>
        <translation>K&amp;de je dráha v dosahu z…</translation>
    </message>
    <message>
        <source>Glide range</source>
        <translation>Dosah klouzání</translation>
    </message>
    <message>
        <source>Altitude of the aircraft (%1 MSL)</source>
        <translation>Výška letadla (%1 MSL)</translation>
    </message>
    <message>
        <source>Glide &amp;margin along the tour</source>
        <translation>&amp;Rezerva klouzání podél trasy</translation>
    </message>
    <message>
        <source>&amp;Decision points</source>
        <translation>Rozhodovací &amp;body</translation>
    </message>
    <message>
        <source>&amp;All landing glides</source>
        <translation>&amp;Všechna klouzání</translation>
    </message>
    <message>
        <source>W&amp;eather</source>
        <translation>&amp;Počasí</translation>
    </message>
    <message>
        <source>&amp;Population</source>
        <translation>&amp;Obyvatelstvo</translation>
    </message>
    <message>
        <source>Terrain con&amp;tours</source>
        <translation>Vrstevnice &amp;terénu</translation>
    </message>
    <message>
        <source>E&amp;xcluded runways</source>
        <translation>V&amp;yloučené dráhy</translation>
    </message>
    <message>
        <source>Le&amp;gend</source>
        <translation>&amp;Legenda</translation>
    </message>
    <message>
        <source>&amp;Units</source>
        <translation>&amp;Jednotky</translation>
    </message>
    <message>
        <source>&amp;Aviation: ft, NM, kt, ft/min</source>
        <translation>&amp;Letecké: ft, NM, kt, ft/min</translation>
    </message>
    <message>
        <source>&amp;Metric: m, km, km/h, m/s</source>
        <translation>&amp;Metrické: m, km, km/h, m/s</translation>
    </message>
    <message>
        <source>Appearan&amp;ce</source>
        <translation>Vz&amp;hled</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>&amp;Podle plochy</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Světlý</translation>
    </message>
    <message>
        <source>Da&amp;rk</source>
        <translation>&amp;Tmavý</translation>
    </message>
    <message>
        <source>This is an example over made-up Alps, already planned. Your own in three steps:  1  New mission, add terrain and airfields (or drop the files here).  2  Press A and click targets on the map.  3  Press Plan tour. Then move along the magenta route to see the glide from each point.</source>
        <translation>Toto je příklad nad vymyšlenými Alpami, už naplánovaný. Vlastní ve třech krocích:  1  Nová mise, přidejte terén a letiště (nebo soubory přetáhněte sem).  2  Stiskněte A a klikněte na cíle na mapě.  3  Stiskněte Naplánovat trasu. Pak jeďte podél purpurové trasy a uvidíte klouzání z každého bodu.</translation>
    </message>
    <message>
        <source>New mission</source>
        <translation>Nová mise</translation>
    </message>
    <message>
        <source>Worst point</source>
        <translation>Nejhorší místo</translation>
    </message>
    <message>
        <source>Wheel, + and −, Page Up and Down</source>
        <translation>Kolečko, + a −, Page Up a Page Down</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>přiblížit, oddálit</translation>
    </message>
    <message>
        <source>Drag, arrows</source>
        <translation>Tažení, šipky</translation>
    </message>
    <message>
        <source>move the map; with the middle button or Space in any tool</source>
        <translation>posunout mapu; prostředním tlačítkem nebo mezerníkem v každém nástroji</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Dvojklik</translation>
    </message>
    <message>
        <source>zoom to the target or runway</source>
        <translation>přiblížit cíl nebo dráhu</translation>
    </message>
    <message>
        <source>A, V, M, W</source>
        <translation>A, V, M, W</translation>
    </message>
    <message>
        <source>add targets, select and move, measure, draw weather</source>
        <translation>přidávat cíle, vybírat a přesouvat, měřit, kreslit počasí</translation>
    </message>
    <message>
        <source>Double click, Return, Backspace</source>
        <translation>Dvojklik, Enter, Backspace</translation>
    </message>
    <message>
        <source>drawing weather: close the outline, take the last corner back</source>
        <translation>kreslení počasí: uzavřít obrys, vzít zpět poslední roh</translation>
    </message>
    <message>
        <source>Ctrl+click</source>
        <translation>Ctrl+klik</translation>
    </message>
    <message>
        <source>measure from there</source>
        <translation>měřit odtud</translation>
    </message>
    <message>
        <source>Shift+click</source>
        <translation>Shift+klik</translation>
    </message>
    <message>
        <source>range rings; on their middle: remove them</source>
        <translation>kruhy vzdálenosti; na jejich středu: odebrat je</translation>
    </message>
    <message>
        <source>R, Shift+R</source>
        <translation>R, Shift+R</translation>
    </message>
    <message>
        <source>range rings from the middle of the map, remove all</source>
        <translation>kruhy vzdálenosti od středu mapy, odebrat všechny</translation>
    </message>
    <message>
        <source>Ctrl+Alt+click, Shift+Alt+click</source>
        <translation>Ctrl+Alt+klik, Shift+Alt+klik</translation>
    </message>
    <message>
        <source>add a target into the nearest leg, at the end</source>
        <translation>přidat cíl do nejbližšího úseku, na konec</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Ctrl+Shift+H</translation>
    </message>
    <message>
        <source>list of the weather</source>
        <translation>seznam počasí</translation>
    </message>
    <message>
        <source>Del, Ctrl+E, Ctrl+Up, Ctrl+Down</source>
        <translation>Del, Ctrl+E, Ctrl+nahoru, Ctrl+dolů</translation>
    </message>
    <message>
        <source>delete, edit, move up, move down the selected target</source>
        <translation>vybraný cíl smazat, upravit, posunout výše, níže</translation>
    </message>
    <message>
        <source>Ctrl+Z, Ctrl+Y</source>
        <translation>Ctrl+Z, Ctrl+Y</translation>
    </message>
    <message>
        <source>undo, redo</source>
        <translation>zpět, znovu</translation>
    </message>
    <message>
        <source>Ctrl+Enter, Ctrl+.</source>
        <translation>Ctrl+Enter, Ctrl+.</translation>
    </message>
    <message>
        <source>plan, stop planning</source>
        <translation>naplánovat, zastavit plánování</translation>
    </message>
    <message>
        <source>Ctrl+W</source>
        <translation>Ctrl+W</translation>
    </message>
    <message>
        <source>worst point of the tour</source>
        <translation>nejhorší místo trasy</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>lowest safe altitude</source>
        <translation>nejmenší bezpečná výška</translation>
    </message>
    <message>
        <source>Pointer on the route</source>
        <translation>Ukazatel na trase</translation>
    </message>
    <message>
        <source>the glide from there, in all views; a click keeps it</source>
        <translation>klouzání odtud, ve všech pohledech; kliknutí je podrží</translation>
    </message>
    <message>
        <source>Left, Right in the profile</source>
        <translation>Vlevo, vpravo v profilu</translation>
    </message>
    <message>
        <source>previous, next decision point</source>
        <translation>předchozí, další rozhodovací bod</translation>
    </message>
    <message>
        <source>Ctrl+Home, Ctrl+Page Down</source>
        <translation>Ctrl+Home, Ctrl+Page Down</translation>
    </message>
    <message>
        <source>show all, centre the plan</source>
        <translation>ukázat vše, vystředit plán</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Home</source>
        <translation>Ctrl+Shift+Home</translation>
    </message>
    <message>
        <source>jump to a position, an airfield or a target</source>
        <translation>přejít na polohu, letiště nebo cíl</translation>
    </message>
    <message>
        <source>Alt+Left, Alt+Right</source>
        <translation>Alt+vlevo, Alt+vpravo</translation>
    </message>
    <message>
        <source>previous, next view</source>
        <translation>předchozí, další pohled</translation>
    </message>
    <message>
        <source>F2 … F8, F11</source>
        <translation>F2 … F8, F11</translation>
    </message>
    <message>
        <source>targets, runways, 3D, profile, engine out, decision points, plan; full-screen map</source>
        <translation>cíle, dráhy, 3D, profil, vysazení motoru, rozhodovací body, plán; mapa na celou obrazovku</translation>
    </message>
    <message>
        <source>Ctrl+P</source>
        <translation>Ctrl+P</translation>
    </message>
    <message>
        <source>briefing for the kneeboard</source>
        <translation>briefing na kolenní desku</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F, Alt+Enter</source>
        <translation>Ctrl+Shift+F, Alt+Enter</translation>
    </message>
    <message>
        <source>files and settings of the mission</source>
        <translation>soubory a nastavení mise</translation>
    </message>
    <message>
        <source>Ctrl+Shift+,</source>
        <translation>Ctrl+Shift+,</translation>
    </message>
    <message>
        <source>preferences</source>
        <translation>předvolby</translation>
    </message>
    <message>
        <source>In 3D: drag, middle drag, right drag</source>
        <translation>Ve 3D: tažení, prostředním, pravým tlačítkem</translation>
    </message>
    <message>
        <source>move, orbit, zoom; 1 to 4 are fixed views, Space is home</source>
        <translation>posunout, otáčet, přiblížit; 1 až 4 jsou pevné pohledy, mezerník výchozí</translation>
    </message>
    <message>
        <source>Keyboard and mouse</source>
        <translation>Klávesnice a myš</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>Pří&amp;ručka</translation>
    </message>
    <message>
        <source>F1</source>
        <translation>F1</translation>
    </message>
    <message>
        <source>the page of the manual for the view or dialog in front</source>
        <translation>stránka příručky k pohledu nebo dialogu vpředu</translation>
    </message>
</context>
<context>
    <name>vp::gui::PlanningController</name>
    <message>
        <source>Include excluded runways</source>
        <translation>Zahrnout vyloučené dráhy</translation>
    </message>
    <message>
        <source>The plan in this file could not be checked and counts as unverified: %1</source>
        <translation>Plán v tomto souboru se nepodařilo zkontrolovat a platí za neověřený: %1</translation>
    </message>
    <message>
        <source>Planning was stopped; the mission is as it was.</source>
        <translation>Plánování bylo zastaveno; mise je, jaká byla.</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Plánovat znovu</translation>
    </message>
    <message>
        <source>Verified: from every point of this %1 tour the aircraft can glide to a runway.</source>
        <translation>Ověřeno: z každého bodu této trasy o délce %1 lze doklouzat na dráhu.</translation>
    </message>
    <message numerus="yes">
        <source>Verified, but for the spirals down to %n target(s), in which the gliding guarantee is suspended; this tour is %1 long.</source>
        <translation>
            <numerusform>Ověřeno, kromě spirály dolů k %n cíli, v níž je záruka doklouzání přerušena; trasa je dlouhá %1.</numerusform>
            <numerusform>Ověřeno, kromě spirál dolů ke %n cílům, v nichž je záruka doklouzání přerušena; trasa je dlouhá %1.</numerusform>
            <numerusform>Ověřeno, kromě spirál dolů k %n cílům, v nichž je záruka doklouzání přerušena; trasa je dlouhá %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Planned in %1 s.</source>
        <translation>Naplánováno za %1 s.</translation>
    </message>
    <message>
        <source>Your edit was placed into the tour before; planning once more searches the whole anew.</source>
        <translation>Úprava byla vložena do předchozí trasy; další plánování prohledá vše znovu.</translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s) to read in the plan panel.</source>
        <translation>
            <numerusform>V okně plánu je %n varování k přečtení.</numerusform>
            <numerusform>V okně plánu jsou %n varování k přečtení.</numerusform>
            <numerusform>V okně plánu je %n varování k přečtení.</numerusform>
        </translation>
    </message>
    <message>
        <source>The independent checker refuses this plan; do not fly it. %1</source>
        <translation>Nezávislá kontrola tento plán odmítá; neleťte podle něj. %1</translation>
    </message>
    <message>
        <source>Allow passing above</source>
        <translation>Povolit přelet</translation>
    </message>
    <message>
        <source>Planning failed.</source>
        <translation>Plánování selhalo.</translation>
    </message>
    <message>
        <source>the mission&apos;s ceiling of %1</source>
        <translation>stropem mise %1</translation>
    </message>
    <message>
        <source>the aircraft&apos;s ceiling of %1</source>
        <translation>dostupem letadla %1</translation>
    </message>
    <message>
        <source>%1, to which the air is reckoned as neither mission nor aircraft has a ceiling</source>
        <translation>%1, kam sahá výpočet vzduchu, protože mise ani letadlo strop nemají</translation>
    </message>
    <message>
        <source>No safe tour joins all targets below %1; how much is missing is not known.</source>
        <translation>Žádná bezpečná trasa nespojuje všechny cíle pod %1; kolik chybí, není známo.</translation>
    </message>
    <message>
        <source>No safe tour: to stay within glide of a runway it must climb to %1, which is %2 above %3.</source>
        <translation>Žádná bezpečná trasa: aby zůstala v dosahu klouzání na dráhu, musí vystoupat do %1, což je %2 nad %3.</translation>
    </message>
    <message>
        <source>No safe tour over target %1: to stay within glide of a runway it must climb to at least %2 there, which is %3 above %4.</source>
        <translation>Žádná bezpečná trasa přes cíl %1: aby zůstala v dosahu klouzání na dráhu, musí tam vystoupat nejméně do %2, což je %3 nad %4.</translation>
    </message>
    <message>
        <source>Aircraft…</source>
        <translation>Letadlo…</translation>
    </message>
    <message>
        <source>Raise ceiling by %1</source>
        <translation>Zvýšit strop o %1</translation>
    </message>
    <message>
        <source>No ceiling</source>
        <translation>Bez stropu</translation>
    </message>
    <message>
        <source>Delete target %1</source>
        <translation>Smazat cíl %1</translation>
    </message>
</context>
<context>
    <name>vp::gui::StatusLine</name>
    <message>
        <source>Progress</source>
        <translation>Průběh</translation>
    </message>
    <message>
        <source>Stop planning (Esc)</source>
        <translation>Zastavit plánování (Esc)</translation>
    </message>
    <message>
        <source>Stop planning</source>
        <translation>Zastavit plánování</translation>
    </message>
    <message>
        <source>Where the tour has the least height above what its glide needs; a click shows the place</source>
        <translation>Kde má trasa nejméně výšky nad tím, co její klouzání potřebuje; kliknutí ukáže místo</translation>
    </message>
    <message>
        <source>Where the tour is lowest above the ground; a click shows the place</source>
        <translation>Kde je trasa nejníže nad terénem; kliknutí ukáže místo</translation>
    </message>
    <message>
        <source>Ground that the map shows from left to right</source>
        <translation>Kolik země mapa ukazuje zleva doprava</translation>
    </message>
    <message>
        <source>Place under the pointer</source>
        <translation>Místo pod ukazatelem</translation>
    </message>
    <message>
        <source>Least glide margin %1 at %2</source>
        <translation>Nejmenší rezerva klouzání %1 v %2</translation>
    </message>
    <message>
        <source>Margin %1</source>
        <translation>Rezerva %1</translation>
    </message>
    <message>
        <source> (old plan)</source>
        <translation> (starý plán)</translation>
    </message>
    <message>
        <source>Least clearance %1 at %2</source>
        <translation>Nejmenší odstup %1 v %2</translation>
    </message>
    <message>
        <source>Clearance %1</source>
        <translation>Odstup %1</translation>
    </message>
    <message>
        <source>Ground %1</source>
        <translation>Terén %1</translation>
    </message>
    <message>
        <source>Ground unknown</source>
        <translation>Terén neznámý</translation>
    </message>
    <message>
        <source>Lowest safe %1</source>
        <translation>Nejmenší bezp. %1</translation>
    </message>
    <message>
        <source>Var %1</source>
        <translation>Dekl. %1</translation>
    </message>
    <message>
        <source>No compass here</source>
        <translation>Zde není kompas</translation>
    </message>
    <message>
        <source>Map %1 wide</source>
        <translation>Šířka mapy %1</translation>
    </message>
</context>
<context>
    <name>vp::gui::WeatherController</name>
    <message>
        <source>Draw weather %1</source>
        <translation>Kreslit počasí %1</translation>
    </message>
    <message>
        <source>Edit weather %1</source>
        <translation>Upravit počasí %1</translation>
    </message>
    <message>
        <source>Delete weather %1</source>
        <translation>Smazat počasí %1</translation>
    </message>
    <message>
        <source>Move a corner of weather %1</source>
        <translation>Přesunout roh počasí %1</translation>
    </message>
    <message>
        <source>Export weather</source>
        <translation>Exportovat počasí</translation>
    </message>
    <message>
        <source>GeoJSON (*.geojson)</source>
        <translation>GeoJSON (*.geojson)</translation>
    </message>
    <message numerus="yes">
        <source>%n weather cell(s) written to %1.</source>
        <translation>
            <numerusform>%n buňka počasí zapsána do %1.</numerusform>
            <numerusform>%n buňky počasí zapsány do %1.</numerusform>
            <numerusform>%n buněk počasí zapsáno do %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vp::help::ManualWindow</name>
    <message>
        <source>Volplane manual</source>
        <translation>Příručka Volplane</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>Stránka příručky</translation>
    </message>
    <message>
        <source>Contents of the manual</source>
        <translation>Obsah příručky</translation>
    </message>
    <message>
        <source>The manual was not found: %1. Install Volplane again, or set VOLPLANE_RESOURCES to the folder that holds it.</source>
        <translation>Příručka nebyla nalezena: %1. Nainstalujte Volplane znovu, nebo nastavte VOLPLANE_RESOURCES na složku, která ji obsahuje.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zpět</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vpřed</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Obsah</translation>
    </message>
    <message>
        <source>Search in this page</source>
        <translation>Hledat na této stránce</translation>
    </message>
    <message>
        <source>Not in this page.</source>
        <translation>Na této stránce není.</translation>
    </message>
</context>
<context>
    <name>vp::jobs::FileIntake</name>
    <message>
        <source>Reading %1</source>
        <translation>Čte se %1</translation>
    </message>
    <message numerus="yes">
        <source>Reading %n file(s)</source>
        <translation>
            <numerusform>Čte se %n soubor</numerusform>
            <numerusform>Čtou se %n soubory</numerusform>
            <numerusform>Čte se %n souborů</numerusform>
        </translation>
    </message>
    <message>
        <source>Left out: %1</source>
        <translation>Vynecháno: %1</translation>
    </message>
    <message>
        <source>Add weather from %1</source>
        <translation>Přidat počasí z %1</translation>
    </message>
    <message>
        <source>Import targets from %1</source>
        <translation>Import cílů z %1</translation>
    </message>
</context>
<context>
    <name>vp::jobs::JobRunner</name>
    <message>
        <source>no further thread could be started; close other programs and try again</source>
        <translation>nepodařilo se spustit další vlákno; zavřete jiné programy a zkuste to znovu</translation>
    </message>
    <message>
        <source>there is not enough memory for this; close other programs or use a smaller terrain</source>
        <translation>na to nestačí paměť; zavřete jiné programy nebo použijte menší terén</translation>
    </message>
    <message>
        <source>a defect in the program stopped this work, nothing was changed: %1</source>
        <translation>chyba v programu tuto práci zastavila, nic se nezměnilo: %1</translation>
    </message>
    <message>
        <source>a defect in the program stopped this work, nothing was changed</source>
        <translation>chyba v programu tuto práci zastavila, nic se nezměnilo</translation>
    </message>
</context>
<context>
    <name>vp::jobs::LandingDesk</name>
    <message>
        <source>there is no terrain to glide over; add a terrain file first</source>
        <translation>není terén, nad nímž by se klouzalo; nejprve přidejte soubor terénu</translation>
    </message>
    <message>
        <source>no runway may be used here; add airfields or let more runways count first</source>
        <translation>zde se nesmí použít žádná dráha; nejprve přidejte letiště nebo povolte více drah</translation>
    </message>
    <message>
        <source>there is no planner called %1</source>
        <translation>plánovač jménem %1 neexistuje</translation>
    </message>
</context>
<context>
    <name>vp::jobs::Workspace</name>
    <message>
        <source>a plan is being made already; stop it first</source>
        <translation>plán se již vytváří; nejprve jej zastavte</translation>
    </message>
    <message>
        <source>no terrain is loaded; add a terrain file first</source>
        <translation>není načten terén; nejprve přidejte soubor terénu</translation>
    </message>
    <message>
        <source>the terrain files have changed and are read again; plan again in a moment</source>
        <translation>soubory terénu se změnily a čtou se znovu; za chvíli plánujte znovu</translation>
    </message>
    <message>
        <source>terrain and airfields are still being read; plan again in a moment</source>
        <translation>terén a letiště se ještě čtou; za chvíli plánujte znovu</translation>
    </message>
    <message>
        <source>no usable runway lies inside the terrain; add airfields, or include runways that the filter leaves out</source>
        <translation>v terénu neleží žádná použitelná dráha; přidejte letiště, nebo zahrňte dráhy, které filtr vynechává</translation>
    </message>
    <message>
        <source>the mission has no targets; press A and click at least one on the map</source>
        <translation>mise nemá cíle; stiskněte A a klikněte na mapě alespoň na jeden</translation>
    </message>
    <message>
        <source>Add terrain</source>
        <translation>Přidat terén</translation>
    </message>
    <message>
        <source>Add airfields</source>
        <translation>Přidat letiště</translation>
    </message>
    <message>
        <source>Add airspaces</source>
        <translation>Přidat vzdušné prostory</translation>
    </message>
    <message>
        <source>Add population</source>
        <translation>Přidat obyvatelstvo</translation>
    </message>
    <message numerus="yes">
        <source>Add %n file(s)</source>
        <translation>
            <numerusform>Přidat %n soubor</numerusform>
            <numerusform>Přidat %n soubory</numerusform>
            <numerusform>Přidat %n souborů</numerusform>
        </translation>
    </message>
    <message>
        <source>terrain: shading</source>
        <translation>terén: stínování</translation>
    </message>
    <message>
        <source>reading the population was stopped</source>
        <translation>čtení obyvatelstva bylo zastaveno</translation>
    </message>
</context>
<context>
    <name>vp::map::MapView</name>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>Terrain, runways, targets and tour. Arrow keys pan, Page Up and Page Down zoom, Ctrl+Home shows everything, the menu key offers what can be done with the object in the middle or the selected target.</source>
        <translation>Terén, dráhy, cíle a trasa. Šipky posouvají, Page Up a Page Down přibližují a oddalují, Ctrl+Home ukáže vše, klávesa nabídky nabídne, co lze s objektem uprostřed nebo vybraným cílem dělat.</translation>
    </message>
    <message>
        <source>No runways yet: drop an airfield file here, or choose File &gt; Add airfields…</source>
        <translation>Zatím žádné dráhy: přetáhněte sem soubor letišť, nebo zvolte Soubor &gt; Přidat letiště…</translation>
    </message>
    <message>
        <source>No targets yet: right-click the map, or use the add-target tool and click</source>
        <translation>Zatím žádné cíle: klikněte na mapu pravým tlačítkem, nebo použijte nástroj cílů a klikněte</translation>
    </message>
    <message>
        <source>Drop a terrain file here, or choose File &gt; Add terrain…</source>
        <translation>Přetáhněte sem soubor terénu, nebo zvolte Soubor &gt; Přidat terén…</translation>
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
        <translation>na kurzu %1</translation>
    </message>
    <message>
        <source>on the worst course</source>
        <translation>na nejhorším kurzu</translation>
    </message>
    <message>
        <source>Lowest safe altitude %1, %2 MSL</source>
        <translation>Nejmenší bezpečná výška %1, %2 MSL</translation>
    </message>
    <message>
        <source>No glide from any altitude</source>
        <translation>Nelze doklouzat z žádné výšky</translation>
    </message>
    <message>
        <source>Runway reachable from %1</source>
        <translation>Dráha v dosahu z %1</translation>
    </message>
    <message>
        <source>Glide margin %1 or more</source>
        <translation>Rezerva klouzání %1 nebo více</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>méně než %1</translation>
    </message>
    <message>
        <source>none: no glide arrives</source>
        <translation>žádná: žádné klouzání nedoletí</translation>
    </message>
    <message>
        <source>Weather: the closer the lines, the less likely to come through</source>
        <translation>Počasí: čím hustší čáry, tím méně pravděpodobný průlet</translation>
    </message>
    <message>
        <source>People per km²</source>
        <translation>Lidí na km²</translation>
    </message>
    <message>
        <source>Decision points, not all at this scale</source>
        <translation>Rozhodovací body, v tomto měřítku ne všechny</translation>
    </message>
    <message>
        <source>Decision points</source>
        <translation>Rozhodovací body</translation>
    </message>
    <message>
        <source>Leg proved safe</source>
        <translation>Úsek prokázaný jako bezpečný</translation>
    </message>
    <message>
        <source>Leg not yet checked</source>
        <translation>Úsek dosud nezkontrolovaný</translation>
    </message>
    <message>
        <source>Glides to the runways</source>
        <translation>Klouzání na dráhy</translation>
    </message>
    <message>
        <source>margin %1</source>
        <translation>rezerva %1</translation>
    </message>
    <message>
        <source>Move %1…</source>
        <translation>Přesunout %1…</translation>
    </message>
    <message>
        <source>Rename %1…</source>
        <translation>Přejmenovat %1…</translation>
    </message>
    <message>
        <source>Edit height of %1…</source>
        <translation>Upravit výšku: %1…</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>Smazat %1</translation>
    </message>
    <message>
        <source>Start and end at %1</source>
        <translation>Začít a skončit na %1</translation>
    </message>
    <message>
        <source>Start at %1, end at %2</source>
        <translation>Začít na %1, skončit na %2</translation>
    </message>
    <message>
        <source>Plan the tour alone, without a home runway</source>
        <translation>Plánovat jen trasu, bez domovské dráhy</translation>
    </message>
    <message>
        <source>Exclude runway %1</source>
        <translation>Vyloučit dráhu %1</translation>
    </message>
    <message>
        <source>Exclude all runways of %1</source>
        <translation>Vyloučit všechny dráhy letiště %1</translation>
    </message>
    <message>
        <source>Use runway %1 again</source>
        <translation>Znovu použít dráhu %1</translation>
    </message>
    <message>
        <source>Airspace %1</source>
        <translation>Vzdušný prostor %1</translation>
    </message>
    <message>
        <source>All of class %1</source>
        <translation>Všechny třídy %1</translation>
    </message>
    <message>
        <source>Airspace rules…</source>
        <translation>Pravidla prostorů…</translation>
    </message>
    <message>
        <source>Zoom in here</source>
        <translation>Přiblížit zde</translation>
    </message>
    <message>
        <source>Zoom to %1</source>
        <translation>Přiblížit %1</translation>
    </message>
    <message>
        <source>Show an engine failure here</source>
        <translation>Ukázat vysazení motoru zde</translation>
    </message>
    <message>
        <source>Insert target before %1</source>
        <translation>Vložit cíl před %1</translation>
    </message>
    <message>
        <source>Edit weather %1…</source>
        <translation>Upravit počasí %1…</translation>
    </message>
    <message>
        <source>Delete weather %1</source>
        <translation>Smazat počasí %1</translation>
    </message>
    <message>
        <source>Add target at %1</source>
        <translation>Přidat cíl v %1</translation>
    </message>
    <message>
        <source>Engine out here: where to?</source>
        <translation>Vysazení motoru zde: kam?</translation>
    </message>
    <message>
        <source>Measure from here</source>
        <translation>Měřit odtud</translation>
    </message>
    <message>
        <source>Remove the range rings here</source>
        <translation>Odebrat zdejší kruhy vzdálenosti</translation>
    </message>
    <message>
        <source>Range rings from here</source>
        <translation>Kruhy vzdálenosti odtud</translation>
    </message>
    <message>
        <source>Centre here</source>
        <translation>Vystředit zde</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Ukázat vše</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>nepoužito</translation>
    </message>
    <message>
        <source>target</source>
        <translation>cíl</translation>
    </message>
    <message>
        <source>target %1</source>
        <translation>cíl %1</translation>
    </message>
    <message>
        <source>%1 AGL</source>
        <translation>%1 AGL</translation>
    </message>
    <message>
        <source>insert before %1</source>
        <translation>vložit před %1</translation>
    </message>
    <message>
        <source>Click to add a target, on the tour to insert it there; Esc when done</source>
        <translation>Kliknutím přidáte cíl, na trase se vloží do ní; Esc, až budete hotovi</translation>
    </message>
    <message>
        <source>Weather needs three corners or more; click where the next one is.</source>
        <translation>Počasí potřebuje alespoň tři rohy; klikněte na místo dalšího.</translation>
    </message>
    <message>
        <source>Click the corners of the weather one after the other; Esc when done</source>
        <translation>Klikejte postupně na rohy počasí; Esc, až budete hotovi</translation>
    </message>
    <message>
        <source>Click the next corner; Backspace takes the last one back</source>
        <translation>Klikněte na další roh; Backspace vezme poslední zpět</translation>
    </message>
    <message>
        <source>Double click or Return closes the outline; Backspace takes the last corner back, Esc drops it</source>
        <translation>Dvojklik nebo Enter uzavře obrys; Backspace vezme poslední roh zpět, Esc jej zahodí</translation>
    </message>
    <message>
        <source>start: %1</source>
        <translation>start: %1</translation>
    </message>
    <message>
        <source>end: %1</source>
        <translation>konec: %1</translation>
    </message>
    <message>
        <source>Click where to measure to</source>
        <translation>Klikněte, kam se má měřit</translation>
    </message>
    <message>
        <source>Click where to measure from; Esc when done</source>
        <translation>Klikněte, odkud se má měřit; Esc, až budete hotovi</translation>
    </message>
    <message>
        <source>Click where %1 shall be; Esc or right click to leave it</source>
        <translation>Klikněte, kde má být %1; Esc nebo pravé tlačítko to nechá být</translation>
    </message>
    <message>
        <source>ground %1</source>
        <translation>terén %1</translation>
    </message>
    <message>
        <source>ground unknown</source>
        <translation>terén neznámý</translation>
    </message>
    <message>
        <source>Release to place the corner; Esc or right click to leave it where it was</source>
        <translation>Puštěním roh umístíte; Esc nebo pravé tlačítko jej nechá, kde byl</translation>
    </message>
    <message>
        <source>Release to place the target; Esc or right click to leave it where it was</source>
        <translation>Puštěním cíl umístíte; Esc nebo pravé tlačítko jej nechá, kde byl</translation>
    </message>
    <message>
        <source>NOT VERIFIED</source>
        <translation>NEOVĚŘENO</translation>
    </message>
    <message>
        <source>OUT OF DATE</source>
        <translation>ZASTARALÉ</translation>
    </message>
</context>
<context>
    <name>vp::panels::AlternativesModel</name>
    <message>
        <source>not reachable</source>
        <translation>nedosažitelná</translation>
    </message>
    <message>
        <source>only around terrain</source>
        <translation>jen kolem terénu</translation>
    </message>
    <message>
        <source>reachable</source>
        <translation>dosažitelná</translation>
    </message>
    <message>
        <source>Runway</source>
        <translation>Dráha</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Rezerva</translation>
    </message>
    <message>
        <source>Needs</source>
        <translation>Potřebuje</translation>
    </message>
    <message>
        <source>Glide</source>
        <translation>Klouzání</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Čas</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Dosah</translation>
    </message>
</context>
<context>
    <name>vp::panels::DecisionModel</name>
    <message>
        <source>unknown</source>
        <translation>neznámo</translation>
    </message>
    <message>
        <source>none</source>
        <translation>žádná</translation>
    </message>
    <message>
        <source>no glide</source>
        <translation>bez klouzání</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Č.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Vzdálenost</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Cíl</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Terén</translation>
    </message>
    <message>
        <source>Safe altitude</source>
        <translation>Bezpečná výška</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Rezerva</translation>
    </message>
    <message>
        <source>Runway</source>
        <translation>Dráha</translation>
    </message>
    <message>
        <source>Glide</source>
        <translation>Klouzání</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Čas</translation>
    </message>
</context>
<context>
    <name>vp::panels::DecisionTable</name>
    <message>
        <source>Decision points</source>
        <translation>Rozhodovací body</translation>
    </message>
    <message>
        <source>Filter by target, runway or number</source>
        <translation>Filtr podle cíle, dráhy nebo čísla</translation>
    </message>
    <message>
        <source>Filter of decision points</source>
        <translation>Filtr rozhodovacích bodů</translation>
    </message>
    <message>
        <source>No plan yet</source>
        <translation>Zatím není plán</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n bod</numerusform>
            <numerusform>%n body</numerusform>
            <numerusform>%n bodů</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 z %2 bodů</translation>
    </message>
</context>
<context>
    <name>vp::panels::EngineOutPanel</name>
    <message>
        <source>Engine out</source>
        <translation>Vysazení motoru</translation>
    </message>
    <message>
        <source>On the tour</source>
        <translation>Na trase</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>Glide distance</source>
        <translation>Délka klouzání</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Čas</translation>
    </message>
    <message>
        <source>Altitude margin</source>
        <translation>Rezerva výšky</translation>
    </message>
    <message>
        <source>On arrival</source>
        <translation>Při příletu</translation>
    </message>
    <message>
        <source>Least clearance</source>
        <translation>Nejmenší odstup</translation>
    </message>
    <message>
        <source>Time to touchdown</source>
        <translation>Čas do dotyku</translation>
    </message>
    <message>
        <source>From here to touchdown</source>
        <translation>Odtud do dotyku</translation>
    </message>
    <message>
        <source>If this runway were closed</source>
        <translation>Kdyby tato dráha byla uzavřena</translation>
    </message>
    <message>
        <source>Next-best runways</source>
        <translation>Další nejlepší dráhy</translation>
    </message>
    <message>
        <source>only around terrain</source>
        <translation>jen kolem terénu</translation>
    </message>
    <message>
        <source>Previous decision point</source>
        <translation>Předchozí rozhodovací bod</translation>
    </message>
    <message>
        <source>Point of the tour</source>
        <translation>Bod trasy</translation>
    </message>
    <message>
        <source>Next decision point</source>
        <translation>Další rozhodovací bod</translation>
    </message>
    <message>
        <source>Fly along the tour</source>
        <translation>Proletět trasu</translation>
    </message>
    <message>
        <source>Worst point</source>
        <translation>Nejhorší místo</translation>
    </message>
    <message>
        <source>Go to the point with the least glide margin</source>
        <translation>Přejít na bod s nejmenší rezervou klouzání</translation>
    </message>
    <message>
        <source>Plan a tour, then choose a point of it to see the glide that would be flown if the engine stopped there.</source>
        <translation>Naplánujte trasu, pak vyberte její bod a uvidíte klouzání, které by se letělo, kdyby tam vysadil motor.</translation>
    </message>
    <message>
        <source>No point chosen</source>
        <translation>Není vybrán žádný bod</translation>
    </message>
    <message>
        <source>Move along the tour on the map, in the profile or with the slider below.</source>
        <translation>Pohybujte se po trase na mapě, v profilu nebo posuvníkem dole.</translation>
    </message>
    <message>
        <source>Comparing other runways.</source>
        <translation>Porovnávají se jiné dráhy.</translation>
    </message>
    <message>
        <source>No glide is known from here</source>
        <translation>Odtud není známo žádné klouzání</translation>
    </message>
    <message>
        <source>not reachable</source>
        <translation>nedosažitelná</translation>
    </message>
    <message>
        <source>%1 after %2</source>
        <translation>%1 po %2</translation>
    </message>
    <message>
        <source>unknown: the glide crosses ground without data</source>
        <translation>neznámý: klouzání vede přes terén bez dat</translation>
    </message>
    <message>
        <source>%1 to lose by circling</source>
        <translation>%1 ke ztracení kroužením</translation>
    </message>
    <message>
        <source>nothing to spare</source>
        <translation>nic nazbyt</translation>
    </message>
    <message>
        <source>The runways have changed since this plan was made; plan again to compare them.</source>
        <translation>Dráhy se od vytvoření tohoto plánu změnily; pro porovnání plánujte znovu.</translation>
    </message>
    <message>
        <source>If %1 were closed: no other runway has a glide from here.</source>
        <translation>Kdyby byla %1 uzavřena: na žádnou jinou dráhu odtud klouzání nevede.</translation>
    </message>
    <message>
        <source>If %1 were closed: still %2 to %3.</source>
        <translation>Kdyby byla %1 uzavřena: ještě %2 na %3.</translation>
    </message>
    <message>
        <source>If %1 were closed: %2 missing to the next best, %3.</source>
        <translation>Kdyby byla %1 uzavřena: chybí %2 na další nejlepší, %3.</translation>
    </message>
</context>
<context>
    <name>vp::panels::GlidePicture</name>
    <message>
        <source>Profile of the glide</source>
        <translation>Profil klouzání</translation>
    </message>
</context>
<context>
    <name>vp::panels::LandingAnswers</name>
    <message>
        <source>Answers of the planners</source>
        <translation>Odpovědi plánovačů</translation>
    </message>
    <message>
        <source>Planners</source>
        <translation>Plánovače</translation>
    </message>
    <message>
        <source>Runways</source>
        <translation>Dráhy</translation>
    </message>
    <message>
        <source>Terms of the answers, side by side</source>
        <translation>Složky odpovědí vedle sebe</translation>
    </message>
    <message>
        <source>Terms</source>
        <translation>Složky</translation>
    </message>
    <message>
        <source>Every runway by total risk: the way there, its length and surface, wind, people under the approach</source>
        <translation>Každá dráha podle celkového rizika: cesta na ni, její délka a povrch, vítr, lidé pod přiblížením</translation>
    </message>
    <message>
        <source>Runways by total risk</source>
        <translation>Dráhy podle celkového rizika</translation>
    </message>
    <message>
        <source>Why this runway stands where it does</source>
        <translation>Proč je tato dráha tam, kde je</translation>
    </message>
    <message>
        <source>Comes after the planners&apos; answers.</source>
        <translation>Přijde po odpovědích plánovačů.</translation>
    </message>
    <message>
        <source>Not ranked: planning was stopped before, or no way can be asked for.</source>
        <translation>Neseřazeno: plánování bylo dříve zastaveno, nebo se na cestu nelze zeptat.</translation>
    </message>
</context>
<context>
    <name>vp::panels::LandingModel</name>
    <message>
        <source>no runway</source>
        <translation>žádná dráha</translation>
    </message>
    <message>
        <source>not a runway</source>
        <translation>není to dráha</translation>
    </message>
    <message>
        <source>checked</source>
        <translation>zkontrolováno</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>nezkontrolováno</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>Plánovač</translation>
    </message>
    <message>
        <source>Runway</source>
        <translation>Dráha</translation>
    </message>
    <message>
        <source>In hand</source>
        <translation>Nazbyt</translation>
    </message>
    <message>
        <source>Weather</source>
        <translation>Počasí</translation>
    </message>
    <message>
        <source>Glide</source>
        <translation>Klouzání</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Čas</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>Nejníže</translation>
    </message>
</context>
<context>
    <name>vp::panels::LandingPanel</name>
    <message>
        <source>Landing now</source>
        <translation>Okamžité přistání</translation>
    </message>
    <message>
        <source>What this landing is</source>
        <translation>Jaké toto přistání je</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Vedle sebe</translation>
    </message>
    <message>
        <source>Each general planner; where there is weather, also the two that keep out of it best</source>
        <translation>Každý obecný plánovač; při počasí i dva, které se mu vyhýbají nejlépe</translation>
    </message>
    <message>
        <source>All %1, side by side</source>
        <translation>Všech %1 vedle sebe</translation>
    </message>
    <message>
        <source>Weather: %1</source>
        <translation>Počasí: %1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Zastavit</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vymazat</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>Course over ground</source>
        <translation>Kurz nad zemí</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>Plánovač</translation>
    </message>
    <message>
        <source>Time for each</source>
        <translation>Čas pro každý</translation>
    </message>
    <message>
        <source>Right-click a place on the map, or a point of the tour, and choose &quot;Engine out here&quot; to see where the aircraft can land from there, at any altitude and on any course.</source>
        <translation>Klikněte pravým tlačítkem na místo mapy nebo bod trasy a zvolte „Vysazení motoru zde“: uvidíte, kde odtud letadlo může přistát, z jakékoli výšky a na jakémkoli kurzu.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>over ground of unknown height</source>
        <translation>nad terénem neznámé výšky</translation>
    </message>
    <message>
        <source>Looking for a way down.</source>
        <translation>Hledá se cesta dolů.</translation>
    </message>
    <message>
        <source>No planner has been asked.</source>
        <translation>Žádný plánovač nebyl dotázán.</translation>
    </message>
    <message>
        <source>%1: %2 in hand at the beginning of the approach.</source>
        <translation>%1: na začátku přiblížení zbývá %2.</translation>
    </message>
    <message>
        <source>Comes through the weather with a probability of %1.</source>
        <translation>Proletí počasím s pravděpodobností %1.</translation>
    </message>
    <message>
        <source>Keeps out of the weather.</source>
        <translation>Vyhýbá se počasí.</translation>
    </message>
    <message>
        <source>The checker has not confirmed this path: do not rely on it.</source>
        <translation>Kontrola tuto cestu nepotvrdila: nespoléhejte na ni.</translation>
    </message>
    <message>
        <source>NOT A RUNWAY: the best that can be had is %1 of glide over ground that stays clear.</source>
        <translation>NENÍ TO DRÁHA: nejlepší, co lze mít, je %1 klouzání nad volným terénem.</translation>
    </message>
    <message>
        <source>%1 of height are missing.</source>
        <translation>Chybí %1 výšky.</translation>
    </message>
</context>
<context>
    <name>vp::panels::PlanSummaryPanel</name>
    <message>
        <source>Plan</source>
        <translation>Plán</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Délka</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Čas</translation>
    </message>
    <message>
        <source>Altitudes</source>
        <translation>Výšky</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Cena</translation>
    </message>
    <message>
        <source>Could be shorter by</source>
        <translation>Mohla by být kratší o</translation>
    </message>
    <message>
        <source>Checked</source>
        <translation>Kontrola</translation>
    </message>
    <message>
        <source>Least margins</source>
        <translation>Nejmenší rezervy</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Druh</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Rezerva</translation>
    </message>
    <message>
        <source>Warnings and findings</source>
        <translation>Varování a nálezy</translation>
    </message>
    <message>
        <source>No plan yet</source>
        <translation>Zatím není plán</translation>
    </message>
    <message>
        <source>Load terrain and airports, mark targets, then plan the tour.</source>
        <translation>Načtěte terén a letiště, vyznačte cíle, pak naplánujte trasu.</translation>
    </message>
    <message>
        <source>VERIFIED</source>
        <translation>OVĚŘENO</translation>
    </message>
    <message>
        <source>UNVERIFIED</source>
        <translation>NEOVĚŘENO</translation>
    </message>
    <message>
        <source>The checker has not confirmed that a runway can be reached from every point. Do not fly this plan.</source>
        <translation>Kontrola nepotvrdila, že z každého bodu lze dosáhnout dráhy. Podle tohoto plánu neleťte.</translation>
    </message>
    <message>
        <source>OUT OF DATE</source>
        <translation>ZASTARALÉ</translation>
    </message>
    <message>
        <source>An input has changed since this plan was made. Plan again, or undo the change. The figures below are those of the old plan.</source>
        <translation>Vstup se od vytvoření tohoto plánu změnil. Plánujte znovu, nebo změnu vezměte zpět. Čísla níže patří starému plánu.</translation>
    </message>
    <message>
        <source>%1, %2 over ground</source>
        <translation>%1, %2 nad zemí</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 v %2</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 až %2</translation>
    </message>
    <message>
        <source>%1, of which %2 for passing above targets</source>
        <translation>%1, z toho %2 za přelet nad cíli</translation>
    </message>
    <message>
        <source>nothing: proved best over these headings and glides</source>
        <translation>nic: prokázána jako nejlepší pro tyto kurzy a klouzání</translation>
    </message>
    <message>
        <source>refined: %1 % below the tour over sampled headings, which need at least %2</source>
        <translation>zjemněno: %1 % pod trasou přes zvolené kurzy, která potřebuje nejméně %2</translation>
    </message>
    <message>
        <source>at most %1 %, at least %2 is needed</source>
        <translation>nejvýše %1 %, nejméně %2 je třeba</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>není známo</translation>
    </message>
    <message>
        <source>%1; at most %2 % above the best of all safe tours</source>
        <translation>%1; nejvýše %2 % nad nejlepší ze všech bezpečných tras</translation>
    </message>
    <message>
        <source>%1 points, %2 glides</source>
        <translation>%1 bodů, %2 klouzání</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>neprošlo</translation>
    </message>
    <message>
        <source>%1: %2 at %3. Click to go there.</source>
        <translation>%1: %2 v %3. Kliknutí tam přejde.</translation>
    </message>
    <message>
        <source>Why the plan was refused</source>
        <translation>Proč byl plán odmítnut</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Varování</translation>
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
        <translation>Stojí</translation>
    </message>
    <message>
        <source>Because</source>
        <translation>Protože</translation>
    </message>
</context>
<context>
    <name>vp::panels::RankingModel</name>
    <message>
        <source>not reached</source>
        <translation>nedosažena</translation>
    </message>
    <message>
        <source>%1. %2, %3</source>
        <translation>%1. %2, %3</translation>
    </message>
    <message>
        <source>How likely way and landing go well, all lines below together; to compare runways, not to fly by</source>
        <translation>Jak pravděpodobně cesta i přistání dopadnou dobře, všechny řádky níže dohromady; k porovnání drah, ne k létání podle toho</translation>
    </message>
    <message>
        <source>Runway</source>
        <translation>Dráha</translation>
    </message>
    <message>
        <source>Goes well</source>
        <translation>Dopadne dobře</translation>
    </message>
    <message>
        <source>In hand</source>
        <translation>Nazbyt</translation>
    </message>
    <message>
        <source>Glide</source>
        <translation>Klouzání</translation>
    </message>
</context>
<context>
    <name>vp::panels::SiteModel</name>
    <message>
        <source>excluded</source>
        <translation>vyloučena</translation>
    </message>
    <message>
        <source>left out by the filter</source>
        <translation>vynechána filtrem</translation>
    </message>
    <message>
        <source>estimated: %1</source>
        <translation>odhadnuto: %1</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>neznámo</translation>
    </message>
    <message>
        <source>lit</source>
        <translation>osvětlená</translation>
    </message>
    <message>
        <source>one way</source>
        <translation>jeden směr</translation>
    </message>
    <message>
        <source>Use runway</source>
        <translation>Použít dráhu</translation>
    </message>
    <message>
        <source>Airport</source>
        <translation>Letiště</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Kurz</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Délka</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Šířka</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Povrch</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Světla</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Výška dráhy</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Vzdálenost</translation>
    </message>
    <message>
        <source>This way only</source>
        <translation>Jen tento směr</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Poznámky</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Poznámka</translation>
    </message>
</context>
<context>
    <name>vp::panels::SitePanel</name>
    <message>
        <source>Runways</source>
        <translation>Dráhy</translation>
    </message>
    <message>
        <source>Find a runway or airport</source>
        <translation>Najít dráhu nebo letiště</translation>
    </message>
    <message>
        <source>unknown surface</source>
        <translation>neznámý povrch</translation>
    </message>
    <message>
        <source>lit</source>
        <translation>osvětlená</translation>
    </message>
    <message>
        <source>Notes on the airfields</source>
        <translation>Poznámky k letištím</translation>
    </message>
    <message>
        <source>No runways yet: load airfields</source>
        <translation>Zatím žádné dráhy: načtěte letiště</translation>
    </message>
    <message>
        <source>%1 of %2 used</source>
        <translation>%1 z %2 použito</translation>
    </message>
    <message>
        <source>%1 found</source>
        <translation>nalezeno %1</translation>
    </message>
</context>
<context>
    <name>vp::panels::SiteRules</name>
    <message>
        <source>&amp;Shortest runway</source>
        <translation>&amp;Nejkratší dráha</translation>
    </message>
    <message>
        <source>any length</source>
        <translation>jakákoli délka</translation>
    </message>
    <message>
        <source>Shortest runway that is used</source>
        <translation>Nejkratší dráha, která se použije</translation>
    </message>
    <message>
        <source>&amp;Narrowest runway</source>
        <translation>Nejú&amp;žší dráha</translation>
    </message>
    <message>
        <source>any width</source>
        <translation>jakákoli šířka</translation>
    </message>
    <message>
        <source>Narrowest runway that is used</source>
        <translation>Nejužší dráha, která se použije</translation>
    </message>
    <message>
        <source>Within, of a tar&amp;get</source>
        <translation>&amp;Do vzdálenosti od cíle</translation>
    </message>
    <message>
        <source>any distance</source>
        <translation>jakákoli vzdálenost</translation>
    </message>
    <message>
        <source>Longest distance of a runway from the nearest target</source>
        <translation>Největší vzdálenost dráhy od nejbližšího cíle</translation>
    </message>
    <message>
        <source>S&amp;urfaces</source>
        <translation>&amp;Povrchy</translation>
    </message>
    <message>
        <source>Use runways whose position is &amp;estimated</source>
        <translation>Dráhy s &amp;odhadnutou polohou</translation>
    </message>
    <message>
        <source>Use &amp;closed runways</source>
        <translation>&amp;Uzavřené dráhy</translation>
    </message>
    <message>
        <source>Use &amp;water</source>
        <translation>&amp;Voda</translation>
    </message>
    <message>
        <source>&amp;Lighted runways only</source>
        <translation>Jen o&amp;světlené dráhy</translation>
    </message>
    <message>
        <source>Surfaces that may be landed on</source>
        <translation>Povrchy, na kterých se smí přistát</translation>
    </message>
    <message>
        <source>any surface</source>
        <translation>jakýkoli povrch</translation>
    </message>
</context>
<context>
    <name>vp::panels::TargetDelegate</name>
    <message>
        <source>Height of the target</source>
        <translation>Výška cíle</translation>
    </message>
    <message>
        <source>Datum of the height</source>
        <translation>Vztažná plocha výšky</translation>
    </message>
</context>
<context>
    <name>vp::panels::TargetModel</name>
    <message>
        <source>unknown</source>
        <translation>neznámo</translation>
    </message>
    <message>
        <source>A target needs a name.</source>
        <translation>Cíl potřebuje jméno.</translation>
    </message>
    <message>
        <source>There is a target %1 already; give another name.</source>
        <translation>Cíl %1 už existuje; dejte jiné jméno.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no position. Write for example 46°36.02′ N 009°54.10′ E or 46.6003, 9.9017.</source>
        <translation>„%1“ není poloha. Napište například 46°36.02′ N 009°54.10′ E nebo 46.6003, 9.9017.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Název</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Nad</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Výška MSL</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Terén</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Poloha</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problém</translation>
    </message>
</context>
<context>
    <name>vp::panels::TargetPanel</name>
    <message>
        <source>Targets</source>
        <translation>Cíle</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Výše</translation>
    </message>
    <message>
        <source>Move target up (Ctrl+Up)</source>
        <translation>Posunout cíl výše (Ctrl+nahoru)</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Níže</translation>
    </message>
    <message>
        <source>Move target down (Ctrl+Down)</source>
        <translation>Posunout cíl níže (Ctrl+dolů)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Odebrat</translation>
    </message>
    <message>
        <source>Remove target (Del)</source>
        <translation>Odebrat cíl (Del)</translation>
    </message>
    <message>
        <source>No targets yet. Click on the map with the target tool to add one.</source>
        <translation>Zatím žádné cíle. Přidejte cíl kliknutím na mapu nástrojem cílů.</translation>
    </message>
    <message>
        <source>One target cannot be planned; its row says why.</source>
        <translation>Jeden cíl nelze plánovat; jeho řádek říká proč.</translation>
    </message>
    <message>
        <source>%1 targets cannot be planned; their rows say why.</source>
        <translation>Počet cílů, které nelze plánovat: %1; jejich řádky říkají proč.</translation>
    </message>
</context>
<context>
    <name>vp::panels::TermsModel</name>
    <message>
        <source>This planner does not tell it.</source>
        <translation>Tento plánovač to neříká.</translation>
    </message>
    <message>
        <source>%1, kept low by this planner</source>
        <translation>%1, tento plánovač ji drží malou</translation>
    </message>
    <message>
        <source>Term</source>
        <translation>Složka</translation>
    </message>
</context>
<context>
    <name>vp::profile::ProfileView</name>
    <message>
        <source>Altitude profile of the tour</source>
        <translation>Výškový profil trasy</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Vzdálenost</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>Above ground</source>
        <translation>Nad zemí</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>neznámo</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Terén</translation>
    </message>
    <message>
        <source>Safe altitude</source>
        <translation>Bezpečná výška</translation>
    </message>
    <message>
        <source>none known</source>
        <translation>žádná není známa</translation>
    </message>
    <message>
        <source>Glide margin</source>
        <translation>Rezerva klouzání</translation>
    </message>
    <message>
        <source>no glide</source>
        <translation>bez klouzání</translation>
    </message>
    <message>
        <source>Glide to</source>
        <translation>Klouzání na</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vítr</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Cíl</translation>
    </message>
</context>
<context>
    <name>vp::scene3d::GlSceneWidget</name>
    <message>
        <source>The 3D view failed: %1</source>
        <translation>3D pohled selhal: %1</translation>
    </message>
</context>
<context>
    <name>vp::scene3d::ImageSceneWidget</name>
    <message>
        <source>There is no 3D view on this machine:
%1.
Map and profile show the same flight.</source>
        <translation>Na tomto počítači není 3D pohled:
%1.
Mapa a profil ukazují týž let.</translation>
    </message>
    <message>
        <source>There is no 3D view: OpenGL could not draw a picture of this size.</source>
        <translation>3D pohled není: OpenGL nedokázalo nakreslit obrázek této velikosti.</translation>
    </message>
</context>
<context>
    <name>vp::scene3d::SceneData</name>
    <message>
        <source>no terrain here</source>
        <translation>zde není terén</translation>
    </message>
    <message>
        <source>glide %1</source>
        <translation>klouzání %1</translation>
    </message>
</context>
<context>
    <name>vp::scene3d::SceneOverlay</name>
    <message>
        <source>Turn the view north</source>
        <translation>Otočit pohled na sever</translation>
    </message>
    <message>
        <source>Compass</source>
        <translation>Kompas</translation>
    </message>
    <message>
        <source>Wind that the plan holds for</source>
        <translation>Vítr, pro který plán platí</translation>
    </message>
    <message>
        <source>Colours of altitudes</source>
        <translation>Barvy výšek</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>Contours %1</source>
        <translation>Vrstevnice %1</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Heights drawn %1×</source>
        <translation>Výšky kresleny %1×</translation>
    </message>
</context>
<context>
    <name>vp::scene3d::SceneToolBar</name>
    <message>
        <source>3D view</source>
        <translation>3D pohled</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Shora</translation>
    </message>
    <message>
        <source>From straight above, north up (1)</source>
        <translation>Kolmo shora, sever nahoře (1)</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Sever</translation>
    </message>
    <message>
        <source>All of the tour, looking north (2)</source>
        <translation>Celá trasa, pohled na sever (2)</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Podél</translation>
    </message>
    <message>
        <source>Behind the aircraft, along the tour (3)</source>
        <translation>Za letadlem, podél trasy (3)</translation>
    </message>
    <message>
        <source>Runway</source>
        <translation>Dráha</translation>
    </message>
    <message>
        <source>From the runway, towards where the glide comes from (4)</source>
        <translation>Z dráhy, tam, odkud klouzání přichází (4)</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Sledovat</translation>
    </message>
    <message>
        <source>Keep the chosen point of the tour in the middle (F)</source>
        <translation>Držet vybraný bod trasy uprostřed (F)</translation>
    </message>
    <message>
        <source>Fly</source>
        <translation>Letět</translation>
    </message>
    <message>
        <source>Fly along the tour; Esc ends it</source>
        <translation>Proletět trasu; Esc let ukončí</translation>
    </message>
    <message>
        <source>Speed of the flight, times that of the aircraft</source>
        <translation>Rychlost letu jako násobek rychlosti letadla</translation>
    </message>
    <message>
        <source>%1× speed</source>
        <translation>%1× rychlost</translation>
    </message>
    <message>
        <source>Curtain</source>
        <translation>Závěs</translation>
    </message>
    <message>
        <source>Surface between the tour and the ground, coloured by altitude</source>
        <translation>Plocha mezi trasou a terénem, obarvená podle výšky</translation>
    </message>
    <message>
        <source>All glides</source>
        <translation>Všechna klouzání</translation>
    </message>
    <message>
        <source>The glide of every decision point, coloured by altitude</source>
        <translation>Klouzání z každého rozhodovacího bodu, obarvené podle výšky</translation>
    </message>
    <message>
        <source>How much larger heights are drawn than distances</source>
        <translation>Kolikrát větší jsou výšky kresleny než vzdálenosti</translation>
    </message>
    <message>
        <source>Heights %1×</source>
        <translation>Výšky %1×</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Další</translation>
    </message>
    <message>
        <source>More of the 3D view&apos;s controls</source>
        <translation>Další ovládání 3D pohledu</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Zastavit</translation>
    </message>
</context>
<context>
    <name>vp::scene3d::SceneView</name>
    <message>
        <source>3D view</source>
        <translation>3D pohled</translation>
    </message>
    <message>
        <source>Terrain, tour and glides in three dimensions. Space shows all, keys 1 to 4 change the view.</source>
        <translation>Terén, trasa a klouzání ve třech rozměrech. Mezerník ukáže vše, klávesy 1 až 4 mění pohled.</translation>
    </message>
    <message>
        <source>No terrain yet.
Add a terrain file to see it in three dimensions.</source>
        <translation>Zatím není terén.
Přidejte soubor terénu a uvidíte jej ve třech rozměrech.</translation>
    </message>
    <message>
        <source>This terrain is too small to be drawn.</source>
        <translation>Tento terén je na kreslení příliš malý.</translation>
    </message>
    <message>
        <source>Preparing the terrain…</source>
        <translation>Připravuje se terén…</translation>
    </message>
</context>
<context>
    <name>vp::style::WindFigure</name>
    <message>
        <source>from anywhere</source>
        <comment>wind</comment>
        <translation>odkudkoli</translation>
    </message>
    <message>
        <source>still air</source>
        <translation>klidný vzduch</translation>
    </message>
</context>
</TS>
