/**
 * A study as words and as a chart of all its sizes: cost (nanoseconds per item, logarithmic) to the
 * right, error upwards, names beside the points.
 *
 * <p>Start with {@link rasterlab.app.study.chart.StudyChart}.
 */
package rasterlab.app.study.chart;
