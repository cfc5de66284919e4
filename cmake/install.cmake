# What is installed: the library, its public headers, the program, and a package config.
