# One interface target carries every compile option of the project.
add_library(texloom_options INTERFACE)
target_compile_options(texloom_options INTERFACE
  -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion
  -fno-math-errno   # nobody asks errno; without it square roots do not vectorise
  -ffp-contract=off # the same bits whether or not the machine has fused multiply-add
  # Where several sources are compiled as one, g++ takes what one of them keeps to itself for a header's.
  $<$<BOOL:${CMAKE_UNITY_BUILD}>:-Wno-subobject-linkage>
  $<$<BOOL:${TEXLOOM_WERROR}>:-Werror>)
target_include_directories(texloom_options INTERFACE ${PROJECT_SOURCE_DIR})

if(TEXLOOM_SANITIZE)
  target_compile_options(texloom_options INTERFACE -fsanitize=${TEXLOOM_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(texloom_options INTERFACE -fsanitize=${TEXLOOM_SANITIZE})
  if(TEXLOOM_SANITIZE MATCHES address AND CMAKE_CXX_COMPILER_ID MATCHES Clang) # which does not say so by itself
    target_compile_definitions(texloom_options INTERFACE __SANITIZE_ADDRESS__=1)
  endif()
  if(TEXLOOM_SANITIZE MATCHES undefined)
    target_compile_options(texloom_options INTERFACE -fno-sanitize-recover=all)
  endif()
endif()

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
# Inner loops are written to vectorise; -O3 does so in every optimised build.
string(REPLACE "-O2" "-O3" CMAKE_CXX_FLAGS_RELWITHDEBINFO "${CMAKE_CXX_FLAGS_RELWITHDEBINFO}")
# Lines and functions are enough for traces and profiles, and compile and link a third faster than all there is to know.
string(REPLACE "-g " "-g1 " CMAKE_CXX_FLAGS_RELWITHDEBINFO "${CMAKE_CXX_FLAGS_RELWITHDEBINFO}")

# gold links in a third of the time of the linker that g++ takes by itself.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=gold TEXLOOM_HAS_GOLD)
if(TEXLOOM_HAS_GOLD)
  add_link_options(-fuse-ld=gold)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()
