find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(OpenImageIO 2.4 REQUIRED)
find_package(TBB REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
# Neither library's own CMake files are found where Debian puts them.
pkg_check_modules(FFTW REQUIRED IMPORTED_TARGET fftw3f)
pkg_check_modules(OpenColorIO REQUIRED IMPORTED_TARGET OpenColorIO)

# Debian's OpenImageIO names include folders that are not there; CMake refuses those.
get_target_property(_folders OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
set(_present)
foreach(_folder IN LISTS _folders)
  if(IS_DIRECTORY "${_folder}")
    list(APPEND _present "${_folder}")
  endif()
endforeach()
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${_present}")

find_path(RANDOM123_INCLUDE_DIR Random123/philox.h REQUIRED)
