# Parts of the core that can be built and tested alone, each with the layers that it needs: what the sanitizers look at in
# turn, since all of it would take them too long. They leave out methods, sessions, programs and the window.
set(TEXLOOM_PART "" CACHE STRING "Part of the core to build and test alone: job, math, network, match, analysis, io or volume; all of Texloom if empty")

set(PART_LAYERS_job base image job)
set(PART_LAYERS_math ${PART_LAYERS_job} math)
set(PART_LAYERS_match ${PART_LAYERS_math} match)
set(PART_LAYERS_analysis ${PART_LAYERS_match} analysis)
set(PART_LAYERS_network ${PART_LAYERS_job} color io math network)
set(PART_LAYERS_io ${PART_LAYERS_job} color io)
set(PART_LAYERS_volume ${PART_LAYERS_io} volume)

# Which of the layers are tested: the others have their own turn.
set(PART_TESTS_job base image job)
set(PART_TESTS_math math)
set(PART_TESTS_network network)
set(PART_TESTS_match match)
set(PART_TESTS_analysis analysis)
set(PART_TESTS_io color io)
set(PART_TESTS_volume volume)

if(TEXLOOM_PART AND NOT PART_LAYERS_${TEXLOOM_PART})
  message(FATAL_ERROR "There is no part ${TEXLOOM_PART}; TEXLOOM_PART is job, math, network, match, analysis, io or volume.")
endif()
