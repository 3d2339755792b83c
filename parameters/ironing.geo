// Indenter of the shallow ironing problem: 1.2 wide, 1.2 high, the bottom an arc of radius 0.75 about (1, 0.75).
n = 8;
s = Sqrt(0.75^2 - 0.6^2);
Point(1) = {0.4, 0.75 - s, 0};  Point(2) = {1.6, 0.75 - s, 0};
Point(3) = {1.6, 1.2, 0};       Point(4) = {0.4, 1.2, 0};
Point(5) = {1, 0.75, 0};
Circle(1) = {1, 5, 2};
Line(2) = {2, 3};  Line(3) = {3, 4};  Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};  Plane Surface(1) = {1};
Transfinite Curve {1, 3} = n + 1;
Transfinite Curve {2, 4} = n / 2 + 1;
Transfinite Surface {1} = {1, 2, 3, 4};
Recombine Surface {1};
Physical Curve("bottom") = {1};
Physical Curve("sides") = {2, 4};
Physical Curve("top") = {3};
Physical Surface("indenter") = {1};
