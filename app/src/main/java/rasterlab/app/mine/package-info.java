/**
 * Puts the user's own programs among the methods of the labs and of the study.
 *
 * <p>A program comes from an exercise, as source. It is compiled when its method is first called,
 * and runs in a child process that is kept: one that hangs is stopped with a message. A lab asks
 * {@link rasterlab.app.mine.OwnMethods} for its topic instead of taking it as it is; start there.
 */
package rasterlab.app.mine;
