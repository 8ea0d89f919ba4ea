<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<tagfile>
  <compound kind="page">
    <name>bgl_namedparameters</name>
    <title>Named Parameters</title>
    <filename>group__bgl__namedparameters.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Delaunay_triangulation_3</name>
    <filename>classCGAL_1_1Delaunay__triangulation__3.html</filename>
  </compound>
</tagfile>
