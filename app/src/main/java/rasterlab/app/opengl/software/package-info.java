/**
 * The software pipeline in OpenGL's place: the same frame from the same state.
 *
 * <p>Vertices are lit and assembled here as OpenGL does it (two sides, flat colours, polygon
 * modes), in eye space; the engine's light, textures and triangles do the rest. Start with {@link
 * rasterlab.app.opengl.software.SoftwarePainter}; {@link rasterlab.app.opengl.software.Deviations}
 * names what it does not have.
 */
package rasterlab.app.opengl.software;
