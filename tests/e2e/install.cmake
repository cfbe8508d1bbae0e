# Installs a build below a folder that did not exist, and looks for what belongs where.
# cmake -DBUILD=<build folder> -P install.cmake
set(prefix ${BUILD}/installed)
file(REMOVE_RECURSE ${prefix})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} --component program
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
foreach(file bin/eerie share/man/man1/eerie.1 share/man/man1/eerie-run.1
    share/bash-completion/completions/eerie share/fish/vendor_completions.d/eerie.fish
    share/eerie/sweeps/first-light.json share/eerie/sweeps/studies/accuracy.json
    share/doc/eerie/README.md share/doc/eerie/docs/decisions.md share/doc/eerie/copyright)
  if(NOT EXISTS ${prefix}/${file})
    message(SEND_ERROR "not installed: ${file}")
  endif()
endforeach()
execute_process(COMMAND ${prefix}/bin/eerie expand ${prefix}/share/eerie/sweeps/first-light.json --db none.sqlite --json
  OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
string(JSON jobs GET ${said} jobs)
if(NOT jobs EQUAL 15)
  message(SEND_ERROR "the installed program sees ${jobs} jobs in the installed first-light.json")
endif()
file(REMOVE_RECURSE ${prefix})
