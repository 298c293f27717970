/**
 * How bright a surface is, from its normal before any perspective division.
 *
 * <p>{@link rasterlab.engine.light.PointLighting} is the whole formula with materials and lights,
 * per vertex or per pixel, in any space without a division; start with it. {@link
 * rasterlab.engine.light.ToneShading} is the vase's own rule, in eye space (x right, y up, z
 * forward). The packages below hold the topics: {@code shade} one point, {@code face} a triangle,
 * {@code normals} the normals of vertices.
 */
package rasterlab.engine.light;
