# Parts of Texloom that can be built and tested alone, each with the layers that it needs: what the sanitizers look at in
# turn, since all of it would take them too long. The last ones, from tools on, need all layers; they are tested one after
# the other in one build folder, so that those are compiled once. They leave out the window.
set(TEXLOOM_PARTS job math network match analysis io volume generator render tools session cli fuzz methods_1 methods_2 methods_3
  methods_4 methods_5 methods_6)
list(JOIN TEXLOOM_PARTS ", " _parts)
set(TEXLOOM_PART "" CACHE STRING "Part to build and test alone: ${_parts}; all of Texloom if empty")

set(TEXLOOM_LAYERS base image color job io math network match analysis volume generator render tools tools/* methods
  methods/* session session/*)
set(PART_LAYERS_job base image job)
set(PART_LAYERS_math ${PART_LAYERS_job} math)
set(PART_LAYERS_match ${PART_LAYERS_math} match)
set(PART_LAYERS_analysis ${PART_LAYERS_match} analysis)
set(PART_LAYERS_network ${PART_LAYERS_job} color io math network)
set(PART_LAYERS_io ${PART_LAYERS_job} color io)
set(PART_LAYERS_volume ${PART_LAYERS_io} volume)
set(PART_LAYERS_generator ${PART_LAYERS_network} volume generator)
set(PART_LAYERS_render ${PART_LAYERS_volume} math render)

# Which of the layers are tested: the others have their own turn.
set(PART_TESTS_job base image job)
set(PART_TESTS_math math)
set(PART_TESTS_network network)
set(PART_TESTS_match match)
set(PART_TESTS_analysis analysis)
set(PART_TESTS_io color io)
set(PART_TESTS_volume volume)
set(PART_TESTS_generator generator)
set(PART_TESTS_render render)
set(PART_TESTS_tools tools)
set(PART_TESTS_session session)

if(TEXLOOM_PART AND NOT TEXLOOM_PART IN_LIST TEXLOOM_PARTS)
  message(FATAL_ERROR "There is no part ${TEXLOOM_PART}; TEXLOOM_PART is one of ${_parts}.")
endif()
if(TEXLOOM_PART AND DEFINED PART_LAYERS_${TEXLOOM_PART})
  set(TEXLOOM_LAYERS ${PART_LAYERS_${TEXLOOM_PART}})
endif()

# texloom_turn(variable list…): of a list, what is tested in this part's turn: every sixth in methods_1 to methods_6, all
# where no part is chosen.
function(texloom_turn variable)
  set(_taken ${ARGN})
  if(TEXLOOM_PART MATCHES "^methods_(.)$")
    set(_taken "")
    set(_index 1)
    foreach(_one IN LISTS ARGN)
      if(_index EQUAL CMAKE_MATCH_1)
        list(APPEND _taken ${_one})
      endif()
      math(EXPR _index "${_index} % 6 + 1")
    endforeach()
  endif()
  set(${variable} ${_taken} PARENT_SCOPE)
endfunction()
