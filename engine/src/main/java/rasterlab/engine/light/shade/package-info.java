/**
 * Topic {@code shade}: one light on one point of a surface, term by term.
 *
 * <p>Directions of any length, in one space without a perspective division. The formula stands in
 * {@link rasterlab.contract.PointShader}; start with {@link
 * rasterlab.engine.light.shade.FormulaShader}.
 */
package rasterlab.engine.light.shade;
