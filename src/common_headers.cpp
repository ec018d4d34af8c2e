// Holds the precompiled headers that the libraries share; see CMakeLists.txt.
