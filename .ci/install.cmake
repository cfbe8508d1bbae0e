# What `cmake --install` puts where, in the GNU directories. The Python package on request.
include(GNUInstallDirs)
option(EERIE_PYTHON "Install the Python package, too" OFF)
set(EERIE_PYTHON_DIR lib/python3/dist-packages CACHE STRING
  "Where: a folder that python3 searches; the default is Debian's below /usr")

# Pages and completions are made from the program's own table of commands.
set(manual ${CMAKE_BINARY_DIR}/manual)
add_custom_command(OUTPUT ${manual}/man/eerie.1 DEPENDS eerie COMMENT "Writing man pages and completions"
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${manual} COMMAND eerie manual --quiet -o ${manual})
add_custom_target(eerie_manual ALL DEPENDS ${manual}/man/eerie.1)

# Debian's packages and local software have folders of their own for zsh.
set(zsh_folder site-functions)
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(zsh_folder vendor-completions)
endif()

# The same search path before and after; packages, whose libraries are the system's, skip it.
set_target_properties(eerie PROPERTIES BUILD_WITH_INSTALL_RPATH ON INSTALL_RPATH_USE_LINK_PATH ON)
install(TARGETS eerie COMPONENT program)
install(DIRECTORY ${manual}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${manual}/completions/eerie
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(FILES ${manual}/completions/_eerie DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/${zsh_folder} COMPONENT program)
install(FILES ${manual}/completions/eerie.fish
  DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program)
install(DIRECTORY sweeps DESTINATION ${CMAKE_INSTALL_DATADIR}/eerie COMPONENT program)
install(FILES README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES ${copyright} DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT program)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program
  FILES_MATCHING PATTERN *.md PATTERN *.png PATTERN *.svg PATTERN *.ipynb PATTERN *.service)
if(EERIE_PYTHON)
  install(DIRECTORY analysis/python/eerie DESTINATION ${EERIE_PYTHON_DIR} COMPONENT python
    PATTERN __pycache__ EXCLUDE)
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-eerie RENAME copyright COMPONENT python)
endif()

# `make deb`: two packages, eerie and python3-eerie.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME eerie)
# To Debian a release candidate is older than its release.
string(REPLACE "-rc" "~rc" CPACK_PACKAGE_VERSION ${EERIE_VERSION})
set(CPACK_PACKAGE_CONTACT "the eerie authors <eerie@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_FILE ${CMAKE_SOURCE_DIR}/.ci/deb/description)
set(CPACK_COMPONENTS_ALL program)
if(EERIE_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME eerie)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "sweeps of planetesimal collisions with an SPH solver inside
Impacts of rubble piles at walking pace, over impact speed, angle, mass ratio
and friction, and what is left of them: shapes, spins, masses. A campaign is a
file; results are a database.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "gnuplot-nox | gnuplot, fonts-dejavu-core")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS ffmpeg)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "python3-eerie, slurm-client")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-eerie)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "results of eerie as pandas frames and numpy arrays
Reads the databases and snapshots that eerie writes, with units, and calls the
program for the rest.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3, python3-pandas, python3-h5py")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS eerie)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib, python3-yt")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
  ${CMAKE_SOURCE_DIR}/.ci/deb/postinst ${CMAKE_SOURCE_DIR}/.ci/deb/prerm)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_SOURCE_DIR}/.ci/deb/compress.cmake)
include(CPack)
