# Writes OUTPUT: the files of the page as the table that assets.hpp declares.
# Called as a script with -DFOLDER=... -DOUTPUT=... so that a changed page is embedded anew.
file(GLOB files ${FOLDER}/*.html ${FOLDER}/*.css ${FOLDER}/*.js ${FOLDER}/*.svg)
list(SORT files)
set(code "#include \"campaign/serve/assets.hpp\"\n\nnamespace eerie::serve {\nnamespace {\nconstexpr Asset table[] = {\n")
foreach(file ${files})
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND code "{\"${name}\", R\"eerie~(${text})eerie~\"},\n")
endforeach()
string(APPEND code "};\n}  // namespace\nstd::span<const Asset> assets() { return table; }\n}  // namespace eerie::serve\n")
file(WRITE ${OUTPUT} "${code}")
