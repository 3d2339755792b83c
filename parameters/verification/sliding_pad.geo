// A pad with a flat of 6 and ends of radius 1.
Point(1) = {-3, 0, 0};  Point(2) = {3, 0, 0};   Point(3) = {4, 1, 0};   Point(4) = {4, 6, 0};
Point(5) = {-4, 6, 0};  Point(6) = {-4, 1, 0};  Point(7) = {3, 1, 0};   Point(8) = {-3, 1, 0};

Line(1) = {1, 2};  Circle(2) = {2, 7, 3};  Line(3) = {3, 4};
Line(4) = {4, 5};  Line(5) = {5, 6};       Circle(6) = {6, 8, 1};

Curve Loop(1) = {1:6};
Plane Surface(1) = {1};
MeshSize {:}    = 1;
MeshSize {1, 2} = 0.4;
Recombine Surface {:};
Mesh.SubdivisionAlgorithm = 1;

Physical Curve("flat")  = {1};
Physical Curve("right") = {2};
Physical Curve("left")  = {6};
Physical Curve("top")   = {4};
Physical Surface("pad") = {1};
