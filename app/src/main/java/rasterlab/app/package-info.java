/**
 * The desktop lab and its command line. A package below is one topic's lab, or what the labs share.
 *
 * <p>Start with {@link rasterlab.app.Main}, which knows both the window and the command line, so
 * that neither has to know the other.
 */
package rasterlab.app;
