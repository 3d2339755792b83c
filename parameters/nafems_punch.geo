// Punch of NAFEMS R0094-2: radius 50, height 100, a fillet of radius 10 at the lower edge; x is the radius.
h = 10;
Point(1) = {0, 0, 0};    Point(2) = {40, 0, 0};   Point(3) = {40, 10, 0};
Point(4) = {50, 10, 0};  Point(5) = {50, 100, 0}; Point(6) = {0, 100, 0};
a = 10 * Sqrt(0.5);
Point(7) = {40 + a, 10 - a, 0};     // middle of the fillet
Point(8) = {30, 0, 0};  Point(9) = {50, 20, 0};   Point(10) = {30, 20, 0};
Point(11) = {0, 20, 0}; Point(12) = {30, 100, 0};

Line(1) = {1, 8};       Line(2) = {8, 2};         Circle(3) = {2, 3, 7};
Circle(4) = {7, 3, 4};  Line(5) = {4, 9};         Line(6) = {9, 5};
Line(7) = {5, 12};      Line(8) = {12, 6};        Line(9) = {6, 11};
Line(10) = {11, 1};     Line(11) = {8, 10};       Line(12) = {11, 10};
Line(13) = {10, 9};     Line(14) = {10, 12};      Line(15) = {10, 7};

Curve Loop(1) = {1, 11, -12, 10};      Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, -15, -11};      Plane Surface(2) = {2};
Curve Loop(3) = {4, 5, -13, 15};       Plane Surface(3) = {3};
Curve Loop(4) = {12, 14, 8, 9};        Plane Surface(4) = {4};
Curve Loop(5) = {13, 6, 7, -14};       Plane Surface(5) = {5};

Transfinite Curve {1, 12, 8} = 4;
Transfinite Curve {10, 11, 2, 5, 15, 3, 4, 13, 7} = 3;
Transfinite Curve {9, 14, 6} = 9;
Transfinite Surface {1} = {1, 8, 10, 11};
Transfinite Surface {2} = {8, 2, 7, 10};
Transfinite Surface {3} = {7, 4, 9, 10};
Transfinite Surface {4} = {11, 10, 12, 6};
Transfinite Surface {5} = {10, 9, 5, 12};
Recombine Surface {1, 2, 3, 4, 5};


Physical Curve("bottom") = {1, 2};
Physical Curve("fillet") = {3, 4};
Physical Curve("top")    = {7, 8};
Physical Surface("punch") = {1, 2, 3, 4, 5};
