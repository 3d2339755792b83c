// A block, 6 x 6, below y = -x^2/40 - x^3/600, through points every 0.1, by 9 faces of second order.
Mesh.ElementOrder = 2;
Mesh.SecondOrderLinear = 0;
Mesh.RecombineAll = 1;

n = 60;
For i In {0 : n}
  x = -2.8 + i * 6 / n;
  Point(i + 1) = {x, -x^2 / 40 - x^3 / 600, 0};
EndFor
Point(101) = {-2.8, -6, 0};
Point(102) = {3.2, -6, 0};
Spline(1) = {1 : n + 1};
Line(2) = {n + 1, 102};
Line(3) = {102, 101};
Line(4) = {101, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve {1, 3} = 10;
Transfinite Curve {2, 4} = 9;
Transfinite Surface {1} = {1, n + 1, 102, 101};
Physical Curve("top") = {1};
Physical Curve("bottom") = {3};
Physical Surface("block") = {1};
