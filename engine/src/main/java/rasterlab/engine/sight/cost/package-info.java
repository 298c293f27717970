/**
 * Work counted in numbers free of noise, and what it costs by measurement.
 *
 * <p>Costs are nanoseconds of processor time, on the machine that the table names. Start with
 * {@link rasterlab.engine.sight.cost.PictureWork}.
 */
package rasterlab.engine.sight.cost;
