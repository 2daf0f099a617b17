# The Debian package; packaging/package builds it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME volplane)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_CONTACT "${VOLPLANE_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "mission planner for flights that can always glide to a runway")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Volplane plans flights that look at many places on the ground, for example a
search or a survey in the mountains, so that the aircraft can glide to a
runway from every point of the flight if the engine stops.

It takes terrain, airfields and a list of targets, and gives the shortest
closed tour that keeps this promise, the glide that belongs to each point, a
certificate of an independent checker, files for flight management systems
and simulators, and a briefing. The package holds the window (volplane) and
the same job without one (volplane-cli).")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What is loaded at run time and so in no library's list: the icons' renderer, letters for pictures and briefings, Mesa's
# drivers, which draw the 3D picture where there is no other OpenGL.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libqt6svg6, fonts-dejavu-core, libgl1-mesa-dri, libegl-mesa0 | libegl-vendor")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "qt6-wayland, hicolor-icon-theme, shared-mime-info, ca-certificates")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "gdal-bin")
include(CPack)
