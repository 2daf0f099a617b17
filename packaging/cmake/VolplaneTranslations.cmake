# vp_add_translations(target): makes resources/translations/volplane_*.ts part of a target, as :/translations/volplane_*.qm of the
# resource "translations". Only lrelease is needed for that; strings are collected by packaging/translations.
find_program(LRELEASE NAMES lrelease lrelease-qt6 HINTS "${QT6_INSTALL_PREFIX}/${QT6_INSTALL_BINS}" /usr/lib/qt6/bin NO_CACHE REQUIRED)
find_program(LUPDATE NAMES lupdate lupdate-qt6 HINTS "${QT6_INSTALL_PREFIX}/${QT6_INSTALL_BINS}" /usr/lib/qt6/bin NO_CACHE REQUIRED)

function(vp_add_translations target)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/translations")
  file(MAKE_DIRECTORY "${folder}")
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/resources/translations/volplane_*.ts")
  set(entries "")
  foreach(source IN LISTS sources)
    get_filename_component(name "${source}" NAME_WE)
    add_custom_command(OUTPUT "${folder}/${name}.qm" COMMAND "${LRELEASE}" -silent "${source}" -qm "${folder}/${name}.qm" DEPENDS "${source}"
      COMMENT "Compiling translation ${name}" VERBATIM)
    list(APPEND compiled "${folder}/${name}.qm")
    string(APPEND entries "<file>${name}.qm</file>")
  endforeach()
  set(list "${folder}/translations.qrc")
  file(CONFIGURE OUTPUT "${list}" CONTENT "<RCC><qresource prefix=\"/translations\">${entries}</qresource></RCC>\n" @ONLY)
  add_custom_command(OUTPUT "${folder}/translations.cpp" COMMAND Qt6::rcc --name translations --output "${folder}/translations.cpp" "${list}"
    DEPENDS "${list}" ${compiled} VERBATIM)
  target_sources(${target} PRIVATE "${folder}/translations.cpp")
  set_source_files_properties("${folder}/translations.cpp" PROPERTIES SKIP_AUTOGEN ON)
endfunction()
