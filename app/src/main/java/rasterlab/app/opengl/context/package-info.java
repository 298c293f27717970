/**
 * Contexts of OpenGL: one without a window, what a context can do, and why there may be none.
 *
 * <p>Every context is asked by {@link rasterlab.app.opengl.context.GlReport} what it has before
 * anything is drawn: a function that a core profile lacks ends the whole program when it is called.
 */
package rasterlab.app.opengl.context;
