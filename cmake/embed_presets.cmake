# Writes OUTPUT, a source that holds every file recipes/*.toml of SOURCE_DIR. Run as
# cmake -DSOURCE_DIR=… -DOUTPUT=… -P embed_presets.cmake
file(GLOB recipes ${SOURCE_DIR}/recipes/*.toml)
list(SORT recipes)
set(entries "")
foreach(recipe IN LISTS recipes)
  get_filename_component(name ${recipe} NAME_WE)
  file(READ ${recipe} text)
  string(APPEND entries "      {\"${name}\", R\"toml(${text})toml\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"craze/scenario/presets.h\"

namespace craze {

const std::vector<Preset>& presets() {
  static const std::vector<Preset> all{
${entries}  };
  return all;
}

}  // namespace craze
")
