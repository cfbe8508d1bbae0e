cmake_minimum_required(VERSION 3.25)
# Writes OUTPUT with the git commit of SOURCE, and touches it only when that changes, so that a
# build without a new commit recompiles nothing.
find_program(git git)
set(commit unknown)
if(git)
  execute_process(COMMAND ${git} --no-optional-locks -C ${SOURCE} describe --always --abbrev=12 --dirty=+ --exclude=*
    OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
  if(status EQUAL 0)
    set(commit ${described})
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT "#pragma once\n#define EERIE_COMMIT \"@commit@\"\n")
