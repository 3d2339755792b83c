// Upper half of a lug: an eye with a hole of radius 10 and an outer radius of 20, and a shank of height 20 that ends at x = -60. Millimetres.
r = 10;  R = 20;  a = r * Sqrt(0.5);
Point(1) = {0, 0, 0};     Point(2) = {r, 0, 0};    Point(3) = {0, r, 0};     Point(4) = {-a, a, 0};   Point(5) = {-r, 0, 0};
Point(6) = {R, 0, 0};     Point(7) = {0, R, 0};    Point(8) = {-R, R, 0};    Point(9) = {-R, 0, 0};
Point(10) = {-60, R, 0};  Point(11) = {-60, 0, 0};

Circle(1) = {2, 1, 3};    Circle(2) = {3, 1, 4};   Circle(3) = {4, 1, 5};
Circle(4) = {6, 1, 7};    Line(5) = {7, 8};        Line(6) = {8, 9};
Line(7) = {2, 6};         Line(8) = {3, 7};        Line(9) = {4, 8};         Line(10) = {5, 9};
Line(11) = {8, 10};       Line(12) = {10, 11};     Line(13) = {11, 9};

Curve Loop(1) = {7, 4, -8, -1};      Plane Surface(1) = {1};
Curve Loop(2) = {8, 5, -9, -2};      Plane Surface(2) = {2};
Curve Loop(3) = {9, 6, -10, -3};     Plane Surface(3) = {3};
Curve Loop(4) = {11, 12, 13, -6};    Plane Surface(4) = {4};

Transfinite Curve {1, 4} = 7;                    // nodes, ends included
Transfinite Curve {2, 3, 5, 6, 12} = 4;
Transfinite Curve {7, 8, 9, 10} = 4;
Transfinite Curve {11, 13} = 7;
Transfinite Surface {1, 2, 3, 4};
Recombine Surface {1, 2, 3, 4};

Physical Curve("hole")     = {1, 2, 3};
Physical Curve("symmetry") = {7, 10, 13};
Physical Curve("end")      = {12};
Physical Surface("lug")    = {1, 2, 3, 4};
