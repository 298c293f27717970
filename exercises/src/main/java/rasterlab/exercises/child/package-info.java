/**
 * The code that runs inside a child process: one compiler, or one loader and caller of a student's
 * class.
 *
 * <p>Uses the JDK and {@code rasterlab.contract} only, because nothing else is on the child's class
 * path. Start with {@link rasterlab.exercises.child.RunMain}.
 */
package rasterlab.exercises.child;
