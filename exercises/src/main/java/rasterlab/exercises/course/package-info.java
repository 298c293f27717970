/**
 * The way through the course: its topics in order, each with its exercises and the lab that
 * prepares for them, for the window and for the server's pages.
 *
 * <p>Start with {@link rasterlab.exercises.course.Chapter}.
 */
package rasterlab.exercises.course;
