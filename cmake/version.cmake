# Writes OUTPUT from TEMPLATE with the version and what git knows of the sources, if it says something else than before.
#   cmake -D SOURCE=… -D VERSION=… -D TEMPLATE=… -D OUTPUT=… -P version.cmake
find_package(Git QUIET)
set(BUILD ${VERSION})
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} -c safe.directory=${SOURCE} describe --always --tags --dirty
    WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE _commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE _failed)
  if(NOT _failed)
    string(APPEND BUILD "+${_commit}")
  endif()
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
