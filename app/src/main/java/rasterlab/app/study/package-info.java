/**
 * A study as chart, table and file.
 *
 * <p>The chart shows cost (nanoseconds per item, logarithmic) to the right and error upwards. Start
 * with {@link rasterlab.app.study.StudyFile}.
 */
package rasterlab.app.study;
