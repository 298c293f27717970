/**
 * How bright a face is: one intensity for the whole face, from its normal before any perspective
 * division.
 *
 * <p>Vectors are in eye space: x right, y up, z forward from the eye. Start with {@link
 * rasterlab.engine.light.Shading}.
 */
package rasterlab.engine.light;
