/**
 * The window around the labs: start-up, tabs, theme, language, what is kept between runs, and the
 * report of failures.
 *
 * <p>Start at {@link rasterlab.app.Main}, then {@link rasterlab.app.shell.LabFrame}; {@link
 * rasterlab.app.shell.LabTabs} makes the same tabs without a window.
 */
package rasterlab.app.shell;
