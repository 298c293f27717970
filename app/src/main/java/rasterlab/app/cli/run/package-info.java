/**
 * {@code ./lab run}: strict JSON in, one method's answer out.
 *
 * <p>Pixel coordinates as in {@link rasterlab.contract}. Start with {@link
 * rasterlab.app.cli.run.TopicRun}; each topic has one implementation of it.
 */
package rasterlab.app.cli.run;
