# What `cmake --install` puts into a prefix, which may be moved afterwards: the program (component "program"), and
# what others link (component "library"; docs/library.md).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS taut RUNTIME COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/taut COMPONENT program)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT program)
file(GLOB pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/*.md)
list(REMOVE_ITEM pages ${PROJECT_SOURCE_DIR}/docs/README.md)  # on how the pictures of the repository are made
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${pages} DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)

# Manual pages and completions, made by the program from its own help whenever it is linked. A build with sanitizers
# has none.
if(NOT TAUT_SANITIZE)
  set(made ${PROJECT_BINARY_DIR}/share)
  add_custom_command(
    TARGET taut POST_BUILD
    COMMAND taut generate man ${made}/man/man1
    COMMAND taut generate completions bash > ${made}/taut.bash
    COMMAND taut generate completions zsh > ${made}/taut.zsh
    COMMAND taut generate completions fish > ${made}/taut.fish
    COMMENT "Making manual pages and completions"
    VERBATIM)
  install(DIRECTORY ${made}/man/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT program)
  set(data ${CMAKE_INSTALL_DATADIR})
  install(FILES ${made}/taut.bash DESTINATION ${data}/bash-completion/completions RENAME taut COMPONENT program)
  # Where zsh looks below /usr/local, and where Debian's looks below /usr.
  foreach(folder site-functions vendor-completions)
    install(FILES ${made}/taut.zsh DESTINATION ${data}/zsh/${folder} RENAME _taut COMPONENT program)
  endforeach()
  install(FILES ${made}/taut.fish DESTINATION ${data}/fish/vendor_completions.d COMPONENT program)
endif()

# Each folder of the source is a library there, too, with the same includes.
set(installed_libraries base view model methods motion measure meshes scene)
foreach(folder ${installed_libraries})
  set_target_properties(taut_${folder} PROPERTIES EXPORT_NAME ${folder})
  install(TARGETS taut_${folder} EXPORT taut ARCHIVE COMPONENT library
          INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/taut)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/${folder}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/taut
          COMPONENT library)
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libtaut-dev RENAME copyright
        COMPONENT library)
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/taut)
install(EXPORT taut NAMESPACE taut:: FILE tautTargets.cmake DESTINATION ${config_folder} COMPONENT library)
configure_package_config_file(${PROJECT_SOURCE_DIR}/app/tautConfig.cmake.in ${PROJECT_BINARY_DIR}/tautConfig.cmake
                              INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tautConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/tautConfig.cmake ${PROJECT_BINARY_DIR}/tautConfigVersion.cmake
        DESTINATION ${config_folder} COMPONENT library)
