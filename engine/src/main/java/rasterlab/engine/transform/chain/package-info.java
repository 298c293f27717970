/**
 * Topic {@code transform}: points through a list of matrices, in float, double and double-double.
 *
 * <p>Points are rows; the list is applied left to right; homogeneous coordinates before the
 * division, ordinary ones after it. Start with {@link
 * rasterlab.engine.transform.chain.DoubleTransformer}; {@link
 * rasterlab.engine.transform.chain.TransformTopic} lists everything.
 */
package rasterlab.engine.transform.chain;
