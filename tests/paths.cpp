// The one place of the tests that is compiled with absolute paths (tests/paths.h).
#include "tests/paths.h"

namespace burl::test {

std::string source_folder() {
    return BURL_SOURCE_DIR;
}

std::string case_file(const std::string& name) {
    return source_folder() + "/tests/cases/" + name;
}

std::string binary_folder() {
    return BURL_BINARY_DIR;
}

std::string mesh_folder() {
    return BURL_MESH_DIR;
}

}  // namespace burl::test
