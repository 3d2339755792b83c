// A shallow arch: half span 10, rise 2, thickness 0.3; radius (10^2 + 2^2)/(2*2) = 26 about (0, -24).
r = 26 - 0.15;  R = 26 + 0.15;
c = 24/26;  s = 10/26;
Point(1) = {-s*r, c*r - 24, 0};  Point(2) = {s*r, c*r - 24, 0};
Point(3) = {s*R, c*R - 24, 0};   Point(4) = {-s*R, c*R - 24, 0};
Point(5) = {0, -24, 0};
Circle(1) = {1, 5, 2};  Line(2) = {2, 3};  Circle(3) = {3, 5, 4};  Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};  Plane Surface(1) = {1};
Transfinite Curve {1, 3} = 41;
Transfinite Curve {2, 4} = 2;
Transfinite Surface {1} = {1, 2, 3, 4};
Recombine Surface {1};
Physical Curve("below") = {1};
Physical Curve("above") = {3};
Physical Curve("ends") = {2, 4};
Physical Surface("arch") = {1};
