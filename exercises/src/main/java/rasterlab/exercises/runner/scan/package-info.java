/**
 * Looks through a student's class files for what the exercise does not allow, before they run.
 *
 * <p>Start with {@link rasterlab.exercises.runner.scan.ByteCodeCheck}.
 */
package rasterlab.exercises.runner.scan;
