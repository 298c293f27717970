/**
 * A frame as the list of OpenGL's calls that draw it: each can be read and run.
 *
 * <p>{@link rasterlab.app.opengl.call.FrameCalls} makes the list of a {@link
 * rasterlab.app.opengl.state.GlFrame}; {@link rasterlab.app.opengl.call.GlPainter} runs it in the
 * current context and reads the picture back. A list can be made where there is no OpenGL.
 */
package rasterlab.app.opengl.call;
