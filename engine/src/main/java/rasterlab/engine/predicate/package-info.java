/**
 * Yes-or-no questions about a point of the plane, asked of its neighbours among the numbers that a
 * method computes with.
 *
 * <p>y grows up. Start with {@link rasterlab.engine.predicate.PointQuestion}.
 */
package rasterlab.engine.predicate;
