// Slot of a dovetail, right half: its flank lies on x = 3 - (y + 2)/2
Point(1)={2.95,-1.9,0};Point(2)={2.15,-0.3,0};Point(3)={8,-0.3,0};Point(4)={8,-1.9,0};Point(5)={8,-5,0};Point(6)={2.95,-5,0};
Line(1)={1,2};Line(2)={2,3};Line(3)={3,4};Line(4)={4,5};Line(5)={5,6};Line(6)={6,1};Line(7)={1,4};
Curve Loop(1)={7,-3,-2,-1};Plane Surface(1)={1};Curve Loop(2)={5,6,7,4};Plane Surface(2)={2};
Transfinite Curve{2,7,5}=7;Transfinite Curve{1,3}=5;Transfinite Curve{4,6}=5;Transfinite Surface{1,2};Recombine Surface{1,2};
Physical Curve("flank")={1};Physical Curve("base")={5};Physical Curve("right")={3,4};Physical Surface("slot")={1,2};
