# As Debian wants them: pages and changelogs compressed, without a time stamp.
set(documents ${CPACK_TEMPORARY_DIRECTORY}/program/usr/share/doc/eerie)
file(RENAME ${documents}/CHANGELOG.md ${documents}/changelog)
set(files ${documents}/changelog)
foreach(package program/usr/share/doc/eerie python/usr/share/doc/python3-eerie)
  set(log ${CPACK_TEMPORARY_DIRECTORY}/${package}/changelog.Debian)
  string(REGEX REPLACE ".*/" "" name ${package})
  # The day of the last commit, so that equal sources give equal packages.
  execute_process(COMMAND git -C ${CMAKE_CURRENT_LIST_DIR} log -1 --format=%cD OUTPUT_VARIABLE day
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT day)
    string(TIMESTAMP day "%a, %d %b %Y %H:%M:%S +0000" UTC)
  endif()
  file(WRITE ${log} "${name} (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) bookworm; urgency=medium\n\n"
    "  * See changelog.gz of eerie.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${day}\n")
  list(APPEND files ${log})
endforeach()
file(GLOB_RECURSE pages ${CPACK_TEMPORARY_DIRECTORY}/*/usr/share/man/*.1)
list(APPEND files ${pages})
foreach(file ${files})
  execute_process(COMMAND gzip -9n ${file} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
