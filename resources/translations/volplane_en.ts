<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Exports</name>
    <message numerus="yes">
        <source>%n waypoints, %1: flown with fly-by turns of %2 m radius the path is at most %3 m beside and %4 m above the tour, never below it; targets are passed within %5 m</source>
        <translation>
            <numerusform>%n waypoint, %1: flown with fly-by turns of %2 m radius the path is at most %3 m beside and %4 m above the tour, never below it; targets are passed within %5 m</numerusform>
            <numerusform>%n waypoints, %1: flown with fly-by turns of %2 m radius the path is at most %3 m beside and %4 m above the tour, never below it; targets are passed within %5 m</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n spirals down to low targets are not part of the waypoints: the route passes above these targets</source>
        <translation>
            <numerusform>%n spiral down to a low target is not part of the waypoints: the route passes above this target</numerusform>
            <numerusform>%n spirals down to low targets are not part of the waypoints: the route passes above these targets</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>PlanningSketch</name>
    <message numerus="yes">
        <source>Roadmap: %n glides</source>
        <translation>
            <numerusform>Roadmap: %n glide</numerusform>
            <numerusform>Roadmap: %n glides</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vp::dialogs::AirspaceDialog</name>
    <message numerus="yes">
        <source>Class %1: %n airspace(s)</source>
        <translation>
            <numerusform>Class %1: %n airspace</numerusform>
            <numerusform>Class %1: %n airspaces</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vp::gui::ExportController</name>
    <message numerus="yes">
        <source>%n files written to %1</source>
        <translation>
            <numerusform>%n file written to %1</numerusform>
            <numerusform>%n files written to %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vp::gui::FileController</name>
    <message numerus="yes">
        <source>%n target(s) imported from %1.</source>
        <translation>
            <numerusform>%n target imported from %1.</numerusform>
            <numerusform>%n targets imported from %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of them cannot be planned on this terrain: %1.</source>
        <translation>
            <numerusform>%n of them cannot be planned on this terrain: %1.</numerusform>
            <numerusform>%n of them cannot be planned on this terrain: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n weather cell(s) added from %1.</source>
        <translation>
            <numerusform>%n weather cell added from %1.</numerusform>
            <numerusform>%n weather cells added from %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>And %n more note(s).</source>
        <translation>
            <numerusform>And %n more note.</numerusform>
            <numerusform>And %n more notes.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vp::gui::PlanningController</name>
    <message numerus="yes">
        <source>Verified, but for the spirals down to %n target(s), in which the gliding guarantee is suspended; this tour is %1 long.</source>
        <translation>
            <numerusform>Verified, but for the spiral down to %n target, in which the gliding guarantee is suspended; this tour is %1 long.</numerusform>
            <numerusform>Verified, but for the spirals down to %n targets, in which the gliding guarantee is suspended; this tour is %1 long.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s) to read in the plan panel.</source>
        <translation>
            <numerusform>%n warning to read in the plan panel.</numerusform>
            <numerusform>%n warnings to read in the plan panel.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vp::gui::WeatherController</name>
    <message numerus="yes">
        <source>%n weather cell(s) written to %1.</source>
        <translation>
            <numerusform>%n weather cell written to %1.</numerusform>
            <numerusform>%n weather cells written to %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vp::jobs::FileIntake</name>
    <message numerus="yes">
        <source>Reading %n file(s)</source>
        <translation>
            <numerusform>Reading %n file</numerusform>
            <numerusform>Reading %n files</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vp::jobs::Workspace</name>
    <message numerus="yes">
        <source>Add %n file(s)</source>
        <translation>
            <numerusform>Add %n file</numerusform>
            <numerusform>Add %n files</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vp::panels::DecisionTable</name>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
</context>
</TS>
