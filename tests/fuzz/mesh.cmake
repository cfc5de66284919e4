# The mesh readers, started from small sound files.
set(seeds ${CMAKE_CURRENT_LIST_DIR}/seeds)
firsthit_fuzz(fuzz_ply fuzz_ply.cpp
    -seed_inputs=${seeds}/ascii.ply,${seeds}/uv.ply,${seeds}/little.ply,${seeds}/big.ply)
firsthit_fuzz(fuzz_stl fuzz_stl.cpp -seed_inputs=${seeds}/ascii.stl,${seeds}/binary.stl)
firsthit_fuzz(fuzz_obj fuzz_obj.cpp -seed_inputs=${seeds}/cube.obj,${seeds}/cube.mtl)
