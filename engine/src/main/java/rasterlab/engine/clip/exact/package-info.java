/**
 * The right answers, in fractions: slow, plain, and without a line of code that methods use.
 *
 * <p>Start with {@link rasterlab.engine.clip.exact.ExactClip}.
 */
package rasterlab.engine.clip.exact;
