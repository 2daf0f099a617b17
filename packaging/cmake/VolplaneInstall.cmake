# Where everything goes: programs, what they read, and what a desktop knows them by. packaging/package makes a Debian
# package of it; `cmake --install` with another prefix works too, as resources are found beside the programs.
include(GNUInstallDirs)
set(made "${CMAKE_BINARY_DIR}/package")
set(share "${CMAKE_INSTALL_DATAROOTDIR}")

install(TARGETS volplane volplane_cli RUNTIME)
install(DIRECTORY "${CMAKE_SOURCE_DIR}/resources/aircraft" "${CMAKE_SOURCE_DIR}/resources/schema" DESTINATION "${share}/volplane")
install(DIRECTORY "${CMAKE_SOURCE_DIR}/maps/" DESTINATION "${share}/volplane/maps" FILES_MATCHING PATTERN "*.vpm" PATTERN "*.vpp" PATTERN "*.tif" PATTERN "*.csv")

install(FILES "${CMAKE_SOURCE_DIR}/resources/desktop/volplane.desktop" DESTINATION "${share}/applications")
install(FILES "${CMAKE_SOURCE_DIR}/resources/desktop/volplane.xml" DESTINATION "${share}/mime/packages")
install(FILES "${CMAKE_SOURCE_DIR}/resources/desktop/volplane.svg" DESTINATION "${share}/icons/hicolor/scalable/apps")
install(FILES "${CMAKE_SOURCE_DIR}/resources/desktop/application-x-volplane-mission.svg"
              "${CMAKE_SOURCE_DIR}/resources/desktop/application-x-volplane-plan.svg" DESTINATION "${share}/icons/hicolor/scalable/mimetypes")

# The pictures of a software centre are fetched from where the project publishes them (those of packaging/screenshots).
set(VOLPLANE_PICTURES_URL "" CACHE STRING "Web address of the folder resources/pictures, for the screenshots in the AppStream data")
set(volplane_screenshots "")
if(VOLPLANE_PICTURES_URL)
  set(type " type=\"default\"")
  foreach(line "engine-out|The landing glide from a point of the tour" "landing-now|An engine failure away from the tour: what several planners answer"
          "map-and-3d|Map and 3D view with the verified plan" "safe-altitude|Lowest safe altitude, and the glide margin along the tour")
    string(REPLACE "|" ";" line "${line}")
    list(GET line 0 picture)
    list(GET line 1 caption)
    string(APPEND volplane_screenshots "    <screenshot${type}>\n      <caption>${caption}</caption>\n"
      "      <image type=\"source\" width=\"1480\" height=\"920\">${VOLPLANE_PICTURES_URL}/${picture}.png</image>\n    </screenshot>\n")
    set(type "")
  endforeach()
  set(volplane_screenshots "  <screenshots>\n${volplane_screenshots}  </screenshots>\n")
endif()
string(TIMESTAMP volplane_release_date "%Y-%m-%d" UTC)
configure_file("${CMAKE_SOURCE_DIR}/resources/desktop/org.volplane.Volplane.metainfo.xml.in" "${made}/org.volplane.Volplane.metainfo.xml" @ONLY)
install(FILES "${made}/org.volplane.Volplane.metainfo.xml" DESTINATION "${share}/metainfo")

foreach(size 16 22 24 32 48 64 128 256 512)  # as packaging/tools/make_icons draws them
  set(icons "${made}/icons/${size}x${size}")
  install(FILES "${icons}/volplane.png" DESTINATION "${share}/icons/hicolor/${size}x${size}/apps" OPTIONAL)
  install(FILES "${icons}/application-x-volplane-mission.png" "${icons}/application-x-volplane-plan.png"
          DESTINATION "${share}/icons/hicolor/${size}x${size}/mimetypes" OPTIONAL)
endforeach()
install(FILES "${made}/volplane.1.gz" "${made}/volplane-cli.1.gz" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" OPTIONAL)
install(FILES "${made}/changelog.gz" "${made}/NEWS.gz" "${CMAKE_SOURCE_DIR}/packaging/debian/copyright" DESTINATION "${share}/doc/volplane" OPTIONAL)
install(DIRECTORY "${CMAKE_BINARY_DIR}/manual" DESTINATION "${share}/doc/volplane" OPTIONAL)
