include(${PROJECT_SOURCE_DIR}/cmake/network_component.cmake)
