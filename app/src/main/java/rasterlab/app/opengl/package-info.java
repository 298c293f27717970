/**
 * The lab of OpenGL: one scene drawn by OpenGL's calls and by the software pipeline from the same
 * state, with the difference of the two pictures.
 *
 * <p>Angles are degrees, pictures in device pixels. {@link rasterlab.app.opengl.OpenGlLabModel}
 * holds what is shown and knows no Swing; {@link rasterlab.app.opengl.OpenGlPanel} shows it; {@link
 * rasterlab.app.opengl.GlCanvas} is OpenGL's window. The state is in {@code opengl.state}, the
 * calls in {@code opengl.call}, the other half in {@code opengl.software}.
 */
package rasterlab.app.opengl;
