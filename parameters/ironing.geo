// Indenter of the shallow ironing problem: 1.2 wide, 1.2 high, the bottom an arc of radius 0.75 about (1, 0.75), its ends rounded by r.
r = 0.15;
dx = 0.6 - r;  dy = Sqrt((0.75 - r)^2 - dx^2);   // from the arc's centre to the fillets'
k = 0.75 / (0.75 - r);
Point(1) = {1 - k*dx, 0.75 - k*dy, 0};  Point(2) = {1 + k*dx, 0.75 - k*dy, 0};
Point(3) = {1.6, 0.75 - dy, 0};  Point(4) = {1.6, 1.2, 0};
Point(5) = {0.4, 1.2, 0};        Point(6) = {0.4, 0.75 - dy, 0};
Point(7) = {1, 0.75, 0};  Point(8) = {1 - dx, 0.75 - dy, 0};  Point(9) = {1 + dx, 0.75 - dy, 0};
Circle(1) = {1, 7, 2};  Circle(2) = {2, 9, 3};
Line(3) = {3, 4};  Line(4) = {4, 5};  Line(5) = {5, 6};
Circle(6) = {6, 8, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6};  Plane Surface(1) = {1};
Transfinite Curve {1} = 11;
Transfinite Curve {2, 6} = 3;
Transfinite Curve {4} = 15;
Transfinite Curve {3, 5} = 7;
Transfinite Surface {1} = {6, 3, 4, 5};
Recombine Surface {1};
Physical Curve("bottom") = {1};
Physical Curve("left fillet") = {6};
Physical Curve("right fillet") = {2};
Physical Curve("sides") = {3, 5};
Physical Curve("top") = {4};
Physical Surface("indenter") = {1};
