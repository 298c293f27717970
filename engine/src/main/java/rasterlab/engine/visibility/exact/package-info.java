/**
 * The exact reference of hidden surfaces: which face is seen at each pixel, without rounding.
 *
 * <p>It shares no code with the methods it judges. Each question is the sign of a polynomial in the
 * given numbers: first in doubles with a bound of their error, and where that does not decide, in
 * whole numbers of any length. Spaces: world, eye (x right, y up, z forward), pixels. Start with
 * {@link rasterlab.engine.visibility.exact.ExactVisibility}; which faces are in one plane is told
 * by {@link rasterlab.engine.visibility.exact.PlaneClasses}.
 */
package rasterlab.engine.visibility.exact;
