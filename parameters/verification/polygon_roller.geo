// A quarter of a roller of radius 10, from the ground up; a polygon where nothing says that it is round.
DefineConstant[ lc = 2, fine = 0.25 ];
Point(1) = {0, 10, 0, lc}; Point(2) = {0, 0, 0, fine}; Point(3) = {10, 10, 0, lc};
Line(1) = {1, 2}; Circle(2) = {2, 1, 3}; Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3}; Plane Surface(1) = {1};
Recombine Surface {1}; Mesh.SubdivisionAlgorithm = 1;
Physical Curve("axis") = {1}; Physical Curve("arc") = {2}; Physical Curve("cut") = {3}; Physical Surface("roller") = {1};
