/**
 * Formulas of statements: what is one in Markdown, and how it looks set in type.
 *
 * <p>Lengths are in em, the size of the type; y grows down from the baseline, x to the right from
 * the formula's left end. Start with {@link rasterlab.exercises.formula.FormulaMarkdown}, then
 * {@link rasterlab.exercises.formula.Formulas}.
 */
package rasterlab.exercises.formula;
