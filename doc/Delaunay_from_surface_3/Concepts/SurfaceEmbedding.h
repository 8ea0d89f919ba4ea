/*!
\ingroup PkgDelaunayFromSurface3Concepts
\cgalConcept

A `SurfaceEmbedding` of a graph gives the cyclic order of the edges around each vertex of a triangulated surface,
as Boost's `PlanarEmbedding` does for graphs in the plane. It is a model of `boost::ReadablePropertyMap` whose key
type is the vertex descriptor of the graph.

The list of a vertex contains each of its edges once, in cyclic order and in either direction. The lists of two
vertices need not agree in direction; this is how a Möbius band can be described. The list of a vertex on the
boundary starts and ends with its two boundary edges. A vertex without edges has an empty list.

\cgalRefines{ReadablePropertyMap}

\cgalHasModelsBegin
\cgalHasModels{`boost::iterator_property_map` over a `std::vector` of vectors of edge descriptors}
\cgalHasModelsEnd

\sa `CGAL::surface_of()`
*/
class SurfaceEmbedding
{
public:
  /// a range of edge descriptors.
  typedef unspecified_type value_type;
};
