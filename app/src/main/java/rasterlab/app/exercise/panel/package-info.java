/**
 * The tab of exercises as the window shows it: statement, editor and result beside each other. The
 * model stands in the package above; nothing is graded here. Start reading at {@link
 * ExercisePanel}.
 */
package rasterlab.app.exercise.panel;
