# d3 and three.js as Debian ships them: the page that the program holds is drawn with them. Sets their
# files, and `copyright`: a file with the licence of eerie and with theirs.
function(page_library variable file folder package)
  find_file(${variable} ${file} PATHS ${folder} NO_DEFAULT_PATH DOC "${file} of Debian's ${package}")
  if(NOT ${variable})
    message(FATAL_ERROR "${folder}/${file} is missing: apt install ${package} (all packages: .ci/packages), or give -D${variable}=FILE")
  endif()
endfunction()

page_library(EERIE_D3 d3.min.js /usr/share/javascript/d3 libjs-d3)
page_library(EERIE_THREE three.module.js /usr/share/javascript/three libjs-three)
page_library(EERIE_TRACKBALL TrackballControls.js /usr/share/javascript/three/examples/jsm/controls libjs-three)
page_library(EERIE_D3_COPYRIGHT copyright /usr/share/doc/libjs-d3 libjs-d3)
page_library(EERIE_THREE_COPYRIGHT copyright /usr/share/doc/libjs-three libjs-three)

set(copyright ${CMAKE_BINARY_DIR}/generated/copyright.txt)
file(READ ${CMAKE_SOURCE_DIR}/LICENSE notices)
foreach(library D3 THREE)
  file(READ ${EERIE_${library}_COPYRIGHT} notice)
  string(TOLOWER ${library} name)
  string(APPEND notices "\nThe program holds libjs-${name} of Debian, whose notices are:\n\n${notice}")
endforeach()
file(CONFIGURE OUTPUT ${copyright} CONTENT "@notices@" @ONLY)  # written where it has changed
