// The lug of lug.geo as a solid: half of its thickness of 12, from the plane of symmetry at z = 0 to the free face at z = 6.
Include "lug.geo";
Delete Physicals;
solid[] = Extrude {0, 0, 6} { Surface{1, 2, 3, 4}; Layers{2}; Recombine; };

Physical Surface("hole")     = {solid[5], solid[11], solid[17]};
Physical Surface("symmetry") = {solid[2], solid[16], solid[22]};
Physical Surface("end")      = {solid[21]};
Physical Surface("middle")   = {1, 2, 3, 4};
Physical Volume("lug")       = {solid[1], solid[7], solid[13], solid[19]};
