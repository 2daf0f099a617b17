# Third-party libraries, with the lowest versions that were tested.
find_package(Threads REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(GDAL 3.6 REQUIRED)
find_package(PROJ 9 REQUIRED CONFIG)  # what GDAL transforms coordinates with; its files are watched
find_package(OpenSSL 3.0 REQUIRED COMPONENTS Crypto)
find_package(ZLIB REQUIRED)
find_package(pugixml 1.12 REQUIRED)
find_package(Boost 1.74 REQUIRED)  # headers only
find_package(NLopt 2.7 REQUIRED)

find_path(GEOGRAPHICLIB_INCLUDE GeographicLib/Geodesic.hpp REQUIRED)
find_library(GEOGRAPHICLIB_LIBRARY NAMES GeographicLib Geographic REQUIRED)
add_library(vp_geographiclib INTERFACE)
target_include_directories(vp_geographiclib SYSTEM INTERFACE "${GEOGRAPHICLIB_INCLUDE}")
target_link_libraries(vp_geographiclib INTERFACE "${GEOGRAPHICLIB_LIBRARY}")

find_path(MD4C_HTML_INCLUDE md4c-html.h REQUIRED)
find_library(MD4C_HTML_LIBRARY NAMES md4c-html REQUIRED)
add_library(vp_md4c INTERFACE)
target_include_directories(vp_md4c SYSTEM INTERFACE "${MD4C_HTML_INCLUDE}")
target_link_libraries(vp_md4c INTERFACE "${MD4C_HTML_LIBRARY}")

find_path(EXPECTED_INCLUDE tl/expected.hpp REQUIRED)
add_library(vp_expected INTERFACE)
target_include_directories(vp_expected SYSTEM INTERFACE "${EXPECTED_INCLUDE}")

if(VOLPLANE_FUZZ)
  return()
endif()

find_package(Qt6 6.4 REQUIRED COMPONENTS Core DBus Gui Widgets Svg OpenGL OpenGLWidgets PrintSupport)
find_package(OpenGL REQUIRED COMPONENTS OpenGL EGL)
find_package(OpenSceneGraph 3.6 REQUIRED COMPONENTS osgViewer osgGA osgText osgUtil osgDB)
add_library(vp_openscenegraph INTERFACE)
target_include_directories(vp_openscenegraph SYSTEM INTERFACE ${OPENSCENEGRAPH_INCLUDE_DIRS})
target_link_libraries(vp_openscenegraph INTERFACE ${OPENSCENEGRAPH_LIBRARIES} OpenGL::OpenGL OpenGL::EGL)

if(VOLPLANE_BUILD_TESTS)
  find_package(Qt6 6.4 REQUIRED COMPONENTS Test)
endif()
