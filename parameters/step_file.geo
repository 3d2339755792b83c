// A quarter of a block of steel with a domed top, an ellipsoid of semi-axes 12, 8 and 4 whose apex is the origin: principal radii of
// curvature 12^2/4 = 36 in x and 8^2/4 = 16 in y. The CAD model and the mesh are made by
//   gmsh -0 step_file.geo -o step_file.step
//   gmsh -3 step_file.geo -o step_file.msh
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 1};
Rotate{{1, 0, 0}, {0, 0, 0}, Pi/2} { Volume{1}; } // the poles of its coordinates away from the apex
Dilate{{0, 0, 0}, {12, 8, 4}} { Volume{1}; }
Translate{0, 0, -4} { Volume{1}; }
Box(2) = {0, 0, -4, 4, 4, 5};
BooleanIntersection(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };

Physical Surface("top") = {1};
Physical Surface("plane x") = {2};
Physical Surface("plane y") = {5};
Physical Surface("sides") = {3, 4};
Physical Surface("bottom") = {6};
Physical Volume("block") = {3};
Transfinite Curve{:} = 3; Transfinite Surface{:}; Recombine Surface{:}; Transfinite Volume{:};
