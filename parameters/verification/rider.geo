// A block with a lower side that falls by 30 degrees.
h = 0.3;
Point(1) = {0, 0, 0, h};
Point(2) = {1, -0.57735026918962576, 0, h};
Point(3) = {1, 1, 0, h};
Point(4) = {0, 1, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Recombine Surface {1};
Mesh.SubdivisionAlgorithm = 1;
Physical Curve("slope") = {1};
Physical Curve("guided") = {2};
Physical Curve("top") = {3};
Physical Surface("rider") = {1};
