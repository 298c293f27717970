/**
 * {@code ./lab run}: strict JSON in, one method's answer out.
 *
 * <p>Pixel coordinates as in {@link rasterlab.contract}. Start with {@link
 * rasterlab.app.cli.run.TopicRun}; each topic has one implementation of it. How JSON is read and
 * written is in {@code json}.
 */
package rasterlab.app.cli.run;
