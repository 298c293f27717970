/**
 * Sign maps as pictures: on the command line, and in a window of their own beside a lab.
 *
 * <p>Start with {@link rasterlab.app.signmap.SignSheet}.
 */
package rasterlab.app.signmap;
