/**
 * Sign maps: what a predicate answers around a point where its value is nearly 0, one pixel for
 * each neighbour that the method's numbers have.
 *
 * <p>Row 0 is the lowest one; y grows up. Source: L. Kettner, K. Mehlhorn, S. Pion, S. Schirra, C.
 * Yap, Classroom examples of robustness problems in geometric computations, Computational Geometry
 * 40(1), 2008, pp. 61–78. Start with {@link rasterlab.engine.signmap.SignSubject}.
 */
package rasterlab.engine.signmap;
