# Writes OUTPUT, a source that holds every file recipes/*.toml and recipes/figures/*.toml of
# SOURCE_DIR. Run as cmake -DSOURCE_DIR=… -DOUTPUT=… -P embed_presets.cmake
function(embed folder function result)
  file(GLOB recipes ${folder}/*.toml)
  list(SORT recipes)
  set(entries "")
  foreach(recipe IN LISTS recipes)
    get_filename_component(name ${recipe} NAME_WE)
    file(READ ${recipe} text)
    string(APPEND entries "      {\"${name}\", R\"toml(${text})toml\"},\n")
  endforeach()
  set(${result} "const std::vector<Preset>& ${function}() {
  static const std::vector<Preset> all{
${entries}  };
  return all;
}
" PARENT_SCOPE)
endfunction()

embed(${SOURCE_DIR}/recipes presets presets)
embed(${SOURCE_DIR}/recipes/figures figure_recipes figures)
file(WRITE ${OUTPUT} "#include \"craze/presets.h\"

namespace craze {

${presets}
${figures}
}  // namespace craze
")
