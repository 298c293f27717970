/**
 * Topic {@code shade-face}: a triangle shaded flat, by Gouraud and by Phong, against the formula at
 * every point; brightness profiles with their Mach bands, and the errors on a whole sphere.
 *
 * <p>Start with {@link rasterlab.engine.light.face.PhongFace}; {@link
 * rasterlab.engine.light.face.FaceTopic} lists everything.
 */
package rasterlab.engine.light.face;
