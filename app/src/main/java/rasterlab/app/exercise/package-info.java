/**
 * The tab of exercises: statement, editor, a check in isolated processes, submission to a server.
 *
 * <p>Sources are kept on the disk as they are typed, by {@link rasterlab.app.exercise.Drafts}.
 * Start with {@link rasterlab.app.exercise.ExerciseLabModel}.
 */
package rasterlab.app.exercise;
