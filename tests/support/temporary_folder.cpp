#include "tests/support/temporary_folder.h"

#include <cstdlib>
#include <iterator>
#include <stdexcept>

namespace texloom::test {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "texloom-test-XXXXXX").string();
    if (!::mkdtemp(name.data()))
        throw std::runtime_error("no temporary folder");
    m_path = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::permissions(m_path, fs::perms::owner_all, ignored);
    fs::remove_all(m_path, ignored);
}

int TemporaryFolder::entries() const {
    return static_cast<int>(std::distance(fs::directory_iterator(m_path), fs::directory_iterator()));
}

} // namespace texloom::test
