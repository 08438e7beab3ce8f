# SPDX-License-Identifier: GPL-3.0-or-later
# Every package setae builds with; ./setup installs them. The same file serves the installed package.
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(Boost 1.74 REQUIRED)
find_package(fmt REQUIRED)
pkg_check_modules(FFTW REQUIRED IMPORTED_TARGET fftw3)
find_path(RANDOM123_INCLUDE Random123/philox.h REQUIRED)
if(NOT TARGET setae_random123)
  add_library(setae_random123 INTERFACE IMPORTED)
  target_include_directories(setae_random123 SYSTEM INTERFACE ${RANDOM123_INCLUDE})
endif()

find_package(Ceres REQUIRED)
find_package(OpenSSL 3 REQUIRED COMPONENTS Crypto)
find_package(cereal REQUIRED)
find_package(pugixml REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
pkg_check_modules(TOMLPLUSPLUS REQUIRED IMPORTED_TARGET tomlplusplus)
pkg_check_modules(LIBZIP REQUIRED IMPORTED_TARGET libzip)
# find_package(HDF5) needs the language C, which a project that uses setae may not have
pkg_search_module(HDF5 REQUIRED IMPORTED_TARGET hdf5-serial hdf5)
pkg_check_modules(TIFF REQUIRED IMPORTED_TARGET libtiff-4>=4.5)
pkg_check_modules(ZSTD REQUIRED IMPORTED_TARGET libzstd)
find_package(ZLIB REQUIRED)
pkg_check_modules(NETCDF REQUIRED IMPORTED_TARGET netcdf)
pkg_check_modules(MUPARSER REQUIRED IMPORTED_TARGET muparser)

# Debian's own OpenCVConfig.cmake asks for every part of OpenCV; three are needed
find_path(OPENCV_INCLUDE opencv2/imgcodecs.hpp PATH_SUFFIXES opencv4 REQUIRED)
if(NOT TARGET setae_opencv)
  add_library(setae_opencv INTERFACE IMPORTED)
  target_include_directories(setae_opencv SYSTEM INTERFACE ${OPENCV_INCLUDE})
  foreach(part imgcodecs imgproc core)
    find_library(OPENCV_${part}_LIBRARY opencv_${part} REQUIRED)
    target_link_libraries(setae_opencv INTERFACE ${OPENCV_${part}_LIBRARY})
  endforeach()
endif()

# labels of scale bars; what its .pc lists beside it serves static linking
pkg_check_modules(TESSERACT REQUIRED tesseract>=5)
find_library(TESSERACT_LIBRARY tesseract REQUIRED)
find_package(OpenMP REQUIRED COMPONENTS CXX) # its threads are held back
if(NOT TARGET setae_tesseract)
  add_library(setae_tesseract INTERFACE IMPORTED)
  target_include_directories(setae_tesseract SYSTEM INTERFACE ${TESSERACT_INCLUDE_DIRS})
  target_link_libraries(setae_tesseract INTERFACE ${TESSERACT_LIBRARY} ${OpenMP_gomp_LIBRARY} ${OpenMP_omp_LIBRARY}) # GCC's or clang's
endif()

# surfaces larger than one machine's memory: built where MPI and FFTW's part for it are there
find_package(MPI QUIET COMPONENTS C)
find_library(FFTW_MPI_LIBRARY fftw3_mpi)
if(MPI_C_FOUND AND FFTW_MPI_LIBRARY)
  set(SETAE_MPI_FOUND ON)
else()
  set(SETAE_MPI_FOUND OFF)
endif()
