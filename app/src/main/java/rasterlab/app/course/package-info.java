/**
 * The map of the course in the window: every exercise under its topic, how far the student has come
 * with it, and the lab that prepares for it.
 *
 * <p>Start with {@link rasterlab.app.course.CourseMapPane}; {@link rasterlab.app.course.Standings}
 * finds out how far the student is, from the server of the course or from what is kept here.
 */
package rasterlab.app.course;
