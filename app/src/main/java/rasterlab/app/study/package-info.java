/**
 * The tab of studies: what is measured, shown as chart and as table, and kept as a file.
 *
 * <p>Start with {@link rasterlab.app.study.StudyFile}.
 */
package rasterlab.app.study;
