/**
 * The isolated runner: compiles and runs a student's source in one-shot child processes.
 *
 * <p>The parent keeps references and expected values, sends one input at a time, compares and
 * measures; the child's word is never a verdict. Start with {@link
 * rasterlab.exercises.runner.Judge}.
 */
package rasterlab.exercises.runner;
