/**
 * The real window, used as a person uses it, by keyboard and mouse.
 *
 * <p>Start with {@link rasterlab.tests.window.WindowHarness}, which opens it.
 */
package rasterlab.tests.window;
