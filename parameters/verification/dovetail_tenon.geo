// Tenon of a dovetail, right half
Point(1)={0,-2,0};Point(2)={3,-2,0};Point(3)={2,0,0};Point(4)={2,3,0};Point(5)={0,3,0};Point(6)={0,0,0};
Line(1)={1,2};Line(2)={2,3};Line(3)={3,4};Line(4)={4,5};Line(5)={5,6};Line(6)={6,1};Line(7)={6,3};
Curve Loop(1)={1,2,-7,6};Plane Surface(1)={1};Curve Loop(2)={7,3,4,5};Plane Surface(2)={2};
Transfinite Curve{1,7,4}=5;Transfinite Curve{2,6}=5;Transfinite Curve{3,5}=5;Transfinite Surface{1,2};Recombine Surface{1,2};
Physical Curve("flank")={2};Physical Curve("top")={4};Physical Curve("middle")={5,6};Physical Surface("tenon")={1,2};
