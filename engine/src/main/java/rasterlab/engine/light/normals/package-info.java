/**
 * Topic {@code vertex-normals}: normals of vertices as means of the normals of faces.
 *
 * <p>Weights may be equal, the faces' areas or their angles at the vertex; only the last do not
 * depend on how flat faces are cut into triangles. Start with {@link
 * rasterlab.engine.light.normals.WeightedNormals}; {@link
 * rasterlab.engine.light.normals.NormalsTopic} lists everything.
 */
package rasterlab.engine.light.normals;
