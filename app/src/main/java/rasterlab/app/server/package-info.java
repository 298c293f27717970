/**
 * Talking with a grading server as a student does, for the window and for the command line.
 *
 * <p>Start with {@link rasterlab.app.server.CourseServer}; {@link rasterlab.app.server.Following}
 * waits for a result, {@link rasterlab.app.server.ServerReport} reads it.
 */
package rasterlab.app.server;
