/**
 * The statement of an exercise: Markdown as HTML that Swing shows, with pictures and formulas.
 * Start reading at {@link Statement}.
 */
package rasterlab.app.exercise.statement;
