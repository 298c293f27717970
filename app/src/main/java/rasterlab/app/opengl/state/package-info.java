/**
 * The contents of the OpenGL lab, apart from who draws them: the states that a control sets, the
 * scene's shapes, lights and materials, the matrices.
 *
 * <p>World: x right, y up, z to the viewer; eye: the world turned and moved away along −z. Colours
 * are shares of 0 to 1, angles degrees. Start with {@link rasterlab.app.opengl.state.Setting} and
 * {@link rasterlab.app.opengl.state.GlChoice}; {@link rasterlab.app.opengl.state.GlFrame} works out
 * what both OpenGL and the software pipeline draw.
 */
package rasterlab.app.opengl.state;
