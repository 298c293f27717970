/**
 * The commands on exercises: {@code check} and {@code submit} grade a source, {@code exercises}
 * lists, begins, checks and proves the catalogue. Start reading at {@link
 * rasterlab.app.cli.exercise.CheckCommand}.
 */
package rasterlab.app.cli.exercise;
