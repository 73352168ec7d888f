# Every library comes from the distribution; scripts/packages.txt lists the packages.
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(yaml-cpp REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(SUNDIALS REQUIRED)
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(GTest REQUIRED)
find_package(HDF5 REQUIRED COMPONENTS C)
find_package(MPI REQUIRED COMPONENTS C)

find_path(UDUNITS2_INCLUDE udunits2.h PATH_SUFFIXES udunits2 REQUIRED)
find_library(UDUNITS2_LIBRARY udunits2 REQUIRED)
add_library(ostium_udunits INTERFACE)
target_include_directories(ostium_udunits SYSTEM INTERFACE ${UDUNITS2_INCLUDE})
target_link_libraries(ostium_udunits INTERFACE ${UDUNITS2_LIBRARY})

find_path(SUITESPARSE_INCLUDE klu.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(KLU_LIBRARY klu REQUIRED)
add_library(ostium_klu INTERFACE)
target_include_directories(ostium_klu SYSTEM INTERFACE ${SUITESPARSE_INCLUDE})
target_link_libraries(ostium_klu INTERFACE ${KLU_LIBRARY})

find_package(VTK REQUIRED COMPONENTS CommonCore CommonDataModel FiltersCore FiltersSources IOImage IOXML
                              RenderingCore RenderingFreeType RenderingOpenGL2)
