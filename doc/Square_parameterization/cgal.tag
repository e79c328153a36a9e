<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<!-- the pages of CGAL's manual that this manual names -->
<tagfile>
  <compound kind="class">
    <name>Parameterizer_3</name>
    <filename>Surface_mesh_parameterization/classParameterizer__3.html</filename>
  </compound>
  <compound kind="class">
    <name>FaceGraph</name>
    <filename>BGL/classFaceGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>MutableFaceGraph</name>
    <filename>BGL/classMutableFaceGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>SparseLinearAlgebraTraits_d</name>
    <filename>Solver_interface/classSparseLinearAlgebraTraits__d.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Surface_mesh</name>
    <filename>Surface_mesh/classCGAL_1_1Surface__mesh.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Surface_mesh_parameterization::Square_border_arc_length_parameterizer_3</name>
    <filename>Surface_mesh_parameterization/classCGAL_1_1Surface__mesh__parameterization_1_1Square__border__arc__length__parameterizer__3.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Surface_mesh_parameterization::Mean_value_coordinates_parameterizer_3</name>
    <filename>Surface_mesh_parameterization/classCGAL_1_1Surface__mesh__parameterization_1_1Mean__value__coordinates__parameterizer__3.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Surface_mesh_parameterization::Iterative_authalic_parameterizer_3</name>
    <filename>Surface_mesh_parameterization/classCGAL_1_1Surface__mesh__parameterization_1_1Iterative__authalic__parameterizer__3.html</filename>
  </compound>
</tagfile>
