# Methods are found by their folders, and what a component.cmake says of a library that is not there goes into the registry.
include(${CMAKE_CURRENT_LIST_DIR}/../../cmake/methods.cmake)

function(expect what wanted)
  if(NOT "${${what}}" STREQUAL "${wanted}")
    message(SEND_ERROR "${what} is \"${${what}}\", not \"${wanted}\"")
  endif()
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
file(WRITE ${SCRATCH}/README.md "no method")
file(WRITE ${SCRATCH}/plain_one/plain_one.cpp "")
file(WRITE ${SCRATCH}/with_library/component.cmake "set(COMPONENT_LIBRARIES Heavy::heavy)")
file(WRITE ${SCRATCH}/left_out/component.cmake "set(COMPONENT_ABSENT \"Heavy was not found; install libheavy-dev.\")")
texloom_find_methods(${SCRATCH})
expect(METHOD_IDS "plain-one;with-library")
expect(METHOD_LIBRARIES "Heavy::heavy")
expect(ABSENT_FOLDERS "left_out")
expect(ABSENT_ENTRIES "        {\"left-out\", \"Heavy was not found; install libheavy-dev.\"},\n")
expect(METHOD_ENTRIES
  "        named(\"plain-one\", plain_one::self),\n        named(\"with-library\", with_library::self),\n")
