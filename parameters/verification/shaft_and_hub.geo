// Both bodies of shaft_and_hub.prm: the shaft 20..40 and the hub 40..60, a quarter of each. Their surfaces at 40 are two.
SetFactory("OpenCASCADE");
Mesh.ElementOrder = 2;

Macro QuarterRing // from `inner` to `outer`, n cells along the arcs
  p = newp;
  Point(p) = {0, 0, 0};
  Point(p + 1) = {inner, 0, 0};  Point(p + 2) = {outer, 0, 0};
  Point(p + 3) = {0, outer, 0};  Point(p + 4) = {0, inner, 0};
  c = newc;
  Line(c) = {p + 1, p + 2};       Circle(c + 1) = {p + 2, p, p + 3};
  Line(c + 2) = {p + 3, p + 4};   Circle(c + 3) = {p + 4, p, p + 1};
  s = news;
  Curve Loop(s) = {c, c + 1, c + 2, c + 3};
  Plane Surface(s) = {s};
  Transfinite Curve{c, c + 2} = 4;
  Transfinite Curve{c + 1, c + 3} = n + 1;
  Transfinite Surface{s};
  Recombine Surface{s};
Return

inner = 20; outer = 40; n = 6;
Call QuarterRing;
Physical Surface("shaft") = {s};
Physical Curve("journal") = {c + 1};
cuts() = {c, c + 2};

inner = 40; outer = 60; n = 9;
Call QuarterRing;
Physical Surface("hub") = {s};
Physical Curve("bore") = {c + 3};
cuts() += {c, c + 2};

Physical Curve("cuts") = cuts();
