/**
 * How charts look wherever they are drawn: their colours and type, their size on a stage or in a
 * file, and the mark and line of each method.
 *
 * <p>Sizes are in a chart's own units, of which its type is 14 high. Start with {@link
 * rasterlab.app.chart.ChartLook}.
 */
package rasterlab.app.chart;
