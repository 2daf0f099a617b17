#pragma once

#include <cstddef>

// What readers of files take at most, in one place: each number is far above what real files hold and keeps memory below a few gigabytes and time
// below some seconds whatever a file holds. tests/core/formats/tst_limits.cpp tries each. Terrain has its own (core/terrain/README.md), because
// rasters are read in parts.
//
// | what                          | at most        | what real files hold                                   | what it bounds                    |
// |-------------------------------|----------------|--------------------------------------------------------|-----------------------------------|
// | any file, unpacked            | 1 GiB          | X-Plane's apt.dat of the world, 0.35 GiB               | text in memory; gzip bombs        |
// | text that is kept as values   | 256 MiB        | OurAirports, 13 MB; a country's airspace, 1 MB         | values of JSON, rows of tables    |
// | XML, and a member of a KMZ    | 64 MiB         | GPX of a day, 5 MB                                     | its tree, 16 bytes a byte; bombs  |
// | JSON depth, members, values   | 64, 1000, 10 M | our own: 6 deep, 20 members, 0.1 M values              | the stack; quadratic time; 1 GiB  |
// | airports of a table           | 1 M            | the world, 0.085 M                                     | the map of them                   |
// | landing sites of a file       | 0.5 M          | the world, 0.07 M                                      | 0.3 GiB                           |
// | sites or targets of a mission | 20,000         | tens                                                   | comparing each with each          |
// | corners of an airspace, of all| 20,000, 1 M    | Germany, 0.06 M                                        | circles: 10 bytes, 3,000 corners  |
// | corners of survey areas       | 100,000        | tens                                                   | each line cuts each side          |
// | targets of an import          | 5,000          | hundreds (target_import.h)                             | hours of planning                 |
// | areas of polygon files        | 5 M, 50 M corners | census blocks of a state, 0.9 M (polygon_file.cpp)  | 0.8 GiB                           |
namespace vp::formats {

inline constexpr std::size_t kMostFileBytes = std::size_t{1} << 30;
inline constexpr std::size_t kMostTextBytes = std::size_t{256} << 20;
inline constexpr std::size_t kMostXmlBytes = std::size_t{64} << 20;
inline constexpr std::size_t kMostJsonDepth = 64;
inline constexpr std::size_t kMostJsonMembers = 1000;
inline constexpr std::size_t kMostJsonValues = 10'000'000;
inline constexpr std::size_t kMostAirports = 1'000'000;
inline constexpr std::size_t kMostSites = 500'000;
inline constexpr std::size_t kMostMissionSites = 20'000;
inline constexpr std::size_t kMostMissionTargets = 20'000;
inline constexpr std::size_t kMostAirspaceCorners = 20'000;
inline constexpr std::size_t kMostAirspacesCorners = 1'000'000;
inline constexpr std::size_t kMostSurveyCorners = 100'000;

}  // namespace vp::formats
