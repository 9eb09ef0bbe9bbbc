# Included by component.cmake of the methods that train or use networks.
if(NOT TEXLOOM_NETWORKS)
  set(COMPONENT_ABSENT "It was left out when Texloom was built; build it with -DTEXLOOM_NETWORKS=ON.")
endif()
