/**
 * Topic {@code matrix}: the course's matrices by their names.
 *
 * <p>Rows as in the textbook, points being rows too. A name, its parameters and its formula stand
 * together in one entry of a list: {@link rasterlab.engine.transform.matrix.NamedMatrices} joins
 * the lists; the formulas themselves are in {@link rasterlab.engine.transform}. Start with {@link
 * rasterlab.engine.transform.matrix.NamedMatrix}.
 */
package rasterlab.engine.transform.matrix;
