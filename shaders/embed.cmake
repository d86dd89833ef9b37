# Writes OUTPUT, a C++ source that defines burl::FUNCTION() over the files of the list FILES (";" separated as "|"),
# named by their paths below FOLDER.
# Run by cmake -P at build time, so that an edited shader or preset is compiled in again.
string(REPLACE "|" ";" FILES "${FILES}")
set(entries "")
foreach(file IN LISTS FILES)
    file(RELATIVE_PATH name "${FOLDER}" "${file}")
    file(READ "${file}" content)
    string(APPEND entries "    {\"${name}\", R\"~~~~(${content})~~~~\"sv},\n")
endforeach()
file(WRITE "${OUTPUT}" "#include <array>\n\n#include \"app/base/embedded.h\"\n\nnamespace burl {\n\nnamespace {\nusing namespace std::string_view_literals;  // their lengths are not counted at compile time\nconstexpr EmbeddedFile files[] = {\n${entries}};\n}  // namespace\n\nstd::span<const EmbeddedFile> ${FUNCTION}() { return files; }\n\n}  // namespace burl\n")
