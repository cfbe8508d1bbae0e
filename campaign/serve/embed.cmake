# Writes OUTPUT: the files of the page as the table that assets.hpp declares.
# Called as a script so that a changed page is embedded anew: -DFOLDER=... (the page), -DD3=...,
# -DTHREE=..., -DTRACKBALL=... (libraries as Debian ships them), -DNOTICES=..., -DOUTPUT=...
file(GLOB files ${FOLDER}/*.html ${FOLDER}/*.css ${FOLDER}/*.js ${FOLDER}/*.svg)
list(SORT files)
list(APPEND files ${D3} ${THREE} ${TRACKBALL} ${NOTICES})
set(code "#include \"campaign/serve/assets.hpp\"\n\nnamespace eerie::serve {\nnamespace {\nusing namespace std::literals;\nconstexpr Asset table[] = {\n")
foreach(file ${files})
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  if(file STREQUAL TRACKBALL)
    # Here it lies beside the module that it needs.
    string(REPLACE "\"../../../build/three.module.js\"" "\"./three.module.js\"" text "${text}")
    if(NOT text MATCHES "from \"./three.module.js\"")
      message(FATAL_ERROR "${file}: where does it take three.js from?")
    endif()
  endif()
  string(APPEND code "{\"${name}\", R\"eerie~(${text})eerie~\"sv},\n")
endforeach()
string(APPEND code "};\n}  // namespace\nstd::span<const Asset> assets() { return table; }\n}  // namespace eerie::serve\n")
file(WRITE ${OUTPUT} "${code}")
