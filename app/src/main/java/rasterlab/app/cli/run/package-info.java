/**
 * {@code ./lab run}: strict JSON in, one method's answer out.
 *
 * <p>Pixel coordinates as in {@link rasterlab.contract}. Start with {@link
 * rasterlab.app.cli.run.RunCommand}; {@code TopicRunner} runs any topic as its format says.
 */
package rasterlab.app.cli.run;
